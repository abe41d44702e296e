// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIND_MIDDLE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIND_MIDDLE_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/internal/walk_into.h>

#include <utility>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where to divide an edge: on its line if it is on one. Returns whether there is such a place.
inline bool find_middle(const Remeshed_surface& remeshed, const Lean_triangulation::Index h,
                        Remeshed_surface::Spot& middle)
{
  using Index = Lean_triangulation::Index;
  const Lean_triangulation& table = remeshed.connectivity();
  const Surface_walker& walker = remeshed.walker();
  Index from = table.source(h), to = table.target(h), beside = to;
  if(table.is_constrained(h))
  {
    if(remeshed.keeps_lines())
      return false;
    if(remeshed.is_fixed(from))
      std::swap(from, to);
    remeshed.for_each_neighbor_on_line(from, [&](const Index w) { beside = w == to ? beside : w; });
    const Place place =
        remeshed.lines().middle(remeshed.spot(from).place, remeshed.spot(to).place, remeshed.spot(beside).place);
    if(place.face.is_valid())
      middle = remeshed.spot_on_line(place);
    return place.face.is_valid();
  }
  const Remeshed_surface::Spot& start = remeshed.spot(from);
  const Place place = walk_into(walker, start.place, .5 * (remeshed.spot(to).point - start.point));
  middle = {walker.point(place), place, walker.normal(place.face), remeshed.metric().size(place)};
  return true;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIND_MIDDLE_H
