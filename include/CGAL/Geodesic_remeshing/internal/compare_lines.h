// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_COMPARE_LINES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_COMPARE_LINES_H

#include <CGAL/Geodesic_remeshing/internal/Line_roughness.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline double length_of_boundary(const Mesh& mesh)
{
  double length = 0.;
  for(Edge e : mesh.edges())
    if(mesh.is_border(e))
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return length;
}

// That of the edges of a remeshing, measured along the input, of which there is much between two vertices near to each
// other where it is rough: the edge of equilateral triangles; or, of a narrow band, the part of the boundary that an
// edge stands for.
inline double edge_length_along(const Mesh& input, const Mesh& output)
{
  const auto all = output.edges();
  const auto on_boundary = std::count_if(all.begin(), all.end(), [&](Edge e) { return output.is_border(e); });
  const double faces = static_cast<double>(output.number_of_faces());
  const double inside = std::sqrt(4. / std::sqrt(3.) * Polygon_mesh_processing::area(input) / faces);
  return on_boundary == 0 ? inside : (std::max)(inside, length_of_boundary(input) / static_cast<double>(on_boundary));
}

// The marked and the boundary edges of an input, and the edges of an output, by the two meshes alone
class Line_comparison
{
public:
  Line_comparison(const Mesh& input, const Mesh& output, const std::vector<char>& is_marked)
    : m_input(input), m_edge_length(edge_length_along(input, output))
  {
    const auto is_line = [&](Edge e) { return input.is_border(e) || is_marked[e.idx()]; };
    const std::vector<int> degree = degrees_on_lines(input, is_line);
    m_pieces = trace_lines(input, is_line, [&](Vertex v) { return degree[v] != 2; });
    if(m_pieces.empty())
      return;
    Edge_tree tree(output.edges().begin(), output.edges().end(), output);
    for(const Line_piece& piece : m_pieces)
      m_distance.push_back(distance_of(piece, tree));
  }

  // The largest one of all lines from the edges of the output
  double distance() const { return m_distance.empty() ? 0. : *std::max_element(m_distance.begin(), m_distance.end()); }

  // Whether each line is within a tolerance; or if it turns to and fro between two vertices of the output, as noise and
  // torn edges do, within what no mesh of that size follows: of noise, the farthest parts leave the chords of such
  // stretches by twice to two and a half times what they do in the mean.
  bool are_covered(const double tolerance) const
  {
    constexpr double farthest_by_mean = 2.5;
    Line_roughness roughness(m_input, m_edge_length);
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      if(m_distance[i] > tolerance && m_distance[i] > farthest_by_mean * roughness.run(m_pieces[i]))
        return false;
    return true;
  }

private:
  using Edge_tree = AABB_tree<AABB_traits_3<Kernel, AABB_halfedge_graph_segment_primitive<Mesh>>>;

  double distance_of(const Line_piece& piece, const Edge_tree& tree) const
  {
    constexpr double fewest = 4., most = 1e6; // parts of an edge
    double largest = 0.;
    for(const Halfedge h : piece.halfedges)
    {
      const Point &p = m_input.point(m_input.source(h)), &q = m_input.point(m_input.target(h));
      const double edges = std::sqrt(CGAL::squared_distance(p, q)) / m_edge_length; // of the output
      const double parts = (std::max)(fewest, (std::min)(std::ceil(4. * edges), most));
      for(double i = 0.; i <= parts; ++i)
        largest = (std::max)(largest, tree.squared_distance(p + (i / parts) * (q - p)));
    }
    return std::sqrt(largest);
  }

  const Mesh& m_input;
  const double m_edge_length;
  std::vector<Line_piece> m_pieces;
  std::vector<double> m_distance; // of each piece
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_COMPARE_LINES_H
