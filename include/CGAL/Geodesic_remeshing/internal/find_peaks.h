// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIND_PEAKS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIND_PEAKS_H

#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The tops of bumps that rise more than half a spacing over their last curve
inline std::vector<Vertex> find_peaks(const Mesh& mesh, const Segmentation& s)
{
  std::vector<Vertex> result;
  for(Vertex v : mesh.vertices())
  {
    const Region& region = s.regions[s.field_region[v]];
    if(s.field[v] - (s.level[v] - 1) * region.spacing < .5 * region.spacing)
      continue;
    bool is_peak = true;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      const Vertex w = mesh.source(h);
      is_peak = is_peak && s.field_region[w] == s.field_region[v] && s.level[w] <= s.level[v] &&
                (s.field[w] < s.field[v] || (!(s.field[v] < s.field[w]) && w < v));
    }
    if(is_peak)
      result.push_back(v);
  }
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIND_PEAKS_H
