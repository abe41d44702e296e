// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_TARGET_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_TARGET_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/numbers_in_messages.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <variant>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// An equilateral triangulation of edge length e has 2 / sqrt(3) vertices for each e * e of area.
inline double edge_length_for(double area, std::size_t vertices)
{
  return std::sqrt(2. * area / (std::sqrt(3.) * static_cast<double>(vertices)));
}

inline double number_for_length(double area, double length)
{
  return 2. * area / (std::sqrt(3.) * length * length);
}

inline void check_scale(double edge_length)
{
  if(!(edge_length > 0.))
    reject("the surface has no area: its faces are degenerate, or too small to compute with");
  if(!is_scale_computable(edge_length))
    reject("the coordinates are too small or too large to compute with");
}

// Halfedges are numbered in 32 bits, four to a face (see Lean_triangulation): that is 2^30 faces, of which some are
// left for topology and for changes on the way.
constexpr double most_vertices = 5e8;

inline void check_not_too_many(double number, const std::string& what)
{
  if(!(number <= most_vertices))
    reject(what + " asks for " + whole_number(number) + " vertices, and more than " + whole_number(most_vertices) +
           " cannot be made");
}

inline void check_length(double length)
{
  if(!(length > 0.) || !std::isfinite(length))
    reject("the edge length must be positive and finite");
}

inline std::size_t rounded_number_of_vertices(double number)
{
  check_not_too_many(number, "the edge length is too small: it");
  return (std::max)(std::size_t(4), static_cast<std::size_t>(std::llround(number)));
}

inline std::size_t vertices_for_length(double area, double length)
{
  check_length(length);
  return rounded_number_of_vertices(number_for_length(area, length));
}

// On a surface with boundary, but for half of the vertices there: these are not known yet.
inline std::size_t vertices_for_faces(const Mesh& surface, std::size_t faces)
{
  check_not_too_many(static_cast<double>(faces / 2), "the number of faces");
  const std::ptrdiff_t vertices =
      static_cast<std::ptrdiff_t>(faces / 2) + euler_characteristic(surface); // V - E + F, and 3 F = 2 E
  if(!CGAL::is_closed(surface))
    return static_cast<std::size_t>((std::max)(std::ptrdiff_t(1), vertices));
  if(vertices < 4)
    throw Remeshing_error("geodesic remeshing: no mesh of this topology has only " + std::to_string(faces) + " faces");
  return static_cast<std::size_t>(vertices);
}

// What the user asks for
using Any_target = std::variant<std::size_t, Number_of_faces, Edge_length>;

template <class Target>
Any_target unpack_target(const Target& target)
{
  static_assert(!std::is_floating_point<Target>::value,
                "geodesic_remeshing: a number of vertices is an integer; for a length write Edge_length{...}");
  if constexpr(std::is_same<Target, Edge_length>::value)
    return target;
  else if constexpr(std::is_same<Target, Number_of_faces>::value)
  {
    if(target.value == 0)
      reject("the number of faces must be positive");
    return target;
  }
  else
  {
    static_assert(std::is_integral<Target>::value, "geodesic_remeshing: the target is a number of vertices, "
                                                   "Number_of_faces{...} or Edge_length{...}");
    if(!(target > 0))
      reject("the number of vertices must be positive");
    check_not_too_many(static_cast<double>(target), "the target");
    return static_cast<std::size_t>(target);
  }
}

// The number of vertices that a target means for this surface
inline std::size_t number_of_vertices_for(const Any_target& target, const Mesh& surface)
{
  if(const Edge_length* const length = std::get_if<Edge_length>(&target))
    return vertices_for_length(area(surface), length->value);
  if(const Number_of_faces* const faces = std::get_if<Number_of_faces>(&target))
    return vertices_for_faces(surface, faces->value);
  return std::get<std::size_t>(target);
}

// The same target again when its number of vertices is known: a length does not tell it any more once the sizing is
// another one.
inline Any_target target_again(const Any_target& target, const std::size_t number_of_vertices)
{
  return std::holds_alternative<Edge_length>(target) ? Any_target(number_of_vertices) : target;
}

// The fewest vertices that a closed surface of this Euler characteristic can be triangulated with: at most n (n - 1) /
// 2 edges fit between n vertices (Heawood), which is attained but for genus 2, where it takes ten (Jungerman, Ringel).
inline std::size_t fewest_vertices(std::ptrdiff_t euler_characteristic)
{
  if(euler_characteristic == -2)
    return 10;
  std::ptrdiff_t n = 4;
  while(n * (n - 1) / 2 < 3 * (n - euler_characteristic))
    ++n;
  return static_cast<std::size_t>(n);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TARGET_H
