// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_DISTANCE_TO_SURFACE_H
#define GEODESIC_REMESHING_TEST_DISTANCE_TO_SURFACE_H

#include "test_support.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>

namespace support {

// Of the vertices of a mesh from a surface
inline double largest_distance(const Mesh& mesh, const Mesh& surface)
{
  using Kernel = CGAL::Kernel_traits<Point>::Kernel;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  const auto all = faces(surface);
  CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> tree(all.begin(), all.end(), surface);
  double largest = 0.;
  for(Vertex v : mesh.vertices())
    largest = (std::max)(largest, tree.squared_distance(mesh.point(v)));
  return std::sqrt(largest);
}

} // namespace support

#endif // GEODESIC_REMESHING_TEST_DISTANCE_TO_SURFACE_H
