// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_WALKER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_WALKER_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Slides along the lines of a surface: features, boundary. A line runs through the input vertices where two of its
// edges meet, from one end to the other or around; ends are corners and where another number of edges meet. A place on
// a line has an exact zero for a coordinate and keeps it, so that straight lines stay covered exactly.
class Line_walker
{
public:
  using Index = Lean_triangulation::Index;
  static constexpr Index none = Lean_triangulation::none;

  Line_walker(const Surface_walker& walker, const Constraints& constraints);

  bool empty() const { return m_pieces.empty(); }

  // Along the projection of `displacement` to the line, for the projection's length; at most half the way to an end,
  // where other vertices are. What is at an end stays.
  Place slide(const Place& from, const Vector& displacement) const;

  // The middle of the way along a line from one place to another, which has no face if there is none. Of the two ways
  // around a closed line that which `beside` is not on. Where `from` is an end `to` must be one too: then the shortest
  // line between them.
  Place middle(const Place& from, const Place& to, const Place& beside) const;

  // The part of a line around a place that is not an end, from one neighbour to the other: `at` is between `low` and
  // `high`, in lengths along the line, which on a closed one go on beyond where it begins. No piece if there is none.
  struct Stretch
  {
    Index piece;
    double low, at, high;
  };
  Stretch stretch(const Place& place, const Place& one, const Place& other) const;
  Place place_at(Index near, double at) const;
  // The vertices of the line strictly between two such positions, or the positions of these
  template <class Visit>
  void for_each_point(const Index near, const double low, const double high, const Visit& visit) const
  {
    for_each_vertex(near, low, high, [&](const Index x, double) { visit(point(x)); });
  }
  template <class Visit>
  void for_each_position(const Index near, const double low, const double high, const Visit& visit) const
  {
    for_each_vertex(near, low, high, [&](Index, const double at) { visit(at); });
  }

private:
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
    bool is_ring;
  }; // pieces [first, last)

  void find_ends(const Constraints& constraints);
  void follow(Index h, Index from);
  Index canonical(const Index h) const { return (std::min)(h, m_table.opposite(h)); }
  bool is_end(const Index x) const { return m_incident[x][1] == none; }
  Index start(const Piece& p) const { return p.is_reversed ? m_table.target(p.h) : m_table.source(p.h); }
  Index end(const Piece& p) const { return p.is_reversed ? m_table.source(p.h) : m_table.target(p.h); }
  const Point& point(const Index x) const { return m_walker.surface().point(Vertex(x)); }
  Index vertex_at(const Place& place) const;
  Index piece_at(const Place& place) const;
  double position(const Place& place, Index piece) const;
  double position_on(const Place& place, const Line& line) const;
  double way_along(Index piece, const Vector& displacement) const;
  Index shortest_line(Index x, Index y) const;
  template <class Visit>
  void for_each_vertex(Index near, double low, double high, const Visit& visit) const;

  const Surface_walker& m_walker;
  const Lean_triangulation& m_table;
  std::vector<std::array<Index, 2>> m_incident; // of an input vertex: halfedges of two line edges; of one at an end
  std::vector<Index> m_piece_of;                // of a halfedge
  std::vector<Piece> m_pieces;
  std::vector<Line> m_lines;
};

inline Line_walker::Line_walker(const Surface_walker& walker, const Constraints& constraints)
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

inline void Line_walker::find_ends(const Constraints& constraints)
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

// From an end to the next, or around. The edge at an end that `incident_` does not know is not asked for.
inline void Line_walker::follow(Index h, const Index from)
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

inline Line_walker::Index Line_walker::vertex_at(const Place& place) const
{
  const auto& c = place.coordinates;
  if((c[0] > 0.) + (c[1] > 0.) + (c[2] > 0.) != 1)
    return none;
  return m_table.source(4 * static_cast<Index>(place.face) + (c[0] > 0. ? 0 : c[1] > 0. ? 1 : 2));
}

inline Line_walker::Index Line_walker::piece_at(const Place& place) const
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
inline double Line_walker::position(const Place& place, const Index piece) const
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
inline double Line_walker::position_on(const Place& place, const Line& line) const
{
  const Index x = vertex_at(place);
  if(x != none && x == start(m_pieces[line.first]))
    return 0.;
  return x != none && is_end(x) ? line.length : position(place, piece_at(place));
}

inline double Line_walker::way_along(const Index piece, const Vector& displacement) const
{
  const Piece& p = m_pieces[piece];
  return p.length > 0. ? displacement * (point(end(p)) - point(start(p))) / p.length : 0.;
}

