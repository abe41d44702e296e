// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_TOP_SEARCH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_TOP_SEARCH_H

#include <CGAL/Geodesic_remeshing/internal/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Does a region end so near to its top that no curve fits between? On a surface with many handles most regions are of
// that kind, and their fronts long: to march all of them down to the saddle, for nothing, would cost the length of the
// front times the number of saddles. A way from the lowest vertex of the top down past the saddle proves it.
class Top_search
{
public:
  Top_search(const Mesh& mesh, const Intrinsic_triangulation& triangulation)
    : m_mesh(mesh), m_triangulation(triangulation), m_beside(mesh.number_of_vertices(), -1),
      m_length(mesh.number_of_vertices(), infinity)
  {}

  void add_side(Vertex v, int region) { m_beside[v] = region; }

  // By edges along which the front marches, over vertices that it `may_pass`, to one that it `arrives` at. Where
  // another front shares the top, from it to vertices beside this front only, and further by edges of the mesh.
  template <class MayPass, class Arrives>
  bool ends_within(double distance, Vertex top, int region, bool is_one_sided, const MayPass& may_pass,
                   const Arrives& arrives)
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](Vertex v, double length) {
      if(!(length < (std::min)(distance, m_length[v])))
        return;
      m_length[v] = length;
      m_touched.push_back(v);
      queue.emplace(length, v);
    };
    reach(top, 0.);
    bool is_found = false;
    while(!queue.empty() && !is_found)
    {
      const auto [length, v] = queue.top();
      queue.pop();
      if(m_length[v] < length)
        continue;
      for(auto spoke = m_triangulation.begin(v); spoke != m_triangulation.end(v); ++spoke)
      {
        const Vertex w(spoke->neighbor);
        is_found = is_found || (arrives(w) && length + spoke->length < distance);
        if(may_pass(w) && (!is_one_sided || m_beside[w] == region || (v != top && m_mesh.halfedge(v, w).is_valid())))
          reach(w, length + spoke->length);
      }
    }
    for(const Vertex v : m_touched)
      m_length[v] = infinity;
    m_touched.clear();
    return is_found;
  }

private:
  const Mesh& m_mesh;
  const Intrinsic_triangulation& m_triangulation;
  std::vector<int> m_beside;    // of a vertex: the last region that has it beside its front
  std::vector<double> m_length; // only what a search touched is reset after it
  std::vector<Vertex> m_touched;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TOP_SEARCH_H
