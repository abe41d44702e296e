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
#include <CGAL/Geodesic_remeshing/internal/squared_distance_to_segment.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline double squared_distance_to_triangle(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const Vector normal = cross_product(b - a, c - a);
  const auto is_left = [&](const Point& from, const Point& to) {
    return cross_product(to - from, p - from) * normal >= 0.;
  };
  if(normal.squared_length() > 0. && is_left(a, b) && is_left(b, c) && is_left(c, a))
    return CGAL::square((p - a) * normal) / normal.squared_length();
  return (std::min)({squared_distance_to_segment(p, a, b), squared_distance_to_segment(p, b, c),
                     squared_distance_to_segment(p, c, a)});
}

// Of a point from the triangles around v. No more than something below the limit where it is below the limit.
inline double squared_distance_to_ring(const Remeshed_surface& remeshed, const Point& p,
                                       const Lean_triangulation::Index v, const double limit)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const Lean_triangulation::Index first = table.halfedge(v);
  Lean_triangulation::Index h = first;
  double least = infinity;
  do
  {
    least =
        (std::min)(least, squared_distance_to_triangle(p, remeshed.spot(v).point, remeshed.spot(table.target(h)).point,
                                                       remeshed.spot(table.apex(h)).point));
    h = table.rotate(h);
  } while(h != first && h != Lean_triangulation::none && least > limit);
  return least;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DISTANCE_TO_RING_H
