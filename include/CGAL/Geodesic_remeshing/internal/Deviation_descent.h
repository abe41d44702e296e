// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_DESCENT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_DESCENT_H

#include <CGAL/Geodesic_remeshing/internal/Deviations.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/distance_to_ring.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Moves vertices over the surface where the triangulation is farthest from it. What decides the Hausdorff distance are
// a few places: ridges and ends of limbs between vertices, hollows that a triangle spans. There the vertices of the
// nearest triangle go where the deviations around them are least, as far as the angles allow it.
class Deviation_descent
{
public:
  using Index = Lean_triangulation::Index;

  // `nearest` may be that of some steps ago. No triangle gets worse than `badness` that is not.
  Deviation_descent(Remeshed_surface& remeshed, const Nearest_vertices& nearest, const double badness)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_input(remeshed.walker().triangulation()),
      m_nearest(nearest), m_badness(badness), m_deviations(remeshed, nearest), m_stamp(m_input.vertex_slots(), 0)
  {}

  // Works at the largest deviations, so many times, but not at what is below the least: on a plane that is rounding.
  void run(std::size_t number_of_trials, double least);

private:
  using Spot = Remeshed_surface::Spot;

  bool better_vertex(Index v, double unit);
  void gather_samples(Index v);
  double cost(const Vertex_ring& ring, const Spot& spot, double unit, double limit) const;

  Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const Lean_triangulation& m_input;
  const Nearest_vertices& m_nearest;
  const double m_badness;
  const Deviations m_deviations;
  std::vector<Index> m_stamp; // of the input's vertices: when they were looked at
  Index m_time = 0;
  std::vector<Index> m_samples; // vertices of the input
};

// The vertices of the input that no triangle is much nearer to than those around v, sought from where v and its
// neighbors are as far as their nearest vertex is one of these
inline void Deviation_descent::gather_samples(const Index v)
{
  ++m_time;
  m_samples.clear();
  const auto enter = [&](const Index x) {
    if(m_stamp[x] == m_time)
      return;
    m_stamp[x] = m_time;
    bool is_near = m_nearest.vertex[x] == v;
    m_table.for_each_neighbor(v, [&](const Index w) { is_near = is_near || m_nearest.vertex[x] == w; });
    if(is_near)
      m_samples.push_back(x);
  };
  const auto enter_around = [&](const Index w) {
    const Index f = static_cast<Index>(m_remeshed.spot(w).place.face);
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      enter(m_input.source(h));
  };
  enter_around(v);
  m_table.for_each_neighbor(v, enter_around);
  for(std::size_t i = 0; i < m_samples.size(); ++i)
    m_input.for_each_neighbor(m_samples[i], enter);
  const auto is_nearer_to_others = [&](const Index x) {
    const double here = .99 * squared_distance_to_ring(m_remeshed, m_deviations.input_point(x), v, 0.);
    bool result = false;
    m_table.for_each_neighbor(v, [&](const Index w) {
      result = result || squared_distance_to_ring(m_remeshed, m_deviations.input_point(x), w, here) < here;
    });
    return result;
  };
  m_samples.erase(std::remove_if(m_samples.begin(), m_samples.end(), is_nearer_to_others), m_samples.end());
}

