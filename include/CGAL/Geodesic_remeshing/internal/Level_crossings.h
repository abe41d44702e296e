// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CROSSINGS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CROSSINGS_H

#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where the equidistant curves cross the edges of the working surface.
//
// Whether a curve crosses an edge is decided by integers alone: the region and the level of the two ends. Along an edge
// between two regions, the curves met are those of a walk through the region graph: out of the one region, through the
// regions between, into the other. So a curve crosses each triangle twice or not at all, and never ends, but where the
// walks of two edges lead different ways around a handle smaller than the triangle.
struct Crossing
{
  int region, level;
  double position; // along the edge, from source to target of its first halfedge
  bool descends;   // does the edge run away from the top of the region there?
};

class Level_crossings
{
public:
  explicit Level_crossings(const Segmentation& segmentation)
    : m_segmentation(segmentation), m_reached(segmentation.number_of_junctions)
  {
    m_at_junction.resize(segmentation.number_of_junctions);
    for(std::size_t r = 0; r < segmentation.regions.size(); ++r)
    {
      m_at_junction[segmentation.regions[r].top].push_back(static_cast<int>(r));
      m_at_junction[segmentation.regions[r].bottom].push_back(static_cast<int>(r));
    }
  }

  // Appends the crossings on an edge, in order from a to b.
  void append(Vertex a, Vertex b, std::vector<Crossing>& out)
  {
    const int r = m_segmentation.field_region[a], s = m_segmentation.field_region[b];
    if(r == s)
    {
      if(m_segmentation.level[a] != m_segmentation.level[b])
        append_within(a, b, out);
      return;
    }
    const std::size_t first = out.size();
    const Route& route = best_route(a, b);
    double travelled =
        append_stretch(r, m_segmentation.field[a], m_segmentation.level[a], route.leaves_at_bottom, true, 0., out);
    for(const auto& step : route.between)
      travelled += append_whole(step.first, step.second, travelled, out);
    const double total = travelled + append_stretch(s, m_segmentation.field[b], m_segmentation.level[b],
                                                    route.enters_at_bottom, false, travelled, out);
    for(std::size_t i = first; i < out.size(); ++i)
      out[i].position = total > 0. ? (std::min)(1., (std::max)(0., out[i].position / total)) : .5;
  }

private:
  // A walk from one region to another: out at top or bottom, down or up through others, in at top or bottom.
  struct Route
  {
    bool leaves_at_bottom, enters_at_bottom;
    std::vector<std::pair<int, bool>> between; // region, downwards?
    double length_between = 0.;
  };

  const Region& region(int r) const { return m_segmentation.regions[r]; }

  void append_within(Vertex a, Vertex b, std::vector<Crossing>& out) const
  {
    const int r = m_segmentation.field_region[a], from = m_segmentation.level[a], to = m_segmentation.level[b];
    const double u = m_segmentation.field[a], w = m_segmentation.field[b];
    const int step = from < to ? 1 : -1;
    for(int k = from < to ? from : from - 1; k != (from < to ? to : to - 1); k += step)
    {
      const double t = (region(r).value(k) - u) / (w - u); // not finite if the ends tie: then the middle
      out.push_back(Crossing{r, k, std::isfinite(t) ? (std::min)(1., (std::max)(0., t)) : .5, step > 0});
    }
  }

  // From a vertex with this field and level to the end of its region (`outwards`), or the other way round. Positions
  // are lengths from the start of the edge. Returns the length of the stretch.
  double append_stretch(int r, double field, int level, bool at_bottom, bool outwards, double start,
                        std::vector<Crossing>& out) const
  {
    const Region& reg = region(r);
    const double length = (std::max)(0., at_bottom ? reg.height - field : field);
    const int lowest = at_bottom ? level : 1, highest = at_bottom ? reg.number_of_levels : level - 1;
    const auto push = [&](int k) {
      const double from_vertex = (std::min)(length, std::abs(reg.value(k) - field));
      out.push_back(Crossing{r, k, start + (outwards ? from_vertex : length - from_vertex), at_bottom == outwards});
    };
    if(at_bottom == outwards)
      for(int k = lowest; k <= highest; ++k)
        push(k);
    else
      for(int k = highest; k >= lowest; --k)
        push(k);
    return length;
  }

  double append_whole(int r, bool downwards, double start, std::vector<Crossing>& out) const
  {
    const Region& reg = region(r);
    for(int i = 1; i <= reg.number_of_levels; ++i)
    {
      const int k = downwards ? i : reg.number_of_levels + 1 - i;
      const double from_top = (std::min)(reg.value(k), reg.height);
      out.push_back(Crossing{r, k, start + (downwards ? from_top : reg.height - from_top), downwards});
    }
    return reg.height;
  }

  double length_to_end(Vertex v, bool at_bottom) const
  {
    const double field = m_segmentation.field[v];
    return (std::max)(0., at_bottom ? region(m_segmentation.field_region[v]).height - field : field);
  }

  // A route, or that there is none whose stretch between is not longer than `longest`
  struct Way
  {
    Route route;
    bool is_found = false;
    double longest = -1.;
  };

