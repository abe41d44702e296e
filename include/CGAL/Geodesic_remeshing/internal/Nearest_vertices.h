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
#include <CGAL/Geodesic_remeshing/internal/spatial_order.h>

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

  explicit Nearest_vertices(const Remeshed_surface& remeshed)
    : Nearest_vertices(
          remeshed, block_size_for(remeshed.walker().triangulation().vertex_slots(), remeshed.block_size().concurrency))
  {}

  Nearest_vertices(const Remeshed_surface& remeshed, Block_size size); // of blocks of the input

private:
  struct Offer
  {
    Index to, vertex;
  };

  bool take(const Remeshed_surface& remeshed, const Offer& offer);
};

inline bool Nearest_vertices::take(const Remeshed_surface& remeshed, const Offer& offer)
{
  const double distance =
      CGAL::squared_distance(remeshed.walker().surface().point(Vertex(offer.to)), remeshed.spot(offer.vertex).point);
  const bool is_nearer = distance < squared_distance[offer.to];
  if(is_nearer)
  {
    squared_distance[offer.to] = distance;
    vertex[offer.to] = offer.vertex;
  }
  return is_nearer;
}

// In each block of the input for itself until nothing changes any more; then what its border has to offer to other
// blocks is handed over.
inline Nearest_vertices::Nearest_vertices(const Remeshed_surface& remeshed, const Block_size size)
  : vertex(remeshed.walker().triangulation().vertex_slots(), Lean_triangulation::none),
    squared_distance(vertex.size(), infinity)
{
  const Lean_triangulation& input = remeshed.walker().triangulation();
  const Lean_triangulation& table = remeshed.connectivity();
  std::vector<std::vector<Offer>> in((vertex.size() >> size.bits) + 1), out(in.size());
  for(Index v = 0; v < table.vertex_slots(); ++v)
  {
    const Index h = 4 * static_cast<Index>(remeshed.spot(v).place.face);
    for(Index i = h; i < h + 3 && !table.is_removed(v); ++i)
      in[input.source(i) >> size.bits].push_back({input.source(i), v});
  }
  std::vector<Index> offered(vertex.size(), Lean_triangulation::none); // to the neighbors last
  const auto spread = [&](const std::size_t block) {
    std::vector<Index> queue;
    for(const Offer& offer : in[block])
      if(take(remeshed, offer))
        queue.push_back(offer.to);
    in[block].clear();
    for(std::size_t i = 0; i < queue.size(); ++i)
    {
      const Index v = vertex[queue[i]];
      if(offered[queue[i]] == v)
        continue;
      offered[queue[i]] = v;
      input.for_each_neighbor(queue[i], [&](const Index y) {
        if(y >> size.bits != block)
          out[block].push_back({y, v});
        else if(vertex[y] != v && take(remeshed, {y, v}))
          queue.push_back(y);
      });
    }
  };
  for(bool goes_on = true; goes_on;)
  {
    parallel_for(size.concurrency, in.size(), spread, 1);
    goes_on = false;
    for(std::vector<Offer>& offers : out)
    {
      goes_on = goes_on || !offers.empty();
      for(const Offer& offer : offers)
        in[offer.to >> size.bits].push_back(offer);
      offers.clear();
    }
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_NEAREST_VERTICES_H
