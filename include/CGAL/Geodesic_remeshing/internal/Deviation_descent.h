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

#include <CGAL/Geodesic_remeshing/internal/Deviation_cost.h>
#include <CGAL/Geodesic_remeshing/internal/Deviations.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

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
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_badness(badness), m_deviations(remeshed, nearest),
      m_cost(remeshed, nearest, m_deviations)
  {}

  // Works at the largest deviations, so many times, but not at what is below the least: on a plane that is rounding.
  void run(std::size_t number_of_trials, double least);

private:
  using Spot = Remeshed_surface::Spot;

  bool better_vertex(Index v, double unit);

  Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const double m_badness;
  const Deviations m_deviations;
  Deviation_cost m_cost;
};

// Tries steps along the edges, long ones first, as long as they help.
inline bool Deviation_descent::better_vertex(const Index v, const double unit)
{
  if(m_remeshed.is_fixed(v) || m_remeshed.is_on_line(v))
    return false;
  constexpr std::array<double, 3> steps = {{.2, .08, .03}};
  constexpr int rounds = 3;
  constexpr double least_gain = .05;
  const Vertex_ring ring(m_remeshed, v);
  m_cost.gather(v, ring);
  const double limit = (std::max)(m_badness, ring.badness());
  double best = m_cost(ring, m_remeshed.spot(v), unit, infinity);
  bool has_moved = false, goes_on = true;
  for(int round = 0; round < rounds && goes_on; ++round)
  {
    const double before = best;
    for(const double step : steps)
      for(std::size_t i = 0; i < ring.size(); ++i)
      {
        const Spot spot = m_remeshed.spot_after(v, step * (ring[i].point - m_remeshed.spot(v).point));
        const double c = ring.badness(spot, limit) <= limit ? m_cost(ring, spot, unit, best) : infinity;
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
