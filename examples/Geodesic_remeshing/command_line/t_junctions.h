// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_T_JUNCTIONS_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_T_JUNCTIONS_H

#include "soup.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace command_line {
namespace internal {

// A vertex of the boundary on an edge of it, between its ends
struct T_junction
{
  std::size_t edge; // its number among those passed
  double along;     // from 0 to 1
  std::size_t vertex;
  double distance;
};

// Those no farther from the edges than the tolerance, in the order of the edges and along each; vertices that are as
// near to an end of an edge are not between its ends.
inline std::vector<T_junction> find_t_junctions(const std::vector<Point>& points,
                                                const std::vector<std::pair<std::size_t, std::size_t>>& edges,
                                                double tolerance)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  const CGAL::Vector_3<mesh_quality::Kernel> margin(tolerance, tolerance, tolerance);
  std::vector<std::size_t> vertices;
  std::vector<Box> boxes_of_edges, boxes_of_vertices;
  for(std::size_t i = 0; i < edges.size(); ++i)
  {
    const auto [a, b] = edges[i];
    vertices.insert(vertices.end(), {a, b});
    const CGAL::Bbox_3 box = points[a].bbox() + points[b].bbox();
    boxes_of_edges.emplace_back((Point(box.xmin(), box.ymin(), box.zmin()) - margin).bbox() +
                                    (Point(box.xmax(), box.ymax(), box.zmax()) + margin).bbox(),
                                i);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for(const std::size_t v : vertices)
    boxes_of_vertices.emplace_back(points[v].bbox(), v);
  std::vector<T_junction> found;
  CGAL::box_intersection_d(
      boxes_of_edges.begin(), boxes_of_edges.end(), boxes_of_vertices.begin(), boxes_of_vertices.end(),
      [&](const Box& edge, const Box& vertex) {
        const Point &a = points[edges[edge.info()].first], &b = points[edges[edge.info()].second];
        const Point& p = points[vertex.info()];
        const double along = ((p - a) * (b - a)) / (b - a).squared_length();
        if(!(along > 0. && along < 1.))
          return;
        const double limit = tolerance * tolerance, distance = CGAL::squared_distance(p, a + along * (b - a));
        if(distance <= limit && CGAL::squared_distance(p, a) > limit && CGAL::squared_distance(p, b) > limit)
          found.push_back({edge.info(), along, vertex.info(), std::sqrt(distance)});
      });
  std::sort(found.begin(), found.end(), [](const T_junction& s, const T_junction& t) {
    return std::tie(s.edge, s.along, s.vertex) < std::tie(t.edge, t.along, t.vertex);
  });
  return found;
}

// Divides the faces beside such edges, so that the edges end at these vertices. One edge of a face at a time; returns
// the number of vertices that edges were divided at.
inline std::size_t stitch_t_junctions(Soup& soup, double tolerance)
{
  std::size_t number = 0;
  for(int edge_of_face = 0; edge_of_face < 3; ++edge_of_face)
  {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    std::vector<std::size_t> face_of;
    for_each_edge(sorted_sides(soup), [&](auto first, auto last) {
      if(last - first != 1)
        return;
      edges.emplace_back(first->ascending ? first->low : first->high, first->ascending ? first->high : first->low);
      face_of.push_back(first->face);
    });
    const std::vector<T_junction> junctions = find_t_junctions(soup.points, edges, tolerance);
    std::vector<bool> is_changed(soup.polygons.size(), false);
    for(auto first = junctions.begin(); first != junctions.end();)
    {
      const auto last =
          std::find_if(first, junctions.end(), [&](const T_junction& t) { return t.edge != first->edge; });
      const std::size_t f = face_of[first->edge];
      const auto [a, b] = edges[first->edge];
      const std::size_t apex = soup.polygons[f][0] + soup.polygons[f][1] + soup.polygons[f][2] - a - b;
      const bool is_free =
          !is_changed[f] && std::none_of(first, last, [apex = apex](const T_junction& t) { return t.vertex == apex; });
      std::size_t from = a;
      for(; first != last; ++first)
        if(is_free)
        {
          soup.polygons.push_back(Polygon{from, first->vertex, apex});
          from = first->vertex;
          ++number;
        }
      if(is_free)
      {
        soup.polygons[f] = Polygon{from, b, apex};
        is_changed[f] = true;
      }
    }
    if(junctions.empty())
      break;
  }
  return number;
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_T_JUNCTIONS_H
