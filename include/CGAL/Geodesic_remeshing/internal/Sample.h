// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A vertex of the mesh to come
struct Sample
{
  Face face;   // of the working surface, where the search for its place in it begins
  Place place; // on the input surface
  Point point;
  double size;                // of the mesh there, relative to the mean, see Metric
  bool is_pinned;             // corners, the root and the tips stay where they are
  int region, level;          // of its curve; level 0: on a top, a bridge, the root; region -1: on a line
  Vertex vertex = Vertex();   // of the working surface, where it must be this one
  Halfedge line = Halfedge(); // of the working surface, where it must lie on this one
  double distance_from_lines = infinity;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_H
