// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DOWNHILL_SEARCH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DOWNHILL_SEARCH_H

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/nearest_in_triangle.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The points of the input, for searches on it
struct Point_of_surface
{
  const Surface_walker* walker;
  const Point& operator()(const Lean_triangulation::Index v) const { return walker->surface().point(Vertex(v)); }
};

// The place of a triangulation that is nearest to a point, sought downhill from face to face: it stays on the sheet
// where it begins, and costs next to nothing where it begins near its end. `point_of(v)` tells where the vertices are.
template <class Point_of>
class Downhill_search
{
public:
  using Index = Lean_triangulation::Index;

  struct Foot
  {
    Index face;
    Nearest_in_triangle nearest;
    double judged_distance; // squared; more than it is where the face is seen from behind
    double penalty() const { return judged_distance - nearest.squared_distance; }
  };

  // A face seen from behind is the other side of a thin part: it counts as farther, its squared distance by `penalty`.
  Downhill_search(const Lean_triangulation& table, const Point_of& point_of, const double penalty)
    : m_table(table), m_point_of(point_of), m_penalty(penalty)
  {}

  Foot foot_in(const Index f, const Point& p, const Vector& normal) const
  {
    const Point &a = m_point_of(m_table.source(4 * f)), &b = m_point_of(m_table.source(4 * f + 1)),
                &c = m_point_of(m_table.source(4 * f + 2));
    Foot foot{f, nearest_in_triangle(p, a, b, c), 0.};
    const bool is_behind = m_penalty > 0. && cross_product(b - a, c - a) * normal < 0.;
    foot.judged_distance = foot.nearest.squared_distance + (is_behind ? m_penalty : 0.);
    return foot;
  }

  // Where the nearest point is on an edge the way goes on beyond the edge, where it is a vertex around the vertex.
  Foot run(const Index from, const Point& p, const Vector& normal) const
  {
    Foot best = foot_in(from, p, normal);
    const auto try_face = [&](const Index f) {
      const Foot foot = foot_in(f, p, normal);
      if(foot.judged_distance < best.judged_distance)
        best = foot;
    };
    for(Index last = Lean_triangulation::none; last != best.face;)
    {
      last = best.face;
      const auto& c = best.nearest.coordinates;
      const Index zeros = !(c[0] > 0.) + !(c[1] > 0.) + !(c[2] > 0.);
      if(zeros == 1)
      {
        const Index o = m_table.opposite(4 * last + (!(c[0] > 0.) ? 1 : !(c[1] > 0.) ? 2 : 0));
        if(o != Lean_triangulation::none)
          try_face(Lean_triangulation::face(o));
      }
      else if(zeros == 2)
        m_table.for_each_outgoing(m_table.source(4 * last + (c[0] > 0.   ? 0
                                                             : c[1] > 0. ? 1
                                                                         : 2)),
                                  [&](const Index h) { try_face(Lean_triangulation::face(h)); });
    }
    return best;
  }

private:
  const Lean_triangulation& m_table;
  const Point_of m_point_of;
  const double m_penalty;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DOWNHILL_SEARCH_H
