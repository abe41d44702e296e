// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_POINT_GRID_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_POINT_GRID_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Points in hashed grids, for finding those near a point. Each point is in the grid of its own size, the cells of one
// being twice as wide as those of the next, so that the distance between the points may change over the surface; where
// it does not there is but one grid. Neighbours are visited in an order that depends on nothing but the points and the
// order of their insertion.
class Point_grid
{
public:
  // The width of the cells for points of size 1
  Point_grid(double cell, std::size_t expected) : m_inverse(1. / cell)
  {
    std::size_t buckets = 64;
    while(buckets < expected)
      buckets *= 2;
    m_first.assign(buckets, none);
  }

  void insert(const Point& p, double size, std::uint32_t id)
  {
    const Grid g = grid(level(size));
    const std::uint32_t b = bucket(g, g.cell(p.x()), g.cell(p.y()), g.cell(p.z()));
    m_entries.push_back(Entry{p, id, m_first[b], g.level});
    m_first[b] = static_cast<std::uint32_t>(m_entries.size() - 1);
    m_lowest = (std::min)(m_lowest, g.level);
    m_highest = (std::max)(m_highest, g.level);
  }

  // Calls `visit(id, point, squared distance)` for the points within `radius` that are of a quarter to four times
  // `size`, and some that are of an eighth or of eight times; the radius must not exceed the width of the cells for
  // that size.
  template <class Visit>
  void near(const Point& p, double size, double radius, const Visit& visit) const
  {
    const int middle = level(size);
    for(int l = (std::max)(m_lowest, middle - 2); l <= (std::min)(m_highest, middle + 2); ++l)
      near(grid(l), p, radius, visit);
  }

private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  struct Entry
  {
    Point point;
    std::uint32_t id, next;
    int level;
  };

  struct Grid
  {
    int level;
    double inverse;
    std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x * inverse)); }
  };

  // The binary logarithm, rounded up
  static int level(double size)
  {
    int exponent;
    return std::frexp(size, &exponent) > .5 ? exponent : exponent - 1;
  }

  Grid grid(int level) const { return Grid{level, std::ldexp(m_inverse, -level)}; }

  template <class Visit>
  void near(const Grid& g, const Point& p, double radius, const Visit& visit) const
  {
    const double limit = radius * radius;
    const std::int64_t x0 = g.cell(p.x() - radius), x1 = g.cell(p.x() + radius), y0 = g.cell(p.y() - radius),
                       y1 = g.cell(p.y() + radius), z0 = g.cell(p.z() - radius), z1 = g.cell(p.z() + radius);
    for(std::int64_t x = x0; x <= x1; ++x)
      for(std::int64_t y = y0; y <= y1; ++y)
        for(std::int64_t z = z0; z <= z1; ++z)
          for(std::uint32_t i = m_first[bucket(g, x, y, z)]; i != none; i = m_entries[i].next)
          {
            const Point& q = m_entries[i].point;
            const double d = CGAL::squared_distance(p, q);
            if(d > limit)
              continue;
            // another cell may share the bucket
            if(m_entries[i].level == g.level && g.cell(q.x()) == x && g.cell(q.y()) == y && g.cell(q.z()) == z)
              visit(m_entries[i].id, q, d);
          }
  }

  std::uint32_t bucket(const Grid& g, std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    const std::uint64_t h = static_cast<std::uint64_t>(static_cast<std::int64_t>(g.level)) * 0xD6E8FEB86659FD93ull ^
                            static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ull ^
                            static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Full ^
                            static_cast<std::uint64_t>(z) * 0x165667B19E3779F9ull;
    return static_cast<std::uint32_t>((h >> 29) & (m_first.size() - 1));
  }

  double m_inverse;
  int m_lowest = (std::numeric_limits<int>::max)(), m_highest = (std::numeric_limits<int>::min)();
  std::vector<std::uint32_t> m_first;
  std::vector<Entry> m_entries;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_POINT_GRID_H
