// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_STITCH_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_STITCH_H

#include "soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace command_line {
namespace internal {

// The ends of edges with one face
inline std::vector<std::size_t> vertices_of_boundary(const Soup& soup)
{
  std::vector<std::size_t> result;
  for_each_edge(sorted_sides(soup), [&](auto first, auto last) {
    if(last - first == 1)
      result.insert(result.end(), {first->low, first->high});
  });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Points in the cells of a grid as wide as the distance at which they are near
class Near_points
{
public:
  Near_points(const std::vector<Point>& points, const std::vector<std::size_t>& chosen, double distance)
    : m_points(points), m_distance(distance)
  {
    for(const std::size_t v : chosen)
      m_entries.push_back({cell(points[v]), v});
    std::sort(m_entries.begin(), m_entries.end());
  }

  template <class Visit>
  void for_each_near(std::size_t v, const Visit& visit) const
  {
    const Cell middle = cell(m_points[v]);
    for(const double x : {-1., 0., 1.})
      for(const double y : {-1., 0., 1.})
      {
        // the cells of a row follow each other
        const Cell low{{middle[0] + x, middle[1] + y, middle[2] - 1.}}, high{{low[0], low[1], middle[2] + 1.}};
        for(auto i = std::lower_bound(m_entries.begin(), m_entries.end(), Entry{low, 0});
            i != m_entries.end() && i->first <= high; ++i)
          if(CGAL::squared_distance(m_points[v], m_points[i->second]) <= m_distance * m_distance)
            visit(i->second);
      }
  }

private:
  using Cell = std::array<double, 3>;
  using Entry = std::pair<Cell, std::size_t>;

  Cell cell(const Point& p) const
  {
    return {{std::floor(p.x() / m_distance), std::floor(p.y() / m_distance), std::floor(p.z() / m_distance)}};
  }

  const std::vector<Point>& m_points;
  const double m_distance;
  std::vector<Entry> m_entries;
};

// Makes one vertex of those of the boundary that are no farther from each other than the tolerance; returns how many
// went.
inline std::size_t stitch(Soup& soup, double tolerance)
{
  const std::vector<std::size_t> boundary = vertices_of_boundary(soup);
  const Near_points near(soup.points, boundary, tolerance);
  Disjoint_sets sets(soup.points.size());
  for(const std::size_t v : boundary)
    near.for_each_near(v, [&](std::size_t w) { sets.union_set(v, w); });
  std::size_t number = 0;
  for(const std::size_t v : boundary)
    number += sets.find_set(v) != v;
  for(auto& polygon : soup.polygons)
    for(std::size_t& v : polygon)
      v = sets.find_set(v);
  return number;
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_STITCH_H
