// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_BADNESS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_BADNESS_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The badness of a triangle is the squared cotangent of its smallest angle: it grows as the angle shrinks and costs one
// division and no root. That of a triangle turned against the surface is above that of any other.
constexpr double turned_badness = 1e15, worst_badness = 1e12;

inline double badness_of_angle(const double degrees)
{
  return CGAL::square(1. / std::tan(degrees * (CGAL_PI / 180.)));
}

// The worse of two sets of triangles is that with more turned ones; of sets with none it is that with the smaller
// angle.
inline double add_badness(const double x, const double y)
{
  return y >= turned_badness ? x + y : (std::max)(x, y);
}

// The smallest angle is opposite the shortest edge; the scalar product of the edges there is (sum of squares)/2 -
// shortest square.
inline double product_at_smallest_angle(const double x, const double y, const double z)
{
  return (x + y + z) / 2. - (std::min)((std::min)(x, y), z);
}

// Of a triangle by the squares of its edges and of twice its area.
inline double triangle_badness(const double x, const double y, const double z, const double area)
{
  const double product = product_at_smallest_angle(x, y, z);
  return product * product < worst_badness * area ? product * product / area : worst_badness;
}

// Whether it is below a limit; without a division.
inline bool is_badness_below(const double limit, const double x, const double y, const double z, const double area)
{
  const double product = product_at_smallest_angle(x, y, z);
  return product * product < limit * area;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_BADNESS_H
