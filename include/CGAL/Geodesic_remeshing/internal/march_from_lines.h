// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_MARCH_FROM_LINES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_MARCH_FROM_LINES_H

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/angle_at.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Does the boundary turn at this vertex of it, by more than 30 degrees?
inline bool turns_at(const Mesh& mesh, Vertex v)
{
  return std::abs(CGAL_PI - angle_at(mesh, v)) > CGAL_PI / 6.;
}

// A surface with boundary has its front start on a line of the boundary, not at a point (where the paper, section 4,
// has a root): parallel to a straight one curves stay straight and need no irregular vertices, where circles have one
// or two a row.
class Line_fronts
{
public:
  // `component_of` a vertex; the boundary in pieces
  Line_fronts(const Mesh& mesh, const std::vector<std::uint32_t>& component_of, std::size_t number_of_components,
              const std::vector<Line_piece>& boundary)
    : m_mesh(mesh), m_metric(mesh)
  {
    std::vector<double> best(number_of_components, -1.);
    std::vector<std::size_t> piece_of(number_of_components, boundary.size());
    for(std::size_t i = 0; i < boundary.size(); ++i)
    {
      const std::size_t c = component_of[mesh.source(boundary[i].halfedges.front())];
      const double merit = length_of(m_metric, boundary[i]) / (1. + std::abs(turning(boundary[i])));
      if(!(merit > best[c]))
        continue;
      best[c] = merit;
      piece_of[c] = i;
    }
    for(std::size_t i : piece_of)
      if(i < boundary.size())
        m_lines.push_back(&boundary[i]);
  }

  // Returns a vertex on the line of each component.
  std::vector<Vertex> march(Fast_marching& marching) const
  {
    std::vector<Vertex> starts;
    for(const Line_piece* line : m_lines)
    {
      starts.push_back(m_mesh.source(line->halfedges.front()));
      marching.add_source(starts.back());
      for(Halfedge h : line->halfedges)
        marching.add_source(m_mesh.target(h));
    }
    marching.march(Front_shape::planar);
    return starts;
  }

private:
  // By what angle the line turns within the surface, between its ends
  double turning(const Line_piece& piece) const
  {
    double sum = 0.;
    for(std::size_t i = piece.is_ring ? 0 : 1; i < piece.halfedges.size(); ++i)
      sum += CGAL_PI - angle_at(m_mesh, m_mesh.source(piece.halfedges[i]));
    return sum;
  }

  const Mesh& m_mesh;
  const Metric m_metric;
  std::vector<const Line_piece*> m_lines;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_MARCH_FROM_LINES_H
