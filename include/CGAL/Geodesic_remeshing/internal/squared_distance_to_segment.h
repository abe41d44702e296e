// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SQUARED_DISTANCE_TO_SEGMENT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SQUARED_DISTANCE_TO_SEGMENT_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline double squared_distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const Vector ab = b - a, ap = p - a;
  const double length = ab.squared_length();
  const double t = length > 0. ? (std::min)((std::max)(ap * ab / length, 0.), 1.) : 0.;
  return (ap - t * ab).squared_length();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SQUARED_DISTANCE_TO_SEGMENT_H
