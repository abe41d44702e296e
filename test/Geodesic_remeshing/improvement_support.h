// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_IMPROVEMENT_SUPPORT_H
#define GEODESIC_REMESHING_TEST_IMPROVEMENT_SUPPORT_H

#include <CGAL/Geodesic_remeshing/internal/improve.h>

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Starts for the improvement, and what must hold after it.
namespace improvement_support {

using namespace CGAL::Geodesic_remeshing::internal;
using Index = Lean_triangulation::Index;

// The same numbers on any platform.
class Random_numbers
{
public:
  double operator()(const double low, const double high)
  {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return low + (high - low) * static_cast<double>(state_ >> 11) / 9007199254740992.;
  }

private:
  std::uint64_t state_ = 1;
};

// columns x rows quadrilaterals, each cut in two; point(i, j); closed in one or both directions or not at all.
template <class Point_of>
Mesh grid(const std::size_t columns, const std::size_t rows, const bool close_i, const bool close_j,
          const Point_of& point)
{
  Mesh mesh;
  const std::size_t m = close_i ? columns : columns + 1, n = close_j ? rows : rows + 1;
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < m; ++i)
      mesh.add_vertex(point(static_cast<double>(i), static_cast<double>(j)));
  const auto at = [&](const std::size_t i, const std::size_t j) {
    return Vertex(static_cast<Index>(j % n * m + i % m));
  };
  for(std::size_t j = 0; j < rows; ++j)
    for(std::size_t i = 0; i < columns; ++i)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

inline Mesh plane(const std::size_t n)
{
  return grid(n, n, false, false, [](const double i, const double j) { return Point(i, j, 0.); });
}

// Around 40, along the tube 16 quadrilaterals, times k. The tube is thick enough to have no acute places.
inline Mesh torus(const std::size_t k)
{
  return grid(40 * k, 16 * k, true, true, [k](const double i, const double j) {
    const double u = 2. * CGAL_PI * i / (40. * k), v = 2. * CGAL_PI * j / (16. * k);
    return Point((5. + 2. * std::cos(v)) * std::cos(u), (5. + 2. * std::cos(v)) * std::sin(u), 2. * std::sin(v));
  });
}

// An octahedron, each face divided into n x n triangles.
inline Mesh sphere(const std::size_t n)
{
  Mesh mesh;
  std::vector<std::array<Vertex, 3>> faces;
  std::array<Vertex, 6> v;
  for(int i = 0; i < 6; ++i)
  {
    std::array<double, 3> p = {{0., 0., 0.}};
    p[i % 3] = i < 3 ? 1. : -1.;
    v[i] = mesh.add_vertex(Point(p[0], p[1], p[2]));
  }
  for(int i = 0; i < 8; ++i)
  {
    const int x = i & 1 ? 3 : 0, y = i & 2 ? 4 : 1, z = i & 4 ? 5 : 2;
    const bool is_even = ((i & 1) + ((i >> 1) & 1) + ((i >> 2) & 1)) % 2 == 0;
    mesh.add_face(v[x], v[is_even ? y : z], v[is_even ? z : y]);
  }
  for(std::size_t k = 1; k < n; k *= 2)
  {
    Mesh finer;
    std::vector<Vertex> middle(mesh.number_of_edges());
    const auto on_sphere = [](const Point& p) {
      return CGAL::ORIGIN + (p - CGAL::ORIGIN) / std::sqrt((p - CGAL::ORIGIN).squared_length());
    };
    for(const Vertex w : mesh.vertices())
      finer.add_vertex(mesh.point(w));
    for(const Edge e : mesh.edges())
      middle[e] =
          finer.add_vertex(on_sphere(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
    for(const Face f : mesh.faces())
    {
      const Halfedge h = mesh.halfedge(f);
      const auto p = vertices_of(mesh, f);
      const Vertex a = middle[mesh.edge(h)], b = middle[mesh.edge(mesh.next(h))], c = middle[mesh.edge(mesh.prev(h))];
      finer.add_face(p[0], a, c);
      finer.add_face(a, p[1], b);
      finer.add_face(c, b, p[2]);
      finer.add_face(a, b, c);
    }
    mesh = finer;
  }
  return mesh;
}

inline Place place_of_vertex(const Mesh& surface, const Vertex v)
{
  const Halfedge h = surface.halfedge(v);
  const Face f = surface.face(surface.is_border(h) ? surface.opposite(h) : h);
  const auto p = vertices_of(surface, f);
  Place place{f, {{0., 0., 0.}}};
  for(std::size_t i = 0; i < 3; ++i)
    place.coordinates[i] = p[i] == v ? 1. : 0.;
  return place;
}

// A triangulation to improve: a mesh, its places on a surface, and what is pinned.
struct Start
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Place> place = mesh.add_property_map<Vertex, Place>("v:place").first;
  Mesh::Property_map<Vertex, bool> pinned = mesh.add_property_map<Vertex, bool>("v:pinned", false).first;
  Mesh::Property_map<Edge, bool> constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;

  Start() = default;
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;
};

// Edges of the boundary and those bent by 40 degrees or more; corners where such do not go on nearly straight.
inline Constraints constraints_of(const Mesh& surface)
{
  const auto normal = [&](const Face f) {
    const auto v = vertices_of(surface, f);
    return CGAL::unit_normal(surface.point(v[0]), surface.point(v[1]), surface.point(v[2]));
  };
  Constraints constraints{std::vector<char>(surface.number_of_edges(), 0),
                          std::vector<char>(surface.number_of_vertices(), 0)};
  for(const Edge e : surface.edges())
    constraints.is_line[e] =
        surface.is_border(e) ||
        normal(surface.face(surface.halfedge(e, 0))) * normal(surface.face(surface.halfedge(e, 1))) < .766;
  for(const Vertex v : surface.vertices())
  {
    std::vector<Vector> ways;
    for(const Halfedge h : surface.halfedges_around_target(surface.halfedge(v)))
      if(constraints.is_line[surface.edge(h)])
      {
        const Vector way = surface.point(surface.source(h)) - surface.point(v);
        ways.push_back(way / std::sqrt(way.squared_length()));
      }
    constraints.is_corner[v] = !ways.empty() && (ways.size() != 2 || ways[0] * ways[1] > -.5);
  }
  return constraints;
}

// The surface's own connectivity, its vertices walked away at random by up to `shift`: those on lines along these.
inline void spoil(const Mesh& surface, const double shift, Start& start, const Constraints& constraints = Constraints())
{
  const Surface_walker walker(surface, constraints);
  const Line_walker lines(walker, constraints);
  Random_numbers random;
  for(const Vertex v : surface.vertices())
  {
    const Vector way(random(-shift, shift), random(-shift, shift), random(-shift, shift));
    const Vertex w = start.mesh.add_vertex(surface.point(v));
    start.place[w] = place_of_vertex(surface, v);
    start.pinned[w] = !constraints.is_corner.empty() && constraints.is_corner[v];
    if(!start.pinned[w])
      start.place[w] =
          walker.triangulation().is_on_line(v) ? lines.slide(start.place[w], way) : walker.walk(start.place[w], way);
    start.mesh.point(w) = walker.point(start.place[w]);
  }
  for(const Face f : surface.faces())
  {
    const auto v = vertices_of(surface, f);
    start.mesh.add_face(v[0], v[1], v[2]);
  }
  if(!constraints.is_line.empty())
    for(const Edge e : start.mesh.edges())
      start.constrained[e] =
          constraints.is_line[surface.edge(surface.halfedge(start.mesh.vertex(e, 0), start.mesh.vertex(e, 1)))];
}

inline Improvement_parameters parameters_for(const Mesh& surface, const std::size_t number_of_vertices)
{
  double area = 0.;
  for(const Face f : surface.faces())
  {
    const auto v = vertices_of(surface, f);
    area += std::sqrt(CGAL::squared_area(surface.point(v[0]), surface.point(v[1]), surface.point(v[2])));
  }
  Improvement_parameters parameters{};
  parameters.number_of_vertices = number_of_vertices;
  parameters.edge_length = std::sqrt(2. * area / (std::sqrt(3.) * number_of_vertices));
  parameters.use_defect_moves = true;
  parameters.number_of_iterations = 3;
  return parameters;
}

inline void improve_to(const Mesh& surface, Start& start, const std::size_t number_of_vertices,
                       const Constraints& constraints = Constraints())
{
  improve(surface, start.mesh, start.place, start.pinned, start.constrained, constraints,
          parameters_for(surface, number_of_vertices), [](double) { return true; });
}

inline std::ptrdiff_t euler_characteristic(const Mesh& mesh)
{
  return static_cast<std::ptrdiff_t>(mesh.number_of_vertices()) - static_cast<std::ptrdiff_t>(mesh.number_of_edges()) +
         static_cast<std::ptrdiff_t>(mesh.number_of_faces());
}

inline double smallest_angle(const Mesh& mesh)
{
  double smallest = 180.;
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      smallest = (std::min)(smallest, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                              mesh.point(mesh.target(mesh.next(h)))));
  return smallest;
}

inline double percent_irregular(const Mesh& mesh)
{
  std::size_t irregular = 0;
  for(const Vertex v : mesh.vertices())
    irregular += mesh.degree(v) != 6;
  return 100. * irregular / mesh.number_of_vertices();
}

inline void expect_valid(const Mesh& surface, const Start& start)
{
  const Mesh& mesh = start.mesh;
  EXPECT_FALSE(mesh.has_garbage());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_EQ(euler_characteristic(mesh), euler_characteristic(surface));
  EXPECT_EQ(CGAL::is_closed(mesh), CGAL::is_closed(surface));
  for(const Vertex v : mesh.vertices())
  {
    const auto& c = start.place[v].coordinates;
    EXPECT_GE((std::min)({c[0], c[1], c[2]}), 0.);
    EXPECT_NEAR(c[0] + c[1] + c[2], 1., 1e-12);
    EXPECT_EQ(mesh.point(v), point_at(surface, start.place[v]));
    std::vector<Vertex> neighbors;
    for(const Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
      neighbors.push_back(w);
    std::sort(neighbors.begin(), neighbors.end());
    EXPECT_TRUE(std::adjacent_find(neighbors.begin(), neighbors.end()) == neighbors.end()) << "double edge at " << v;
    EXPECT_GE(neighbors.size(), mesh.is_border(v) ? 2u : 3u);
  }
}

inline void expect_no_turned_faces(const Mesh& surface, const Start& start)
{
  const Surface_walker walker(surface);
  for(const Face f : start.mesh.faces())
  {
    const auto v = vertices_of(start.mesh, f);
    const Vector normal = CGAL::normal(start.mesh.point(v[0]), start.mesh.point(v[1]), start.mesh.point(v[2]));
    Vector sum(0., 0., 0.);
    for(const Vertex w : v)
      sum = sum + walker.normal(start.place[w].face);
    EXPECT_GT(normal * sum, 0.) << "at face " << f;
  }
}

} // namespace improvement_support

#endif // GEODESIC_REMESHING_TEST_IMPROVEMENT_SUPPORT_H
