// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_VERTICES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_VERTICES_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// For each vertex of the input the nearest vertex of the triangulation, searched along the surface from the faces where
// the vertices are: what is near in space but on another sheet does not count.
struct Nearest_vertices
{
  using Index = Lean_triangulation::Index;

  std::vector<Index> vertex; // `none` on isolated vertices and components without vertices
  std::vector<double> squared_distance;

  explicit Nearest_vertices(const Remeshed_surface& remeshed);
};

inline Nearest_vertices::Nearest_vertices(const Remeshed_surface& remeshed)
  : vertex(remeshed.walker().triangulation().vertex_slots(), Lean_triangulation::none),
    squared_distance(vertex.size(), infinity)
{
  const Lean_triangulation& input = remeshed.walker().triangulation();
  const Lean_triangulation& table = remeshed.connectivity();
  std::vector<Index> queue;
  const auto offer = [&](const Index x, const Index v) {
    const double distance =
        CGAL::squared_distance(remeshed.walker().surface().point(Vertex(x)), remeshed.spot(v).point);
    if(!(distance < squared_distance[x]))
      return;
    squared_distance[x] = distance;
    vertex[x] = v;
    queue.push_back(x);
  };
  for(Index v = 0; v < table.vertex_slots(); ++v)
  {
    if(table.is_removed(v))
      continue;
    const Index h = 4 * static_cast<Index>(remeshed.spot(v).place.face);
    for(Index i = 0; i < 3; ++i)
      offer(input.source(h + i), v);
  }
  for(std::size_t i = 0; i < queue.size(); ++i)
  {
    const Index v = vertex[queue[i]];
    input.for_each_neighbor(queue[i], [&](const Index y) {
      if(vertex[y] != v)
        offer(y, v);
    });
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_VERTICES_H
