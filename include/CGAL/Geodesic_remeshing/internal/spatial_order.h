// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SPATIAL_ORDER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SPATIAL_ORDER_H

#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What is near on the surface should be near in memory: all stages go from neighbour to neighbour, and on a large mesh
// in another order they spend most of their time waiting for memory.

// More vertices than these, with what the stages know of them, fit into no cache of a core; sorting fewer gains little.
constexpr bool is_large(std::size_t number_of_vertices)
{
  return number_of_vertices > 32768;
}

// Puts two zero bits before each of the lowest 21.
inline std::uint64_t spread_bits(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffull;
  x = (x | x << 16) & 0x001f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

// The vertices along a Morton curve through the bounding box, ties by index
inline std::vector<Vertex> spatial_order(const Mesh& mesh, const Concurrency concurrency)
{
  Bbox_3 box;
  for(Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  const double length = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  const double scale = length > 0. ? 2097151. / length : 0.;
  const auto bits = [&](double x, double from) { return spread_bits(static_cast<std::uint64_t>((x - from) * scale)); };
  std::vector<std::pair<std::uint64_t, Vertex>> keys(mesh.number_of_vertices());
  parallel_for(concurrency, keys.size(), [&](const std::size_t i) {
    const Vertex v(static_cast<Mesh::size_type>(i));
    const Point& p = mesh.point(v);
    keys[i] = {bits(p.x(), box.xmin()) | bits(p.y(), box.ymin()) << 1 | bits(p.z(), box.zmin()) << 2, v};
  });
  parallel_sort(concurrency, keys.begin(), keys.end(), std::less<>());
  std::vector<Vertex> order(keys.size());
  parallel_for(concurrency, keys.size(), [&](const std::size_t i) { order[i] = keys[i].second; });
  return order;
}

// The numbers that elements of a mesh have in its copy
struct Numbering
{
  std::vector<Vertex> vertex;
  std::vector<Edge> edge;
  std::vector<Face> face;
};

// Copies a mesh with its vertices in this order, and edges and faces in the order in which the vertices meet them. Each
// edge keeps its first halfedge, each face and each vertex the halfedge that stands for it.
inline Numbering copy_in_order(const Mesh& mesh, const std::vector<Vertex>& order, Mesh& copy,
                               const Concurrency concurrency = Concurrency())
{
  Numbering number{std::vector<Vertex>(mesh.num_vertices()), std::vector<Edge>(mesh.num_edges()),
                   std::vector<Face>(mesh.num_faces())};
  copy.reserve(static_cast<Mesh::size_type>(order.size()), mesh.number_of_edges(), mesh.number_of_faces());
  for(Vertex v : order)
    number.vertex[v] = copy.add_vertex(mesh.point(v));
  const auto copied = [&](Halfedge h) {
    return copy.halfedge(number.edge[mesh.edge(h)], mesh.halfedge(mesh.edge(h), 0) == h ? 0 : 1);
  };
  for(Vertex v : order)
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      const Edge e = mesh.edge(h);
      if(!number.edge[e].is_valid())
        number.edge[e] = copy.edge(copy.add_edge(number.vertex[mesh.vertex(e, 1)], number.vertex[mesh.vertex(e, 0)]));
      if(!mesh.is_border(h) && !number.face[mesh.face(h)].is_valid())
        number.face[mesh.face(h)] = copy.add_face();
    }
  parallel_for(concurrency, order.size(), [&](const std::size_t i) {
    const Vertex v = order[i];
    copy.set_halfedge(number.vertex[v], copied(mesh.halfedge(v)));
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      const Halfedge g = copied(h);
      copy.set_next(g, copied(mesh.next(h)));
      if(mesh.is_border(h))
        continue;
      const Face f = number.face[mesh.face(h)];
      copy.set_face(g, f);
      if(mesh.halfedge(mesh.face(h)) == h)
        copy.set_halfedge(f, g);
    }
  });
  return number;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SPATIAL_ORDER_H
