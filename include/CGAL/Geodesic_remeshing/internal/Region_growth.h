// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REGION_GROWTH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REGION_GROWTH_H

#include <CGAL/Geodesic_remeshing/internal/Bridge_sides.h>
#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Fronts.h>
#include <CGAL/Geodesic_remeshing/internal/Open_region.h>
#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/Top_search.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_order.h>
#include <CGAL/Geodesic_remeshing/internal/complete_regions.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Grows single regions (paper, section 5, "Tree regions construction"); what begins and ends them is the business of
// `Region_builder`.
//
// A region is *open* from the event that begins it to the one that ends it. Only then is its height known and its
// local distance marched, from its top and no further than to the level of the ending event: so the sum over all
// regions is about one pass over the surface.
class Region_growth
{
public:
  Region_growth(const Mesh& mesh, Fast_marching& marching, const std::vector<double>& distance,
                const Vertex_order& order, double curve_distance)
    : fronts(mesh), m_mesh(mesh), m_marching(marching), m_distance(distance), m_order(order),
      m_curve_distance(curve_distance), m_top_of(mesh.number_of_vertices(), -1), m_sides(mesh),
      m_search(mesh, marching.triangulation()), m_disorder(disorder_of(order, distance))
  {
    const std::size_t n = mesh.number_of_vertices();
    result.region.assign(n, -1);
    result.field_region.assign(n, -1);
    result.field.assign(n, 0.);
    result.level.assign(n, 0);
    result.time.assign(n, 0);
  }

  Segmentation result;
  Fronts fronts;
  std::vector<Open_region> open; // by region

  int add_region(Region_kind kind, Vertex centre, std::size_t top)
  {
    Region region;
    region.kind = kind;
    region.centre = centre;
    region.spacing = m_curve_distance;
    region.top = region.bottom = top;
    result.regions.push_back(region);
    open.emplace_back();
    return static_cast<int>(result.regions.size()) - 1;
  }

  void add_source(int r, Vertex v, double distance)
  {
    Open_region& region = open[r];
    region.sources.emplace_back(v, distance);
    if(!region.lowest.is_valid() || m_order.rank[v] < m_order.rank[region.lowest])
      region.lowest = v;
  }

  void add_side(int r, Vertex v)
  {
    open[r].side.push_back(v);
    m_search.add_side(v, r);
  }

  // Ends an open region above a saddle: its height is the distance from its top to the curve of D through the saddle,
  // rounded down to a multiple of the curve distance (paper, section 5).
  void close(int r, Vertex saddle, std::size_t junction)
  {
    Region& region = result.regions[r];
    region.bottom = junction;
    const bool one_sided = !open[r].side.empty();
    if(is_flat(r, saddle, one_sided))
    {
      if(region.kind == Region_kind::leaf)
        take_leaf(r);
      return;
    }
    march(r);
    if(one_sided)
      m_sides.mark(r, open[r].side,
                   [&](Vertex v) { return !fronts.is_taken(v) && m_order.rank[v] > m_order.rank[saddle]; });
    const auto domain = [&](Vertex v) {
      return is_unowned(v) && (!one_sided || m_sides.is_on(v, r) || m_order.rank[v] <= m_order.rank[saddle]);
    };
    double reach = 0.;
    m_marching.march(shape(r), domain, [&](Vertex v, double d) {
      if(is_unowned(v) && m_order.rank[v] <= m_order.rank[saddle])
      {
        reach = (std::max)(0., d - (m_distance[saddle] - m_distance[v]));
        return false;
      }
      reach = (std::max)(0., d);
      return true;
    });
    region.number_of_levels = static_cast<int>(std::floor(reach / m_curve_distance + 1e-9));
    region.height = region.number_of_levels * m_curve_distance;
    if(region.kind == Region_kind::leaf)
      take_leaf(r);
    else if(region.number_of_levels > 0)
      take_region(r, region.height);
  }

  // A leaf that meets nothing reaches the root. It ends half way, and the root region goes on with the same circles.
  int open_root_below_leaf(int leaf)
  {
    Region& region = result.regions[leaf];
    region.bottom = result.number_of_junctions++;
    const Vertex centre = region.centre;
    march(leaf);
    m_marching.march(Front_shape::circular, infinity);
    double reach = 0.;
    for(Vertex v : m_marching.reached())
      reach = (std::max)(reach, m_marching.distance(v));
    region.number_of_levels = static_cast<int>(std::floor(.5 * reach / m_curve_distance));
    region.height = region.number_of_levels * m_curve_distance;
    take_leaf(leaf);
    const int r = add_region(Region_kind::root, centre, result.regions[leaf].bottom);
    result.regions[r].children.push_back(leaf);
    result.regions[leaf].parents.push_back(r);
    add_source(r, centre, 0.);
    open[r].offset = result.regions[leaf].height;
    return r;
  }

  // Does the front of the region get to the root?
  bool reaches(int r, Vertex root)
  {
    march(r);
    bool found = false;
    m_marching.march(
        shape(r), [this](Vertex v) { return is_unowned(v); },
        [&](Vertex v, double) {
          found = found || v == root;
          return !found;
        });
    return found;
  }

