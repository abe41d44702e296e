// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLED_PATH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLED_PATH_H

#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/Line_sampler.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Sample.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A point of a polyline on the working surface
struct Path_point
{
  Point point;
  double density;
  Halfedge halfedge;
  double position;
};

// A polyline on the working surface, measured in its metric, and the samples on it: one path at a time, in memory used
// again.
class Sampled_path
{
public:
  Sampled_path(const Mesh& surface, const Working_surface& working, const Line_samples& lines)
    : m_surface(surface), m_working(working), m_mesh(working.mesh), m_input_metric(surface), m_metric(working.mesh),
      m_lines(lines)
  {}

  Path_point on_edge(Halfedge h, double position) const
  {
    const Curve_point p{h, position};
    return Path_point{internal::point_at(m_mesh, p), density_at(m_mesh, m_metric, p), h, position};
  }

  void set(const std::vector<Path_point>& path, bool is_closed)
  {
    m_path = path;
    if(is_closed)
      m_path.push_back(path.front());
    m_length.assign(1, 0.);
    for(std::size_t i = 1; i < m_path.size(); ++i)
      m_length.push_back(m_length.back() + .5 * (m_path[i - 1].density + m_path[i].density) *
                                               std::sqrt(CGAL::squared_distance(m_path[i - 1].point, m_path[i].point)));
  }

  Sample sample_at(double s, int region, int level) const
  {
    std::size_t i = std::upper_bound(m_length.begin(), m_length.end(), s) - m_length.begin();
    i = (std::min)((std::max)(i, std::size_t(1)), m_length.size() - 1);
    const double l = m_length[i] - m_length[i - 1];
    const double t = l > 0. ? (std::min)(1., (std::max)(0., (s - m_length[i - 1]) / l)) : 0.;
    return sample_between(m_path[i - 1], m_path[i], t, region, level);
  }

  double length() const { return m_length.back(); }
  const std::vector<double>& lengths() const { return m_length; } // up to each point
  const Path_point& point(std::size_t i) const { return m_path[i]; }

private:
  Sample sample_between(const Path_point& a, const Path_point& b, double t, int region, int level) const
  {
    // both points lie on edges of the face of a's halfedge
    const Face f = m_mesh.face(a.halfedge);
    std::array<double, 3> weights = {{0., 0., 0.}};
    const auto corners = vertices_of(m_mesh, f);
    const auto put = [&](const Path_point& p, double w) {
      for(int i = 0; i < 3; ++i)
        weights[i] += w * (corners[i] == m_mesh.source(p.halfedge)   ? 1. - p.position
                           : corners[i] == m_mesh.target(p.halfedge) ? p.position
                                                                     : 0.);
    };
    put(a, 1. - t);
    put(b, t);
    const Place place = place_on_input(m_surface, m_working, f, weights);
    Sample sample{f, place, internal::point_at(m_surface, place), m_input_metric.size(place), false, region, level};
    sample.distance_from_lines = distance_from_lines(f, weights);
    return sample;
  }

  double distance_from_lines(Face f, const std::array<double, 3>& weights) const
  {
    if(m_lines.distance.empty())
      return infinity;
    const auto v = vertices_of(m_mesh, f);
    const auto& d = m_lines.distance;
    return weights[0] * d[v[0]] + weights[1] * d[v[1]] + weights[2] * d[v[2]];
  }

  const Mesh& m_surface;
  const Working_surface& m_working;
  const Mesh& m_mesh;
  const Metric m_input_metric, m_metric;
  const Line_samples& m_lines;
  std::vector<Path_point> m_path;
  std::vector<double> m_length;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLED_PATH_H
