// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_BRIDGE_SIDES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_BRIDGE_SIDES_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Two fronts that begin on the two sides of one bridge must not march over it: of each vertex the region whose side it
// is on, where that matters.
class Bridge_sides
{
public:
  explicit Bridge_sides(const Mesh& mesh) : m_mesh(mesh) {}

  bool is_on(const Vertex v, const int region) const { return m_region_of[v] == region; }

  // By a flood over edges of the mesh, from some vertices over those that are `beside` the bridge.
  template <class Beside>
  void mark(const int region, std::vector<Vertex> stack, const Beside& beside)
  {
    if(m_region_of.empty())
      m_region_of.assign(m_mesh.number_of_vertices(), -1);
    while(!stack.empty())
    {
      const Vertex v = stack.back();
      stack.pop_back();
      if(is_on(v, region) || !beside(v))
        continue;
      m_region_of[v] = region;
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        stack.push_back(m_mesh.source(h));
    }
  }

private:
  const Mesh& m_mesh;
  std::vector<int> m_region_of;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_BRIDGE_SIDES_H
