// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_WORKING_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_WORKING_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The surface the stages work on: the input surface with its long edges split (paper, section 3: on large triangles the
// equidistant curves are not what they should be). It covers the same points, and knows for each of its own where that
// is on the input surface.
struct Working_surface
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Place> place;    // of a vertex, on the input surface
  Mesh::Property_map<Face, Face> input_face;  // the face of the input surface that a face lies in
  Mesh::Property_map<Edge, bool> is_line;     // of an edge on a line of the input
  Mesh::Property_map<Vertex, double> density; // only where the input surface has one, see Metric

  // The property maps are those of this object's own mesh: moving would be fine, copying would not.
  Working_surface() = default;
  Working_surface(const Working_surface&) = delete;
  Working_surface& operator=(const Working_surface&) = delete;
};

// The coordinates in `face` of a point of the closed face that is known by its place in that face or in one beside it.
// A point on an edge or a vertex has exact zeros, so the vertices that carry weight are vertices of both faces.
inline std::array<double, 3> coordinates_in(const Mesh& surface, const Place& place, Face face)
{
  if(place.face == face)
    return place.coordinates;
  std::array<double, 3> result = {{0., 0., 0.}};
  const auto from = vertices_of(surface, place.face), to = vertices_of(surface, face);
  for(int i = 0; i < 3; ++i)
  {
    if(!(place.coordinates[i] > 0.))
      continue;
    for(int j = 0; j < 3; ++j)
      if(to[j] == from[i])
        result[j] += place.coordinates[i];
  }
  CGAL_assertion(result[0] + result[1] + result[2] > .999);
  return result;
}

// The place on the input surface of the point of a working face with these barycentric coordinates.
inline Place place_on_input(const Mesh& surface, const Working_surface& working, Face face,
                            const std::array<double, 3>& weights)
{
  Place result{working.input_face[face], {{0., 0., 0.}}};
  const auto v = vertices_of(working.mesh, face);
  for(int i = 0; i < 3; ++i)
  {
    if(!(weights[i] > 0.))
      continue; // an exact zero keeps points of edges on their edges
    const auto c = coordinates_in(surface, working.place[v[i]], result.face);
    for(int j = 0; j < 3; ++j)
      result.coordinates[j] += weights[i] * c[j];
  }
  return result;
}

inline void put_vertex(Working_surface& working, const Metric& input_metric, Vertex v, const Point& point,
                       const Place& place)
{
  working.mesh.point(v) = point;
  working.place[v] = place;
  if(!input_metric.is_uniform())
    working.density[v] = 1. / input_metric.size(place);
}

// Splits an edge of a triangle mesh, and its two triangles with it. Returns the new vertex.
inline Vertex split_edge_at(Working_surface& working, const Metric& input_metric, Halfedge h, const Point& point,
                            const Place& place)
{
  Mesh& mesh = working.mesh;
  const Halfedge o = mesh.opposite(h);
  const Face f = mesh.face(h), g = mesh.face(o);
  const Halfedge to_new = Euler::split_edge(h, mesh);
  const Vertex v = mesh.target(to_new);
  put_vertex(working, input_metric, v, point, place);
  working.is_line[mesh.edge(to_new)] = working.is_line[mesh.edge(h)];
  if(f != Mesh::null_face())
  {
    const Halfedge d = Euler::split_face(to_new, mesh.next(mesh.next(to_new)), mesh);
    working.input_face[mesh.face(d)] = working.input_face[mesh.face(mesh.opposite(d))] = working.input_face[f];
  }
  if(g != Mesh::null_face())
  {
    const Halfedge d = Euler::split_face(o, mesh.next(mesh.next(o)), mesh);
    working.input_face[mesh.face(d)] = working.input_face[mesh.face(mesh.opposite(d))] = working.input_face[g];
  }
  return v;
}

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

inline Vertex bisect(const Mesh& surface, Working_surface& working, const Metric& input_metric, Edge e)
{
  const Mesh& mesh = working.mesh;
  Halfedge h = mesh.halfedge(e);
  if(mesh.is_border(h))
    h = mesh.opposite(h);
  const Face f = mesh.face(h);
  std::array<double, 3> weights = {{0., 0., 0.}};
  const auto corners = vertices_of(mesh, f);
  for(int i = 0; i < 3; ++i)
    if(corners[i] == mesh.source(h) || corners[i] == mesh.target(h))
      weights[i] = .5;
  const Place place = place_on_input(surface, working, f, weights);
  return split_edge_at(working, input_metric, h, point_at(surface, place), place);
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

// The longest edge of the working surface, in edge lengths of the mesh to be: shorter ones were measured to take more
// time for no better a mesh, longer ones to bend the curves.
constexpr double longest_working_edge = 1.5;

// A surface as thin as a thread has so little area for its length that there are not even vertices for a path of edges
// from one end to the other; while the pieces to work on would be without number.
inline void check_thinness(const Mesh& surface, double edge_length, std::size_t number_of_vertices)
{
  const Metric metric(surface);
  double longest = 0.;
  for(Edge e : surface.edges())
    longest = (std::max)(longest, metric.length(e) / edge_length);
  const double number = static_cast<double>(number_of_vertices);
  constexpr double room =
      2.; // the legs of a right triangle alone, with its three vertices, are longer than the edges of equilateral ones
  if(!(longest > room * number))
    return;
  const double needed =
      longest / number * longest / (room * room); // the edge length falls as the square root of the number
  throw Remeshing_error(
      "geodesic remeshing: the surface is too long and thin for " + std::to_string(number_of_vertices) + " vertices: " +
      (needed < 1e9 ? "it takes " + std::to_string(static_cast<long long>(std::ceil(needed))) : "no number would do"));
}

// On lines a third of that: distances from a line are those from its vertices.
constexpr double part_on_lines = 1. / 3.;

inline void make_working_surface(const Mesh& surface, const Constraints& constraints, double maximum_edge_length,
                                 Working_surface& working)
{
  working.mesh = surface;
  working.place = working.mesh.add_property_map<Vertex, Place>("v:place").first;
  working.input_face = working.mesh.add_property_map<Face, Face>("f:input_face").first;
  if(!Metric(surface).is_uniform())
    working.density = add_density(working.mesh); // a copy of that of the input surface
  for(Face f : surface.faces())
  {
    working.input_face[f] = f;
    Halfedge h = surface.halfedge(f);
    for(int i = 0; i < 3; ++i, h = surface.next(h))
    {
      Place& place = working.place[surface.source(h)];
      place.face = f;
      place.coordinates = {{0., 0., 0.}};
      place.coordinates[i] = 1.;
    }
  }
  working.is_line = working.mesh.add_property_map<Edge, bool>("e:line", false).first;
  for(Edge e : surface.edges())
    working.is_line[e] = !constraints.is_line.empty() && constraints.is_line[e.idx()];
  split_long_edges(surface, working, maximum_edge_length, false);
  split_long_edges(surface, working, part_on_lines * maximum_edge_length, true);
}

inline void make_working_surface(const Mesh& surface, double maximum_edge_length, Working_surface& working)
{
  make_working_surface(surface, Constraints(), maximum_edge_length, working);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_WORKING_SURFACE_H
