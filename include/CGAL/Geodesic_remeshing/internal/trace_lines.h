// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_TRACE_LINES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_TRACE_LINES_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A line from one corner to the next, or a ring without corners: each halfedge begins where the one before ends.
struct Line_piece
{
  std::vector<Halfedge> halfedges;
  bool is_ring;
  bool is_kept = false; // an edge of the input that is to be an edge of the output
};

inline double length_of(const Metric& metric, const Line_piece& piece)
{
  double length = 0.;
  for(Halfedge h : piece.halfedges)
    length += metric.length(h);
  return length;
}

// The number of lines that end at or pass through each vertex
template <class IsLine>
std::vector<int> degrees_on_lines(const Mesh& mesh, const IsLine& is_line)
{
  std::vector<int> degree(mesh.number_of_vertices(), 0);
  for(Edge e : mesh.edges())
    if(is_line(e))
      for(int i = 0; i < 2; ++i)
        ++degree[mesh.vertex(e, i)];
  return degree;
}

// Divides the lines of a mesh into pieces. Every vertex that does not lie on exactly two line edges must be a corner.
template <class IsLine, class IsCorner>
std::vector<Line_piece> trace_lines(const Mesh& mesh, const IsLine& is_line, const IsCorner& is_corner)
{
  std::vector<char> traced(mesh.number_of_edges(), 0);
  std::vector<Line_piece> pieces;
  const auto trace = [&](Halfedge h) {
    const Vertex start = mesh.source(h);
    Line_piece piece{{h}, false};
    traced[mesh.edge(h).idx()] = 1;
    while(mesh.target(h) != start && !is_corner(mesh.target(h)))
    {
      Halfedge g = mesh.next(h);
      while(!is_line(mesh.edge(g)))
        g = mesh.next(mesh.opposite(g));
      h = g;
      traced[mesh.edge(h).idx()] = 1;
      piece.halfedges.push_back(h);
    }
    piece.is_ring = !is_corner(start);
    pieces.push_back(std::move(piece));
  };
  for(bool from_corners : {true, false})
    for(Edge e : mesh.edges())
      for(int i = 0; i < 2; ++i)
        if(is_line(e) && !traced[e.idx()] && (!from_corners || is_corner(mesh.source(mesh.halfedge(e, i)))))
          trace(mesh.halfedge(e, i));
  return pieces;
}

inline std::vector<Line_piece> trace_lines(const Mesh& mesh, const Constraints& constraints)
{
  return trace_lines(
      mesh, [&](Edge e) { return constraints.is_line[e.idx()] != 0; },
      [&](Vertex v) { return constraints.is_corner[v.idx()] != 0; });
}

// The fewest edges that can cover each piece, so that no two edges have the same ends: three for a ring or a loop at
// a corner, two where another piece joins the same corners already.
inline std::vector<int> fewest_intervals(const Mesh& mesh, const std::vector<Line_piece>& pieces)
{
  using Ends = std::pair<std::pair<Vertex, Vertex>, std::size_t>;
  std::vector<int> fewest(pieces.size(), 1);
  std::vector<Ends> ends;
  for(std::size_t i = 0; i < pieces.size(); ++i)
  {
    const Vertex a = mesh.source(pieces[i].halfedges.front()), b = mesh.target(pieces[i].halfedges.back());
    if(a == b)
      fewest[i] = 3;
    else
      ends.emplace_back(std::make_pair((std::min)(a, b), (std::max)(a, b)), i);
  }
  std::sort(ends.begin(), ends.end());
  for(std::size_t i = 1; i < ends.size(); ++i)
    if(ends[i].first == ends[i - 1].first)
      fewest[ends[i].second] = 2;
  return fewest;
}

inline std::size_t number_of_intervals(const Line_piece& piece, double length, double spacing, int fewest)
{
  if(piece.is_kept)
    return 1;
  return (std::max)(static_cast<std::size_t>(fewest), static_cast<std::size_t>(std::llround(length / spacing)));
}

// The samples inside a piece: its ends, if it has any, are samples already.
inline std::size_t number_inside(const Line_piece& piece, std::size_t intervals)
{
  return piece.is_ring ? intervals : intervals - 1;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TRACE_LINES_H
