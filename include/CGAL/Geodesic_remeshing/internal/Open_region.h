// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_OPEN_REGION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_OPEN_REGION_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A region between the event that begins it and the one that ends it
struct Open_region
{
  std::vector<std::pair<Vertex, double>> sources; // the top: vertices and their (signed) distances from it
  std::vector<Vertex> waiting;                    // vertices that the fronts above had to leave, see Fronts
  std::vector<Vertex> side;                       // free vertices beside the front, if another shares its bridge
  Vertex lowest;                                  // of the sources
  double offset = 0.;                             // of the top from the sources
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_OPEN_REGION_H
