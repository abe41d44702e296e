// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_COMPONENT_EXTENT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_COMPONENT_EXTENT_H

#include <CGAL/Geodesic_remeshing/internal/Component_numbers.h>
#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>
#include <CGAL/Geodesic_remeshing/internal/size_field.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How near to a line, in edge lengths, a curve may have samples: a row of samples on a line needs its own room.
constexpr double room_beside_lines = .5;

// A connected component of the input, as far as it matters for the number of vertices that it gets. Lengths and areas
// are those of the metric.
struct Extent
{
  double area = 0., boundary = 0., sides_of_lines = 0.; // one on the boundary, else two
  std::ptrdiff_t euler_characteristic = 0;
  std::size_t boundary_loops = 0, corners = 0;

  // Every loop needs three vertices of its own. With the loops filled in, the surface would be a closed one with
  // at most a vertex more for each.
  std::size_t fewest() const
  {
    const std::ptrdiff_t loops = static_cast<std::ptrdiff_t>(boundary_loops);
    const std::size_t filled = fewest_vertices(euler_characteristic + loops);
    return (std::max)({filled - (std::min)(boundary_loops, filled), 3 * boundary_loops, corners});
  }

  // That triangles with this edge length have: a vertex for each sqrt(3)/2 e^2, and half a vertex more for each
  // edge of the boundary
  double wanted(double edge_length) const
  {
    return 2. * area / (std::sqrt(3.) * edge_length * edge_length) + .5 * boundary / edge_length;
  }

  // The same for curves at this distance: where they end before a line there is a little more room than between rows
  // of triangles.
  double wanted_of_curves(double edge_length) const
  {
    const double rows = 2. / std::sqrt(3.) * room_beside_lines - .5;
    const double inside = 2. * area / (std::sqrt(3.) * edge_length * edge_length);
    return wanted(edge_length) - (std::min)(rows * sides_of_lines / edge_length, .2 * inside);
  }
};

inline std::vector<std::uint32_t> components_of(const Mesh& mesh, std::size_t& number)
{
  Component_numbers components(mesh.number_of_vertices());
  for(Edge e : mesh.edges())
    components.join(mesh.vertex(e, 0), mesh.vertex(e, 1));
  return components.take(number);
}

// The lines are marked.
inline std::vector<Extent> extents_of_components(const Mesh& mesh, const Constraints& constraints)
{
  const auto is_line = lines_of(mesh);
  std::size_t number;
  const std::vector<std::uint32_t> component_of = components_of(mesh, number);
  std::vector<Extent> extents(number);
  const Metric metric(mesh);
  for(Vertex v : mesh.vertices())
  {
    Extent& extent = extents[component_of[v]];
    ++extent.euler_characteristic;
    extent.corners += v.idx() < constraints.is_corner.size() && constraints.is_corner[v.idx()] != 0;
  }
  for(Edge e : mesh.edges())
  {
    Extent& extent = extents[component_of[mesh.vertex(e, 0)]];
    --extent.euler_characteristic;
    if(is_line[e])
      extent.sides_of_lines += metric.length(e) * (mesh.is_border(e) ? 1. : 2.);
  }
  for(Face f : mesh.faces())
  {
    Extent& extent = extents[component_of[mesh.target(mesh.halfedge(f))]];
    ++extent.euler_characteristic;
    extent.area += area(mesh, metric, f);
  }
  std::vector<char> seen(mesh.number_of_halfedges(), 0);
  for(Halfedge h : mesh.halfedges())
  {
    if(!mesh.is_border(h) || seen[h])
      continue;
    Extent& extent = extents[component_of[mesh.target(h)]];
    ++extent.boundary_loops;
    for(Halfedge g : mesh.halfedges_around_face(h))
    {
      seen[g] = 1;
      extent.boundary += metric.length(g);
    }
  }
  return extents;
}

template <class Value>
auto sum_over(const std::vector<Extent>& extents, const Value& value)
{
  decltype(value(extents.front())) sum = 0;
  for(const Extent& e : extents)
    sum += value(e);
  return sum;
}

// A number that all components can have, as far as models have shown: three times what they need at the least. Handles
// and loops want that room, but of very many spheres and discs hardly any does.
inline std::size_t enough_vertices(const std::vector<Extent>& extents)
{
  constexpr std::size_t for_a_few = 100;
  std::size_t fewest = 0, enough = for_a_few;
  for(const Extent& e : extents)
  {
    fewest += e.fewest();
    enough += e.euler_characteristic > 0 ? e.fewest() + e.fewest() / 2 : 3 * e.fewest();
  }
  return (std::min)(3 * fewest, enough);
}

// The number of vertices of all components, each at least what it needs
template <class Wanted>
double sum_of_wanted(const std::vector<Extent>& extents, const Wanted& wanted)
{
  return sum_over(extents, [&](const Extent& e) { return (std::max)(static_cast<double>(e.fewest()), wanted(e)); });
}

// The edge length at which the components together want this number of vertices: what small ones take more than their
// share the others have less.
template <class Wanted>
double edge_length_for(const std::vector<Extent>& extents, std::size_t vertices, const Wanted& wanted)
{
  const double by_area = edge_length_for(sum_over(extents, [](const Extent& e) { return e.area; }), vertices);
  const double number = static_cast<double>(vertices);
  const auto number_at = [&](double edge_length) {
    return sum_of_wanted(extents, [&](const Extent& e) { return wanted(e, edge_length); });
  };
  if(std::abs(number_at(by_area) - number) < 1e-9 * number)
    return by_area;
  double low = .5 * by_area, high = 2. * by_area;
  for(int i = 0; i < 30 && number_at(high) > number; ++i)
    high *= 2.;
  for(int i = 0; i < 50; ++i)
  {
    const double middle = .5 * (low + high);
    (number_at(middle) > number ? low : high) = middle;
  }
  return high;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_COMPONENT_EXTENT_H
