// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CURVE_SAMPLER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CURVE_SAMPLER_H

#include <CGAL/Geodesic_remeshing/internal/Component_extent.h>
#include <CGAL/Geodesic_remeshing/internal/Curve_phase.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/Line_sampler.h>
#include <CGAL/Geodesic_remeshing/internal/Sample_set.h>
#include <CGAL/Geodesic_remeshing/internal/Sampled_path.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/find_peaks.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Distributes the vertices of the new mesh over the curves (paper, section 6): first the root, the tips and the bridges
// with their T-junctions, then each curve, from the tops down, at equal distances and with the phase that puts each
// vertex opposite the middle of an edge of the curve before.
class Curve_sampler
{
public:
  Curve_sampler(const Mesh& surface, const Working_surface& working, const Segmentation& segmentation,
                const Level_curves& curves, const Line_samples& lines, double edge_length, std::size_t expected,
                const Concurrency concurrency = Concurrency())
    : m_surface(surface), m_working(working), m_mesh(working.mesh), m_metric(working.mesh),
      m_segmentation(segmentation), m_curves(curves), m_lines(lines), m_edge_length(edge_length),
      m_concurrency(concurrency), m_samples(working.mesh, edge_length, expected), m_path(surface, working, lines),
      m_phase(m_path, m_samples, edge_length, samples_of_a_block, concurrency)
  {
    m_pins.resize(curves.points.size() > 0 ? curves.curves.size() : 0);
  }

  // What does not depend on the spacing. Returns the number of these samples beside those that curves go through.
  std::size_t sample_off_curves(const std::vector<Vertex>& roots)
  {
    for(const Sample& sample : m_lines.samples)
      m_samples.add(sample);
    for(Vertex r : roots)
      add_vertex(r, true);
    for(Vertex v : m_segmentation.tips)
      add_vertex(v, true);
    for(const auto& bridge : m_segmentation.bridges)
      sample_bridge(bridge);
    std::size_t result = m_samples.size();
    for(const auto& pins : m_pins)
      result -= pins.size();
    return result;
  }

  // `spacing` along the curves: a little different from the edge length that the mesh aims at, so that the number of
  // samples is the wanted number of vertices.
  std::vector<Sample> sample_curves(double spacing)
  {
    m_spacing = spacing;
    for(std::size_t c = 0; c < m_curves.curves.size(); ++c)
      sample_curve(c);
    for(Vertex v : find_peaks(m_mesh, m_segmentation)) // nothing else would cover them
      add_vertex(v, false);
    return m_samples.take();
  }

  // A rule for tiny curves: a loop needs three samples to be more than a line, and has them from three quarters of an
  // edge length on. Smaller ones surround a tip or a passing bump, which the samples around it cover.
  static int number_on_loop(double length, double spacing, double edge_length)
  {
    const int n = static_cast<int>(std::lround(length / spacing));
    return n >= 3 ? n : (length >= .75 * edge_length ? 3 : 0);
  }

private:
  // A sample takes a microsecond or two.
  static constexpr std::size_t samples_of_a_block = 128;

  // ---- the single samples

  bool add_vertex(Vertex v, bool is_pinned)
  {
    const Face f = face_at(m_mesh, v);
    if(!m_samples.is_free(f, m_mesh.point(v), m_metric.size(v), m_samples.size()) ||
       (!m_lines.distance.empty() && m_lines.distance[v] < room_beside_lines * m_edge_length))
      return false;
    std::array<double, 3> weights = {{0., 0., 0.}};
    for(int i = 0; i < 3; ++i)
      weights[i] = vertices_of(m_mesh, f)[i] == v ? 1. : 0.;
    m_samples.add(Sample{f, place_on_input(m_surface, m_working, f, weights), m_mesh.point(v), m_metric.size(v),
                         is_pinned, m_segmentation.field_region[v], 0});
    return true;
  }

  // ---- bridges

  // The first crossing met on the way along an edge, if any
  bool first_crossing(Vertex from, Vertex to, std::size_t& crossing, double& position) const
  {
    const Halfedge h = m_mesh.halfedge(from, to);
    const std::size_t e = m_mesh.edge(h).idx();
    const std::size_t begin = m_curves.crossing_begin[e], end = m_curves.crossing_begin[e + 1];
    if(begin == end)
      return false;
    const bool first = m_mesh.halfedge(m_mesh.edge(h), 0) == h;
    crossing = first ? begin : end - 1;
    position = first ? m_curves.crossings[crossing].position : 1. - m_curves.crossings[crossing].position;
    return true;
  }

