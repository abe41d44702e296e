// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BOUNDARIES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BOUNDARIES_H

#include <CGAL/Geodesic_remeshing/internal/Level_crossings.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where the boundaries of the regions cross the edges: of all equidistant curves those at the bottoms of regions.
//
// Some vertices belong to another region than the curves put them in: those of bridges, which lie between the fronts
// that meet there. For them the crossings on the way from the one region to the other are added at the ends of their
// edges, and what then crosses a boundary to and fro is taken away. So the crossings around a face cancel as those of
// the curves do: a boundary crosses each face twice or not at all.
class Region_boundaries
{
public:
  Region_boundaries(const Mesh& mesh, const Segmentation& segmentation)
    : m_mesh(mesh), m_segmentation(segmentation), m_whole(segmentation.regions.size()), m_last(m_whole.size())
  {
    for(std::size_t r = m_whole.size(); r-- > 0;) // parents come after their children
    {
      m_whole[r] = is_last(r) || region(r).number_of_levels > 0 ? static_cast<int>(r) : below(static_cast<int>(r));
      m_last[r] = is_last(r) ? static_cast<int>(r) : m_last[region(r).parents.front()];
    }
  }

  // Regions that degenerate to their tops are part of the region below, a leaf on a bridge of one beside it. A pocket
  // behind a bridge is a last region beside the root's: no way down leads from what is above the one to the other.
  int region_of(const Vertex v) const
  {
    int r = m_segmentation.region[v];
    while(region(r).part_of >= 0)
      r = region(r).part_of;
    const int by_curves = region_by_curves(v);
    return m_last[r] == m_last[by_curves] ? m_whole[r] : by_curves;
  }

  // The region on the other side of the bottom
  int below(const int r) const { return m_whole[region(r).parents.front()]; }

  Level_curves crossings() const; // nothing else of the curves

private:
  const Region& region(const std::size_t r) const { return m_segmentation.regions[r]; }
  bool is_last(const std::size_t r) const { return region(r).parents.empty(); }

  // The region that the curves put a vertex in
  int region_by_curves(const Vertex v) const
  {
    const int r = m_segmentation.field_region[v];
    return is_last(r) || m_segmentation.level[v] <= region(r).number_of_levels ? r : below(r);
  }

  void append_way(int from, int to, double position, std::vector<Crossing>& out) const;
  static void append(const Crossing& crossing, std::vector<Crossing>& out)
  {
    if(!out.empty() && out.back().region == crossing.region && out.back().descends != crossing.descends)
      out.pop_back();
    else
      out.push_back(crossing);
  }

  const Mesh& m_mesh;
  const Segmentation& m_segmentation;
  std::vector<int> m_whole; // of each region: the one that it is part of
  std::vector<int> m_last;  // of each region: the one that the ways down from it end in
};

// Down to the region that both lie above, and up again
inline void Region_boundaries::append_way(int from, int to, const double position, std::vector<Crossing>& out) const
{
  std::vector<int> up;
  while(from != to)
    if(from < to)
    {
      append({from, region(from).number_of_levels, position, true}, out);
      from = below(from);
    }
    else
    {
      up.push_back(to);
      to = below(to);
    }
  for(; !up.empty(); up.pop_back())
    append({up.back(), region(up.back()).number_of_levels, position, false}, out);
}

inline Level_curves Region_boundaries::crossings() const
{
  Level_curves result;
  Level_crossings all(m_segmentation);
  std::vector<Crossing> on_edge, of_boundaries;
  for(Edge e : m_mesh.edges())
  {
    const Vertex a = m_mesh.source(m_mesh.halfedge(e)), b = m_mesh.target(m_mesh.halfedge(e));
    on_edge.clear();
    of_boundaries.clear();
    all.append(a, b, on_edge);
    append_way(region_of(a), region_by_curves(a), 0., of_boundaries);
    for(const Crossing& crossing : on_edge)
      if(!is_last(crossing.region) && crossing.level == region(crossing.region).number_of_levels)
        append(crossing, of_boundaries);
    append_way(region_by_curves(b), region_of(b), 1., of_boundaries);
    result.crossing_begin.push_back(result.crossings.size());
    result.crossings.insert(result.crossings.end(), of_boundaries.begin(), of_boundaries.end());
  }
  result.crossing_begin.push_back(result.crossings.size());
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BOUNDARIES_H
