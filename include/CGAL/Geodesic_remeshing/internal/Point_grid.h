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

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Points in a hashed uniform grid, for finding those near a point. Neighbours are visited in an order that depends on
// nothing but the points and the order of their insertion.
class Point_grid
{
public:
  Point_grid(double cell, std::size_t expected) : m_inverse(1. / cell)
  {
    std::size_t buckets = 64;
    while(buckets < expected)
      buckets *= 2;
    m_first.assign(buckets, none);
  }

  void insert(const Point& p, std::uint32_t id)
  {
    const std::uint32_t b = bucket(cell(p.x()), cell(p.y()), cell(p.z()));
    m_entries.push_back(Entry{p, id, m_first[b]});
    m_first[b] = static_cast<std::uint32_t>(m_entries.size() - 1);
  }

  // Calls `visit(id, point, squared distance)` for the points within `radius`, which must not exceed the cell's size.
  template <class Visit>
  void near(const Point& p, double radius, const Visit& visit) const
  {
    const double limit = radius * radius;
    const std::int64_t x0 = cell(p.x() - radius), x1 = cell(p.x() + radius), y0 = cell(p.y() - radius),
                       y1 = cell(p.y() + radius), z0 = cell(p.z() - radius), z1 = cell(p.z() + radius);
    for(std::int64_t x = x0; x <= x1; ++x)
      for(std::int64_t y = y0; y <= y1; ++y)
        for(std::int64_t z = z0; z <= z1; ++z)
          for(std::uint32_t i = m_first[bucket(x, y, z)]; i != none; i = m_entries[i].next)
          {
            const Point& q = m_entries[i].point;
            if(cell(q.x()) != x || cell(q.y()) != y || cell(q.z()) != z)
              continue; // another cell in the same bucket
            const double d = CGAL::squared_distance(p, q);
            if(d <= limit)
              visit(m_entries[i].id, q, d);
          }
  }

private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  struct Entry
  {
    Point point;
    std::uint32_t id, next;
  };

  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x * m_inverse)); }

  std::uint32_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    const std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ull
                          ^ static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Full
                          ^ static_cast<std::uint64_t>(z) * 0x165667B19E3779F9ull;
    return static_cast<std::uint32_t>((h >> 29) & (m_first.size() - 1));
  }

  double m_inverse;
  std::vector<std::uint32_t> m_first;
  std::vector<Entry> m_entries;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_POINT_GRID_H