  // The bridge runs from front to front; its ends on the two curves are the T-junctions, which both curves get as
  // samples.
  void sample_bridge(const std::vector<Vertex>& bridge)
  {
    std::vector<Path_point> path;
    std::size_t middle = bridge.size() / 2;
    for(std::size_t i = 0; i < bridge.size(); ++i)
      if(m_segmentation.level[bridge[i]] >
         m_segmentation.regions[m_segmentation.field_region[bridge[i]]].number_of_levels)
        middle = i; // on the bridge proper, beyond the curves of the regions above
    std::size_t low = middle, high = middle, crossing_low = 0, crossing_high = 0;
    double t_low = 0., t_high = 0.;
    bool cut_low = false, cut_high = false;
    while(low > 0 && !(cut_low = first_crossing(bridge[low], bridge[low - 1], crossing_low, t_low)))
      --low;
    while(high + 1 < bridge.size() &&
          !(cut_high = first_crossing(bridge[high], bridge[high + 1], crossing_high, t_high)))
      ++high;
    if(cut_low)
    {
      const Halfedge h = m_mesh.halfedge(bridge[low - 1], bridge[low]);
      path.push_back(m_path.on_edge(h, 1. - t_low));
    }
    for(std::size_t i = low; i < high; ++i)
      path.push_back(m_path.on_edge(m_mesh.halfedge(bridge[i], bridge[i + 1]), 0.));
    if(high > 0 && !cut_high)
      path.push_back(m_path.on_edge(m_mesh.halfedge(bridge[high - 1], bridge[high]), 1.));
    if(cut_high)
    {
      const Halfedge h = m_mesh.halfedge(bridge[high], bridge[high + 1]);
      path.push_back(m_path.on_edge(h, 0.));
      path.push_back(m_path.on_edge(h, t_high));
    }
    if(path.size() < 2)
      return;
    m_path.set(path, false);
    const double length = m_path.length();
    if(length < .6 * m_edge_length)
      return; // the two curves almost touch: samples on either serve both
    const int n = (std::max)(1, static_cast<int>(std::lround(length / m_edge_length)));
    for(int i = 0; i <= n; ++i)
    {
      Sample sample = m_path.sample_at(length * i / n, m_segmentation.field_region[bridge[middle]], 0);
      if(!m_samples.is_free(sample, m_samples.size()))
        continue;
      if(i == 0 && cut_low)
        pin(crossing_low);
      if(i == n && cut_high)
        pin(crossing_high);
      m_samples.add(sample);
    }
  }

  // The curve through this crossing has a sample there already.
  void pin(std::size_t crossing)
  {
    const std::size_t point = m_curves.point_of_crossing[crossing];
    const auto c = std::partition_point(curve_order().begin(), curve_order().end(),
                                        [&](const std::pair<std::size_t, std::size_t>& p) { return p.first <= point; });
    const std::size_t curve = std::prev(c)->second;
    m_pins[curve].push_back(point - m_curves.curves[curve].begin);
  }

  // (first point, curve), by first point
  const std::vector<std::pair<std::size_t, std::size_t>>& curve_order()
  {
    if(m_order.empty())
    {
      for(std::size_t c = 0; c < m_curves.curves.size(); ++c)
        m_order.emplace_back(m_curves.curves[c].begin, c);
      std::sort(m_order.begin(), m_order.end());
    }
    return m_order;
  }

  // ---- curves

  void sample_curve(std::size_t c)
  {
    const Level_curve& curve = m_curves.curves[c];
    std::vector<Path_point>& path = m_scratch;
    path.clear();
    for(std::size_t i = curve.begin; i < curve.end; ++i)
      path.push_back(m_path.on_edge(m_curves.points[i].halfedge, m_curves.points[i].position));
    if(path.size() < 2)
      return;
    m_path.set(path, curve.is_closed);
    const double length = m_path.length();
    std::vector<std::size_t>& pins = m_pins[c];
    if(!pins.empty() && curve.is_closed)
    {
      sample_between_pins(curve, pins);
      return;
    }
    const int n = number_on_loop(length, m_spacing, m_edge_length);
    if(n == 0)
      return;
    const double step = length / n, start = step * m_phase(curve, n);
    add_row(curve, start, step, n);
  }

  void add_row(const Level_curve& curve, double start, double step, int n)
  {
    const std::size_t first = m_samples.size();
    m_row.resize(n);
    m_is_near_others.resize(n);
    parallel_for(
        m_concurrency, m_row.size(),
        [&](const std::size_t i) {
          m_row[i] = m_path.sample_at(start + static_cast<double>(i) * step, curve.region, curve.level);
          m_is_near_others[i] = m_samples.is_near_others(m_row[i]);
        },
        samples_of_a_block);
    for(std::size_t i = 0; i < m_row.size(); ++i)
      if(!m_is_near_others[i] || m_samples.is_free(m_row[i], first))
        m_samples.add(m_row[i]);
  }

  void sample_between_pins(const Level_curve& curve, std::vector<std::size_t>& pins)
  {
    std::sort(pins.begin(), pins.end());
    pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
    const double length = m_path.length();
    for(std::size_t i = 0; i < pins.size(); ++i)
    {
      const double from = m_path.lengths()[pins[i]];
      const double to = i + 1 < pins.size() ? m_path.lengths()[pins[i + 1]] : length + m_path.lengths()[pins.front()];
      const int n = (std::max)(1, static_cast<int>(std::lround((to - from) / m_spacing)));
      const double step = (to - from) / n;
      const std::size_t first = m_samples.size();
      for(int j = 1; j < n; ++j)
      {
        double s = from + j * step;
        s -= s >= length ? length : 0.;
        const Sample sample = m_path.sample_at(s, curve.region, curve.level);
        if(m_samples.is_free(sample, first))
          m_samples.add(sample);
      }
    }
  }

  const Mesh& m_surface;
  const Working_surface& m_working;
  const Mesh& m_mesh;
  const Metric m_metric;
  const Segmentation& m_segmentation;
  const Level_curves& m_curves;
  const Line_samples& m_lines;
  const double m_edge_length;
  double m_spacing = 0.;
  const Concurrency m_concurrency;
  Sample_set m_samples;
  std::vector<std::vector<std::size_t>> m_pins; // of a curve: its points that are samples already
  std::vector<std::pair<std::size_t, std::size_t>> m_order;
  Sampled_path m_path;
  const Curve_phase m_phase;
  std::vector<Path_point> m_scratch;
  std::vector<Sample> m_row;
  std::vector<char> m_is_near_others; // of a sample of the row
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CURVE_SAMPLER_H
