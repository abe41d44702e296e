// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_GAPS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_GAPS_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far it is from a line to the next one beside it, straight over the surface
class Line_gaps
{
public:
  // What is farther than `farthest` is not sought.
  Line_gaps(const Mesh& mesh, const double farthest)
    : m_mesh(mesh), m_metric(mesh), m_is_line(lines_of(mesh)), m_farthest(farthest)
  {}

  // From the middle of h over its face, at a right angle: the faces that the way crosses are unfolded into a plane, in
  // which h lies on the first axis. Around a point of many faces without area rounding might lead in circles: so the
  // way has an end.
  double beside(Halfedge h) const
  {
    const double middle = .5 * m_metric.length(h);
    Planar_point a{0., 0.}, b{2. * middle, 0.}; // the ends of h
    for(int crossed = 0; crossed < most_faces && !m_mesh.is_border(h); ++crossed)
    {
      const Planar_point c = apex(h, a, b);
      const bool is_right = c.x < middle;
      (is_right ? a : b) = c;
      h = is_right ? m_mesh.next(h) : m_mesh.prev(h);
      const double t = b.x > a.x ? (middle - a.x) / (b.x - a.x) : .5;
      const double width = a.y + t * (b.y - a.y);
      if(!(width <= m_farthest))
        break;
      if(m_is_line[m_mesh.edge(h)])
        return width;
      h = m_mesh.opposite(h);
    }
    return infinity;
  }

private:
  static constexpr int most_faces = 1000;

  struct Planar_point
  {
    double x, y;
  };

  // Of the face of h, whose ends are at a and b: to the left of the way from a to b. The lengths of a metric may miss
  // the triangle inequality by a little.
  Planar_point apex(const Halfedge h, const Planar_point& a, const Planar_point& b) const
  {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if(!(length > 0.))
      return a;
    const double to_a = m_metric.length(m_mesh.prev(h)), to_b = m_metric.length(m_mesh.next(h));
    const double along = .5 * (length + (to_a - to_b) * (to_a + to_b) / length);
    const double height = std::sqrt((std::max)(0., to_a * to_a - along * along));
    const double x = (b.x - a.x) / length, y = (b.y - a.y) / length;
    return {a.x + along * x - height * y, a.y + along * y + height * x};
  }

  const Mesh& m_mesh;
  const Metric m_metric;
  const Mesh::Property_map<Edge, bool> m_is_line;
  const double m_farthest;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_GAPS_H
