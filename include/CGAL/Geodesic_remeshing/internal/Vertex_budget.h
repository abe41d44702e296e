// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_BUDGET_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_BUDGET_H

#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/size_field.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A connected component of the input, as far as it matters for the number of vertices that it gets. Lengths and areas are those
// of the metric.
struct Extent
{
  double area = 0., boundary = 0.;
  std::ptrdiff_t euler_characteristic = 0;
  std::size_t boundary_loops = 0, corners = 0;

  // Every loop needs three vertices of its own. With the loops filled in, the surface would be a closed one with
  // at most a vertex more for each.
  std::size_t fewest() const
  {
    const std::ptrdiff_t loops = static_cast<std::ptrdiff_t>(boundary_loops);
    std::size_t topology = fewest_vertices(euler_characteristic + loops);
    topology = boundary_loops == 0 ? topology : (std::max)(topology - (std::min)(boundary_loops, topology), 3 * boundary_loops);
    return (std::max)(topology, corners);
  }

  // That triangles with this edge length have: a vertex for each sqrt(3)/2 e^2, and half a vertex more for each
  // edge of the boundary
  double wanted(double edge_length) const
  {
    return 2. * area / (std::sqrt(3.) * edge_length * edge_length) + .5 * boundary / edge_length;
  }
};

inline std::vector<std::size_t> components_of(const Mesh& mesh, std::size_t& number)
{
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> component_of(mesh.number_of_vertices(), none);
  std::vector<Vertex> stack;
  number = 0;
  for(Vertex seed : mesh.vertices())
  {
    if(component_of[seed] != none)
      continue;
    component_of[seed] = number;
    for(stack.assign(1, seed); !stack.empty();)
    {
      const Vertex v = stack.back();
      stack.pop_back();
      for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
        if(component_of[mesh.source(h)] == none)
        {
          component_of[mesh.source(h)] = number;
          stack.push_back(mesh.source(h));
        }
    }
    ++number;
  }
  return component_of;
}

