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
// regions between, into the other. So a curve crosses each triangle twice or not at all, and never ends.
struct Crossing
{
  int region, level;
  double position; // along the edge, from source to target of its first halfedge
  bool descends;   // does the edge run away from the top of the region there?
};

class Level_crossings
{
public:
  explicit Level_crossings(const Segmentation& segmentation) : m_segmentation(segmentation)
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
      out.push_back(Crossing{r, k, t >= 0. && t <= 1. ? t : (t < 0. ? 0. : (t > 1. ? 1. : .5)), step > 0});
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

  const Route& best_route(Vertex a, Vertex b)
  {
    // Fronts never touch but at the junctions, so what is adjacent is so through junctions that were there already
    const std::size_t time = (std::max)(m_segmentation.time[a], m_segmentation.time[b]);
    const auto key = std::make_tuple(m_segmentation.field_region[a], m_segmentation.field_region[b], time);
    auto found = m_routes.find(key);
    if(found == m_routes.end())
      found = m_routes.emplace(key, find_routes(std::get<0>(key), std::get<1>(key), time)).first;
    const auto& routes = found->second;
    const auto length = [&](const Route& route) {
      return length_to_end(a, route.leaves_at_bottom) + route.length_between + length_to_end(b, route.enters_at_bottom);
    };
    return *std::min_element(routes.begin(), routes.end(),
                             [&](const Route& p, const Route& q) { return length(p) < length(q); });
  }

  // The four ways (out at top or bottom, in at top or bottom), each by the shortest walk between, where there is one
  std::vector<Route> find_routes(int r, int s, std::size_t time) const
  {
    std::vector<Route> routes;
    for(bool out_at_bottom : {true, false})
      for(bool in_at_bottom : {false, true})
        find_walk(out_at_bottom ? region(r).bottom : region(r).top, in_at_bottom ? region(s).bottom : region(s).top, r,
                  s, time, Route{out_at_bottom, in_at_bottom, {}, 0.}, routes);
    if(routes.empty() && time < m_at_junction.size())
      return find_routes(r, s, m_at_junction.size());
    CGAL_assertion(!routes.empty()); // an edge does not join different components
    return routes;
  }

  void find_walk(std::size_t from, std::size_t to, int r, int s, std::size_t time, Route route,
                 std::vector<Route>& routes) const
  {
    if(from >= time || to >= time)
      return;
    struct Reached
    {
      double length;
      int through;
      std::size_t before;
    };
    std::map<std::size_t, Reached> reached;
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    reached[from] = Reached{0., -1, from};
    queue.emplace(0., from);
    while(!queue.empty() && queue.top().second != to)
    {
      const Entry top = queue.top();
      queue.pop();
      if(top.first > reached[top.second].length)
        continue;
      for(int q : m_at_junction[top.second])
      {
        const std::size_t other = region(q).top == top.second ? region(q).bottom : region(q).top;
        if(q == r || q == s || other >= time)
          continue;
        const double length = top.first + region(q).height;
        const auto known = reached.find(other);
        if(known != reached.end() && known->second.length <= length)
          continue;
        reached[other] = Reached{length, q, top.second};
        queue.emplace(length, other);
      }
    }
    const auto end = reached.find(to);
    if(end == reached.end())
      return;
    route.length_between = end->second.length;
    for(std::size_t j = to; j != from; j = reached[j].before)
      route.between.emplace_back(reached[j].through, region(reached[j].through).bottom == j);
    std::reverse(route.between.begin(), route.between.end());
    routes.push_back(route);
  }

  const Segmentation& m_segmentation;
  std::vector<std::vector<int>> m_at_junction;
  std::map<std::tuple<int, int, std::size_t>, std::vector<Route>> m_routes;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CROSSINGS_H
