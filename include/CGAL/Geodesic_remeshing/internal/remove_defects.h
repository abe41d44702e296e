// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REMOVE_DEFECTS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REMOVE_DEFECTS_H

#include <CGAL/Geodesic_remeshing/internal/Defect_moves.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/quadric_relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

enum class Sweeps { first, last };

// The steps between the first sweeps make the mesh even, those between the last keep to the surface. Short steps need
// both each time; long ones one kind, as in turn either takes back a part of what the other did.
inline void step_after_sweep(Remeshed_surface& remeshed, const Sweeps sweeps, const std::vector<Quadric>& planes)
{
  const bool does_both = !takes_long_steps(remeshed);
  flip_to_regular_valences(remeshed);
  if(does_both || sweeps == Sweeps::first)
    relax(remeshed);
  if(does_both)
    flip_to_regular_valences(remeshed);
  if(does_both || sweeps == Sweeps::last)
    relax_with_quadrics(remeshed, planes);
}

// Where limbs and spikes are thinner than edges are long, most vertices are irregular and no flips leave good angles.
inline bool are_most_irregular(const Remeshed_surface& remeshed)
{
  const Lean_triangulation& table = remeshed.connectivity();
  std::size_t number = 0;
  for(Lean_triangulation::Index v = 0; v < table.vertex_slots(); ++v)
    number += !table.is_removed(v) && remeshed.energy().is_irregular(v);
  return 2 * number > table.number_of_vertices();
}

// Sweeps of defect moves until they gain next to nothing, since each costs steps over the whole mesh. The
// short ways come first: a pair that glides far leaves the mesh sheared along its way, so the steps between the sweeps
// are what the angles live on.
template <class Progress>
bool remove_defects(Remeshed_surface& remeshed, Defect_moves&& moves, const Sweeps which,
                    const std::vector<Quadric>& planes, const Progress& go_on)
{
  constexpr std::size_t sweeps = 6, last_depth = 12;
  const int least_gain = static_cast<int>(remeshed.connectivity().number_of_vertices() / 200);
  for(std::size_t i = 0; i < sweeps; ++i)
  {
    const std::size_t depth = (std::min)((which == Sweeps::first ? 4 : 8) + 4 * i, last_depth);
    const int gain = moves.sweep(depth);
    step_after_sweep(remeshed, which, planes);
    if(!go_on(static_cast<double>(i + 1) / sweeps))
      return false;
    if(gain <= least_gain && (depth == last_depth || are_most_irregular(remeshed)))
      break;
  }
  return true;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REMOVE_DEFECTS_H