  // The remainder of the height is spread over the curves (paper, section 6).
  void finish_region(int r, Vertex root, bool is_root)
  {
    Region& region = result.regions[r];
    region.bottom = result.number_of_junctions++;
    march(r);
    const double offset = open[r].offset;
    m_marching.march(
        shape(r), [&](Vertex v) { return offset > 0. || is_unowned(v); }, [](Vertex, double) { return true; });
    double height = 0.;
    for(Vertex v : m_marching.reached())
      if(is_unowned(v) && (!is_root || v == root))
        height = (std::max)(height, m_marching.distance(v) - offset);
    region.height = height;
    region.spacing = height > 0. ? height / (std::max)(1., std::round(height / m_curve_distance)) : m_curve_distance;
    if(is_root)
    {
      region.kind = Region_kind::root;
      region.centre = root;
    }
    int deepest = 0;
    for(Vertex v : m_marching.reached())
      if(is_unowned(v) && m_marching.distance(v) < infinity)
      {
        own(v, r, m_marching.distance(v) - offset);
        deepest = (std::max)(deepest, result.level[v]);
        fronts.take(v);
      }
    for(Vertex v : open[r].waiting)
    {
      result.region[v] = r;
      result.time[v] = static_cast<std::uint32_t>(region.bottom);
      fronts.take(v);
    }
    region.number_of_levels = (std::max)(0, deepest - 1);
    open[r] = Open_region();
  }

  void complete() { complete_regions(m_mesh, m_order, result); }

private:
  // Is it sure that no curve fits between top and bottom? (The march comes nowhere later than along edges, but for what
  // repeated arrivals leave, far less than a tenth.)
  bool is_flat(int r, Vertex saddle, bool one_sided)
  {
    const auto is_below = [&](Vertex v) { return m_order.rank[v] <= m_order.rank[saddle]; };
    return m_search.ends_within(
        .9 * m_curve_distance - m_disorder, open[r].lowest, r, one_sided,
        [&](Vertex v) { return is_unowned(v) && (!one_sided || (!fronts.is_taken(v) && !is_below(v))); },
        [&](Vertex v) { return is_unowned(v) && is_below(v); });
  }

  void own(Vertex v, int r, double field)
  {
    result.region[v] = r;
    result.time[v] = static_cast<std::uint32_t>(result.regions[r].bottom);
    if(result.field_region[v] >= 0)
      return;
    result.field_region[v] = r;
    result.field[v] = field;
    result.level[v] = level_of(result.regions[r], field);
  }

  static int level_of(const Region& region, double field)
  {
    // the slack keeps the root, which lies a whole number of spacings from its top, from getting a curve around itself
    return (std::max)(1, static_cast<int>(std::ceil(field / region.spacing - 1e-9)));
  }

  void march(int r)
  {
    m_marching.clear();
    for(const auto& source : open[r].sources)
      m_marching.add_source(source.first, source.second);
  }

  // From a centre the fronts are circles, from the spectacles they are curves.
  Front_shape shape(int r) const { return open[r].sources.size() == 1 ? Front_shape::circular : Front_shape::planar; }

  bool is_unowned(Vertex v) const { return result.field_region[v] < 0; }

  void take_leaf(int r)
  {
    const Region& region = result.regions[r];
    fronts.take(region.centre);
    own(region.centre, r, 0.);
    if(region.number_of_levels > 0)
      take_region(r, region.height);
  }

  // Takes the vertices within `height` of the top, nearest first.
  void take_region(int r, double height)
  {
    std::vector<Vertex> near;
    for(Vertex v : m_marching.reached())
      if(is_unowned(v) && m_marching.distance(v) <= height)
        near.push_back(v);
    std::sort(near.begin(), near.end(), [this](Vertex a, Vertex b) {
      const double p = m_marching.distance(a), q = m_marching.distance(b);
      return p < q || (!(q < p) && a < b);
    });
    for(Vertex v : near)
    {
      result.field_region[v] = r;
      result.field[v] = m_marching.distance(v);
      result.level[v] = level_of(result.regions[r], result.field[v]);
    }
    near.insert(near.begin(), open[r].waiting.begin(), open[r].waiting.end());
    for(const auto& source : open[r].sources)
      m_top_of[source.first] = r;
    const auto is_own = [&](Vertex v) { return result.region[v] == r || m_top_of[v] == r; };
    fronts.sweep(near, is_own, [&](Vertex v) {
      result.region[v] = r;
      result.time[v] = static_cast<std::uint32_t>(result.regions[r].bottom);
    });
    open[r].waiting.clear();
    for(Vertex v : near)
      if(!fronts.is_taken(v))
        open[r].waiting.push_back(v);
  }

  const Mesh& m_mesh;
  Fast_marching& m_marching;
  const std::vector<double>& m_distance;
  const Vertex_order& m_order;
  const double m_curve_distance;
  std::vector<int> m_top_of; // of a vertex: the region closed last whose top it is on
  Bridge_sides m_sides;
  Top_search m_search;
  const double m_disorder;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REGION_GROWTH_H
