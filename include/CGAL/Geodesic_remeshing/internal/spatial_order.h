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

#include <CGAL/Geodesic_remeshing/internal/Nested_blocks.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
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

// A large mesh is in an order in space, so that its blocks are patches. With those of 1024 vertices four times as many
// steps are across borders as with these, and larger ones leave threads without work.
inline Block_size block_size_for(const std::size_t number_of_vertices, const Concurrency concurrency)
{
  return {concurrency, is_large(number_of_vertices) ? 13 : Block_size::one_block};
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

// The vertices along a Morton curve through their bounding box, ties as they were
inline std::vector<Vertex> spatial_order(const Mesh& mesh, const std::vector<Vertex>& vertices,
                                         const Concurrency concurrency)
{
  Bbox_3 box;
  for(Vertex v : vertices)
    box += mesh.point(v).bbox();
  const double length = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  const double scale = length > 0. ? 2097151. / length : 0.;
  const auto bits = [&](double x, double from) { return spread_bits(static_cast<std::uint64_t>((x - from) * scale)); };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(vertices.size());
  parallel_for(concurrency, keys.size(), [&](const std::size_t i) {
    const Point& p = mesh.point(vertices[i]);
    keys[i] = {bits(p.x(), box.xmin()) | bits(p.y(), box.ymin()) << 1 | bits(p.z(), box.zmin()) << 2,
               static_cast<std::uint32_t>(i)};
  });
  parallel_sort(concurrency, keys.begin(), keys.end(), std::less<>());
  std::vector<Vertex> order(keys.size());
  parallel_for(concurrency, keys.size(), [&](const std::size_t i) { order[i] = vertices[keys[i].second]; });
  return order;
}

// Of all vertices of a mesh without removed ones
inline std::vector<Vertex> spatial_order(const Mesh& mesh, const Concurrency concurrency)
{
  return spatial_order(mesh, std::vector<Vertex>(mesh.vertices().begin(), mesh.vertices().end()), concurrency);
}

// The numbers that elements of a mesh have in its copy
struct Numbering
{
  std::vector<Vertex> vertex;
  std::vector<Edge> edge;
  std::vector<Face> face;
};

// The numbers of elements sorted by their first vertex, ties by index; `first_vertex(i)` is invalid for those that are
// removed.
template <class Descriptor, class First_vertex>
std::vector<Descriptor> number_by_vertices(const std::size_t elements, const std::size_t vertices,
                                           const First_vertex& first_vertex)
{
  std::vector<std::uint32_t> next(vertices + 1, 0);
  for(std::size_t i = 0; i < elements; ++i)
  {
    const Vertex v = first_vertex(i);
    if(v.is_valid())
      ++next[v.idx() + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Descriptor> result(elements);
  for(std::size_t i = 0; i < elements; ++i)
  {
    const Vertex v = first_vertex(i);
    if(v.is_valid())
      result[i] = Descriptor(next[v]++);
  }
  return result;
}

// Copies a mesh into an empty one, with its vertices in this order, and edges and faces in that of the first of their
// vertices. Each edge keeps its first halfedge, each face and each vertex the halfedge that stands for it.
inline Numbering copy_in_order(const Mesh& mesh, const std::vector<Vertex>& order, Mesh& copy,
                               const Concurrency concurrency = Concurrency())
{
  using Size = Mesh::size_type;
  Numbering number;
  copy.resize(static_cast<Size>(order.size()), mesh.number_of_edges(), mesh.number_of_faces());
  number.vertex.resize(mesh.num_vertices());
  parallel_for(concurrency, order.size(), [&](const std::size_t i) {
    const Vertex v(static_cast<Size>(i));
    number.vertex[order[i]] = v;
    copy.point(v) = mesh.point(order[i]);
  });
  const auto first_of_edge = [&](const std::size_t i) {
    const Edge e(static_cast<Size>(i));
    return mesh.is_removed(e) ? Vertex()
                              : (std::min)(number.vertex[mesh.vertex(e, 0)], number.vertex[mesh.vertex(e, 1)]);
  };
  const auto first_of_face = [&](const std::size_t i) {
    const Face f(static_cast<Size>(i));
    if(mesh.is_removed(f))
      return Vertex();
    const auto v = vertices_of(mesh, f);
    return (std::min)({number.vertex[v[0]], number.vertex[v[1]], number.vertex[v[2]]});
  };
  parallel_invoke(
      concurrency, [&] { number.edge = number_by_vertices<Edge>(mesh.num_edges(), order.size(), first_of_edge); },
      [&] { number.face = number_by_vertices<Face>(mesh.num_faces(), order.size(), first_of_face); });
  // In the order of the mesh: to write here and there takes less time than to read so.
  const auto copied = [&](const Halfedge h) { return copy.halfedge(number.edge[mesh.edge(h)], h.idx() & 1); };
  parallel_for(concurrency, mesh.num_halfedges(), [&](const std::size_t i) {
    const Halfedge h(static_cast<Size>(i));
    if(mesh.is_removed(h))
      return;
    const Halfedge g = copied(h);
    copy.set_target(g, number.vertex[mesh.target(h)]);
    copy.set_next(g, copied(mesh.next(h)));
    if(!mesh.is_border(h))
      copy.set_face(g, number.face[mesh.face(h)]);
  });
  parallel_for(concurrency, mesh.num_faces(), [&](const std::size_t i) {
    const Face f(static_cast<Size>(i));
    if(!mesh.is_removed(f))
      copy.set_halfedge(number.face[f], copied(mesh.halfedge(f)));
  });
  parallel_for(concurrency, order.size(), [&](const std::size_t i) {
    copy.set_halfedge(number.vertex[order[i]], copied(mesh.halfedge(order[i])));
  });
  return number;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SPATIAL_ORDER_H
