// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FRONT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FRONT_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How a front is bent where nothing is known of it yet: around a point source, or like a curve that it left.
enum class Front_shape { circular, planar };

// What is known where a front has passed the end of an edge: its distance, and the angle between the edge and the
// shortest path back to the source, positive on the side that the front comes from; infinite if unknown.
struct Front_at_end
{
  double distance;
  double angle;
};

// A front that has come to a vertex: its distance, and how far the way back turns from the side to which it is told.
struct Arrival
{
  double distance = infinity;
  double turn = 0.;
};

// A triangle laid into the plane: a at the origin, b at (base, 0), the apex at (x, y) with y >= 0.
struct Flat_triangle
{
  Flat_triangle(double base, double side_a, double side_b)
    : base(base), x(((side_a - side_b) * (side_a + side_b) + base * base) / (2. * base)),
      y(std::sqrt((std::max)(0., (side_a - x) * (side_a + x))))
  {}

  // between the side from the apex to a and a direction from the apex
  double angle_at_apex(double to_x, double to_y) const
  {
    return std::atan2(std::abs(x * to_y - y * to_x), -x * to_x - y * to_y);
  }

  double base, x, y;
};

// The front is a circle about a virtual source below the base, which lies where both ends have their distance from it;
// `offset` is the distance that the virtual source itself has from the true one.
inline Arrival circular_arrival(const Flat_triangle& t, double from_a, double from_b, double offset)
{
  const double radius_a = from_a - offset;
  const double radius_b = from_b - offset;
  const double source_x = ((radius_a - radius_b) * (radius_a + radius_b) + t.base * t.base) / (2. * t.base);
  const double square = (radius_a - source_x) * (radius_a + source_x);
  if(!(square >= 0.))
    return Arrival();
  const double depth = std::sqrt(square);
  const double crossing = source_x * t.y + t.x * depth; // of the base, by the path, times the height of both triangles
  if(!(0. <= crossing && crossing <= t.base * (t.y + depth)))
    return Arrival();
  const double to_x = source_x - t.x;
  const double to_y = -depth - t.y;
  return {offset + std::sqrt(to_x * to_x + to_y * to_y), t.angle_at_apex(to_x, to_y)};
}

// The front is a line, or close to one: the paths through a and b turn by `turning` against each other.
inline Arrival planar_arrival(const Flat_triangle& t, double from_a, double from_b, double turning)
{
  const double slope_x = (from_b - from_a) / t.base;
  if(!(std::abs(slope_x) < 1.))
    return Arrival();
  const double slope_y = std::sqrt((1. - slope_x) * (1. + slope_x));
  const double crossing = t.x - t.y * slope_x / slope_y;
  if(!(0. <= crossing && crossing <= t.base))
    return Arrival();
  const double sagitta = 0.5 * turning * slope_y * crossing * (1. - crossing / t.base);
  return {from_a + slope_x * t.x + slope_y * t.y - sagitta, t.angle_at_apex(-slope_x, -slope_y)};
}

// A front that enters a triangle through its base comes to the apex (nothing if it does not pass between the ends of
// the base). The turn is told from the side to a.
//
// A front is bent by all the curvature that it has passed: 1 / distance, Kimmel and Sethian's virtual source, is its
// curvature only in the plane. But the angle between the paths that pass the two ends is that curvature, exactly,
// whatever the surface was in between; it is taken from the directions of the paths, and makes the error ten times
// smaller (and right behind saddles, where fronts start anew).
template <Front_shape shape>
Arrival arrive_across(const Front_at_end& a, const Front_at_end& b, double base, double side_a, double side_b)
{
  // Turnings that are smaller than this are a bend so slight that the sagitta says it to 1e-10 of the base; those of
  // paths that come together faster than `most_converging` are of two fronts that meet, not of one.
  constexpr double least_turning = 1e-3;
  constexpr double most_converging = -0.3;

  if(!(base > 0.))
    return Arrival();
  const Flat_triangle t(base, side_a, side_b);
  const double turning = CGAL_PI - a.angle - b.angle;
  if(!(turning > -infinity))
    return shape == Front_shape::circular && a.distance >= 0. && b.distance >= 0.
               ? circular_arrival(t, a.distance, b.distance, 0.)
               : planar_arrival(t, a.distance, b.distance, 0.);
  if(turning > least_turning && a.angle > 0. && b.angle > 0.)
  {
    // where the two paths meet, by the law of sines; rounding and the curvature between them leave two offsets
    const double diameter = base / std::sin(turning);
    const double radius_a = diameter * std::sin(b.angle);
    const double radius_b = diameter * std::sin(a.angle);
    const double offset = 0.5 * ((a.distance - radius_a) + (b.distance - radius_b));
    if(offset <= (std::min)(a.distance, b.distance))
      return circular_arrival(t, a.distance, b.distance, offset);
  }
  return planar_arrival(t, a.distance, b.distance, (std::max)(most_converging, (std::min)(turning, -most_converging)));
}

// A front that comes to the end of an edge from its beginning. It does so only if the way back goes on along the edge,
// or ends there, or turns there around a saddle vertex; else this is a bound for a front that has not come yet, and its
// direction is known no better than the surface is flat: not at all if the turn is large.
template <Front_shape shape>
Arrival arrive_along(const Front_at_end& begin, double length)
{
  constexpr double large_turn = 0.3;

  if(!(begin.angle < infinity))
  {
    const bool is_source = !(begin.distance > 0.);
    return {begin.distance + length, is_source ? 0. : infinity};
  }
  const double angle = std::abs(begin.angle);
  if(angle < CGAL_PI - large_turn)
    return {begin.distance + length, infinity};
  const double turn = shape == Front_shape::planar
                          ? CGAL_PI - angle
                          : std::atan2((std::max)(0., begin.distance) * std::sin(angle),
                                       length - (std::max)(0., begin.distance) * std::cos(angle));
  return {begin.distance + length, begin.angle < 0. ? -turn : turn};
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FRONT_H
