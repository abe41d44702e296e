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
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
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

  // No change leaves an angle smaller than `least_angle`, unless nothing else is left: then it may be 10.
  Vertex_count(Remeshed_surface& remeshed, const double edge_length, const double least_angle = 10.)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_squared_edge_length(edge_length * edge_length),
      m_least_angle(least_angle)
  {}

  // Returns whether the number was reached.
  bool reach(std::size_t number_of_vertices);
  // The same, at the cost of angles if nothing else is left
  bool reach_at_any_cost(std::size_t number_of_vertices);

private:
  // The collapse of h, or, where `other` is given, the split of the source of both between them, or that of h itself.
  struct Change
  {
    double cost;
    Index h, other;
    bool operator<(const Change& c) const { return std::tie(cost, h, other) < std::tie(c.cost, c.h, c.other); }
  };

  void find_collapses();
  void find_splits();
  void keep_cheapest(std::size_t number);
  std::size_t apply(std::size_t number);
  bool collapse(Index h);
  bool split(Index h, Index other);
  bool split_edge(Index h);
  void find_edge_splits();
  double worst_around(const std::array<Index, 4>& vertices) const;
  bool settle(const std::array<Index, 4>& changed, double before, bool is_line = false);
  double size_cost(Index v, Index w) const;
  double cost_of_lines(Index h) const;
  std::array<Index, 4> corners(Index h) const;
  bool is_touched(const Change& change) const;

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  double m_squared_edge_length;
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
    m_changes.clear();
    if(n < number_of_vertices)
    {
      m_remeshed.reserve_free(static_cast<Index>(number));
      find_splits();
      find_edge_splits();
    }
    else
      find_collapses();
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
  for(const double angle : {10., 5., 2., 1.})
    for(const std::size_t more : {0, 5000})
    {
      m_least_angle = angle;
      m_more = more;
      if(reach(number_of_vertices))
        return true;
    }
  return false;
}

// The length of an edge weighs as much as one step of the energy (2) when it is off by the whole edge length.
inline double Vertex_count::size_cost(const Index v, const Index w) const
{
  const Remeshed_surface::Spot &a = m_remeshed.spot(v), &b = m_remeshed.spot(w);
  return 2. * squared_distance(a.point, b.point) / (m_squared_edge_length * CGAL::square(.5 * (a.size + b.size)));
}

// Of an edge between lines: what is added to the cost of its collapse, which leaves a longer edge on the line.
inline double Vertex_count::cost_of_lines(const Index h) const
{
  constexpr double last_resort = 1000., longest = 2. * 1.3 * 1.3;
  double length = 0.;
  m_remeshed.for_each_neighbor_on_line(
      m_table.target(h), [&](const Index w) { length = (std::max)(length, size_cost(m_table.source(h), w)); });
  return length > longest ? last_resort : 0.;
}

// Of the two faces of an edge; at the boundary, where there is one, the source takes the place of the fourth.
inline std::array<Vertex_count::Index, 4> Vertex_count::corners(const Index h) const
{
  const Index o = m_table.opposite(h), a = m_table.source(h);
  return {{a, m_table.target(h), m_table.apex(h), o == Lean_triangulation::none ? a : m_table.apex(o)}};
}

inline void Vertex_count::find_collapses()
{
  for(Index f = 0; f < m_table.face_slots(); ++f)
  {
    for(Index h = 4 * f; h < 4 * f + 3 && !m_table.is_removed_face(f); ++h)
    {
      const Index v = m_table.source(h), w = m_table.target(h);
      const bool is_line = m_table.is_constrained(h);
      if(is_line ? !m_remeshed.is_fixed(w) : m_remeshed.is_free(w))
        m_changes.push_back({m_remeshed.energy().of_collapse(h) + size_cost(v, w) + (is_line ? cost_of_lines(h) : 0.),
                             h, Lean_triangulation::none});
    }
  }
}

// Of each vertex the cheapest split into halves.
inline void Vertex_count::find_splits()
{
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
  {
    if(m_table.is_removed(v) || m_remeshed.is_on_line(v))
      continue;
    const int valence = static_cast<int>(m_table.valence(v)), half = valence / 2;
    Change best{infinity, Lean_triangulation::none, Lean_triangulation::none};
    double size = 0.;
    Index across = m_table.halfedge(v);
    for(int i = 0; i < half; ++i)
      across = m_table.rotate(across);
    m_table.for_each_outgoing(v, [&](const Index h) {
      const double cost = 2. * (m_remeshed.energy().excess_at(Lean_triangulation::next(h)) +
                                m_remeshed.energy().excess_at(Lean_triangulation::next(across)));
      best = (std::min)(best, Change{cost, h, across});
      size += size_cost(v, m_table.target(h));
      across = m_table.rotate(across);
    });
    const int one = half + 2 - 6, two = valence - half + 2 - 6, excess = valence - 6;
    best.cost += one * one + two * two - excess * excess + 2 - size / valence;
    m_changes.push_back(best);
  }
}

inline void Vertex_count::find_edge_splits()
{
  constexpr double last_resort = 1000., shortest = 2. * 1.5 * 1.5;
  for(Index h = 0; h < 4 * m_table.face_slots(); ++h)
  {
    if((h & 3) == 3 || m_table.is_removed_face(Lean_triangulation::face(h)) || m_table.opposite(h) < h)
      continue;
    const Index v = m_table.source(h), w = m_table.target(h);
    if(!m_remeshed.is_on_line(v) || !m_remeshed.is_on_line(w) ||
       (m_remeshed.keeps_lines() && m_table.is_constrained(h)))
      continue;
    const double size = size_cost(v, w), last = m_table.is_constrained(h) ? last_resort : .5 * last_resort;
    m_changes.push_back({m_remeshed.energy().of_edge_split(h) - size + (size < shortest ? last : 0.), h, h});
  }
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
  if(!m_remeshed.find_middle(h, middle))
    return false;
  const double before = worst_around(around);
  const Index w = m_table.split_edge(h);
  m_remeshed.put(w, middle);
  m_touched[around[0]] = m_touched[around[1]] = true;
  return settle({{w, w, around[2], around[3]}}, before);
}

// The vertex and the new one part along the line between their halves of the ring.
inline bool Vertex_count::split(const Index h, const Index other)
{
  const Index v = m_table.source(h), c = m_table.target(h), d = m_table.target(other);
  const double before = worst_around({{v, v, c, d}});
  const Index w = m_table.split(h, other);
  m_remeshed.put(w, m_remeshed.spot(v));
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

// Relaxes the vertices whose valence has changed; refuses what leaves a face turned or worse than the rounds to come
// mend: of little help is that to the vertices of lines, which cannot give way. But where it was as bad before, as
// between lines nearer to each other than the edges are long, nothing is lost.
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
