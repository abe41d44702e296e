// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TOUCHING_EDGES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TOUCHING_EDGES_H

#include "soup.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace command_line {
namespace internal {

// Solids that touch each other, or themselves, along an edge, as those made of cubes and many of machine parts do: four
// faces have the edge, which no mesh has. To cut the surface open there leaves slits, and the solid is none any more;
// here it is parted into sheets that touch, each of which has the two faces that have inside between them.
class Touching_edges
{
public:
  explicit Touching_edges(Soup& soup) : m_soup(soup) {}

  // Returns the number of edges that were parted: those that as many faces run through in one direction as in the
  // other.
  std::size_t part()
  {
    find();
    const std::size_t number = m_edges.size();
    if(number == 0)
      return 0;
    while(divide_edges_between_the_same_fans())
      find();
    give_each_fan_a_vertex();
    return number;
  }

private:
  using Pair = std::pair<std::size_t, std::size_t>; // of faces
  struct Edge
  {
    std::size_t low, high;
    std::vector<Pair> pairs;
  };

  // Of the edge that this one is a part of, if edges were divided. An edge from a middle to an apex is a part of none.
  Pair ends_of(const std::size_t low, const std::size_t high) const
  {
    const auto end = m_ends.find(high); // the later of the two
    if(end == m_ends.end())
      return {low, high};
    const Pair& ends = end->second;
    const auto other = m_ends.find(low);
    const bool is_part = low == ends.first || low == ends.second || (other != m_ends.end() && other->second == ends);
    return is_part ? ends : Pair(low, high);
  }

  // Around an edge from its one end to the other, a face that runs through it in this direction has the inside before
  // it, and one that runs against it has it behind. All is measured at the undivided edge and from the apexes, where
  // faces lie on each other they come in the order of these: both parts of an edge must be paired alike.
  std::vector<Pair> pairs_around(std::vector<Side>::const_iterator first, std::vector<Side>::const_iterator last) const
  {
    const Pair ends = ends_of(first->low, first->high);
    const Point &a = m_soup.points[ends.first], &b = m_soup.points[ends.second];
    const CGAL::Vector_3<mesh_quality::Kernel> axis = b - a;
    const bool is_reversed = (m_soup.points[first->high] - m_soup.points[first->low]) * axis < 0.;
    if(2 * std::count_if(first, last, [](const Side& s) { return s.ascending; }) != last - first)
      return {};
    std::vector<std::pair<std::size_t, const Side*>> apexes;
    for(auto s = first; s != last; ++s)
    {
      const auto& p = m_soup.polygons[s->face];
      apexes.emplace_back(p[0] + p[1] + p[2] - s->low - s->high, &*s);
    }
    std::sort(apexes.begin(), apexes.end());
    const auto way_to = [&](const std::size_t apex) { return m_soup.points[apex] - a; };
    const auto x = CGAL::cross_product(CGAL::cross_product(axis, way_to(apexes.front().first)), axis);
    const auto y = CGAL::cross_product(axis, x);
    if(!(x.squared_length() > 0.))
      return {}; // a face without area
    const double length = std::sqrt(axis.squared_length());
    std::vector<std::pair<double, const Side*>> around;
    for(const auto& [apex, side] : apexes)
      around.emplace_back(std::atan2(way_to(apex) * y, length * (way_to(apex) * x)), side);
    std::stable_sort(around.begin(), around.end(), [](const auto& s, const auto& t) { return s.first < t.first; });
    // Like brackets that open and close: solids that overlap have one pair within another. Twice around, as the first
    // to close may have been opened last.
    std::vector<Pair> pairs;
    std::vector<std::size_t> open;
    for(int round = 0; round < 2; ++round)
      for(auto& [angle, side] : around)
        if(side != nullptr && side->ascending == is_reversed && round == 0)
          open.push_back(side->face);
        else if(side != nullptr && side->ascending != is_reversed && !open.empty())
        {
          pairs.emplace_back(open.back(), side->face);
          open.pop_back();
          side = nullptr;
        }
    return pairs;
  }

  std::size_t corner(std::size_t f, std::size_t v) const
  {
    const auto& p = m_soup.polygons[f];
    return 3 * f + (p[0] == v ? 0 : p[1] == v ? 1 : 2);
  }

  // The edges that are to be parted, and the fans of faces around vertices that there will be
  void find()
  {
    m_edges.clear();
    m_fans = Disjoint_sets(3 * m_soup.polygons.size());
    const std::vector<Side> sides = sorted_sides(m_soup);
    for_each_edge(sides, [&](auto first, auto last) {
      std::vector<Pair> pairs;
      if(last - first == 2)
        pairs.emplace_back(first->face, first[1].face);
      else if(last - first > 2)
      {
        pairs = pairs_around(first, last);
        if(!pairs.empty())
          m_edges.push_back({first->low, first->high, pairs});
      }
      for(const Pair& pair : pairs)
        for(const std::size_t v : {first->low, first->high})
          m_fans.union_set(corner(pair.first, v), corner(pair.second, v));
    });
  }

  // Where the same fans meet at both ends there would still be four faces: such an edge gets a vertex in its middle,
  // which will be as many as there are sheets. One edge of a face at a time.
  bool divide_edges_between_the_same_fans()
  {
    bool is_any_divided = false;
    std::vector<bool> is_changed(m_soup.polygons.size(), false);
    for(const Edge& e : m_edges)
    {
      std::vector<Pair> fans;
      bool is_free = true;
      for(const Pair& pair : e.pairs)
      {
        fans.emplace_back(m_fans.find_set(corner(pair.first, e.low)), m_fans.find_set(corner(pair.first, e.high)));
        is_free = is_free && !is_changed[pair.first] && !is_changed[pair.second];
      }
      std::sort(fans.begin(), fans.end());
      if(std::adjacent_find(fans.begin(), fans.end()) == fans.end())
        continue;
      is_any_divided = true;
      if(!is_free)
        continue;
      const std::size_t middle = m_soup.points.size();
      m_ends.emplace(middle, ends_of(e.low, e.high));
      m_soup.points.push_back(CGAL::midpoint(m_soup.points[e.low], m_soup.points[e.high]));
      for(const Pair& pair : e.pairs)
        for(const std::size_t f : {pair.first, pair.second})
        {
          is_changed[f] = true;
          Polygon other = m_soup.polygons[f];
          std::replace(other.begin(), other.end(), e.low, middle);
          std::replace(m_soup.polygons[f].begin(), m_soup.polygons[f].end(), e.high, middle);
          m_soup.polygons.push_back(other);
        }
    }
    return is_any_divided;
  }

  void give_each_fan_a_vertex()
  {
    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> fan_of(m_soup.points.size(), none);
    std::vector<std::size_t> vertex_of(3 * m_soup.polygons.size(), none); // of the fans
    for(std::size_t f = 0; f < m_soup.polygons.size(); ++f)
      for(std::size_t i = 0; i < 3; ++i)
      {
        std::size_t& v = m_soup.polygons[f][i];
        const std::size_t fan = m_fans.find_set(3 * f + i);
        if(fan_of[v] == none)
        {
          fan_of[v] = fan;
          vertex_of[fan] = v;
        }
        else if(vertex_of[fan] == none)
        {
          vertex_of[fan] = m_soup.points.size();
          m_soup.points.push_back(Point(m_soup.points[v]));
        }
        v = vertex_of[fan];
      }
  }

  Soup& m_soup;
  std::vector<Edge> m_edges;
  Disjoint_sets m_fans;
  std::map<std::size_t, Pair> m_ends; // of the edges that got these vertices in their middles
};

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TOUCHING_EDGES_H
