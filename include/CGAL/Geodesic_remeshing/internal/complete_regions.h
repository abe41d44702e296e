// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_COMPLETE_REGIONS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_COMPLETE_REGIONS_H

#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_order.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline bool has_region(const Segmentation& segmentation, Vertex v)
{
  return segmentation.region[v] >= 0 && segmentation.field_region[v] >= 0;
}

inline bool copy_neighbour(const Mesh& mesh, Vertex v, Segmentation& segmentation)
{
  for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
  {
    const Vertex w = mesh.source(h);
    if(!has_region(segmentation, w))
      continue;
    segmentation.region[v] = segmentation.region[w];
    segmentation.time[v] = static_cast<std::uint32_t>(segmentation.regions[segmentation.region[w]].bottom);
    segmentation.field_region[v] = segmentation.field_region[w];
    segmentation.field[v] = segmentation.field[w];
    segmentation.level[v] = segmentation.level[w];
    return true;
  }
  return false;
}

// Vertices that no march has reached, shut in by others, are as their neighbours are, from these inwards.
inline void complete_regions(const Mesh& mesh, const Vertex_order& order, Segmentation& segmentation)
{
  std::vector<Vertex> left;
  for(Vertex v : mesh.vertices())
    if(order.rank[v] != Vertex_order::none && !has_region(segmentation, v))
      left.push_back(v);
  for(std::size_t i = 0; i < left.size(); ++i)
  {
    const Vertex v = left[i];
    if(has_region(segmentation, v) || !copy_neighbour(mesh, v, segmentation))
      continue;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      const Vertex w = mesh.source(h); // which was passed by if it came before
      if(order.rank[w] != Vertex_order::none && !has_region(segmentation, w))
        left.push_back(w);
    }
  }
  CGAL_postcondition(std::all_of(left.begin(), left.end(), [&](Vertex v) { return has_region(segmentation, v); }));
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_COMPLETE_REGIONS_H
