// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_COST_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_COST_H

#include <CGAL/Geodesic_remeshing/internal/nearest_in_triangle.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What a deviation costs: its square, and well above the tolerance much more, so that the few large ones, of which the
// Hausdorff distance is one, are worked at as well as the many small ones.
class Fit_cost
{
public:
  void set_tolerance(const double tolerance)
  {
    m_inverse_tolerance = tolerance > 0. ? 1. / CGAL::square(tolerance) : 0.;
  }

  template <class Foot>
  double operator()(const Foot& foot) const
  {
    return of(foot.nearest.squared_distance) + foot.penalty();
  }
  double of(const double squared_distance) const
  {
    const double x = squared_distance * m_inverse_tolerance;
    return squared_distance * (1. + x * x);
  }
  // The weight with which a sum of squares has the same slope
  template <class Foot>
  double weight(const Foot& foot) const
  {
    const double x = foot.nearest.squared_distance * m_inverse_tolerance;
    return 1. + 3. * x * x;
  }

private:
  double m_inverse_tolerance = 0.;
};

// The step of a vertex at which a sum of squared lengths is the least, each that of a difference along a direction.
struct Fit_system
{
  double xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0.;
  Vector right = Vector(0., 0., 0.);

  void add_square(const Vector& u, const double weight)
  {
    xx += weight * u.x() * u.x();
    xy += weight * u.x() * u.y();
    xz += weight * u.x() * u.z();
    yy += weight * u.y() * u.y();
    yz += weight * u.y() * u.z();
    zz += weight * u.z() * u.z();
  }

  // A deviation along the way to the nearest point, which the step changes by a share, the vertex' coordinate there. It
  // is the nearest point that moves (sign 1) or the point it is nearest to (-1).
  void add(const Nearest_in_triangle& nearest, const double sign, const double weight, const double share)
  {
    if(!(nearest.squared_distance > 0.))
      return;
    add_square(nearest.way, weight * share * share / nearest.squared_distance);
    right = right + sign * weight * share * nearest.way;
  }

  // A way to be gone, as far as it is in the plane of a normal.
  void add_in_plane(const Vector& way, const Vector& normal, const double weight)
  {
    xx += weight;
    yy += weight;
    zz += weight;
    add_square(normal, -weight);
    right = right + weight * (way - (way * normal) * normal);
  }

  Vector least() const
  {
    const double p = yy * zz - yz * yz, q = yz * xz - xy * zz, r = xy * yz - yy * xz;
    const double s = xx * zz - xz * xz, t = xy * xz - xx * yz, u = xx * yy - xy * xy;
    const double determinant = xx * p + xy * q + xz * r;
    return Vector(p * right.x() + q * right.y() + r * right.z(), q * right.x() + s * right.y() + t * right.z(),
                  r * right.x() + t * right.y() + u * right.z()) /
           determinant;
  }
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_COST_H
