// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_SAMPLER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_SAMPLER_H

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Sample.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The samples on lines, and how far from the lines the vertices of the working surface are
struct Line_samples
{
  std::vector<Sample> samples;  // the corners, then the pieces, each from one end to the other
  std::vector<double> distance; // of a vertex; empty where there are no lines
};

// Samples what the output has to follow before anything else (paper, section 6, on feature curves): the corners, and
// each line between them at equal distances along it. What the curves bring keeps away from these.
class Line_sampler
{
public:
  Line_sampler(const Mesh& surface, const Working_surface& working)
    : m_surface(surface), m_working(working), m_mesh(working.mesh), m_input_metric(surface), m_metric(working.mesh)
  {}

  std::vector<Sample> run(const Constraints& constraints, const std::vector<Line_piece>& pieces, double spacing)
  {
    for(Vertex v : m_surface.vertices()) // they have the same index in the working surface
      if(constraints.is_corner[v.idx()])
        add_corner(v);
    const std::vector<int> fewest = fewest_intervals(m_mesh, pieces);
    for(std::size_t i = 0; i < pieces.size(); ++i)
      sample_piece(pieces[i], spacing, fewest[i]);
    return std::move(m_samples);
  }

private:
  void add_corner(Vertex v)
  {
    Sample sample{face_at(m_mesh, v), m_working.place[v], m_mesh.point(v), m_metric.size(v), true, -1, 0};
    sample.vertex = v;
    m_samples.push_back(sample);
  }

  void sample_piece(const Line_piece& piece, double spacing, int fewest)
  {
    const double length = length_of(m_metric, piece);
    const std::size_t n = number_of_intervals(piece, length, spacing, fewest);
    double travelled = 0.; // up to the current halfedge
    std::size_t i = 0;
    for(std::size_t j = piece.is_ring ? 0 : 1; j < n; ++j)
    {
      const double s = length * static_cast<double>(j) / static_cast<double>(n);
      while(i + 1 < piece.halfedges.size() && travelled + length_of(m_metric, piece, i) < s)
        travelled += length_of(m_metric, piece, i++);
      const double l = length_of(m_metric, piece, i);
      add_on_line(piece.halfedges[i], l > 0. ? (std::min)(1., (s - travelled) / l) : 0.);
    }
  }

  void add_on_line(Halfedge h, double position)
  {
    const Face f = m_mesh.face(m_mesh.is_border(h) ? m_mesh.opposite(h) : h);
    std::array<double, 3> weights = {{0., 0., 0.}};
    const auto corners = vertices_of(m_mesh, f);
    for(int i = 0; i < 3; ++i)
      weights[i] = corners[i] == m_mesh.source(h) ? 1. - position : corners[i] == m_mesh.target(h) ? position : 0.;
    const Place place = place_on_input(m_surface, m_working, f, weights);
    Sample sample{f, place, internal::point_at(m_surface, place), m_input_metric.size(place), false, -1, 0};
    sample.line = h;
    m_samples.push_back(sample);
  }

  const Mesh& m_surface;
  const Working_surface& m_working;
  const Mesh& m_mesh;
  const Metric m_input_metric, m_metric;
  std::vector<Sample> m_samples;
};

// Those that are marked, see line_edges.h
inline std::vector<Line_piece> trace_marked_lines(const Mesh& mesh, const Constraints& constraints)
{
  const auto is_line = lines_of(mesh);
  const auto is_corner = [&](Vertex v) {
    return v.idx() < constraints.is_corner.size() && constraints.is_corner[v.idx()];
  };
  std::vector<Line_piece> pieces = trace_lines(
      mesh, [&](Edge e) { return is_line[e]; }, is_corner);
  for(Line_piece& piece : pieces)
    piece.is_kept = constraints.are_kept;
  return pieces;
}

// Up to `farthest`, on a surface that is cut along the lines, so that a line is not near to what lies beyond another
// one or on another sheet. The edges on lines are short enough for the distance from their vertices to do.
inline std::vector<double> distances_from_lines(const Mesh& cut, Fast_marching& marching, double farthest)
{
  marching.clear();
  for(Vertex v : cut.vertices())
    if(cut.is_border(v, false))
      marching.add_source(v);
  marching.march(Front_shape::planar, farthest);
  std::vector<double> result(cut.number_of_vertices(), farthest);
  for(Vertex v : marching.reached())
    result[v] = marching.distance(v);
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_SAMPLER_H
