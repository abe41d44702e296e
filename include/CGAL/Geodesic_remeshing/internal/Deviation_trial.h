// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_TRIAL_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_TRIAL_H

#include <CGAL/Geodesic_remeshing/internal/Deviation_cost.h>
#include <CGAL/Geodesic_remeshing/internal/Deviations.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Moves the vertices of a face to where the deviations around them are least, as far as the angles allow it. Looks at
// nothing but vertices up to two edges from them.
class Deviation_trial
{
public:
  using Index = Lean_triangulation::Index;

  // `nearest` may be that of some steps ago. No triangle gets worse than `badness` that is not.
  Deviation_trial(Remeshed_surface& remeshed, const Nearest_vertices& nearest, const Deviations& deviations,
                  const double badness)
    : m_remeshed(remeshed), m_badness(badness), m_cost(remeshed, nearest, deviations)
  {}

  // `unit` is a squared distance. Returns whether a vertex has moved.
  bool run(const Index f, const double unit)
  {
    bool has_moved = false;
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      has_moved = better_vertex(m_remeshed.connectivity().source(h), unit) || has_moved;
    return has_moved;
  }

private:
  using Spot = Remeshed_surface::Spot;

  bool better_vertex(Index v, double unit);

  Remeshed_surface& m_remeshed;
  const double m_badness;
  Deviation_cost m_cost;
};

// Tries steps along the edges, long ones first, as long as they help.
inline bool Deviation_trial::better_vertex(const Index v, const double unit)
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

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_TRIAL_H
