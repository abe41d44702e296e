// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DISTANCE_TO_RING_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DISTANCE_TO_RING_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/nearest_in_triangle.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Of a point from the triangles around v; where that is below the limit some value below it, perhaps not the least.
inline double squared_distance_to_ring(const Remeshed_surface& remeshed, const Point& p,
                                       const Lean_triangulation::Index v, const double limit)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const Lean_triangulation::Index first = table.halfedge(v);
  Lean_triangulation::Index h = first;
  double least = infinity;
  do
  {
    least = (std::min)(least, nearest_in_triangle(p, remeshed.spot(v).point, remeshed.spot(table.target(h)).point,
                                                  remeshed.spot(table.apex(h)).point)
                                  .squared_distance);
    h = table.rotate(h);
  } while(h != first && h != Lean_triangulation::none && least > limit);
  return least;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DISTANCE_TO_RING_H
