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

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>

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

  static constexpr const char *place_property = "v:place", *face_property = "f:input_face";

  // The property maps are those of this object's own mesh: moving would be fine, copying takes the function below.
  Working_surface() = default;
  Working_surface(const Working_surface&) = delete;
  Working_surface& operator=(const Working_surface&) = delete;
};

inline void copy_working_surface(const Working_surface& from, Working_surface& to)
{
  to.mesh = from.mesh;
  to.place = *to.mesh.property_map<Vertex, Place>(Working_surface::place_property);
  to.input_face = *to.mesh.property_map<Face, Face>(Working_surface::face_property);
  to.is_line = lines_of(to.mesh);
  if(!Metric(to.mesh).is_uniform())
    to.density = *to.mesh.property_map<Vertex, double>(Metric::property);
}

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

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_WORKING_SURFACE_H
