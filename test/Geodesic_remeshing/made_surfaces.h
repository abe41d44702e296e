// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_MADE_SURFACES_H
#define GEODESIC_REMESHING_TEST_MADE_SURFACES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Surfaces from formulas, the same on every machine, whose topology and shape are known: the oracles of the tests.
namespace made {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

inline Mesh octahedron()
{
  Mesh mesh;
  for(const Point& p :
      {Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)})
    mesh.add_vertex(p);
  for(unsigned x : {0u, 1u})
    for(unsigned y : {2u, 3u})
      for(unsigned z : {4u, 5u})
        if((x + y + z) % 2 == 0) // an even number of mirrorings keeps the orientation
          mesh.add_face(Vertex(x), Vertex(y), Vertex(z));
        else
          mesh.add_face(Vertex(x), Vertex(z), Vertex(y));
  return mesh;
}

inline Mesh tetrahedron()
{
  Mesh mesh;
  for(const Point& p : {Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)})
    mesh.add_vertex(p);
  for(const std::array<unsigned, 3>& f : {std::array<unsigned, 3>{{0, 1, 2}}, {{0, 3, 1}}, {{0, 2, 3}}, {{1, 3, 2}}})
    mesh.add_face(Vertex(f[0]), Vertex(f[1]), Vertex(f[2]));
  return mesh;
}

