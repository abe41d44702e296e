// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_RELAXATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_RELAXATION_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Steps that make no angle smaller than this one need not ask whether they make one smaller than it was: angles up to here
// may be spent on evenness, which pays back in the mean.
inline double tolerated_badness()
{
  static const double badness = badness_of_angle(36.);
  return badness;
}

// Moves a vertex the given way: whole, or if this spoils the ring by .4 or .16 of it.
inline void try_way(Remeshed_surface& remeshed, const Lean_triangulation::Index v, Vector way)
{
  const Remeshed_surface::Spot old = remeshed.spot(v);
  const double limit = (std::max)(remeshed.ring_badness(v), tolerated_badness());
  for(int trial = 0; trial < 3; ++trial, way = .4 * way) {
    remeshed.put(v, remeshed.spot_after(v, way));
    if(remeshed.ring_badness(v) <= limit)
      return;
    remeshed.put(v, old);
  }
}

inline void relax_vertex(Remeshed_surface& remeshed, const Lean_triangulation::Index v)
{
  try_way(remeshed, v, remeshed.way_to_center_of_neighbors(v));
}

inline void relax(Remeshed_surface& remeshed)
{
  const Lean_triangulation& table = remeshed.connectivity();
  for(Lean_triangulation::Index v = 0; v < table.vertex_slots(); ++v)
    if(!table.is_removed(v) && !remeshed.is_fixed(v))
      relax_vertex(remeshed, v);
}

// Flips that lower the energy of the valences, as long as no angle falls below what relaxation mends, and none that turns
// a face. Those that leave the energy as it is are made where they better the angles. Returns their number.
inline std::size_t flip_to_regular_valences(Remeshed_surface& remeshed)
{
  static const double mendable = badness_of_angle(15.);
  Lean_triangulation& table = remeshed.connectivity();
  std::size_t flips = 0;
  for(Lean_triangulation::Index h = 0; h < 4 * table.face_slots(); ++h) {
    if((h & 3) == 3 || table.is_removed_face(table.face(h)))
      continue;
    const Lean_triangulation::Index o = table.opposite(h);
    if(table.is_constrained(h) || o < h)
      continue;
    const int energy = remeshed.energy_of_flip(h);
    if(energy > 0 || !table.is_flip_legal(h))
      continue;
    const auto a = table.source(h), b = table.target(h), c = table.apex(h), d = table.apex(o);
    const double before = add_badness(remeshed.badness(a, b, c), remeshed.badness(b, a, d));
    const double after = add_badness(remeshed.badness(a, d, c), remeshed.badness(b, c, d));
    if(energy < 0 ? after <= (std::max)(before, mendable) : after < before) {
      table.flip(h);
      ++flips;
    }
  }
  return flips;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_RELAXATION_H
