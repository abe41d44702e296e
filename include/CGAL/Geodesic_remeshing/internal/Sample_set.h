// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SET_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SET_H

#include <CGAL/Geodesic_remeshing/internal/Component_extent.h>
#include <CGAL/Geodesic_remeshing/internal/Point_grid.h>
#include <CGAL/Geodesic_remeshing/internal/Sample.h>
#include <CGAL/Geodesic_remeshing/internal/Sheet_search.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The samples so far, and where there is room for more. `mesh` is what their faces are faces of.
class Sample_set
{
public:
  Sample_set(const Mesh& mesh, double edge_length, std::size_t expected)
    : m_edge_length(edge_length), m_grid(1.5 * edge_length, expected), m_sheets(mesh)
  {
    m_samples.reserve(expected + expected / 8);
  }

  std::size_t size() const { return m_samples.size(); }
  std::vector<Sample> take() { return std::move(m_samples); }

  void add(const Sample& sample)
  {
    m_grid.insert(sample.point, sample.size, static_cast<std::uint32_t>(m_samples.size()));
    m_samples.push_back(sample);
  }

  // A sample is refused where another is nearer than half an edge length: rows of samples where two curves almost touch
  // only make needles. On one curve samples keep their own distance, which in a thin tube may be smaller: those from
  // `first_of_curve` on do not count. Beside lines there must be room for triangles.
  bool is_free(const Sample& sample, std::size_t first_of_curve)
  {
    return !(sample.distance_from_lines < room_beside_lines * m_edge_length) &&
           is_free(sample.face, sample.point, sample.size, first_of_curve);
  }

  // Samples on another sheet, however near, do no harm, if it is another one as far as the triangles to come reach:
  // around a limb or the rim of a fin they do.
  bool is_free(Face f, const Point& p, double size, std::size_t first_of_curve)
  {
    bool free = true;
    const double distance = .5 * m_edge_length * size;
    m_grid.near(p, size, distance, [&](std::uint32_t id, const Point&, double) {
      free = free && (id >= first_of_curve || !m_sheets.connects(f, m_samples[id].face, p, 3. * distance));
    });
    return free;
  }

  // If it is not, no search over sheets is needed. May be asked by several threads, unlike the others.
  bool is_near_others(const Sample& sample) const
  {
    bool result = sample.distance_from_lines < room_beside_lines * m_edge_length;
    m_grid.near(sample.point, sample.size, .5 * m_edge_length * sample.size,
                [&](std::uint32_t, const Point&, double) { result = true; });
    return result;
  }

  // Calls `visit(sample, its point)` for those within this distance.
  template <class Visit>
  void for_each_near(const Point& p, double size, double distance, const Visit& visit) const
  {
    m_grid.near(p, size, distance, [&](std::uint32_t id, const Point& q, double) { visit(m_samples[id], q); });
  }

private:
  const double m_edge_length;
  Point_grid m_grid;
  Sheet_search m_sheets;
  std::vector<Sample> m_samples;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SET_H
