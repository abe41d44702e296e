// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_LINES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_LINES_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The lines of a surface: features, boundary. A line runs through the input vertices where two of its edges meet, from
// one end to the other or around; ends are corners and where another number of edges meet. A place on a line has an
// exact zero for a coordinate; its position is the length along the line up to it.
class Surface_lines
{
public:
  using Index = Lean_triangulation::Index;
  static constexpr Index none = Lean_triangulation::none;

  Surface_lines(const Surface_walker& walker, const Constraints& constraints);

  bool empty() const { return m_pieces.empty(); }

  // The place at a position of a line, sought from one of its pieces on
  Place place_at(Index near, double at) const;

protected:
  // An edge of a line, from `begin` on (in lengths along the line). A halfedge of it, which may run the other way.
  struct Piece
  {
    Index h;
    bool is_reversed;
    Index line;
    double begin, length;
  };
  struct Line
  {
    Index first, last;
    double length;
    bool is_loop; // ends where it begins, perhaps at a corner
  };              // pieces [first, last)

  bool is_end(const Index x) const { return m_incident[x][1] == none; }
  Index start(const Piece& p) const { return p.is_reversed ? m_table.target(p.h) : m_table.source(p.h); }
  Index end(const Piece& p) const { return p.is_reversed ? m_table.source(p.h) : m_table.target(p.h); }
  const Point& point(const Index x) const { return m_walker.surface().point(Vertex(x)); }
  Index vertex_at(const Place& place) const;
  Index piece_at(const Place& place) const;
  double position(const Place& place, Index piece) const;
  double position_on(const Place& place, const Line& line) const;

private:
  void find_ends(const Constraints& constraints);
  void follow(Index h, Index from);
  Index canonical(const Index h) const { return (std::min)(h, m_table.opposite(h)); }

  const Surface_walker& m_walker;

protected:
  const Lean_triangulation& m_table;
  std::vector<std::array<Index, 2>> m_incident; // of an input vertex: halfedges of two line edges; of one at an end
  std::vector<Index> m_piece_of;                // of a halfedge
  std::vector<Piece> m_pieces;
  std::vector<Line> m_lines;
};

inline Surface_lines::Surface_lines(const Surface_walker& walker, const Constraints& constraints)
  : m_walker(walker), m_table(walker.triangulation())
{
  find_ends(constraints);
  if(m_incident.empty())
    return;
  m_piece_of.assign(4 * m_table.face_slots(), none);
  const auto follow_where = [&](const auto& is_start) {
    for(Index h = 0; h < m_piece_of.size(); ++h)
      if((h & 3) != 3 && m_table.is_constrained(h))
        for(const Index x : {m_table.source(h), m_table.target(h)})
          if(m_piece_of[h] == none && is_start(x))
            follow(canonical(h), x);
  };
  follow_where([&](const Index x) { return is_end(x); });
  follow_where([](Index) { return true; }); // what is left are closed lines
}

inline void Surface_lines::find_ends(const Constraints& constraints)
{
  std::vector<Index> degree;
  for(Index h = 0; h < 4 * m_table.face_slots(); ++h)
  {
    if((h & 3) == 3 || !m_table.is_constrained(h) || canonical(h) != h)
      continue;
    degree.resize(m_table.vertex_slots(), 0);
    m_incident.resize(m_table.vertex_slots(), {{none, none}});
    for(const Index x : {m_table.source(h), m_table.target(h)})
    {
      if(degree[x] < 2)
        m_incident[x][degree[x]] = h;
      ++degree[x];
    }
  }
  for(Index x = 0; x < degree.size(); ++x)
    if(degree[x] != 2 || (!constraints.is_corner.empty() && constraints.is_corner[x]))
      m_incident[x][1] = none;
}

// From an end to the next, or around. The edge at an end that `m_incident` does not know is not asked for.
inline void Surface_lines::follow(Index h, const Index from)
{
  const Index number = static_cast<Index>(m_lines.size()), first = static_cast<Index>(m_pieces.size());
  double length = 0.;
  Index x = from;
  while(h != none && m_piece_of[h] == none)
  {
    m_piece_of[h] = static_cast<Index>(m_pieces.size());
    if(m_table.opposite(h) != none)
      m_piece_of[m_table.opposite(h)] = m_piece_of[h];
    const bool is_reversed = m_table.source(h) != x;
    const double piece = std::sqrt(squared_distance(point(m_table.source(h)), point(m_table.target(h))));
    m_pieces.push_back({h, is_reversed, number, length, piece});
    length += piece;
    x = is_reversed ? m_table.source(h) : m_table.target(h);
    h = is_end(x) ? none : m_incident[x][m_incident[x][0] == h];
  }
  m_lines.push_back({first, static_cast<Index>(m_pieces.size()), length, x == from});
}

inline Surface_lines::Index Surface_lines::vertex_at(const Place& place) const
{
  const auto& c = place.coordinates;
  if((c[0] > 0.) + (c[1] > 0.) + (c[2] > 0.) != 1)
    return none;
  return m_table.source(4 * static_cast<Index>(place.face) + (c[0] > 0. ? 0 : c[1] > 0. ? 1 : 2));
}

inline Surface_lines::Index Surface_lines::piece_at(const Place& place) const
{
  const Index x = vertex_at(place), f = place.face;
  if(x != none)
    return m_incident[x][0] == none ? none : m_piece_of[m_incident[x][0]];
  for(Index i = 0; i < 3; ++i)
    if(!(place.coordinates[(i + 2) % 3] > 0.))
      return m_piece_of[4 * f + i];
  return none;
}

// Of a place that is on this piece
inline double Surface_lines::position(const Place& place, const Index piece) const
{
  const Piece& p = m_pieces[piece];
  const Index f = place.face;
  double weight = 0.;
  for(Index i = 0; i < 3; ++i)
    if(m_table.source(4 * f + i) == end(p))
      weight = place.coordinates[i];
  return p.begin + weight * p.length;
}

// Of a place on this line or at its end
inline double Surface_lines::position_on(const Place& place, const Line& line) const
{
  const Index x = vertex_at(place);
  if(x != none && x == start(m_pieces[line.first]))
    return 0.;
  return x != none && is_end(x) ? line.length : position(place, piece_at(place));
}

inline Place Surface_lines::place_at(Index near, double at) const
{
  const Line& line = m_lines[m_pieces[near].line];
  if(line.is_loop && line.length > 0. && !(at >= 0. && at < line.length))
  {
    near = at < 0. ? line.last - 1 : line.first;
    at -= line.length * std::floor(at / line.length);
  }
  while(near + 1 < line.last && at > m_pieces[near].begin + m_pieces[near].length)
    ++near;
  while(near > line.first && at < m_pieces[near].begin)
    --near;
  const Piece& p = m_pieces[near];
  const double t = p.length > 0. ? (std::min)((std::max)((at - p.begin) / p.length, 0.), 1.) : 0.;
  Place place{Face(Lean_triangulation::face(p.h)), {{0., 0., 0.}}};
  place.coordinates[p.h & 3] = p.is_reversed ? t : 1. - t;
  place.coordinates[Lean_triangulation::next(p.h) & 3] = p.is_reversed ? 1. - t : t;
  return place;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_LINES_H
