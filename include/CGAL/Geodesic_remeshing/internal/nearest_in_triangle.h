// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_IN_TRIANGLE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_IN_TRIANGLE_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The nearest point of a triangle: its barycentric coordinates, those of the edges it is on exactly zero.
struct Nearest_in_triangle
{
  std::array<double, 3> coordinates;
  Vector way; // from the nearest point to the one asked for
  double squared_distance;
};

// Of a triangle without area
inline std::array<double, 3> nearest_on_sides(const Vector& ab, const Vector& ac, const Vector& ap)
{
  const auto part = [](const Vector& way, const Vector& side) {
    const double length = side * side;
    return length > 0. ? (std::max)(0., (std::min)(1., way * side / length)) : 0.;
  };
  const double on_ab = part(ap, ab), on_ac = part(ap, ac), on_bc = part(ap - ab, ac - ab);
  const std::array<std::array<double, 3>, 3> points = {
      {{{1. - on_ab, on_ab, 0.}}, {{1. - on_ac, 0., on_ac}}, {{0., 1. - on_bc, on_bc}}}};
  const auto distance = [&](const std::array<double, 3>& c) { return (ap - c[1] * ab - c[2] * ac).squared_length(); };
  return *std::min_element(points.begin(), points.end(),
                           [&](const auto& c, const auto& d) { return distance(c) < distance(d); });
}

// By the regions of the corners, of the edges and of the inside in which the point can be.
inline std::array<double, 3> nearest_coordinates(const Vector& ab, const Vector& ac, const Vector& ap)
{
  const double d1 = ab * ap, d2 = ac * ap;
  if(d1 <= 0. && d2 <= 0.)
    return {{1., 0., 0.}};
  const double bb = ab * ab, bc = ab * ac, cc = ac * ac;
  const double d3 = d1 - bb, d4 = d2 - bc;
  if(d3 >= 0. && d4 <= d3)
    return {{0., 1., 0.}};
  const double vc = d1 * d4 - d3 * d2;
  if(bb > 0. && vc <= 0. && d1 >= 0. && d3 <= 0.)
    return {{1. - d1 / (d1 - d3), d1 / (d1 - d3), 0.}};
  const double d5 = d1 - bc, d6 = d2 - cc;
  if(d6 >= 0. && d5 <= d6)
    return {{0., 0., 1.}};
  const double vb = d5 * d2 - d1 * d6;
  if(vb <= 0. && d2 >= 0. && d6 <= 0.)
    return {{1. - d2 / (d2 - d6), 0., d2 / (d2 - d6)}};
  const double va = d3 * d6 - d5 * d4;
  if(va <= 0. && d4 >= d3 && d5 >= d6)
  {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {{0., 1. - t, t}};
  }
  const double sum = va + vb + vc; // the square of twice the area
  if(!(sum > 1e-14 * bb * cc))     // which is rounding, and so is what tells the inside
    return nearest_on_sides(ab, ac, ap);
  return {{va / sum, vb / sum, vc / sum}};
}

inline Nearest_in_triangle nearest_in_triangle(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const Vector ab = b - a, ac = c - a, ap = p - a;
  Nearest_in_triangle result;
  result.coordinates = nearest_coordinates(ab, ac, ap);
  result.way = ap - result.coordinates[1] * ab - result.coordinates[2] * ac;
  result.squared_distance = result.way.squared_length();
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_IN_TRIANGLE_H
