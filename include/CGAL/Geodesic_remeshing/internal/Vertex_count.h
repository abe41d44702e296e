// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_COUNT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_COUNT_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_changes.h>
#include <CGAL/Geodesic_remeshing/internal/find_middle.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Brings the number of vertices to the one asked for, by collapses and splits where they cost least regularity: at a
// 5-7 pair they cost none (the pair moves over by one row), in a regular part they make new irregular vertices. Among
// equals the shortest edges go, and the widest rings are divided. The vertices of lines have their own spacing: their
// number changes only where they are too near or too far from each other, or if nothing else is left.
class Vertex_count
{
public:
  using Index = Lean_triangulation::Index;

  // No change leaves an angle smaller than `least_angle`, nor than the smallest that was there before; where nothing
  // else is left it may be 10.
  Vertex_count(Remeshed_surface& remeshed, const double edge_length, const double least_angle = 10.)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_edge_length(edge_length), m_least_angle(least_angle)
  {}

  // Returns whether the number was reached.
  bool reach(std::size_t number_of_vertices);
  // The same, at the cost of angles if nothing else is left
  bool reach_at_any_cost(std::size_t number_of_vertices);

private:
  using Change = Vertex_change;

  void keep_cheapest(std::size_t number);
  std::size_t apply(std::size_t number);
  bool collapse(Index h);
  bool split(Index h, Index other);
  bool split_edge(Index h);
  double worst_around(const std::array<Index, 4>& vertices) const;
  bool settle(const std::array<Index, 4>& changed, double before, bool is_line = false);
  std::array<Index, 4> corners(Index h) const;
  bool is_touched(const Change& change) const;

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  double m_edge_length;
  double m_least_angle;                // that a change may leave
  double m_least_angle_on_lines = 30.; // that a collapse along a line may leave; lowered only if nothing else is left
  std::size_t m_more = 0;              // changes looked at
  std::vector<Change> m_changes;
  std::vector<char> m_touched; // vertices whose valence or place has changed since the costs were found
};

inline bool Vertex_count::reach(const std::size_t number_of_vertices)
{
  while(m_table.number_of_vertices() != number_of_vertices)
  {
    const std::size_t n = m_table.number_of_vertices();
    const std::size_t number = n < number_of_vertices ? number_of_vertices - n : n - number_of_vertices;
    if(n < number_of_vertices)
      m_remeshed.reserve_free(static_cast<Index>(number));
    const Vertex_changes changes(m_remeshed, m_edge_length);
    m_changes = n < number_of_vertices ? changes.splits() : changes.collapses();
    m_touched.assign(m_table.vertex_slots(), false);
    keep_cheapest(number);
    if(apply(number) > 0)
      continue;
    if(m_least_angle > 10.)
      m_least_angle -= 10.;
    else if(m_least_angle_on_lines > 10.)
      m_least_angle_on_lines -= 10.;
    else
      return false;
  }
  return true;
}

inline bool Vertex_count::reach_at_any_cost(const std::size_t number_of_vertices)
{
  // of a band narrower than edges are long all faces are flatter than one degree
  for(const double angle : {10., 5., 2., 1., .1, .01})
    for(const std::size_t more : {0, 5000})
    {
      m_least_angle = angle;
      m_more = more;
      if(reach(number_of_vertices))
        return true;
    }
  return false;
}

// Of the two faces of an edge; at the boundary, where there is one, the source takes the place of the fourth.
inline std::array<Vertex_count::Index, 4> Vertex_count::corners(const Index h) const
{
  const Index o = m_table.opposite(h), a = m_table.source(h);
  return {{a, m_table.target(h), m_table.apex(h), o == Lean_triangulation::none ? a : m_table.apex(o)}};
}

// Neighbours of a change made have to wait for the next pass; so some more than wanted are looked at. The cheapest may
// all be in a place that bears none: then many more.
inline void Vertex_count::keep_cheapest(const std::size_t number)
{
  const std::size_t kept = (std::min)(m_changes.size(), 8 * number + 16 + m_more);
  std::nth_element(m_changes.begin(), m_changes.begin() + kept, m_changes.end());
  m_changes.resize(kept);
  std::sort(m_changes.begin(), m_changes.end());
}

