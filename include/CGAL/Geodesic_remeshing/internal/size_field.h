// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SIZE_FIELD_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SIZE_FIELD_H

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/numbers_in_messages.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// From the lengths that the user wishes, up to a factor, to those that edges are to have: the factor found by the
// number of vertices, no length below the smallest or above the largest, none growing faster than the gradation allows.
class Size_field
{
public:
  Size_field(const Mesh& surface, std::vector<double> wishes, const Sizing_limits& limits)
    : m_surface(surface), m_wishes(std::move(wishes)), m_limits(limits)
  {}

  // The length at each vertex for this factor
  std::vector<double> lengths(double factor)
  {
    std::vector<double> result = m_wishes;
    for(double& length : result)
      length = (std::min)((std::max)(factor * length, m_limits.minimum_length), m_limits.maximum_length);
    if(grows_too_fast(result))
      limit_growth(result);
    return result;
  }

  // The length at each vertex so that the mesh has this number of vertices, to one percent: more exactly the limits are
  // not kept by any mesh. By the secant of the logarithms, between which the number is nearly a straight line; halving
  // what is left where the secant leaves it, as where a single tiny wish and the gradation make most of the number.
  std::vector<double> lengths_for_number(double number)
  {
    double factor = std::sqrt(number_of_vertices(m_wishes) / number), exponent = -2.;
    double last_factor = 0., last_number = 0., low = 0., high = infinity; // factors that give too many and too few
    for(int i = 0; i < 60; ++i)
    {
      std::vector<double> result = lengths(factor);
      const double n = number_of_vertices(result);
      if(std::abs(n - number) < .01 * number)
        return result;
      if(i > 0 && std::abs(std::log(n / last_number)) > 1e-6)
        exponent = (std::min)((std::max)(std::log(n / last_number) / std::log(factor / last_factor), -2.), -.5);
      last_factor = factor;
      last_number = n;
      (n > number ? low : high) = factor;
      factor *= std::pow(number / n, 1. / exponent);
      if(low > 0. && high < infinity && !(low < factor && factor < high))
        factor = std::sqrt(low * high);
    }
    fail(number);
  }

  // Equilateral triangles of edge length l have 2 / (sqrt(3) l l) vertices for each unit of area.
  double number_of_vertices(const std::vector<double>& lengths) const
  {
    double sum = 0.;
    for(Face f : m_surface.faces())
    {
      const auto v = vertices_of(m_surface, f);
      sum += std::sqrt(CGAL::squared_area(m_surface.point(v[0]), m_surface.point(v[1]), m_surface.point(v[2]))) *
             mean_of_inverse_squares({{lengths[v[0]], lengths[v[1]], lengths[v[2]]}});
    }
    return 2. / std::sqrt(3.) * sum;
  }

  // The mean of 1 / (l l) over a triangle on which l changes linearly
  static double mean_of_inverse_squares(std::array<double, 3> l)
  {
    std::sort(l.begin(), l.end());
    if(l[2] < 1.5 * l[0]) // by the middles of the edges, to four digits
      return 4. / 3. *
             (1. / CGAL::square(l[0] + l[1]) + 1. / CGAL::square(l[1] + l[2]) + 1. / CGAL::square(l[2] + l[0]));
    // exactly, but with a difference that cancels for nearly equal lengths: the second divided difference of -log
    // (Hermite and Genocchi)
    const auto slope = [](double a, double b) {
      return b - a > 1e-9 * a ? -std::log1p((b - a) / a) / (b - a) : -1. / a;
    };
    return 2. * (slope(l[1], l[2]) - slope(l[0], l[1])) / (l[2] - l[0]);
  }

private:
  bool grows_too_fast(const std::vector<double>& lengths) const
  {
    const Metric metric(m_surface);
    for(Edge e : m_surface.edges())
      if(std::abs(lengths[m_surface.vertex(e, 0)] - lengths[m_surface.vertex(e, 1)]) >
         m_limits.gradation * metric.length(e))
        return true;
    return false;
  }

