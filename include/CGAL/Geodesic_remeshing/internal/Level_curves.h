// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CURVES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CURVES_H

#include <CGAL/Geodesic_remeshing/internal/Level_crossings.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A point of a curve: on a halfedge, at source + position * (target - source). The way to the curve's next point lies
// in the face of the halfedge, and the top of the region on the side of its source.
struct Curve_point
{
  Halfedge halfedge;
  double position;
};

struct Level_curve
{
  int region, level;
  bool is_closed;
  std::size_t begin, end; // into Level_curves::points
};

// The equidistant curves of all regions and levels, as ordered polylines over the edges (paper, section 3).
struct Level_curves
{
  std::vector<Level_curve> curves; // by region, then level
  std::vector<Curve_point> points;
  std::vector<std::size_t> crossing_begin; // of an edge: its first crossing
  std::vector<Crossing> crossings;
  std::vector<std::size_t> point_of_crossing;
};

inline Point point_at(const Mesh& mesh, const Curve_point& p)
{
  const Point& a = mesh.point(mesh.source(p.halfedge));
  const Point& b = mesh.point(mesh.target(p.halfedge));
  return Point(a.x() + p.position * (b.x() - a.x()), a.y() + p.position * (b.y() - a.y()),
               a.z() + p.position * (b.z() - a.z()));
}

inline double density_at(const Mesh& mesh, const Metric& metric, const Curve_point& p)
{
  if(metric.is_uniform())
    return 1.;
  return (1. - p.position) * metric.density(mesh.source(p.halfedge)) +
         p.position * metric.density(mesh.target(p.halfedge));
}

// In the metric of the mesh
inline std::vector<double> lengths_of_curves(const Mesh& mesh, const Level_curves& curves)
{
  const Metric metric(mesh);
  std::vector<double> lengths;
  lengths.reserve(curves.curves.size());
  for(const Level_curve& curve : curves.curves)
  {
    double length = 0.;
    const Curve_point& first = curves.points[curve.is_closed ? curve.end - 1 : curve.begin];
    Point before = point_at(mesh, first);
    double density_before = density_at(mesh, metric, first);
    for(std::size_t i = curve.begin; i < curve.end; ++i)
    {
      const Point here = point_at(mesh, curves.points[i]);
      const double density = density_at(mesh, metric, curves.points[i]);
      length += .5 * (density_before + density) * std::sqrt(CGAL::squared_distance(before, here));
      before = here;
      density_before = density;
    }
    lengths.push_back(length);
  }
  return lengths;
}

// Follows the curves from crossing to crossing: many levels in one pass, each crossing visited once.
class Curve_tracer
{
public:
  Curve_tracer(const Mesh& mesh, const Segmentation& segmentation) : m_mesh(mesh)
  {
    Level_crossings crossings(segmentation);
    m_result.crossing_begin.reserve(mesh.number_of_edges() + 1);
    for(Edge e : mesh.edges())
    {
      m_result.crossing_begin.push_back(m_result.crossings.size());
      crossings.append(mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e)), m_result.crossings);
    }
    m_result.crossing_begin.push_back(m_result.crossings.size());
    m_result.point_of_crossing.assign(m_result.crossings.size(), unvisited);
  }

  Level_curves trace()
  {
    // arcs first: they begin on the boundary, or would be entered in their middle
    for(Edge e : m_mesh.edges())
      if(m_mesh.is_border(e))
        trace_from(e);
    for(Edge e : m_mesh.edges())
      trace_from(e);
    std::stable_sort(m_result.curves.begin(), m_result.curves.end(), [](const Level_curve& a, const Level_curve& b) {
      return a.region < b.region || (a.region == b.region && a.level < b.level);
    });
    return std::move(m_result);
  }

private:
  static constexpr std::size_t unvisited = static_cast<std::size_t>(-1);

  void trace_from(Edge e)
  {
    for(std::size_t c = m_result.crossing_begin[e.idx()]; c < m_result.crossing_begin[e.idx() + 1]; ++c)
    {
      if(m_result.point_of_crossing[c] != unvisited)
        continue;
      // with the top on the left hand
      Halfedge h = m_mesh.halfedge(e, m_result.crossings[c].descends ? 0 : 1);
      if(m_mesh.is_border(h))
        continue; // the other end of an arc
      trace_curve(h, c);
    }
  }

  void trace_curve(Halfedge h, std::size_t start)
  {
    Level_curve curve{m_result.crossings[start].region, m_result.crossings[start].level, false, m_result.points.size(),
                      0};
    std::size_t c = start;
    while(true)
    {
      const bool first = m_mesh.halfedge(m_mesh.edge(h), 0) == h;
      m_result.point_of_crossing[c] = m_result.points.size();
      m_result.points.push_back(
          Curve_point{h, first ? m_result.crossings[c].position : 1. - m_result.crossings[c].position});
      if(m_mesh.is_border(h) || !step(h, c))
        break;
      if(c == start)
      {
        curve.is_closed = true;
        break;
      }
      if(m_result.point_of_crossing[c] != unvisited)
        break;
    }
    curve.end = m_result.points.size();
    m_result.curves.push_back(curve);
  }

  // To the other crossing of the same curve in the face of h, and on to the halfedge on its far side
  bool step(Halfedge& h, std::size_t& c) const
  {
    const Crossing& here = m_result.crossings[c];
    for(Halfedge g : {m_mesh.next(h), m_mesh.prev(h)})
    {
      const std::size_t e = m_mesh.edge(g).idx();
      for(std::size_t i = m_result.crossing_begin[e]; i < m_result.crossing_begin[e + 1]; ++i)
        if(m_result.crossings[i].region == here.region && m_result.crossings[i].level == here.level)
        {
          c = i;
          h = m_mesh.opposite(g);
          return true;
        }
    }
    return false;
  }

  const Mesh& m_mesh;
  Level_curves m_result;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LEVEL_CURVES_H
