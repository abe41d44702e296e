// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_ORDER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_ORDER_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The one total order of the vertices that all combinatorial decisions use: by distance, then by index. `ascending[i]`
// is the vertex of rank i. No two floating-point numbers are ever compared for equality: ranks are.
struct Vertex_order
{
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1); // the rank of a vertex that is left out
  std::vector<Vertex> ascending;
  std::vector<std::uint32_t> rank;
};

inline bool has_lower_neighbour(const Mesh& mesh, const std::vector<std::uint32_t>& rank, Vertex v)
{
  for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    if(rank[mesh.source(h)] < rank[v])
      return true;
  return false;
}

// Every vertex but the roots must have a lower neighbour, or the fronts that sweep down would meet minima that are not
// roots. Distances come from the intrinsic triangulation, whose edges are not those of the mesh, so this can fail by a
// hair; a flood from the roots (a vertex is as high as the lowest pass to it) then gives the order.
inline void flood_from(const std::vector<Vertex>& roots, const Mesh& mesh, Vertex_order& order)
{
  using Entry = std::pair<std::uint32_t, Vertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<char> queued(mesh.number_of_vertices(), 0);
  for(Vertex r : roots)
  {
    queue.emplace(0, r);
    queued[r] = 1;
  }
  std::vector<Vertex> flooded;
  flooded.reserve(mesh.number_of_vertices());
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    flooded.push_back(top.second);
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(top.second)))
    {
      const Vertex w = mesh.source(h);
      if(queued[w])
        continue;
      queued[w] = 1;
      queue.emplace((std::max)(top.first, order.rank[w]), w);
    }
  }
  order.ascending.swap(flooded);
  for(std::size_t i = 0; i < order.ascending.size(); ++i)
    order.rank[order.ascending[i]] = static_cast<std::uint32_t>(i);
}

// How much farther a vertex can be than one of higher rank: nothing, but where there was a flood
inline double disorder_of(const Vertex_order& order, const std::vector<double>& distance)
{
  double result = 0., farthest = 0.;
  for(Vertex v : order.ascending)
  {
    farthest = (std::max)(farthest, distance[v]);
    result = (std::max)(result, farthest - distance[v]);
  }
  return result;
}

// \pre every connected component has exactly one of the `roots`, and no vertex is isolated
inline Vertex_order order_vertices(const Mesh& mesh, const std::vector<double>& distance,
                                   const std::vector<Vertex>& roots, const std::vector<Vertex>& vertices)
{
  Vertex_order order;
  order.ascending = vertices;
  order.rank.assign(mesh.number_of_vertices(), Vertex_order::none);
  std::sort(order.ascending.begin(), order.ascending.end(),
            [&](Vertex a, Vertex b) { return distance[a] < distance[b] || (!(distance[b] < distance[a]) && a < b); });
  for(std::size_t i = 0; i < order.ascending.size(); ++i)
    order.rank[order.ascending[i]] = static_cast<std::uint32_t>(i);
  const auto is_minimum = [&](Vertex v) { return !has_lower_neighbour(mesh, order.rank, v); };
  const auto minima = std::count_if(vertices.begin(), vertices.end(), is_minimum);
  if(static_cast<std::size_t>(minima) != roots.size() || !std::all_of(roots.begin(), roots.end(), is_minimum))
    flood_from(roots, mesh, order);
  return order;
}

inline Vertex_order order_vertices(const Mesh& mesh, const std::vector<double>& distance,
                                   const std::vector<Vertex>& roots)
{
  return order_vertices(mesh, distance, roots, std::vector<Vertex>(mesh.vertices().begin(), mesh.vertices().end()));
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_ORDER_H