  // A length may be no more than any other plus the gradation times the distance from there. These are the distances
  // from all vertices at once, each beginning at its own length: one march.
  void limit_growth(std::vector<double>& lengths)
  {
    if(!m_triangulation)
      m_triangulation.emplace(m_surface);
    Fast_marching marching(*m_triangulation);
    for(Vertex v : m_surface.vertices())
      marching.add_source(v, lengths[v] / m_limits.gradation);
    marching.march(Front_shape::planar);
    for(Vertex v : m_surface.vertices())
      lengths[v] = (std::min)(lengths[v], m_limits.gradation * marching.distance(v));
  }

  [[noreturn]] void fail(double number)
  {
    const auto number_with = [&](double length) {
      return length > 0. && length < infinity
                 ? whole_number(number_of_vertices(std::vector<double>(m_wishes.size(), length)))
                 : "";
    };
    const std::string fewest = number_with(m_limits.maximum_length), most = number_with(m_limits.minimum_length);
    const std::string message =
        fewest.empty() && most.empty()
            ? "lengths that differ as much as those of the sizing cannot be scaled to " + whole_number(number) +
                  " vertices"
            : whole_number(number) + " vertices are not within the limits of the sizing: its lengths allow" +
                  (fewest.empty() ? "" : " no fewer than about " + fewest) +
                  (fewest.empty() || most.empty() ? "" : " and") + (most.empty() ? "" : " no more than about " + most);
    throw Remeshing_error("geodesic remeshing: " + message);
  }

  const Mesh& m_surface;
  const std::vector<double> m_wishes;
  const Sizing_limits m_limits;
  std::optional<Intrinsic_triangulation> m_triangulation;
};

inline void check_limits(const Sizing_limits& limits)
{
  if(!(limits.gradation > 0.))
    reject("the gradation must be positive");
  if(!(limits.minimum_length >= 0.) || !(limits.maximum_length > 0.))
    reject("the smallest and the largest length must be positive");
  if(!std::isfinite(limits.minimum_length))
    reject("the smallest length must be finite");
  if(!(limits.minimum_length <= limits.maximum_length))
    reject("the smallest length is above the largest");
}

// By a power of two, which rounds nothing: where only the ratios count, lengths near to one can be computed with.
inline std::vector<double> scaled_to_one(std::vector<double> lengths)
{
  const int exponent = std::ilogb(*std::max_element(lengths.begin(), lengths.end()));
  for(double& length : lengths)
    length = std::scalbn(length, -exponent);
  return lengths;
}

// What a remeshing aims at
struct Goal
{
  std::size_t number_of_vertices;
  double mean_edge_length; // that of a uniform mesh with so many vertices
};

// Finds out what a target means on this surface, and makes the wished lengths, where there are any, the metric of the
// surface.
inline Goal set_goal(const Any_target& target, const std::vector<double>& wishes, const Sizing_limits& limits,
                     Mesh& surface)
{
  const auto goal = [&](std::size_t n) { return Goal{n, edge_length_for(area(surface), n)}; };
  if(wishes.empty())
    return goal(number_of_vertices_for(target, surface));
  check_limits(limits);
  const Edge_length* const length = std::get_if<Edge_length>(&target);
  Size_field field(surface, length != nullptr ? wishes : scaled_to_one(wishes), limits);
  std::vector<double> lengths;
  Goal result;
  if(length != nullptr)
  {
    check_length(length->value);
    lengths = field.lengths(length->value);
    result = goal(rounded_number_of_vertices(field.number_of_vertices(lengths)));
  }
  else
  {
    result = goal(number_of_vertices_for(target, surface));
    lengths = field.lengths_for_number(static_cast<double>(result.number_of_vertices));
  }
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  if(!(*shortest < *longest)) // no sizing: improved for its angles alone
    return result;
  const auto density = add_density(surface);
  for(Vertex v : surface.vertices())
    density[v] = result.mean_edge_length / lengths[v];
  return result;
}

// The area of a face in the metric
inline double area(const Mesh& mesh, const Metric& metric, Face f)
{
  if(metric.is_uniform())
    return area(mesh, f);
  const auto v = vertices_of(mesh, f);
  return area(mesh, f) *
         Size_field::mean_of_inverse_squares({{metric.size(v[0]), metric.size(v[1]), metric.size(v[2])}});
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SIZE_FIELD_H