inline std::vector<Extent> extents_of_components(const Mesh& mesh)
{
  std::size_t number;
  const std::vector<std::size_t> component_of = components_of(mesh, number);
  std::vector<Extent> extents(number);
  const Metric metric(mesh);
  for(Vertex v : mesh.vertices())
    ++extents[component_of[v]].euler_characteristic;
  for(Edge e : mesh.edges())
    --extents[component_of[mesh.vertex(e, 0)]].euler_characteristic;
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

inline void count_corners(const Mesh& mesh, const Constraints& constraints, std::vector<Extent>& extents)
{
  std::size_t number;
  const std::vector<std::size_t> component_of = components_of(mesh, number);
  for(Vertex v : mesh.vertices())
    extents[component_of[v]].corners += v.idx() < constraints.is_corner.size() && constraints.is_corner[v.idx()] != 0;
}

template <class Value>
auto sum_over(const std::vector<Extent>& extents, const Value& value)
{
  decltype(value(extents.front())) sum = 0;
  for(const Extent& e : extents)
    sum += value(e);
  return sum;
}

// Of all components, each at least what it needs
inline double wanted(const std::vector<Extent>& extents, double edge_length)
{
  return sum_over(extents, [&](const Extent& e)
                  { return (std::max)(static_cast<double>(e.fewest()), e.wanted(edge_length)); });
}

// The edge length at which the components together have this number of vertices, each at least what it needs: what small
// ones take more than their share the others have less.
inline double edge_length_for(const std::vector<Extent>& extents, std::size_t vertices)
{
  const double by_area = edge_length_for(sum_over(extents, [](const Extent& e) { return e.area; }), vertices);
  const auto is_enough = [&](double edge_length)
  { return !(wanted(extents, edge_length) > static_cast<double>(vertices) * (1. + 1e-9)); };
  if(is_enough(by_area))
    return by_area;
  double low = by_area, high = 2. * by_area;
  for(int i = 0; i < 30 && !is_enough(high); ++i)
    high *= 2.;
  for(int i = 0; i < 60; ++i)
  {
    const double middle = .5 * (low + high);
    (is_enough(middle) ? high : low) = middle;
  }
  return high;
}

// The samples on lines: corners, and what lies inside the pieces. In numbers only
class Line_budget
{
public:
  Line_budget(const Mesh& mesh, const std::vector<Line_piece>& pieces, std::size_t corners)
    : m_pieces(pieces), m_fewest(fewest_intervals(mesh, pieces)), m_corners(corners)
  {
    const Metric metric(mesh);
    for(const Line_piece& piece : pieces)
    {
      m_length.push_back(length_of(metric, piece));
      m_is_boundary.push_back(mesh.is_border(mesh.edge(piece.halfedges.front())));
    }
  }

  std::size_t fewest() const { return number(infinity); }

  std::size_t number(double spacing) const
  {
    std::size_t sum = m_corners;
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      sum += number_inside(m_pieces[i], number_of_intervals(m_length[i], spacing, m_fewest[i]));
    return sum;
  }

  std::size_t edges_on_boundary(double spacing) const
  {
    std::size_t sum = 0;
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      if(m_is_boundary[i])
        sum += number_of_intervals(m_length[i], spacing, m_fewest[i]);
    return sum;
  }

  // The spacing itself, or a wider one where so many samples would be more than this
  double spacing_for(double spacing, std::size_t most) const
  {
    if(number(spacing) <= most)
      return spacing;
    double low = spacing, high = 2. * spacing;
    while(number(high) > most && number(high) > fewest())
      high *= 2.;
    for(int i = 0; i < 40; ++i)
    {
      const double middle = .5 * (low + high);
      (number(middle) > most ? low : high) = middle;
    }
    return high;
  }

private:
  const std::vector<Line_piece>& m_pieces;
  const std::vector<int> m_fewest;
  const std::size_t m_corners;
  std::vector<double> m_length;
  std::vector<char> m_is_boundary;
};

// The numbers to work with
struct Vertex_budget
{
  std::size_t number_of_vertices;
  double edge_length, spacing_on_lines;
};

inline void check_number_of_vertices(std::size_t number, std::size_t topology, std::size_t lines)
{
  const auto reject_number = [&](std::size_t needed, const std::string& what)
  {
    if(number < needed)
      throw Remeshing_error("geodesic remeshing: " + std::to_string(number) + " vertices are too few: " + what + " "
                            + std::to_string(needed));
  };
  reject_number(topology, "the topology of the input needs");
  reject_number(lines, "the corners and lines of the input need");
}

// `number` is that of the target if it is a number, else what follows from the area alone.
template <class Target>
Vertex_budget make_budget(const Target& target, const Mesh& mesh, std::size_t number, const std::vector<Line_piece>& pieces,
                          const Constraints& constraints)
{
  std::vector<Extent> extents = extents_of_components(mesh);
  count_corners(mesh, constraints, extents);
  const Line_budget lines(mesh, pieces, sum_over(extents, [](const Extent& e) { return e.corners; }));
  const std::size_t fewest = sum_over(extents, [](const Extent& e) { return e.fewest(); });
  double spacing = edge_length_for(sum_over(extents, [](const Extent& e) { return e.area; }), number);
  if constexpr(std::is_same<Target, Edge_length>::value)
    number = static_cast<std::size_t>(std::llround(wanted(extents, spacing)));
  else if constexpr(std::is_same<Target, Number_of_faces>::value)
    number += (target.value + lines.edges_on_boundary(spacing)) / 2 - target.value / 2; // F = 2 V - 2 chi - B
  check_number_of_vertices(number, fewest, lines.fewest());
  const double edge_length = edge_length_for(extents, number);
  if constexpr(!std::is_same<Target, Number_of_faces>::value)
    spacing = edge_length;
  return Vertex_budget{number, edge_length, lines.spacing_for(spacing, number)};
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_BUDGET_H
