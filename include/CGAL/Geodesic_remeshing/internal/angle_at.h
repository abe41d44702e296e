// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_ANGLE_AT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_ANGLE_AT_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <cmath>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The sum of the angles of the faces at a vertex
inline double angle_at(const Mesh& mesh, Vertex v)
{
  double sum = 0.;
  for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    if(mesh.is_border(h))
      continue;
    const Vector a(mesh.point(v), mesh.point(mesh.source(h))), b(mesh.point(v), mesh.point(mesh.target(mesh.next(h))));
    sum += std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  }
  return sum;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_ANGLE_AT_H