inline bool Vertex_count::is_touched(const Change& change) const
{
  if(m_table.is_removed_face(m_table.face(change.h)))
    return true;
  if(change.other != Lean_triangulation::none && change.other != change.h)
    return m_touched[m_table.source(change.h)] || m_touched[m_table.target(change.h)] ||
           m_touched[m_table.target(change.other)];
  const std::array<Index, 4> around = corners(change.h);
  return std::any_of(around.begin(), around.end(), [&](const Index v) { return m_touched[v]; });
}

inline std::size_t Vertex_count::apply(const std::size_t number)
{
  std::size_t made = 0;
  for(const Change& change : m_changes)
  {
    if(made == number)
      break;
    if(is_touched(change))
      continue;
    m_remeshed.record();
    const auto start = m_remeshed.mark();
    if(change.other == Lean_triangulation::none ? collapse(change.h)
       : change.other == change.h               ? split_edge(change.h)
                                                : split(change.h, change.other))
      ++made;
    else
      m_remeshed.undo_to(start);
    m_remeshed.forget();
  }
  return made;
}

inline bool Vertex_count::collapse(const Index h)
{
  if(!m_table.is_collapse_legal(h))
    return false;
  const std::array<Index, 4> around = corners(h);
  const Index a = around[0], b = around[1];
  const Vector way = m_remeshed.spot(b).point - m_remeshed.spot(a).point;
  const bool are_alike = m_remeshed.is_on_line(a) == m_remeshed.is_on_line(b);
  const bool is_line = m_table.is_constrained(h);
  const double before = worst_around(around);
  m_table.collapse(h);
  if(!m_remeshed.is_fixed(a) && are_alike)
    m_remeshed.put(a, m_remeshed.spot_after(a, .5 * way));
  return settle({{a, a, around[2], around[3]}}, before, is_line);
}

// Divides an edge of a line, or one from line to line, where no vertex is free to be split.
inline bool Vertex_count::split_edge(const Index h)
{
  const std::array<Index, 4> around = corners(h);
  Remeshed_surface::Spot middle;
  if(!find_middle(m_remeshed, h, middle))
    return false;
  const double before = worst_around(around);
  const Index w = m_table.split_edge(h);
  m_remeshed.put_new(w, middle);
  m_touched[around[0]] = m_touched[around[1]] = true;
  return settle({{w, w, around[2], around[3]}}, before);
}

// The vertex and the new one part along the line between their halves of the ring.
inline bool Vertex_count::split(const Index h, const Index other)
{
  const Index v = m_table.source(h), c = m_table.target(h), d = m_table.target(other);
  const double before = worst_around({{v, v, c, d}});
  const Index w = m_table.split(h, other);
  m_remeshed.put_new(w, m_remeshed.spot(v));
  m_remeshed.put(w, m_remeshed.spot_after(w, .5 * Vertex_ring(m_remeshed, w).way_to_center()));
  if(!m_remeshed.is_fixed(v))
    m_remeshed.put(v, m_remeshed.spot_after(v, .5 * Vertex_ring(m_remeshed, v).way_to_center()));
  return settle({{v, w, c, d}}, before);
}

inline double Vertex_count::worst_around(const std::array<Index, 4>& vertices) const
{
  double worst = 0.;
  for(const Index v : vertices)
    worst = (std::max)(worst, m_remeshed.ring_badness(v));
  return worst;
}

// Relaxes the vertices whose valence has changed; refuses what leaves a face worse than the rounds to come mend. Where
// one was as bad before, as between lines nearer to each other than the edges are long, nothing is lost; but of a line,
// whose vertices cannot give way, that is refused as well.
inline bool Vertex_count::settle(const std::array<Index, 4>& changed, const double before, const bool is_line)
{
  const double angle =
      is_line ? (std::min)(m_least_angle_on_lines, m_least_angle_on_lines - 10. + m_least_angle) : m_least_angle;
  const double mendable = is_line ? badness_of_angle(angle) : (std::max)(badness_of_angle(angle), before);
  for(int round = 0; round < 2; ++round)
    for(const Index v : changed)
      if(!m_remeshed.is_fixed(v))
        relax_vertex(m_remeshed, v);
  if(worst_around(changed) > mendable)
    return false;
  for(const Index v : changed)
    m_touched[v] = true;
  return true;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_COUNT_H
