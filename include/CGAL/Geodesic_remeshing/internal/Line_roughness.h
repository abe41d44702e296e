// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_ROUGHNESS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_ROUGHNESS_H

#include <CGAL/Geodesic_remeshing/internal/squared_distance_to_segment.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far a line leaves the chords of its stretches of a given length, in the mean. Of a straight line that is nothing,
// of a smooth one the height of an arc, and a single corner counts for little; a line that turns to and fro within
// every stretch leaves them by its noise. A ring goes on behind its end; of a short one the stretches are thirds, as no
// mesh has fewer edges around it.
class Line_roughness
{
public:
  Line_roughness(const Mesh& mesh, const double stretch) : m_mesh(mesh), m_stretch(stretch) {}

  double run(const Line_piece& piece)
  {
    const double length = measure(piece);
    const double stretch = (std::min)(m_stretch, piece.is_ring ? length / 3. : length);
    if(!(stretch > 0.))
      return 0.;
    const double starts = piece.is_ring ? length : length - stretch;
    const double number = std::floor(starts / stretch * chords_of_a_stretch) + 1.;
    double sum = 0.;
    for(double i = 0.; i < number; ++i)
      sum += height_over(starts * i / number, stretch);
    return sum / number;
  }

private:
  static constexpr double chords_of_a_stretch = 4.; // that start on it

  // The length of the piece; a ring is gone around twice
  double measure(const Line_piece& piece)
  {
    m_points.assign(1, m_mesh.point(m_mesh.source(piece.halfedges.front())));
    m_position.assign(1, 0.);
    for(int round = 0; round < (piece.is_ring ? 2 : 1); ++round)
      for(const Halfedge h : piece.halfedges)
      {
        const Point& p = m_mesh.point(m_mesh.target(h));
        m_position.push_back(m_position.back() + std::sqrt(CGAL::squared_distance(m_points.back(), p)));
        m_points.push_back(p);
      }
    return m_position[piece.halfedges.size()];
  }

  double height_over(const double start, const double stretch) const
  {
    const Point from = point_at(start), to = point_at(start + stretch);
    double largest = 0.;
    for(std::size_t i = index_behind(start); i < m_points.size() && m_position[i] < start + stretch; ++i)
      largest = (std::max)(largest, squared_distance_to_segment(m_points[i], from, to));
    return std::sqrt(largest);
  }

  // Of the first point farther along the piece
  std::size_t index_behind(const double s) const
  {
    return std::upper_bound(m_position.begin(), m_position.end(), s) - m_position.begin();
  }

  Point point_at(const double s) const
  {
    const std::size_t i = index_behind(s);
    if(i == m_points.size())
      return m_points.back();
    const double t = (s - m_position[i - 1]) / (m_position[i] - m_position[i - 1]);
    return m_points[i - 1] + t * (m_points[i] - m_points[i - 1]);
  }

  const Mesh& m_mesh;
  const double m_stretch;
  std::vector<Point> m_points;
  std::vector<double> m_position;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_ROUGHNESS_H
