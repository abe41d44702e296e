// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SPLIT_LONG_EDGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SPLIT_LONG_EDGES_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Thin are triangles whose height over their longest edge is less than this part of it.
constexpr double thin_height = .05;

// The halfedge is within a face of the input, between two thin parts of it.
inline bool is_within_sliver(const Working_surface& working, Halfedge h)
{
  const Mesh& mesh = working.mesh;
  const Halfedge o = mesh.opposite(h);
  if(mesh.is_border(h) || mesh.is_border(o) || working.input_face[mesh.face(h)] != working.input_face[mesh.face(o)])
    return false;
  const auto is_thin = [&](Halfedge i) {
    const Point &p = mesh.point(mesh.source(i)), &q = mesh.point(mesh.target(i));
    return 2. * std::sqrt(CGAL::squared_area(p, q, mesh.point(mesh.target(mesh.next(i))))) <
           thin_height * CGAL::squared_distance(p, q);
  };
  return is_thin(h) && is_thin(o);
}

// Bisected as they come, the edges of a sliver leave long diagonals in it, whose bisection makes three slivers of half
// its length out of one: without number in the end, where twice as many for half the length will do. So the edges of
// the input on either side come first; then the other diagonal is the shorter one, and takes the place of this.
struct Step_in_sliver
{
  Edge side; // to be bisected, if any
  bool flips = false;
};

inline Step_in_sliver step_in_sliver(const Mesh& surface, const Working_surface& working, const Metric& metric,
                                     Halfedge h)
{
  constexpr double shorter = .6; // of the diagonal: sides and other diagonals as long would come next anyway
  const Mesh& mesh = working.mesh;
  const Halfedge o = mesh.opposite(h);
  const double limit = shorter * metric.length(mesh.edge(h));
  Step_in_sliver result;
  double longest = limit;
  for(Halfedge i : {mesh.next(h), mesh.prev(h), mesh.next(o), mesh.prev(o)})
  {
    const Halfedge j = mesh.opposite(i);
    const bool is_side = mesh.is_border(j) || working.input_face[mesh.face(j)] != working.input_face[mesh.face(i)];
    if(is_side && metric.length(mesh.edge(i)) > longest)
    {
      result.side = mesh.edge(i);
      longest = metric.length(mesh.edge(i));
    }
  }
  if(result.side != Mesh::null_edge())
    return result;
  const Vertex s = mesh.source(h), t = mesh.target(h), a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(o));
  if(!(metric.length(a, b) < limit) || mesh.halfedge(a, b) != Mesh::null_halfedge())
    return result;
  // in barycentric coordinates, in which nothing is thin
  const Face face = working.input_face[mesh.face(h)];
  const auto at = [&](Vertex v) {
    const auto c = coordinates_in(surface, working.place[v], face);
    return Kernel::Point_2(c[0], c[1]);
  };
  const CGAL::Orientation side = CGAL::orientation(at(s), at(t), at(a));
  result.flips = CGAL::orientation(at(s), at(b), at(a)) == side && CGAL::orientation(at(b), at(t), at(a)) == side;
  return result;
}

// Bisects edges, longest first, until none is longer than `maximum_length`: the order that keeps angles from degrading
// (Rivara's longest-edge bisection), ties by index.
inline void split_long_edges(const Mesh& surface, Working_surface& working, double maximum_length, bool only_lines)
{
  Mesh& mesh = working.mesh;
  const Metric metric(mesh), input_metric(surface);
  using Entry = std::pair<double, Edge>;
  const auto shorter = [](const Entry& a, const Entry& b) {
    return a.first < b.first || (!(b.first < a.first) && b.second < a.second);
  };
  std::vector<Entry> long_edges;
  const auto is_long = [&](Edge e) { return (!only_lines || working.is_line[e]) && metric.length(e) > maximum_length; };
  for(Edge e : mesh.edges())
    if(is_long(e))
      long_edges.emplace_back(metric.length(e), e);
  std::priority_queue<Entry, std::vector<Entry>, decltype(shorter)> queue(shorter, std::move(long_edges));
  while(!queue.empty())
  {
    const Entry top = queue.top();
    queue.pop();
    if(metric.length(top.second) < top.first)
      continue; // split since
    Edge edge = top.second;
    if(is_within_sliver(working, mesh.halfedge(edge)))
    {
      const Step_in_sliver step = step_in_sliver(surface, working, metric, mesh.halfedge(edge));
      if(step.flips)
        Euler::flip_edge(mesh.halfedge(edge), mesh);
      if(is_long(edge) && (step.flips || step.side != Mesh::null_edge()))
        queue.emplace(metric.length(edge), edge);
      if(step.flips)
        continue;
      if(step.side != Mesh::null_edge())
        edge = step.side;
    }
    const Vertex v = bisect(surface, working, input_metric, edge);
    for(Halfedge i : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(is_long(mesh.edge(i)))
        queue.emplace(metric.length(i), mesh.edge(i));
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SPLIT_LONG_EDGES_H
