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

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Fronts.h>
#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_order.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Builds the regions of a segmentation one by one (paper, section 5, "Tree regions construction"). The sweep over the
// distance D (`region_sweep.h`) tells the events: where a leaf begins, and where fronts meet.
//
// A region is *open* from the event that begins it to the one that ends it. Only then is its height known and its
// local distance marched, from its top and no further than to the level of the ending event: so the sum over all regions
// is about one pass over the surface.
class Region_builder
{
public:
  Region_builder(const Mesh& mesh, Fast_marching& marching, const std::vector<double>& distance,
                 const Vertex_order& order, double curve_distance)
    : m_mesh(mesh), m_marching(marching), m_distance(distance), m_order(order), m_curve_distance(curve_distance),
      m_fronts(mesh), m_front_of(mesh.number_of_vertices(), -1), m_path_length(mesh.number_of_vertices(), infinity),
      m_path_from(mesh.number_of_vertices())
  {
    const std::size_t n = mesh.number_of_vertices();
    m_result.region.assign(n, -1);
    m_result.field_region.assign(n, -1);
    m_result.field.assign(n, 0.);
    m_result.level.assign(n, 0);
    m_result.time.assign(n, 0);
  }

  const Segmentation& result() const { return m_result; }
  Segmentation take_result() { return std::move(m_result); }

