// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BUILDER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BUILDER_H

#include <CGAL/Geodesic_remeshing/internal/Region_growth.h>
#include <CGAL/Geodesic_remeshing/internal/Uphill_search.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Builds the regions of a segmentation one by one. The sweep over the distance D (`region_sweep.h`) tells the events:
// where a leaf begins, and where fronts meet. Here are the tops: centres, and the bridges through saddles.
class Region_builder
{
public:
  Region_builder(const Mesh& mesh, Fast_marching& marching, const std::vector<double>& distance,
                 const Vertex_order& order, double curve_distance)
    : m_mesh(mesh), m_growth(mesh, marching, distance, order, curve_distance), m_result(m_growth.result),
      m_fronts(m_growth.fronts), m_search(mesh, order, m_fronts), m_front_of(mesh.number_of_vertices(), -1)
  {}

  Segmentation take_result()
  {
    m_growth.complete();
    return std::move(m_result);
  }

  // A maximum of D that is not noise: the centre of a leaf region.
  int open_leaf(Vertex centre)
  {
    const int r = m_growth.add_region(Region_kind::leaf, centre, m_result.number_of_junctions++);
    m_growth.add_source(r, centre, 0.);
    m_front_of[centre] = r;
    m_result.tips.push_back(centre);
    return r;
  }

  // The open region whose front lies above this neighbour of a saddle, one of `candidates`. Between the saddle's level
  // and that front there is only free surface, so a search uphill over free vertices finds it.
  int region_above(Vertex saddle, Vertex neighbour, const std::vector<int>& candidates)
  {
    if(candidates.size() == 1)
      return candidates.front();
    int found = candidates.front();
    m_search.until(saddle, neighbour, [&](Vertex v) {
      if(std::find(candidates.begin(), candidates.end(), m_front_of[v]) == candidates.end())
        return false;
      found = m_front_of[v];
      return true;
    });
    return found;
  }

  // Fronts meet at a saddle: ends the regions above it, joins their bottoms by bridges through the saddle (the paper's
  // spectacles), and opens a region for each front that results: one where two fronts merge, two where a front that met
  // itself splits. `arcs[i]` are the neighbours above the saddle through which the front of `regions[i]` arrives.
  std::vector<int> meet(Vertex saddle, const std::vector<std::vector<Vertex>>& arcs, const std::vector<int>& regions)
  {
    std::vector<int> closed(regions);
    std::sort(closed.begin(), closed.end());
    closed.erase(std::unique(closed.begin(), closed.end()), closed.end());
    const std::size_t junction = m_result.number_of_junctions++;
    for(int r : closed)
      m_growth.close(r, saddle, junction);

    std::vector<Vertex> bridge(1, saddle);
    std::vector<std::vector<Vertex>> ways;
    for(std::size_t i = 0; i < arcs.size(); ++i)
      ways.push_back(m_search.way_to_front(saddle, arcs[i], ways));
    const bool splits = closed.size() < arcs.size();
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(Vertex v : ways[i])
        if(!m_fronts.is_taken(v))
        {
          put_on_bridge(v, regions[i], m_result.region[ways[i].back()], splits);
          bridge.push_back(v);
        }
    const int beside = ways.front().empty() ? regions.front() : m_result.region[ways.front().back()];
    put_on_bridge(saddle, regions.front(), beside, splits);
    add_bridges(saddle, ways);
    join_centres(ways);
    const std::vector<int> opened = open_below(saddle, junction, bridge, closed);
    if(splits)
      for(Vertex v : bridge)
        m_result.region[v] = region_beside(v, opened, beside);
    return opened;
  }

  // The last region of a connected component, around its root. `open` are the regions still open there; those that do
  // not reach the root (a pocket behind a bridge) are filled on their own.
  void finish(Vertex root, const std::vector<int>& open)
  {
    int main = open.front();
    for(int r : open)
      if(open.size() > 1 && m_growth.reaches(r, root))
        main = r;
    m_growth.finish_region(main, root, true);
    for(int r : open)
      if(r != main)
        m_growth.finish_region(r, root, false);
  }

  int open_root_below_leaf(int leaf) { return m_growth.open_root_below_leaf(leaf); }

private:
  // A vertex of a bridge lies on the bottom of the region above and on the top of the one below. Where fronts merge it
  // counts as part of the region that the bridge ends at; where a front splits that would close that region to a ring
  // around nothing, so it counts as part of the first region below, which `open_below` is about to add.
  void put_on_bridge(Vertex v, int above, int beside, bool splits)
  {
    const Region& region = m_result.regions[above];
    m_result.region[v] = splits ? static_cast<int>(m_result.regions.size()) : beside;
    m_result.time[v] = static_cast<std::uint32_t>(m_result.number_of_junctions);
    m_fronts.take(v);
    if(m_result.field_region[v] >= 0)
      return;
    m_result.field_region[v] = above;
    m_result.field[v] = region.height;
    m_result.level[v] = region.number_of_levels + 1; // outside of all curves of the region above
  }

