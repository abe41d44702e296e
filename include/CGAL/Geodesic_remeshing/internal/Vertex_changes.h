// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_CHANGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_CHANGES_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The collapse of h, or, where `other` is given, the split of the source of both between them, or that of h itself.
struct Vertex_change
{
  double cost;
  Lean_triangulation::Index h, other;
  bool operator<(const Vertex_change& c) const { return std::tie(cost, h, other) < std::tie(c.cost, c.h, c.other); }
};

// What could change the number of vertices by one, and what it costs: the energy of the valences that it adds, and what
// the lengths of the edges are off.
class Vertex_changes
{
public:
  using Index = Lean_triangulation::Index;

  Vertex_changes(const Remeshed_surface& remeshed, const double edge_length)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_squared_edge_length(edge_length * edge_length)
  {}

  std::vector<Vertex_change> collapses() const;
  std::vector<Vertex_change> splits() const;

private:
  void find_splits(std::vector<Vertex_change>& changes) const;
  void find_edge_splits(std::vector<Vertex_change>& changes) const;
  double size_cost(Index v, Index w) const;
  double cost_of_lines(Index h) const;

  const Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  double m_squared_edge_length;
};

// The length of an edge weighs as much as one step of the energy (2) when it is off by the whole edge length.
inline double Vertex_changes::size_cost(const Index v, const Index w) const
{
  const Remeshed_surface::Spot &a = m_remeshed.spot(v), &b = m_remeshed.spot(w);
  return 2. * squared_distance(a.point, b.point) / (m_squared_edge_length * CGAL::square(.5 * (a.size + b.size)));
}

// Of an edge between lines: what is added to the cost of its collapse, which leaves a longer edge on the line.
inline double Vertex_changes::cost_of_lines(const Index h) const
{
  constexpr double last_resort = 1000., longest = 2. * 1.3 * 1.3;
  double length = 0.;
  m_remeshed.for_each_neighbor_on_line(
      m_table.target(h), [&](const Index w) { length = (std::max)(length, size_cost(m_table.source(h), w)); });
  return length > longest ? last_resort : 0.;
}

inline std::vector<Vertex_change> Vertex_changes::collapses() const
{
  std::vector<Vertex_change> changes;
  for(Index f = 0; f < m_table.face_slots(); ++f)
  {
    for(Index h = 4 * f; h < 4 * f + 3 && !m_table.is_removed_face(f); ++h)
    {
      const Index v = m_table.source(h), w = m_table.target(h);
      const bool is_line = m_table.is_constrained(h);
      if(is_line ? !m_remeshed.is_fixed(w) : m_remeshed.is_free(w))
        changes.push_back({m_remeshed.energy().of_collapse(h) + size_cost(v, w) + (is_line ? cost_of_lines(h) : 0.), h,
                           Lean_triangulation::none});
    }
  }
  return changes;
}

inline std::vector<Vertex_change> Vertex_changes::splits() const
{
  std::vector<Vertex_change> changes;
  find_splits(changes);
  find_edge_splits(changes);
  return changes;
}

// Of each vertex the cheapest split into halves.
inline void Vertex_changes::find_splits(std::vector<Vertex_change>& changes) const
{
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
  {
    if(m_table.is_removed(v) || m_remeshed.is_on_line(v))
      continue;
    const int valence = static_cast<int>(m_table.valence(v)), half = valence / 2;
    Vertex_change best{infinity, Lean_triangulation::none, Lean_triangulation::none};
    double size = 0.;
    Index across = m_table.halfedge(v);
    for(int i = 0; i < half; ++i)
      across = m_table.rotate(across);
    m_table.for_each_outgoing(v, [&](const Index h) {
      const double cost = 2. * (m_remeshed.energy().excess_at(Lean_triangulation::next(h)) +
                                m_remeshed.energy().excess_at(Lean_triangulation::next(across)));
      best = (std::min)(best, Vertex_change{cost, h, across});
      size += size_cost(v, m_table.target(h));
      across = m_table.rotate(across);
    });
    const int one = half + 2 - 6, two = valence - half + 2 - 6, excess = valence - 6;
    best.cost += one * one + two * two - excess * excess + 2 - size / valence;
    changes.push_back(best);
  }
}

inline void Vertex_changes::find_edge_splits(std::vector<Vertex_change>& changes) const
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
    changes.push_back({m_remeshed.energy().of_edge_split(h) - size + (size < shortest ? last : 0.), h, h});
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_CHANGES_H