// Each triangle cut into four, the new vertices in the middles of the edges
inline Mesh divided(const Mesh& mesh)
{
  Mesh result;
  std::vector<Vertex> middle(mesh.number_of_edges());
  for(Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  for(auto e : mesh.edges())
    middle[e.idx()] = result.add_vertex(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  for(auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f), i = mesh.next(h), j = mesh.next(i);
    const Vertex a = middle[mesh.edge(h).idx()], b = middle[mesh.edge(i).idx()], c = middle[mesh.edge(j).idx()];
    result.add_face(mesh.source(h), a, c);
    result.add_face(mesh.source(i), b, a);
    result.add_face(mesh.source(j), c, b);
    result.add_face(a, b, c);
  }
  return result;
}

inline Mesh divided(Mesh mesh, int times)
{
  for(int i = 0; i < times; ++i)
    mesh = divided(mesh);
  return mesh;
}

// 4^times faces for each of the octahedron's eight
inline Mesh sphere(int times, double radius = 1.)
{
  Mesh mesh = octahedron();
  for(int i = 0; i < times; ++i)
  {
    mesh = divided(mesh);
    for(Vertex v : mesh.vertices())
      mesh.point(v) =
          CGAL::ORIGIN + (mesh.point(v) - CGAL::ORIGIN) / std::sqrt((mesh.point(v) - CGAL::ORIGIN).squared_length());
  }
  for(Vertex v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + radius * (mesh.point(v) - CGAL::ORIGIN);
  return mesh;
}

inline Mesh ellipsoid(int times, double a, double b, double c)
{
  Mesh mesh = sphere(times);
  for(Vertex v : mesh.vertices())
    mesh.point(v) = Point(a * mesh.point(v).x(), b * mesh.point(v).y(), c * mesh.point(v).z());
  return mesh;
}

// A unit sphere with six equal spikes, on the axes
inline Mesh spiky_sphere(int times, double height, double width)
{
  Mesh mesh = sphere(times);
  for(Vertex v : mesh.vertices())
  {
    const Vector p = mesh.point(v) - CGAL::ORIGIN;
    const double largest = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    const double angle = std::acos((std::min)(1., largest));
    mesh.point(v) = CGAL::ORIGIN + (1. + height * (std::max)(0., 1. - angle / width)) * p;
  }
  return mesh;
}

inline Mesh torus(double large, double small, unsigned around, unsigned along_tube)
{
  Mesh mesh;
  for(unsigned i = 0; i < around; ++i)
    for(unsigned j = 0; j < along_tube; ++j)
    {
      const double u = 2. * CGAL_PI * i / around, v = 2. * CGAL_PI * j / along_tube;
      const double r = large + small * std::cos(v);
      mesh.add_vertex(Point(r * std::cos(u), r * std::sin(u), small * std::sin(v)));
    }
  const auto at = [&](unsigned i, unsigned j) { return Vertex(i % around * along_tube + j % along_tube); };
  for(unsigned i = 0; i < around; ++i)
    for(unsigned j = 0; j < along_tube; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// A cylinder along z from 0 to `length`, its caps fans around their centres, or left open
inline Mesh cylinder(double radius, double length, unsigned around, unsigned along, bool has_caps = true)
{
  Mesh mesh;
  for(unsigned j = 0; j <= along; ++j)
    for(unsigned i = 0; i < around; ++i)
    {
      const double u = 2. * CGAL_PI * i / around;
      mesh.add_vertex(Point(radius * std::cos(u), radius * std::sin(u), length * j / along));
    }
  const auto at = [&](unsigned i, unsigned j) { return Vertex(j * around + i % around); };
  for(unsigned j = 0; j < along; ++j)
    for(unsigned i = 0; i < around; ++i)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  if(!has_caps)
    return mesh;
  const Vertex low = mesh.add_vertex(Point(0, 0, 0)), high = mesh.add_vertex(Point(0, 0, length));
  for(unsigned i = 0; i < around; ++i)
  {
    mesh.add_face(low, at(i + 1, 0), at(i, 0));
    mesh.add_face(high, at(i, along), at(i + 1, along));
  }
  return mesh;
}

// A square of side n in the plane z = 0, of n * n * 2 triangles
inline Mesh plane(unsigned n)
{
  Mesh mesh;
  for(unsigned j = 0; j <= n; ++j)
    for(unsigned i = 0; i <= n; ++i)
      mesh.add_vertex(Point(i, j, 0));
  const auto at = [&](unsigned i, unsigned j) { return Vertex(j * (n + 1) + i); };
  for(unsigned j = 0; j < n; ++j)
    for(unsigned i = 0; i < n; ++i)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

// A block of unit cubes: from a corner to the opposite one
struct Block
{
  std::array<int, 3> low, high;
};

// The surface of the union of blocks, which must not touch along an edge or at a corner only. All of it is exactly flat
// and at integer coordinates: many vertices have the same distance from anywhere.
inline Mesh blocks(const std::vector<Block>& boxes)
{
  const auto is_inside = [&](const std::array<int, 3>& c) {
    for(const Block& b : boxes)
      if(b.low[0] <= c[0] && c[0] < b.high[0] && b.low[1] <= c[1] && c[1] < b.high[1] && b.low[2] <= c[2] &&
         c[2] < b.high[2])
        return true;
    return false;
  };
  std::map<std::array<int, 3>, bool> cubes;
  for(const Block& b : boxes)
    for(int x = b.low[0]; x < b.high[0]; ++x)
      for(int y = b.low[1]; y < b.high[1]; ++y)
        for(int z = b.low[2]; z < b.high[2]; ++z)
          cubes[{{x, y, z}}] = true;
  Mesh mesh;
  std::map<std::array<int, 3>, Vertex> corner;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto found = corner.find(p);
    return found != corner.end() ? found->second : corner[p] = mesh.add_vertex(Point(p[0], p[1], p[2]));
  };
  for(const auto& cube : cubes)
    for(int axis = 0; axis < 3; ++axis)
      for(int side = 0; side < 2; ++side)
      {
        std::array<int, 3> beside = cube.first, p = cube.first;
        beside[axis] += side == 1 ? 1 : -1;
        if(is_inside(beside))
          continue;
        p[axis] += side;
        std::array<int, 3> q = p, r = p, s = p; // p, q, r, s in turn around the square, seen from outside
        q[(axis + (side == 1 ? 1 : 2)) % 3] += 1;
        s[(axis + (side == 1 ? 2 : 1)) % 3] += 1;
        r[(axis + 1) % 3] += 1;
        r[(axis + 2) % 3] += 1;
        const Vertex a = vertex(p), b = vertex(q), c = vertex(r), d = vertex(s);
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
  return mesh;
}

// Moves each vertex to the mean of its neighbours, so often: rounds off what `blocks()` makes
inline Mesh rounded(Mesh mesh, int times)
{
  for(int i = 0; i < times; ++i)
  {
    std::vector<Point> points;
    for(Vertex v : mesh.vertices())
    {
      Vector sum(0, 0, 0);
      for(Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
        sum = sum + (mesh.point(w) - CGAL::ORIGIN);
      points.push_back(CGAL::ORIGIN + sum / static_cast<double>(mesh.degree(v)));
    }
    for(Vertex v : mesh.vertices())
      mesh.point(v) = points[v.idx()];
  }
  return mesh;
}

// An L and a stair, extruded: creases that are not convex, corners of three creases
inline Mesh l_shape(int width = 4)
{
  return blocks({Block{{{0, 0, 0}}, {{3 * width, width, width}}}, Block{{{0, width, 0}}, {{width, 3 * width, width}}}});
}

inline Mesh stairs(int steps, int height = 2)
{
  std::vector<Block> boxes;
  for(int i = 0; i < steps; ++i)
    boxes.push_back(Block{{{0, i * height, 0}}, {{(steps - i) * 2 * height, (i + 1) * height, 3 * height}}});
  return blocks(boxes);
}

// A wheel along z with teeth of straight flanks; its caps are fans around their centres
inline Mesh gear(unsigned teeth, double inner, double outer, double width)
{
  Mesh mesh;
  const unsigned n = 4 * teeth;
  for(double z : {0., width})
    for(unsigned i = 0; i < n; ++i)
    {
      const double radius = i % 4 < 2 ? outer : inner;
      const double u = 2. * CGAL_PI * (i / 4 + (i % 4 == 0 ? .05 : i % 4 == 1 ? .45 : i % 4 == 2 ? .5 : 1.)) / teeth;
      mesh.add_vertex(Point(radius * std::cos(u), radius * std::sin(u), z));
    }
  const Vertex low = mesh.add_vertex(Point(0, 0, 0)), high = mesh.add_vertex(Point(0, 0, width));
  for(unsigned i = 0; i < n; ++i)
  {
    const Vertex a(i), b((i + 1) % n), c(n + (i + 1) % n), d(n + i);
    mesh.add_face(a, b, c);
    mesh.add_face(a, c, d);
    mesh.add_face(low, b, a);
    mesh.add_face(high, d, c);
  }
  return mesh;
}

// Rings of triangles around the origin in the plane z = 0
inline Mesh disc(unsigned rings, double radius = 1.)
{
  Mesh mesh;
  const Vertex middle = mesh.add_vertex(Point(0, 0, 0));
  const unsigned n = 6 * rings;
  for(unsigned j = 1; j <= rings; ++j)
    for(unsigned i = 0; i < n; ++i)
    {
      const double r = radius * j / rings, u = 2. * CGAL_PI * i / n;
      mesh.add_vertex(Point(r * std::cos(u), r * std::sin(u), 0));
    }
  const auto at = [&](unsigned i, unsigned j) { return Vertex(1 + (j - 1) * n + i % n); };
  for(unsigned i = 0; i < n; ++i)
  {
    mesh.add_face(middle, at(i, 1), at(i + 1, 1));
    for(unsigned j = 1; j < rings; ++j)
    {
      mesh.add_face(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
  return mesh;
}

inline Mesh box(int x, int y, int z)
{
  return blocks({Block{{{0, 0, 0}}, {{x, y, z}}}});
}

// Tubes of this width from one middle along -x, +x, -y, +y, -z, +z: as many as there are lengths (two at least)
inline Mesh branching_tubes(const std::vector<int>& lengths, int width = 4)
{
  std::vector<Block> boxes(1, Block{{{0, 0, 0}}, {{width, width, width}}});
  for(std::size_t i = 0; i < lengths.size(); ++i)
  {
    const int axis = static_cast<int>(i / 2);
    Block limb = boxes.front();
    if(i % 2 == 1)
      limb.high[axis] += lengths[i];
    else
      limb.low[axis] -= lengths[i];
    boxes.push_back(limb);
  }
  return rounded(blocks(boxes), 3);
}

// A trunk along z with arms that go out and then up
inline Mesh cactus_blocks()
{
  return blocks({Block{{{0, 0, 0}}, {{4, 4, 40}}}, Block{{{-8, 0, 12}}, {{0, 4, 16}}},
                 Block{{{-8, 0, 16}}, {{-4, 4, 28}}}, Block{{{4, 0, 18}}, {{14, 4, 22}}},
                 Block{{{10, 0, 22}}, {{14, 4, 30}}}});
}

// A chain of tori: a plate with as many square holes
inline Mesh chain_of_tori(int genus, int width = 4)
{
  std::vector<Block> boxes;
  const int length = 2 * width * genus + width;
  boxes.push_back(Block{{{0, 0, 0}}, {{length, width, width}}});
  boxes.push_back(Block{{{0, 2 * width, 0}}, {{length, 3 * width, width}}});
  for(int i = 0; i <= genus; ++i)
    boxes.push_back(Block{{{2 * width * i, width, 0}}, {{2 * width * i + width, 2 * width, width}}});
  return rounded(blocks(boxes), 3);
}

inline Mesh moved(Mesh mesh, const Vector& by)
{
  for(Vertex v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + by;
  return mesh;
}

inline Mesh scaled(Mesh mesh, double factor)
{
  for(Vertex v : mesh.vertices())
    mesh.point(v) = CGAL::ORIGIN + factor * (mesh.point(v) - CGAL::ORIGIN);
  return mesh;
}

inline Mesh together(const std::vector<Mesh>& meshes)
{
  Mesh result;
  for(const Mesh& mesh : meshes)
    result += mesh;
  return result;
}

struct Case
{
  std::string name;
  Mesh mesh;
};

// All kinds: one hill, many, flat ends, creases, long triangles, handles, several components
inline std::vector<Case> make_cases()
{
  return {{"sphere", sphere(3)},
          {"ellipsoid", ellipsoid(3, 3, 1, 2)},
          {"octahedron", octahedron()},
          {"tetrahedron", tetrahedron()},
          {"box", box(6, 5, 4)},
          {"cube", box(6, 6, 6)},
          {"thin_box", box(12, 9, 1)},
          {"cylinder", cylinder(1, 20, 16, 40)},
          {"cylinder_of_long_triangles", cylinder(1, 20, 8, 1)},
          {"spiky_sphere", spiky_sphere(4, 2, .4)},
          {"tubes_3", branching_tubes({20, 12, 15})},
          {"tubes_6", branching_tubes({12, 14, 16, 18, 20, 22})},
          {"equal_tubes_6", branching_tubes({16, 16, 16, 16, 16, 16})},
          {"cactus_blocks", cactus_blocks()},
          {"cactus", rounded(cactus_blocks(), 4)},
          {"torus", torus(3, 1, 40, 16)},
          {"thin_torus", torus(10, .5, 60, 8)},
          {"tori_2", chain_of_tori(2)},
          {"tori_5", chain_of_tori(5)},
          {"spheres_and_torus", together({sphere(3), torus(6, 1, 40, 12), moved(sphere(2), Vector(20, 0, 0))})}};
}

inline const std::vector<Case>& cases()
{
  static const std::vector<Case> all = make_cases();
  return all;
}

} // namespace made

#endif // GEODESIC_REMESHING_TEST_MADE_SURFACES_H