  // Where a front splits, the vertices of the bridge have a region below on either side. They count to the first of
  // them, or where the bridge leaves no room for that one, to the other.
  int region_beside(Vertex v, const std::vector<int>& opened, int otherwise) const
  {
    for(int r : opened)
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if(!m_fronts.is_taken(m_mesh.source(h)) && m_front_of[m_mesh.source(h)] == r)
          return r;
    return otherwise;
  }

  // Leaves without a height are but centres on the bridges. They count to a region that has one and that the bridges
  // join them with, if there is any, so that each region is in one piece.
  void join_centres(const std::vector<std::vector<Vertex>>& ways)
  {
    std::vector<int> met;
    for(const auto& way : ways)
      if(!way.empty())
        met.push_back(whole_region(m_result.region[way.back()]));
    const auto is_centre = [this](int r) {
      return m_result.regions[r].kind == Region_kind::leaf && m_result.regions[r].number_of_levels == 0;
    };
    const auto joined = std::find_if_not(met.begin(), met.end(), is_centre);
    for(int r : met)
      if(is_centre(r) && r != (joined == met.end() ? met.front() : *joined) && m_result.regions[r].part_of < 0)
        m_result.regions[r].part_of = joined == met.end() ? met.front() : *joined;
  }

  int whole_region(int r) const
  {
    while(m_result.regions[r].part_of >= 0)
      r = m_result.regions[r].part_of;
    return r;
  }

  // One polyline through the saddle for two fronts; where more meet, one from the saddle to each further front.
  void add_bridges(Vertex saddle, const std::vector<std::vector<Vertex>>& ways)
  {
    for(std::size_t i = 0; i + 1 < ways.size(); ++i)
    {
      std::vector<Vertex> bridge;
      if(i == 0)
        bridge.assign(ways[0].rbegin(), ways[0].rend());
      bridge.push_back(saddle);
      bridge.insert(bridge.end(), ways[i + 1].begin(), ways[i + 1].end());
      m_result.bridges.push_back(bridge);
    }
  }

  std::vector<int> open_below(Vertex saddle, std::size_t junction, const std::vector<Vertex>& bridge,
                              const std::vector<int>& closed)
  {
    std::vector<int> opened;
    std::vector<Vertex> waiting;
    for(int c : closed)
    {
      waiting.insert(waiting.end(), m_growth.open[c].waiting.begin(), m_growth.open[c].waiting.end());
      m_growth.open[c] = Open_region();
    }
    const auto fronts = m_fronts.fronts_at(bridge);
    for(const auto& front : fronts)
    {
      const int r = m_growth.add_region(Region_kind::interior, saddle, junction);
      opened.push_back(r);
      for(int c : closed)
      {
        m_result.regions[r].children.push_back(c);
        m_result.regions[c].parents.push_back(r);
      }
      for(Halfedge h : front)
      {
        const Vertex a = m_mesh.source(h);
        if(m_growth.open[r].sources.empty() || m_growth.open[r].sources.back().first != a)
          m_growth.add_source(r, a, field_below(a, closed));
        m_front_of[m_mesh.target(h)] = r;
        if(fronts.size() > 1)
          m_growth.add_side(r, m_mesh.target(h));
      }
    }
    for(Vertex v : waiting)
      if(!m_fronts.is_taken(v) && m_front_of[v] >= 0 && m_front_of[v] < static_cast<int>(m_growth.open.size()) &&
         !opened.empty())
      {
        const int r =
            std::find(opened.begin(), opened.end(), m_front_of[v]) != opened.end() ? m_front_of[v] : opened.front();
        m_growth.open[r].waiting.push_back(v);
        m_growth.add_source(r, v, field_below(v, closed));
      }
    return opened;
  }

  // The signed distance of a vertex of the regions above from their common bottom: zero or less.
  double field_below(Vertex v, const std::vector<int>& closed)
  {
    int r = m_result.field_region[v];
    double result = m_result.field[v];
    while(true)
    {
      result -= m_result.regions[r].height;
      if(ends_at(r, closed))
        return (std::min)(result, 0.);
      r = next_below(r, closed);
    }
  }

  bool ends_at(int r, const std::vector<int>& closed) const
  {
    return m_result.regions[r].parents.empty() || std::find(closed.begin(), closed.end(), r) != closed.end();
  }

  // The first region below that has a height, or that is one of those closed last. A front that meets others again and
  // again before it gets on leaves long chains of regions without a height: the way past them is kept.
  int next_below(int r, const std::vector<int>& closed)
  {
    m_below.resize(m_result.regions.size(), -1);
    int below = m_below[r] >= 0 ? m_below[r] : static_cast<int>(m_result.regions[r].parents.front());
    while(m_result.regions[below].number_of_levels == 0 && !ends_at(below, closed))
      below = m_below[below] >= 0 ? m_below[below] : static_cast<int>(m_result.regions[below].parents.front());
    return m_below[r] = below;
  }

  const Mesh& m_mesh;
  Region_growth m_growth;
  Segmentation& m_result;
  Fronts& m_fronts;
  Uphill_search m_search;
  std::vector<int> m_below;    // of a region, where it is known: see next_below()
  std::vector<int> m_front_of; // of a free vertex beside a front: the open region of that front
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BUILDER_H
