// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FAST_MARCHING_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FAST_MARCHING_H

#include <CGAL/Geodesic_remeshing/internal/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

enum class Front_shape { circular, planar };

// Distances that a front brings from the sources to the vertices, in the order of their arrival (section 3 of the
// paper, after Kimmel and Sethian). Where a face is crossed against that order - obtuse angles, of which the intrinsic
// Delaunay triangulation has left few - a vertex may be reached better after it was settled: it is then queued again,
// so that no unfolding of faces is needed.
class Fast_marching
{
  using Index = Intrinsic_triangulation::Index;
  using Spoke = Intrinsic_triangulation::Spoke;

public:
  explicit Fast_marching(const Intrinsic_triangulation& triangulation)
    : m_triangulation(&triangulation), m_state(triangulation.number_of_vertices())
  {}

  // The front starts at `v` with this value, which may be any number.
  void add_source(Vertex v, double distance = 0.)
  {
    CGAL_precondition(static_cast<std::size_t>(v.idx()) < m_state.size());
    lower(static_cast<Index>(v.idx()), distance);
  }

  // Marches until the queue is empty. `domain(v)`: may the front enter `v`? `settle(v, distance)` is called in
  // ascending order whenever a vertex is taken from the queue, again if its distance has dropped later. When it returns
  // false the march stops at once, and another call would go on from there.
  template <typename Domain, typename Settle>
  void march(Front_shape shape, const Domain& domain, Settle&& settle)
  {
    if(shape == Front_shape::circular)
      march_shape<Front_shape::circular>(domain, settle, infinity);
    else
      march_shape<Front_shape::planar>(domain, settle, infinity);
  }

  // Marches over everything not farther than `maximum_distance`.
  void march(Front_shape shape, double maximum_distance = infinity)
  {
    const auto everywhere = [](Vertex) { return true; };
    const auto always = [](Vertex, double) { return true; };
    if(shape == Front_shape::circular)
      march_shape<Front_shape::circular>(everywhere, always, maximum_distance);
    else
      march_shape<Front_shape::planar>(everywhere, always, maximum_distance);
  }

  // Infinite where the front has not been.
  double distance(Vertex v) const { return m_state[v.idx()].distance; }

  // All vertices that have a distance, in the order in which they got their first one.
  const std::vector<Vertex>& reached() const { return m_reached; }

  // Forgets sources and distances, at the cost of what was reached.
  void clear()
  {
    for(const Vertex v : m_reached)
      m_state[v.idx()] = State();
    m_reached.clear();
    m_queue.clear();
  }

private:
  struct State
  {
    double distance = infinity;
    bool is_settled = false; // left the queue with this distance
  };

  struct Entry
  {
    double distance;
    Index vertex;

    // the heap has its smallest entry on top
    friend bool operator<(const Entry& a, const Entry& b)
    {
      return a.distance > b.distance || (!(a.distance < b.distance) && a.vertex > b.vertex);
    }
  };

  void lower(Index v, double distance)
  {
    State& state = m_state[v];
    if(!(distance < state.distance))
      return;
    if(!(state.distance < infinity))
      m_reached.push_back(Vertex(v));
    state.distance = distance;
    state.is_settled = false;
    m_queue.push_back(Entry{distance, v});
    std::push_heap(m_queue.begin(), m_queue.end());
  }

  template <Front_shape shape, typename Domain, typename Settle>
  void march_shape(const Domain& domain, Settle& settle, double maximum_distance);

  template <Front_shape shape, typename Domain>
  void spread_from(Index v, const Domain& domain, double maximum_distance);

  static bool is_obtuse(double side_a, double side_b, double base)
  {
    return side_a * side_a + side_b * side_b < base * base;
  }

  template <Front_shape shape>
  static double across(double from_a, double from_b, double base, double side_a, double side_b);

  const Intrinsic_triangulation* m_triangulation;
  std::vector<State> m_state;
  std::vector<Vertex> m_reached;
  std::vector<Entry> m_queue; // a binary heap; entries whose distance is no longer that of the vertex are dropped when met
};

template <Front_shape shape, typename Domain, typename Settle>
void Fast_marching::march_shape(const Domain& domain, Settle& settle, double maximum_distance)
{
  while(!m_queue.empty())
  {
    const Entry top = m_queue.front();
    State& state = m_state[top.vertex];
    const bool is_current = !state.is_settled && !(state.distance < top.distance);
    if(is_current && !settle(Vertex(top.vertex), top.distance))
      return;
    std::pop_heap(m_queue.begin(), m_queue.end());
    m_queue.pop_back();
    if(!is_current)
      continue;
    state.is_settled = true;
    spread_from<shape>(top.vertex, domain, maximum_distance);
  }
}

// Brings the front from v, which has just been settled, to its neighbors: along the spokes, and across the faces that
// have another settled vertex.
template <Front_shape shape, typename Domain>
void Fast_marching::spread_from(Index v, const Domain& domain, double maximum_distance)
{
  const double here = m_state[v].distance;
  double beyond_previous_face = infinity;
  const Spoke* const end = m_triangulation->end(v);
  for(const Spoke* spoke = m_triangulation->begin(v); spoke != end; ++spoke)
  {
    const State& b = m_state[spoke->neighbor];
    double best = (std::min)(here + spoke->length, beyond_previous_face);
    beyond_previous_face = infinity;
    if(spoke->rim >= 0.)
    {
      const State& c = m_state[spoke[1].neighbor];
      if(c.is_settled && (b.distance > here || is_obtuse(spoke->length, spoke->rim, spoke[1].length)))
        best = (std::min)(best, across<shape>(here, c.distance, spoke[1].length, spoke->length, spoke->rim));
      if(b.is_settled && (c.distance > here || is_obtuse(spoke[1].length, spoke->rim, spoke->length)))
        beyond_previous_face = across<shape>(here, b.distance, spoke->length, spoke[1].length, spoke->rim);
    }
    if(best < b.distance && best <= maximum_distance && domain(Vertex(spoke->neighbor)))
      lower(spoke->neighbor, best);
  }
}

// The value at the apex of a triangle of which the base' ends a and b have theirs, if the front comes in through the
// base; else infinity. A circular front comes from a point (the virtual source) that is found from its distances to a
// and b, a planar one from infinity.
template <Front_shape shape>
double Fast_marching::across(double from_a, double from_b, double base, double side_a, double side_b)
{
  if(!(base > 0.))
    return infinity;
  // a lies at the origin, b on the x-axis, the apex above it, the virtual source below it
  const double x = ((side_a - side_b) * (side_a + side_b) + base * base) / (2. * base);
  const double y = std::sqrt((std::max)(0., (side_a - x) * (side_a + x)));
  if(shape == Front_shape::planar)
  {
    const double slope_x = (from_b - from_a) / base;
    if(!(std::abs(slope_x) <= 1.))
      return infinity;
    const double slope_y = std::sqrt((1. - slope_x) * (1. + slope_x));
    const double crossing = x * slope_y - y * slope_x;
    return 0. <= crossing && crossing <= base * slope_y ? from_a + slope_x * x + slope_y * y : infinity;
  }
  const double source_x = ((from_a - from_b) * (from_a + from_b) + base * base) / (2. * base);
  const double square = (from_a - source_x) * (from_a + source_x);
  if(!(square >= 0.))
    return infinity;
  const double depth = std::sqrt(square);
  const double crossing = source_x * y + x * depth;
  if(!(0. <= crossing && crossing <= base * (y + depth)))
    return infinity;
  return std::sqrt((x - source_x) * (x - source_x) + (y + depth) * (y + depth));
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FAST_MARCHING_H