// The place at a position of a line, sought from one of its pieces on
inline Place Line_walker::place_at(Index near, double at) const
{
  const Line& line = m_lines[m_pieces[near].line];
  if(line.is_ring && line.length > 0. && !(at >= 0. && at < line.length))
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

inline Place Line_walker::slide(const Place& from, const Vector& displacement) const
{
  Index piece = piece_at(from);
  if(piece == none)
    return from;
  const Index x = vertex_at(from);
  double way = 0.;
  if(x == none)
    way = way_along(piece, displacement);
  else if(!is_end(x))
  {
    // Where the line bends, along that of its two edges which leads more the way of the displacement.
    double farthest = 0.;
    for(const Index h : m_incident[x])
    {
      const double along = way_along(m_piece_of[h], displacement);
      const double away = start(m_pieces[m_piece_of[h]]) == x ? along : -along;
      if(away > farthest)
      {
        farthest = away;
        piece = m_piece_of[h];
        way = along;
      }
    }
  }
  const Line& line = m_lines[m_pieces[piece].line];
  if(!(std::abs(way) > 0.) || !(line.length > 0.))
    return from;
  const double at = position(from, piece);
  if(is_end(start(m_pieces[line.first])))
  {
    if(!(at + way > 0.))
      way = -.5 * at;
    if(!(at + way < line.length))
      way = .5 * (line.length - at);
  }
  return place_at(piece, at + way);
}

inline Line_walker::Index Line_walker::shortest_line(const Index x, const Index y) const
{
  Index best = none;
  const auto look = [&](const Index h) {
    if(!m_table.is_constrained(h))
      return;
    const Index number = m_pieces[m_piece_of[h]].line;
    const Line& line = m_lines[number];
    const Index first = start(m_pieces[line.first]), last = end(m_pieces[line.last - 1]);
    if(((first == x && last == y) || (first == y && last == x)) && (best == none || line.length < m_lines[best].length))
      best = number;
  };
  m_table.for_each_outgoing(x, [&](const Index h) {
    look(h);
    look(Lean_triangulation::previous(h));
  });
  return best;
}

inline Place Line_walker::middle(const Place& from, const Place& to, const Place& beside) const
{
  const Index x = vertex_at(from), y = vertex_at(to);
  if(x != none && is_end(x))
  {
    const Index number = y == none ? none : shortest_line(x, y);
    return number == none ? Place() : place_at(m_lines[number].first, .5 * m_lines[number].length);
  }
  const Index piece = piece_at(from), other = piece_at(to);
  if(piece == none || other == none || ((y == none || !is_end(y)) && m_pieces[piece].line != m_pieces[other].line))
    return Place();
  const Line& line = m_lines[m_pieces[piece].line];
  const double at = position(from, piece);
  double way = position_on(to, line) - at;
  if(line.is_ring)
  {
    const auto forward = [&](const double d) { return d < 0. ? d + line.length : d; };
    const double side = forward(position_on(beside, line) - at);
    way = forward(way) < side ? forward(way) : forward(way) - line.length;
  }
  return place_at(piece, at + .5 * way);
}

inline Line_walker::Stretch Line_walker::stretch(const Place& place, const Place& one, const Place& other) const
{
  const Index piece = piece_at(place), x = vertex_at(place);
  if(piece == none || (x != none && is_end(x)))
    return {none, 0., 0., 0.};
  const Line& line = m_lines[m_pieces[piece].line];
  const double at = position(place, piece);
  double low = position_on(one, line), high = position_on(other, line);
  if(line.is_ring)
  {
    const auto forward = [&](const double d) { return d < 0. ? d + line.length : d; };
    low = forward(low - at);
    high = forward(high - at);
    if(high < low)
      std::swap(low, high);
    return {piece, at + high - line.length, at, at + low};
  }
  if(high < low)
    std::swap(low, high);
  return {piece, low, at, high};
}

template <class Visit>
void Line_walker::for_each_vertex(const Index near, const double low, const double high, const Visit& visit) const
{
  const Line& line = m_lines[m_pieces[near].line];
  const auto visit_if_between = [&](const Index i, const double turn) {
    const double at = m_pieces[i].begin + turn;
    if(at > low && at < high)
      visit(start(m_pieces[i]), at);
    return at;
  };
  double turn = 0.;
  for(Index i = near; visit_if_between(i, turn) > low;)
  {
    if(i == line.first && !line.is_ring)
      break;
    turn -= i == line.first ? line.length : 0.;
    i = i == line.first ? line.last - 1 : i - 1;
  }
  turn = 0.;
  for(Index i = near;;)
  {
    if(i + 1 == line.last && !line.is_ring)
      break;
    turn += i + 1 == line.last ? line.length : 0.;
    i = i + 1 == line.last ? line.first : i + 1;
    if(!(visit_if_between(i, turn) < high))
      break;
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_WALKER_H
