// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_REGIONS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_REGIONS_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/angle_at.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Does the surface close to a tip around this vertex? On flat ground, too, fronts from a line meet, behind a hole for
// one; a sample there would only disturb the rows. A tip misses an angle: here a tenth of a radian, at the vertices
// around it up to some ring within the distance of two curves. Not at all within that distance: a horn has its tip and
// its root there, which miss nothing together (on ChineseDragon with 500 vertices the Hausdorff distance was a fifth
// larger).
inline bool is_pointed(const Mesh& mesh, Vertex tip, double curve_distance)
{
  const Metric metric(mesh);
  const double radius = curve_distance * (metric.is_uniform() ? 1. : metric.size(tip));
  double missing = 0.;
  std::vector<Vertex> near(1, tip);
  std::set<Vertex> seen = {tip};
  for(std::size_t i = 0; i < near.size() && missing < .1; ++i)
  {
    if(mesh.is_border(near[i], false))
      continue;
    missing += 2. * CGAL_PI - angle_at(mesh, near[i]);
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(near[i])))
    {
      const Vertex v = mesh.source(h);
      if(squared_distance(mesh.point(v), mesh.point(tip)) <= radius * radius && seen.insert(v).second)
        near.push_back(v);
    }
  }
  return !(missing < .1);
}

// A component whose front starts on a line is one region: its curves are arcs or loops at a whole part of its height,
// so that between two parallel lines there are whole rows. Where fronts run into boundaries the segmentation has no
// rule.
inline void add_line_regions(const std::vector<double>& distance, const std::vector<Vertex>& starts,
                             const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& component_of,
                             double curve_distance, Segmentation& result)
{
  const std::size_t n = component_of.size();
  result.region.resize(n, -1);
  result.field_region.resize(n, -1);
  result.field.resize(n, 0.);
  result.time.resize(n, 0);
  result.level.resize(n, 1);
  std::vector<int> region_of(starts.empty() ? 0 : *std::max_element(component_of.begin(), component_of.end()) + 1, -1);
  for(Vertex start : starts)
  {
    region_of[component_of[start]] = static_cast<int>(result.regions.size());
    Region region;
    region.kind = Region_kind::root;
    region.centre = start;
    region.top = result.number_of_junctions++;
    region.bottom = result.number_of_junctions++;
    result.regions.push_back(region);
  }
  for(Vertex v : vertices)
  {
    Region& region = result.regions[region_of[component_of[v]]];
    region.height = (std::max)(region.height, distance[v]);
  }
  for(Vertex start : starts)
  {
    Region& region = result.regions[region_of[component_of[start]]];
    region.number_of_levels = (std::max)(1, static_cast<int>(std::lround(region.height / curve_distance)));
    region.spacing = region.height > 0. ? region.height / region.number_of_levels : curve_distance;
  }
  for(Vertex v : vertices)
  {
    const int r = region_of[component_of[v]];
    result.region[v] = result.field_region[v] = r;
    result.field[v] = distance[v];
    result.time[v] = static_cast<std::uint32_t>(result.number_of_junctions);
    result.level[v] = (std::max)(1, static_cast<int>(std::ceil(distance[v] / result.regions[r].spacing - 1e-9)));
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_REGIONS_H
