// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_RANDOM_SURFACES_H
#define GEODESIC_REMESHING_TEST_RANDOM_SURFACES_H

#include "made_surfaces.h"

#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Surfaces that nobody would think of: one for each seed, on every machine.
namespace random_surfaces {

using made::Mesh;
using made::Point;
using made::Vertex;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;

// SplitMix64: the distributions of the standard library differ from one library to the other.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}

  std::uint64_t bits()
  {
    std::uint64_t z = m_state += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
  double between(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  bool chance(double probability) { return between(0., 1.) < probability; }

private:
  std::uint64_t m_state;
};

// Where fans of faces touch in a vertex that is made two; vertices without faces go.
inline void clean(Mesh& mesh)
{
  CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices(mesh);
  CGAL::Polygon_mesh_processing::remove_isolated_vertices(mesh);
  mesh.collect_garbage();
}

// Cubes in a small grid, joined at random: any genus, any number of components, and many points at equal distances
inline Mesh random_blocks(Random& random)
{
  std::vector<made::Block> boxes;
  const std::size_t number = 1 + random.below(7);
  for(std::size_t i = 0; i < number; ++i)
  {
    made::Block box;
    for(int axis = 0; axis < 3; ++axis)
    {
      box.low[axis] = static_cast<int>(random.below(6));
      box.high[axis] = box.low[axis] + 1 + static_cast<int>(random.below(5));
    }
    boxes.push_back(box);
  }
  Mesh mesh = made::blocks(boxes); // holes where cubes touch in an edge only
  clean(mesh);
  return mesh;
}

inline Mesh random_base(Random& random)
{
  switch(random.below(7))
  {
  case 0:
    return made::sphere(static_cast<int>(1 + random.below(4)));
  case 1:
    return made::torus(random.between(1.1, 6.), 1., static_cast<unsigned>(3 + random.below(40)),
                       static_cast<unsigned>(3 + random.below(20)));
  case 2:
    return made::cylinder(1., random.between(.01, 30.), static_cast<unsigned>(3 + random.below(20)),
                          static_cast<unsigned>(1 + random.below(20)), random.chance(.5));
  case 3:
    return made::spiky_sphere(3, random.between(.2, 6.), random.between(.1, .6));
  case 4:
    return made::plane(static_cast<unsigned>(1 + random.below(12)));
  default:
    return random_blocks(random);
  }
}

inline void punch_holes(Random& random, Mesh& mesh)
{
  const std::size_t number = 1 + random.below(10);
  for(std::size_t i = 0; i < number && mesh.number_of_faces() > 2; ++i)
  {
    const Face f(static_cast<Mesh::size_type>(random.below(mesh.num_faces())));
    if(!mesh.is_removed(f))
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  clean(mesh);
}

// Vertices that lie on an edge or at the same place as another one, and faces with angles of almost nothing
inline void spoil_faces(Random& random, Mesh& mesh)
{
  const std::size_t number = 1 + random.below(20);
  for(std::size_t i = 0; i < number; ++i)
  {
    const Face f(static_cast<Mesh::size_type>(random.below(mesh.num_faces())));
    const Halfedge h = mesh.halfedge(f);
    const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
                r = mesh.point(mesh.target(mesh.next(h)));
    const Halfedge n = CGAL::Euler::add_center_vertex(h, mesh);
    const double off = random.chance(.5) ? 0. : std::pow(10., -random.between(3., 14.));
    mesh.point(mesh.target(n)) = CGAL::barycenter(p, random.chance(.3) ? 0. : .5, q, .5, r, off);
  }
}

inline void move_points(Random& random, Mesh& mesh)
{
  double sum = 0.;
  for(auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const double noise =
      random.chance(.3) ? random.between(0., .4) * sum / static_cast<double>(mesh.number_of_edges()) : 0.;
  const double stretch[] = {1., std::pow(10., random.chance(.3) ? random.between(-2., 2.) : 0.),
                            std::pow(10., random.chance(.2) ? random.between(-3., 1.) : 0.)};
  const double scale = random.chance(.2) ? std::pow(10., random.between(-12., 12.)) : 1.;
  const double offset = random.chance(.1) ? 1e6 : 0.;
  for(Vertex v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(scale * (stretch[0] * (p.x() + noise * random.between(-1., 1.)) + offset),
                          scale * (stretch[1] * (p.y() + noise * random.between(-1., 1.)) + offset),
                          scale * (stretch[2] * (p.z() + noise * random.between(-1., 1.)) - offset));
  }
}

inline Mesh random_surface(Random& random)
{
  Mesh mesh = random_base(random);
  if(random.chance(.2))
    mesh = made::together({mesh, made::moved(random_base(random), made::Vector(20., 0., 0.))});
  if(random.chance(.3))
    mesh = made::rounded(mesh, 2);
  if(random.chance(.3))
    punch_holes(random, mesh);
  if(random.chance(.3))
    spoil_faces(random, mesh);
  move_points(random, mesh);
  return mesh;
}

} // namespace random_surfaces

#endif // GEODESIC_REMESHING_TEST_RANDOM_SURFACES_H