  // A maximum of D that is not noise: the centre of a leaf region.
  int open_leaf(Vertex centre)
  {
    const int r = add_region(Region_kind::leaf, centre, m_result.number_of_junctions++);
    m_open[r].sources.emplace_back(centre, 0.);
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
    std::vector<Vertex> stack(1, neighbour);
    m_path_length[neighbour] = 0.;
    m_path_touched.push_back(neighbour);
    int found = candidates.front();
    while(!stack.empty())
    {
      const Vertex v = stack.back();
      stack.pop_back();
      if(std::find(candidates.begin(), candidates.end(), m_front_of[v]) != candidates.end())
      {
        found = m_front_of[v];
        break;
      }
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      {
        const Vertex w = m_mesh.source(h);
        if(m_fronts.is_taken(w) || m_order.rank[w] <= m_order.rank[saddle] || m_path_length[w] < infinity)
          continue;
        m_path_length[w] = 0.;
        m_path_touched.push_back(w);
        stack.push_back(w);
      }
    }
    forget_paths();
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
      close(r, saddle, junction);

    std::vector<Vertex> bridge(1, saddle);
    std::vector<std::vector<Vertex>> ways;
    for(std::size_t i = 0; i < arcs.size(); ++i)
      ways.push_back(way_to_front(saddle, arcs[i], ways));
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

  // The last region of a connected component, around its root. `open` are the regions still open there; those that do not
  // reach the root (a pocket behind a bridge) are filled on their own.
  void finish(Vertex root, const std::vector<int>& open)
  {
    int main = open.front();
    for(int r : open)
      if(open.size() > 1 && reaches(r, root))
        main = r;
    finish_region(main, root, true);
    for(int r : open)
      if(r != main)
        finish_region(r, root, false);
  }

  // A leaf that meets nothing reaches the root. It ends half way, and the root region goes on with the same circles.
  int open_root_below_leaf(int leaf)
  {
    Region& region = m_result.regions[leaf];
    region.bottom = m_result.number_of_junctions++;
    const Vertex centre = region.centre;
    march(leaf);
    m_marching.march(Front_shape::circular, infinity);
    double reach = 0.;
    for(Vertex v : m_marching.reached())
      reach = (std::max)(reach, m_marching.distance(v));
    region.number_of_levels = static_cast<int>(std::floor(.5 * reach / m_curve_distance));
    region.height = region.number_of_levels * m_curve_distance;
    take_leaf(leaf);
    const int r = add_region(Region_kind::root, centre, m_result.regions[leaf].bottom);
    m_result.regions[r].children.push_back(leaf);
    m_result.regions[leaf].parents.push_back(r);
    m_open[r].sources.emplace_back(centre, 0.);
    m_open[r].offset = m_result.regions[leaf].height;
    return r;
  }

private:
  struct Open_region
  {
    std::vector<std::pair<Vertex, double>> sources; // the top: vertices and their (signed) distances from it
    std::vector<Vertex> waiting;                    // vertices that the fronts above had to leave, see Fronts
    std::vector<Vertex> side;                       // free vertices beside the front, if another shares its bridge
    double offset = 0.;                             // of the top from the sources
  };

  int add_region(Region_kind kind, Vertex centre, std::size_t top)
  {
    Region region;
    region.kind = kind;
    region.centre = centre;
    region.spacing = m_curve_distance;
    region.top = region.bottom = top;
    m_result.regions.push_back(region);
    m_open.emplace_back();
    return static_cast<int>(m_result.regions.size()) - 1;
  }

  void own(Vertex v, int r, double field)
  {
    m_result.region[v] = r;
    m_result.time[v] = m_result.regions[r].bottom;
    if(m_result.field_region[v] >= 0)
      return;
    m_result.field_region[v] = r;
    m_result.field[v] = field;
    m_result.level[v] = level_of(m_result.regions[r], field);
  }

  static int level_of(const Region& region, double field)
  {
    // the slack keeps the root, which lies a whole number of spacings from its top, from getting a curve around itself
    return (std::max)(1, static_cast<int>(std::ceil(field / region.spacing - 1e-9)));
  }

  // A vertex of a bridge lies on the bottom of the region above and on the top of the one below. Where fronts merge it counts
  // as part of the region that the bridge ends at; where a front splits that would close that region to a ring around
  // nothing, so it counts as part of the first region below, which `open_below` is about to add.
  void put_on_bridge(Vertex v, int above, int beside, bool splits)
  {
    const Region& region = m_result.regions[above];
    m_result.region[v] = splits ? static_cast<int>(m_result.regions.size()) : beside;
    m_result.time[v] = m_result.number_of_junctions;
    m_fronts.take(v);
    if(m_result.field_region[v] >= 0)
      return;
    m_result.field_region[v] = above;
    m_result.field[v] = region.height;
    m_result.level[v] = region.number_of_levels + 1; // outside of all curves of the region above
  }

  // Where a front splits, the vertices of the bridge have a region below on either side. They count to the first of them, or
  // where the bridge leaves no room for that one, to the other.
  int region_beside(Vertex v, const std::vector<int>& opened, int otherwise) const
  {
    for(int r : opened)
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if(!m_fronts.is_taken(m_mesh.source(h)) && m_front_of[m_mesh.source(h)] == r)
          return r;
    return otherwise;
  }

  void march(int r)
  {
    m_marching.clear();
    for(const auto& source : m_open[r].sources)
      m_marching.add_source(source.first, source.second);
  }

  // From a centre the fronts are circles, from the spectacles they are curves.
  Front_shape shape(int r) const
  {
    return m_open[r].sources.size() == 1 ? Front_shape::circular : Front_shape::planar;
  }

  bool is_unowned(Vertex v) const { return m_result.field_region[v] < 0; }

  // Ends an open region above a saddle: its height is the distance from its top to the curve of D through the saddle,
  // rounded down to a multiple of the curve distance (paper, section 5).
  void close(int r, Vertex saddle, std::size_t junction)
  {
    Region& region = m_result.regions[r];
    region.bottom = junction;
    march(r);
    const bool one_sided = mark_side(r, saddle);
    const auto domain = [&](Vertex v)
    { return is_unowned(v) && (!one_sided || m_side_of[v] == r || m_order.rank[v] <= m_order.rank[saddle]); };
    double reach = 0.;
    m_marching.march(shape(r), domain, [&](Vertex v, double d)
    {
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

  void take_leaf(int r)
  {
    const Region& region = m_result.regions[r];
    m_fronts.take(region.centre);
    own(region.centre, r, 0.);
    if(region.number_of_levels > 0)
      take_region(r, region.height);
  }

  // Leaves without a height are but centres on the bridges. They count to a region that has one and that the bridges
  // join them with, if there is any, so that each region is in one piece.
  void join_centres(const std::vector<std::vector<Vertex>>& ways)
  {
    std::vector<int> met;
    for(const auto& way : ways)
      if(!way.empty())
        met.push_back(whole_region(m_result.region[way.back()]));
    const auto is_centre = [this](int r)
    { return m_result.regions[r].kind == Region_kind::leaf && m_result.regions[r].number_of_levels == 0; };
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

  // Two fronts that begin on the two sides of one bridge must not march over it: marks the surface from the one front down to
  // the level of the saddle, by a flood over edges of the mesh.
  bool mark_side(int r, Vertex saddle)
  {
    if(m_open[r].side.empty())
      return false;
    if(m_side_of.empty())
      m_side_of.assign(m_mesh.number_of_vertices(), -1);
    std::vector<Vertex> stack = m_open[r].side;
    while(!stack.empty())
    {
      const Vertex v = stack.back();
      stack.pop_back();
      if(m_side_of[v] == r || m_fronts.is_taken(v) || m_order.rank[v] <= m_order.rank[saddle])
        continue;
      m_side_of[v] = r;
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        stack.push_back(m_mesh.source(h));
    }
    return true;
  }

  // Takes the vertices within `height` of the top, nearest first.
  void take_region(int r, double height)
  {
    std::vector<Vertex> near;
    for(Vertex v : m_marching.reached())
      if(is_unowned(v) && m_marching.distance(v) <= height)
        near.push_back(v);
    std::sort(near.begin(), near.end(), [this](Vertex a, Vertex b)
              { const double p = m_marching.distance(a), q = m_marching.distance(b); return p < q || (!(q < p) && a < b); });
    for(Vertex v : near)
    {
      m_result.field_region[v] = r;
      m_result.field[v] = m_marching.distance(v);
      m_result.level[v] = level_of(m_result.regions[r], m_result.field[v]);
    }
    near.insert(near.begin(), m_open[r].waiting.begin(), m_open[r].waiting.end());
    if(m_top_of.empty())
      m_top_of.assign(m_mesh.number_of_vertices(), -1);
    for(const auto& source : m_open[r].sources)
      m_top_of[source.first] = r;
    const auto is_own = [&](Vertex v) { return m_result.region[v] == r || m_top_of[v] == r; };
    m_fronts.sweep(near, is_own, [&](Vertex v)
    {
      m_result.region[v] = r;
      m_result.time[v] = m_result.regions[r].bottom;
    });
    m_open[r].waiting.clear();
    for(Vertex v : near)
      if(!m_fronts.is_taken(v))
        m_open[r].waiting.push_back(v);
  }

  // The shortest way along edges from the saddle through one arc of its neighbours to a front: free vertices, then a taken one.
  std::vector<Vertex> way_to_front(Vertex saddle, const std::vector<Vertex>& arc,
                                   const std::vector<std::vector<Vertex>>& other_ways)
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto relax = [&](Vertex from, Vertex to, double length)
    {
      if(m_order.rank[to] <= m_order.rank[saddle] || m_path_length[to] <= length)
        return;
      for(const auto& way : other_ways)
        if(std::find(way.begin(), way.end(), to) != way.end() && !m_fronts.is_taken(to))
          return;
      m_path_length[to] = length;
      m_path_from[to] = from;
      m_path_touched.push_back(to);
      queue.emplace(length, to);
    };
    for(Vertex v : arc)
      relax(saddle, v, edge_length(saddle, v));
    std::vector<Vertex> way;
    while(!queue.empty() && way.empty())
    {
      const Entry top = queue.top();
      queue.pop();
      if(m_path_length[top.second] < top.first)
        continue;
      if(m_fronts.is_taken(top.second))
        for(Vertex v = top.second; v != saddle; v = m_path_from[v])
          way.push_back(v);
      else
        for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(top.second)))
          relax(top.second, m_mesh.source(h), top.first + edge_length(top.second, m_mesh.source(h)));
    }
    std::reverse(way.begin(), way.end());
    forget_paths();
    return way;
  }

  double edge_length(Vertex v, Vertex w) const
  { return std::sqrt(CGAL::squared_distance(m_mesh.point(v), m_mesh.point(w))); }

  void forget_paths()
  {
    for(Vertex v : m_path_touched)
      m_path_length[v] = infinity;
    m_path_touched.clear();
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
      waiting.insert(waiting.end(), m_open[c].waiting.begin(), m_open[c].waiting.end());
      m_open[c] = Open_region();
    }
    const auto fronts = m_fronts.fronts_at(bridge);
    for(const auto& front : fronts)
    {
      const int r = add_region(Region_kind::interior, saddle, junction);
      opened.push_back(r);
      for(int c : closed)
      {
        m_result.regions[r].children.push_back(c);
        m_result.regions[c].parents.push_back(r);
      }
      for(Halfedge h : front)
      {
        const Vertex a = m_mesh.source(h);
        if(m_open[r].sources.empty() || m_open[r].sources.back().first != a)
          m_open[r].sources.emplace_back(a, field_below(a, closed));
        m_front_of[m_mesh.target(h)] = r;
        if(fronts.size() > 1)
          m_open[r].side.push_back(m_mesh.target(h));
      }
    }
    for(Vertex v : waiting)
      if(!m_fronts.is_taken(v) && m_front_of[v] >= 0 && m_front_of[v] < static_cast<int>(m_open.size()) && !opened.empty())
      {
        const int r = std::find(opened.begin(), opened.end(), m_front_of[v]) != opened.end() ? m_front_of[v] : opened.front();
        m_open[r].waiting.push_back(v);
        m_open[r].sources.emplace_back(v, field_below(v, closed));
      }
    return opened;
  }

  // The signed distance of a vertex of the regions above from their common bottom: zero or less.
  double field_below(Vertex v, const std::vector<int>& closed) const
  {
    int r = m_result.field_region[v];
    double result = m_result.field[v];
    while(true)
    {
      result -= m_result.regions[r].height;
      if(std::find(closed.begin(), closed.end(), r) != closed.end() || m_result.regions[r].parents.empty())
        return (std::min)(result, 0.);
      r = static_cast<int>(m_result.regions[r].parents.front());
    }
  }

  bool reaches(int r, Vertex root)
  {
    march(r);
    bool found = false;
    m_marching.march(shape(r), [this](Vertex v) { return is_unowned(v); },
                     [&](Vertex v, double) { found = found || v == root; return !found; });
    return found;
  }

  // The remainder of the height is spread over the curves (paper, section 6).
  void finish_region(int r, Vertex root, bool is_root)
  {
    Region& region = m_result.regions[r];
    region.bottom = m_result.number_of_junctions++;
    march(r);
    const double offset = m_open[r].offset;
    m_marching.march(shape(r), [&](Vertex v) { return offset > 0. || is_unowned(v); }, [](Vertex, double) { return true; });
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
        deepest = (std::max)(deepest, m_result.level[v]);
        m_fronts.take(v);
      }
    for(Vertex v : m_open[r].waiting)
    {
      m_result.region[v] = r;
      m_result.time[v] = region.bottom;
      m_fronts.take(v);
    }
    region.number_of_levels = (std::max)(0, deepest - 1);
    m_open[r] = Open_region();
  }

  const Mesh& m_mesh;
  Fast_marching& m_marching;
  const std::vector<double>& m_distance;
  const Vertex_order& m_order;
  const double m_curve_distance;

  Fronts m_fronts;
  std::vector<int> m_front_of;          // of a free vertex beside a front: the open region of that front
  std::vector<Open_region> m_open;
  std::vector<int> m_top_of;            // of a vertex: the region closed last whose top it is on
  std::vector<int> m_side_of;           // of a vertex: the region whose side of a bridge it is on, where that matters
  std::vector<double> m_path_length;    // scratch of the searches; only what they touched is reset
  std::vector<Vertex> m_path_from, m_path_touched;
  Segmentation m_result;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REGION_BUILDER_H
