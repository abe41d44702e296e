// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_TIP_RECOVERY_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_TIP_RECOVERY_H

#include <CGAL/Geodesic_remeshing/internal/Intersection_search.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Polish.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/distance_to_ring.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Steps towards the centre of the neighbours shorten tips: horns, ears, claws, and dents as well. Where a vertex of the
// input is farther from the triangulation than its neighbours and than a tolerance, the nearest vertex is sent there
// and stays, provided that the triangles around can be made good.
class Tip_recovery
{
public:
  using Index = Lean_triangulation::Index;

  explicit Tip_recovery(Remeshed_surface& remeshed)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_input(remeshed.walker().triangulation())
  {}

  // `nearest` tells the nearest vertices as they are before the first is sent. Returns the number of vertices sent.
  std::size_t run(const Nearest_vertices& nearest, double tolerance);

private:
  const Point& input_point(const Index x) const { return m_remeshed.walker().surface().point(Vertex(x)); }
  double distance_to_ring(const Index x, const Index v, const double limit) const
  {
    return squared_distance_to_ring(m_remeshed, input_point(x), v, limit);
  }
  bool is_tip(Index x) const;
  bool send_one_of(Index v, Index x);
  bool send(Index v, Index x);

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  const Lean_triangulation& m_input;
  std::vector<double>
      m_squared_distance; // of each input vertex from its nearest vertex; then from the triangles around that
};

// Farther than all neighbours; the index decides among equals. What is on a line is left to the vertices of the line.
inline bool Tip_recovery::is_tip(const Index x) const
{
  bool is_farthest = !m_input.is_on_line(x);
  m_input.for_each_neighbor(x, [&](const Index y) {
    is_farthest = is_farthest && (m_squared_distance[y] < m_squared_distance[x] ||
                                  (!(m_squared_distance[x] < m_squared_distance[y]) && x < y));
  });
  return is_farthest;
}

// Sends the nearest vertex v or, where that has to stay or finds no good place, the nearest of its neighbours. To try
// more of them was measured to keep no more tips, and to leave more intersections at small numbers of vertices.
inline bool Tip_recovery::send_one_of(const Index v, const Index x)
{
  if(m_remeshed.can_be_sent(v) && send(v, x))
    return true;
  Index best = Lean_triangulation::none;
  double least = infinity;
  m_table.for_each_neighbor(v, [&](const Index w) {
    const double distance = CGAL::squared_distance(input_point(x), m_remeshed.spot(w).point);
    if(m_remeshed.can_be_sent(w) && distance < least)
    {
      least = distance;
      best = w;
    }
  });
  return best != Lean_triangulation::none && send(best, x);
}

inline bool Tip_recovery::send(const Index v, const Index x)
{
  static const double good = badness_of_angle(30.);
  std::vector<Index> around;
  m_table.for_each_neighbor(v, [&](const Index w) { around.push_back(w); });
  const auto badness = [&] {
    double sum = m_remeshed.ring_badness(v);
    for(const Index w : around)
      sum = add_badness(sum, m_remeshed.ring_badness(w));
    return sum;
  };
  const double before = badness();
  m_remeshed.record();
  m_remeshed.put(v, m_remeshed.spot_at_vertex(x));
  Polish polish(m_remeshed);
  for(int round = 0; round < 2; ++round)
    for(const Index w : around)
      polish.better_vertex(w);
  // A tip is thin: the way to it may lead through its other side.
  const bool is_good = badness() <= (std::max)(before, good) && !has_intersections_near(m_remeshed, around);
  if(is_good)
    m_remeshed.pin_tip(v);
  else
    m_remeshed.undo_to({0, 0});
  m_remeshed.forget();
  return is_good;
}

inline std::size_t Tip_recovery::run(const Nearest_vertices& nearest, const double tolerance)
{
  const auto limit = [&](const Index x) { return CGAL::square(tolerance * m_remeshed.metric().size(Vertex(x))); };
  m_squared_distance = nearest.squared_distance;
  const Concurrency concurrency = m_remeshed.block_size().concurrency;
  const auto is_far = [&](const std::size_t i) {
    const Index x = static_cast<Index>(i);
    return nearest.vertex[x] != Lean_triangulation::none && m_squared_distance[x] > limit(x);
  };
  parallel_for(concurrency, m_input.vertex_slots(), [&](const std::size_t i) {
    const Index x = static_cast<Index>(i);
    if(is_far(x))
      m_squared_distance[x] = (std::min)(m_squared_distance[x], distance_to_ring(x, nearest.vertex[x], limit(x)));
  });
  const std::vector<Index> tips =
      parallel_list(concurrency, m_input.vertex_slots(), [&](const Index x) { return is_far(x) && is_tip(x); });
  std::size_t sent = 0;
  for(const Index x : tips)
  {
    // The nearest vertex need not be one of the nearest triangle.
    double distance = m_squared_distance[x];
    m_table.for_each_neighbor(nearest.vertex[x], [&](const Index w) {
      if(distance > limit(x))
        distance = (std::min)(distance, distance_to_ring(x, w, limit(x)));
    });
    if(distance > limit(x) && send_one_of(nearest.vertex[x], x))
      ++sent;
  }
  return sent;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TIP_RECOVERY_H
