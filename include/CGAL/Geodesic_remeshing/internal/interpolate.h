// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INTERPOLATE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INTERPOLATE_H

#include <CGAL/Dimension.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

using Barycentric_coordinates = std::array<double, 3>;

template <class FT>
Barycentric_coordinates in_doubles(const std::array<FT, 3>& coordinates)
{
  return {{CGAL::to_double(coordinates[0]), CGAL::to_double(coordinates[1]), CGAL::to_double(coordinates[2])}};
}

// Can be scaled and added, with something of the kind as the result: labels that convert to numbers, as enumerators and
// the descriptors of a mesh, give numbers.
template <class T, class = void>
struct is_vector : std::false_type
{};
template <class T>
struct is_vector<T, std::void_t<decltype(.5 * std::declval<const T&>() + .5 * std::declval<const T&>())>>
  : std::bool_constant<
        !std::is_arithmetic<decltype(.5 * std::declval<const T&>() + .5 * std::declval<const T&>())>::value>
{};

template <class T, class = void>
struct is_point : std::false_type
{};
template <class T>
struct is_point<T, std::enable_if_t<is_vector<decltype(std::declval<const T&>() - CGAL::ORIGIN)>::value>>
  : std::true_type
{};

template <class T>
struct is_array_of_numbers : std::false_type
{};
template <class T, std::size_t n>
struct is_array_of_numbers<std::array<T, n>> : std::is_floating_point<T>
{};

// The value at barycentric coordinates over a triangle with these values at its corners: a mean where there is such a
// thing, the value of the corner with the largest coordinate where there is not.
template <class Value, class T>
Value interpolate(const T& a, const T& b, const T& c, const Barycentric_coordinates& at)
{
  if constexpr(std::is_same<Value, CGAL::IO::Color>::value)
  {
    const auto channel = [&](int i) {
      return static_cast<unsigned char>(std::lround(at[0] * a[i] + at[1] * b[i] + at[2] * c[i]));
    };
    return Value(channel(0), channel(1), channel(2), channel(3));
  }
  else if constexpr(is_array_of_numbers<Value>::value)
  {
    Value result = a;
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = static_cast<typename Value::value_type>(at[0] * a[i] + at[1] * b[i] + at[2] * c[i]);
    return result;
  }
  else if constexpr(std::is_floating_point<Value>::value || is_vector<Value>::value)
    return static_cast<Value>(at[0] * a + at[1] * b + at[2] * c);
  else if constexpr(!std::is_arithmetic<Value>::value && is_point<Value>::value)
    return a + (at[1] * (b - a) + at[2] * (c - a));
  else
    return at[0] >= at[1] && at[0] >= at[2] ? a : at[1] >= at[2] ? b : c;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INTERPOLATE_H