  // Out at the bottom or the top of one region, in at the top or the bottom of the other
  using Ways = std::array<Way, 4>;
  static bool leaves_at_bottom(std::size_t way) { return way < 2; }
  static bool enters_at_bottom(std::size_t way) { return way % 2 == 1; }

  // Of the four ways, each by the shortest walk between, the shortest. Most edges have one that is not longer than
  // themselves, and only as far are the others sought: around a handle they would be as long as the graph is large.
  const Route& best_route(Vertex a, Vertex b)
  {
    // Fronts never touch but at the junctions, so what is adjacent is so through junctions that were there already
    const std::size_t time = (std::max)(m_segmentation.time[a], m_segmentation.time[b]);
    const int r = m_segmentation.field_region[a], s = m_segmentation.field_region[b];
    Ways& ways = m_routes[std::make_tuple(r, s, time)];
    const auto length = [&](std::size_t i, double between) {
      return length_to_end(a, leaves_at_bottom(i)) + between + length_to_end(b, enters_at_bottom(i));
    };
    find_any(r, s, time, ways);
    std::size_t best = ways.size();
    double shortest = infinity;
    const auto compare = [&](std::size_t i) {
      const double l = ways[i].is_found ? length(i, ways[i].route.length_between) : infinity;
      if(l < shortest || (!(shortest < l) && i < best))
        best = i, shortest = l;
    };
    for(std::size_t i = 0; i < ways.size(); ++i)
      compare(i);
    for(std::size_t i = 0; i < ways.size(); ++i)
      if(const double least = length(i, 0.); least < shortest || (!(shortest < least) && i < best))
      {
        find_way(r, s, i, time, shortest, ways[i]);
        compare(i);
      }
    CGAL_assertion(ways[best].is_found); // an edge does not join different components
    return ways[best].route;
  }

  // Regions that meet have a way without a stretch between.
  void find_any(int r, int s, std::size_t time, Ways& ways)
  {
    const auto is_any_found = [&] {
      return std::any_of(ways.begin(), ways.end(), [](const Way& way) { return way.is_found; });
    };
    for(std::size_t i = 0; i < ways.size(); ++i)
      if(out_of(r, i) == into(s, i))
        find_way(r, s, i, time, 0., ways[i]);
    for(double longest = region(r).spacing; !is_any_found() && ways[0].longest < infinity; longest *= 8.)
      for(std::size_t i = 0; i < ways.size(); ++i)
        find_way(r, s, i, time, longest < 1e6 * region(r).spacing ? longest : infinity, ways[i]);
    if(!is_any_found())
      for(std::size_t i = 0; i < ways.size(); ++i)
        find_walk(r, s, i, m_at_junction.size(), infinity, ways[i]);
  }

  void find_way(int r, int s, std::size_t i, std::size_t time, double longest, Way& way)
  {
    if(way.is_found || !(way.longest < longest))
      return;
    way.longest = longest;
    find_walk(r, s, i, time, longest, way);
  }

  std::size_t out_of(int r, std::size_t way) const { return leaves_at_bottom(way) ? region(r).bottom : region(r).top; }
  std::size_t into(int s, std::size_t way) const { return enters_at_bottom(way) ? region(s).bottom : region(s).top; }

  void find_walk(int r, int s, std::size_t i, std::size_t time, double longest, Way& way)
  {
    const std::size_t from = out_of(r, i), to = into(s, i);
    if(from >= time || to >= time)
      return;
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    reach(from, Reached{0., -1, from});
    queue.emplace(0., from);
    while(!queue.empty() && queue.top().second != to)
    {
      const Entry top = queue.top();
      queue.pop();
      if(top.first > m_reached[top.second].length)
        continue;
      for(int q : m_at_junction[top.second])
      {
        const std::size_t other = region(q).top == top.second ? region(q).bottom : region(q).top;
        if(q == r || q == s || other >= time)
          continue;
        const double length = top.first + region(q).height;
        if(length > longest || m_reached[other].length <= length)
          continue;
        reach(other, Reached{length, q, top.second});
        queue.emplace(length, other);
      }
    }
    if(m_reached[to].length < infinity)
    {
      way.is_found = true;
      way.route = Route{leaves_at_bottom(i), enters_at_bottom(i), {}, m_reached[to].length};
      for(std::size_t j = to; j != from; j = m_reached[j].before)
        way.route.between.emplace_back(m_reached[j].through, region(m_reached[j].through).bottom == j);
      std::reverse(way.route.between.begin(), way.route.between.end());
    }
    for(const std::size_t j : m_touched)
      m_reached[j] = Reached();
    m_touched.clear();
  }

  struct Reached
  {
    double length = infinity;
    int through = -1;
    std::size_t before = 0;
  };

  void reach(std::size_t junction, const Reached& reached)
  {
    m_reached[junction] = reached;
    m_touched.push_back(junction);
  }

  const Segmentation& m_segmentation;
  std::vector<Reached> m_reached; // of each junction: only what a walk touched is reset after it
  std::vector<std::size_t> m_touched;
  std::vector<std::vector<int>> m_at_junction;
  std::map<std::tuple<int, int, std::size_t>, Ways> m_routes;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CROSSINGS_H
