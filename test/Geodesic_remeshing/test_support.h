// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_SUPPORT_H
#define GEODESIC_REMESHING_TEST_SUPPORT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// Measures that know nothing of the code they judge.
namespace support {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Point = Mesh::Point;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;

// What a set of faces is, as a surface of its own: where it touches itself in a vertex only, that is two vertices.
struct Topology
{
  int components = 0;
  int boundary_loops = 0;
  int euler_characteristic = 0;

  int genus() const { return (2 * components - boundary_loops - euler_characteristic) / 2; }
  bool operator==(const Topology& t) const
  {
    return components == t.components && boundary_loops == t.boundary_loops &&
           euler_characteristic == t.euler_characteristic;
  }
};

class Union_of_indices
{
public:
  explicit Union_of_indices(std::size_t n) : m_parent(n)
  {
    for(std::size_t i = 0; i < n; ++i)
      m_parent[i] = i;
  }

  std::size_t find(std::size_t i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  void unite(std::size_t i, std::size_t j) { m_parent[find(i)] = find(j); }

private:
  std::vector<std::size_t> m_parent;
};

// The topology of the sets of faces with the same number, by number
template <class Number_of_face>
std::map<int, Topology> topologies(const Mesh& mesh, const Number_of_face& number)
{
  const auto inner = [&](Halfedge h) { return mesh.is_border(h) ? -1 : number(mesh.face(h)); };
  const auto is_rim = [&](Halfedge h) { return inner(h) != inner(mesh.opposite(h)); };
  std::map<int, Topology> result;
  Union_of_indices corners(mesh.number_of_halfedges()), pieces(mesh.number_of_faces()),
      rims(mesh.number_of_halfedges());
  for(Halfedge h : mesh.halfedges())
  {
    if(mesh.is_border(h))
      continue;
    if(!is_rim(h)) // the corners beside the edge belong together, and so do the faces
    {
      corners.unite(h, mesh.prev(mesh.opposite(h)));
      pieces.unite(mesh.face(h), mesh.face(mesh.opposite(h)));
      continue;
    }
    Halfedge following = mesh.next(h); // along the rim
    while(!is_rim(following))
      following = mesh.next(mesh.opposite(following));
    rims.unite(h, following);
  }
  std::map<int, int> twice_edges;
  for(Halfedge h : mesh.halfedges())
  {
    if(mesh.is_border(h))
      continue;
    Topology& t = result[inner(h)];
    t.euler_characteristic += corners.find(h) == std::size_t(h);
    t.boundary_loops += is_rim(h) && rims.find(h) == std::size_t(h);
    twice_edges[inner(h)] += is_rim(h) ? 2 : 1;
  }
  for(Face f : mesh.faces())
  {
    Topology& t = result[number(f)];
    ++t.euler_characteristic;
    t.components += pieces.find(f) == std::size_t(f);
  }
  for(const auto& edges : twice_edges)
    result[edges.first].euler_characteristic -= edges.second / 2;
  return result;
}

inline Topology topology_of(const Mesh& mesh)
{
  const auto all = topologies(mesh, [](Face) { return 0; });
  return all.empty() ? Topology() : all.begin()->second;
}

struct Quality
{
  double smallest_angle = 180.;
  double mean_smallest_angle = 0.;
  double percent_below_30 = 0.;
  double percent_irregular = 0.;
};

inline double angle_at(const Point& p, const Point& q, const Point& r)
{
  const auto u = p - q, v = r - q;
  const double area = std::sqrt(CGAL::cross_product(u, v).squared_length());
  return std::atan2(area, u * v) * 180. / CGAL_PI;
}

inline Quality quality_of(const Mesh& mesh)
{
  Quality quality;
  for(Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    const Point& p = mesh.point(mesh.source(h));
    const Point& q = mesh.point(mesh.target(h));
    const Point& r = mesh.point(mesh.target(mesh.next(h)));
    const double smallest = (std::min)({angle_at(p, q, r), angle_at(q, r, p), angle_at(r, p, q)});
    quality.smallest_angle = (std::min)(quality.smallest_angle, smallest);
    quality.mean_smallest_angle += smallest / static_cast<double>(mesh.number_of_faces());
    quality.percent_below_30 += smallest < 30. ? 100. / static_cast<double>(mesh.number_of_faces()) : 0.;
  }
  for(Vertex v : mesh.vertices())
    quality.percent_irregular += mesh.degree(v) != 6 ? 100. / static_cast<double>(mesh.number_of_vertices()) : 0.;
  return quality;
}

inline double area_of(const Mesh& mesh)
{
  double sum = 0.;
  for(Face f : mesh.faces())
  {
    const Halfedge h = mesh.halfedge(f);
    sum += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                        mesh.point(mesh.target(mesh.next(h)))));
  }
  return sum;
}

// Vertex for vertex and face for face
inline bool is_same_mesh(const Mesh& a, const Mesh& b)
{
  if(a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces())
    return false;
  for(Vertex v : a.vertices())
    if(a.point(v).x() != b.point(v).x() || a.point(v).y() != b.point(v).y() || a.point(v).z() != b.point(v).z())
      return false;
  for(Face f : a.faces())
  {
    const Halfedge h = a.halfedge(f), g = b.halfedge(f);
    if(a.source(h) != b.source(g) || a.target(h) != b.target(g) || a.target(a.next(h)) != b.target(b.next(g)))
      return false;
  }
  return true;
}

} // namespace support

#endif // GEODESIC_REMESHING_TEST_SUPPORT_H
