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
#include <cstddef>
#include <tuple>
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
  bool is_kept = false;               // an edge of the input that is to be an edge of the output
  std::vector<double> densities = {}; // how many times as near to each other its samples are as others, on a halfedge
};

inline double even_length_of(const Metric& metric, const Line_piece& piece)
{
  double length = 0.;
  for(Halfedge h : piece.halfedges)
    length += metric.length(h);
  return length;
}

// What counts where a piece is divided: as much as its samples are denser it is longer.
inline double length_of(const Metric& metric, const Line_piece& piece, std::size_t i)
{
  return metric.length(piece.halfedges[i]) * (piece.densities.empty() ? 1. : piece.densities[i]);
}

inline double length_of(const Metric& metric, const Line_piece& piece)
{
  double length = 0.;
  for(std::size_t i = 0; i < piece.halfedges.size(); ++i)
    length += length_of(metric, piece, i);
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

// How often a piece is as long as its ends are apart
inline double detour_of(const Mesh& mesh, const Line_piece& piece)
{
  double length = 0.;
  for(Halfedge h : piece.halfedges)
    length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  return length / std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(piece.halfedges.front())),
                                                   mesh.point(mesh.target(piece.halfedges.back()))));
}

// The fewest edges that can cover each piece, so that no two edges have the same ends: three for a ring or a loop at
// a corner, also if its ends are two vertices at one point; two where another piece joins the same corners already,
// which is the straightest of them: three points of a straight one would make a face without area.
inline std::vector<int> fewest_intervals(const Mesh& mesh, const std::vector<Line_piece>& pieces)
{
  constexpr double loop = 20.;
  struct Ends
  {
    Vertex low, high;
    double detour;
    std::size_t piece;
    bool operator<(const Ends& e) const
    {
      return std::tie(low, high, detour, piece) < std::tie(e.low, e.high, e.detour, e.piece);
    }
  };
  std::vector<int> fewest(pieces.size(), 1);
  std::vector<Ends> ends;
  for(std::size_t i = 0; i < pieces.size(); ++i)
  {
    const Vertex a = mesh.source(pieces[i].halfedges.front()), b = mesh.target(pieces[i].halfedges.back());
    const double detour = a == b ? infinity : detour_of(mesh, pieces[i]);
    if(detour < loop)
      ends.push_back({(std::min)(a, b), (std::max)(a, b), detour, i});
    else
      fewest[i] = 3;
  }
  std::sort(ends.begin(), ends.end());
  for(std::size_t i = 1; i < ends.size(); ++i)
    if(ends[i].low == ends[i - 1].low && ends[i].high == ends[i - 1].high)
      fewest[ends[i].piece] = 2;
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