// The sum of the sixth powers of the deviations, of which the largest make up nearly all; no more than something above
// the limit where it is above the limit
inline double Deviation_descent::cost(const Vertex_ring& ring, const Spot& spot, const double unit,
                                      const double limit) const
{
  // Where the input is not finer than the triangulation its edges cross the triangles' anywhere: with the middles alone
  // the distance grew there.
  constexpr std::array<double, 3> parts = {{.25, .5, .75}};
  const double large = .3 * unit;
  const std::size_t n = ring.size();
  double sum = 0.;
  const auto add = [&](const double deviation) {
    const double x = deviation / unit;
    sum += x * x * x;
  };
  for(std::size_t i = 0; i < n && sum <= limit; ++i)
  {
    for(const double part : parts)
      add(m_deviations.from_input(spot.point + part * (ring[i].point - spot.point), spot, large, ring[i]));
    add(m_deviations.from_input(CGAL::centroid(spot.point, ring[i].point, ring[(i + 1) % n].point), spot, large,
                                ring[i]));
  }
  for(std::size_t s = 0; s < m_samples.size() && sum <= limit; ++s)
  {
    const Point& p = m_deviations.input_point(m_samples[s]);
    double least = infinity;
    for(std::size_t i = 0; i < n; ++i)
      least = (std::min)(least,
                         nearest_in_triangle(p, spot.point, ring[i].point, ring[(i + 1) % n].point).squared_distance);
    add(least);
  }
  return sum;
}

// Tries steps along the edges, long ones first, as long as they help.
inline bool Deviation_descent::better_vertex(const Index v, const double unit)
{
  if(m_remeshed.is_fixed(v) || m_remeshed.is_on_line(v))
    return false;
  constexpr std::array<double, 3> steps = {{.2, .08, .03}};
  constexpr int rounds = 3;
  constexpr double least_gain = .05;
  gather_samples(v);
  const Vertex_ring ring(m_remeshed, v);
  const double limit = (std::max)(m_badness, ring.badness());
  double best = cost(ring, m_remeshed.spot(v), unit, infinity);
  bool has_moved = false, goes_on = true;
  for(int round = 0; round < rounds && goes_on; ++round)
  {
    const double before = best;
    for(const double step : steps)
      for(std::size_t i = 0; i < ring.size(); ++i)
      {
        const Spot spot = m_remeshed.spot_after(v, step * (ring[i].point - m_remeshed.spot(v).point));
        const double c = ring.badness(spot, limit) <= limit ? cost(ring, spot, unit, best) : infinity;
        if(c < best)
        {
          best = c;
          has_moved = true;
          m_remeshed.put(v, spot);
        }
      }
    goes_on = best < (1. - least_gain) * before;
  }
  return has_moved;
}

// A trouble that is bettered may still be the largest. Where nothing helps all that is nearest to the same face is left
// until a vertex around it has moved. Some of those on the list are bettered with others: it has to be longer than
// there are trials.
inline void Deviation_descent::run(const std::size_t number_of_trials, const double least)
{
  using Deviation = Deviations::Deviation;
  if(number_of_trials == 0)
    return;
  std::vector<Deviation> heap = m_deviations.largest(4 * number_of_trials, CGAL::square(least));
  std::make_heap(heap.begin(), heap.end());
  const auto put_back = [&](const Deviation& trouble) {
    heap.push_back(trouble);
    std::push_heap(heap.begin(), heap.end());
  };
  std::vector<char> is_stuck(m_table.face_slots(), 0);
  for(std::size_t trials = 0; trials < number_of_trials && !heap.empty();)
  {
    std::pop_heap(heap.begin(), heap.end());
    Deviation trouble = heap.back();
    heap.pop_back();
    trouble.squared = m_deviations.now(trouble); // may have been bettered with another one
    if(!heap.empty() && trouble < heap.front())
    {
      put_back(trouble);
      continue;
    }
    const Index f = m_deviations.face_near(trouble);
    if(f == Lean_triangulation::none || is_stuck[f]) // none if the distances overflow
      continue;
    ++trials;
    bool has_moved = false;
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      has_moved = better_vertex(m_table.source(h), trouble.squared) || has_moved;
    is_stuck[f] = !has_moved;
    for(Index h = 4 * f; h < 4 * f + 3 && has_moved; ++h)
      m_table.for_each_outgoing(m_table.source(h), [&](const Index k) { is_stuck[Lean_triangulation::face(k)] = 0; });
    const double after = m_deviations.now(trouble);
    if(after < .9 * trouble.squared && after > CGAL::square(least))
      put_back({after, trouble.is_of_input, trouble.at});
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_DESCENT_H
