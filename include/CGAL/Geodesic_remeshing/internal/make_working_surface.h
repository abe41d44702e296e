// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_MAKE_WORKING_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_MAKE_WORKING_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>
#include <CGAL/Geodesic_remeshing/internal/numbers_in_messages.h>
#include <CGAL/Geodesic_remeshing/internal/split_long_edges.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

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
      (needed < most_vertices ? "it takes at least " + std::to_string(static_cast<long long>(std::ceil(needed)))
                              : "no number would do"));
}

// Bisecting an edge about as long as the rounding of its middle need not make it shorter, and could go on without end.
// Edges a good deal longer than that are needed anyway, or their angles would be those of rounding.
inline void check_resolution(const Mesh& surface, double edge_length)
{
  constexpr double roundings = 16.;
  const Metric metric(surface);
  double shortest = infinity, largest = 0.; // edge and coordinate
  for(Vertex v : surface.vertices())
  {
    const Point& p = surface.point(v);
    shortest = (std::min)(shortest, metric.size(v) * edge_length);
    largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  }
  const double rounding = std::numeric_limits<double>::epsilon() * largest;
  if(!(shortest > roundings * rounding))
    throw Remeshing_error("geodesic remeshing: edges of length " + short_number(shortest) +
                          " are too short for coordinates as large as " + short_number(largest) +
                          ", which are rounded: they must be longer than " + short_number(roundings * rounding) +
                          ", or the surface nearer to the origin");
}

// On lines a third of that: distances from a line are those from its vertices.
constexpr double part_on_lines = 1. / 3.;

// Whether the surface has an edge that the working surface must not have. Its lines are marked.
inline bool has_long_edges(const Mesh& surface, double maximum_edge_length)
{
  const Metric metric(surface);
  const auto is_line = lines_of(surface);
  return std::any_of(surface.edges_begin(), surface.edges_end(), [&](Edge e) {
    return metric.length(e) > (is_line[e] ? part_on_lines : 1.) * maximum_edge_length;
  });
}

// With its edges as long as they are; the lines are those that are marked.
inline void copy_surface(const Mesh& surface, Working_surface& working)
{
  working.mesh = surface;
  working.place = working.mesh.add_property_map<Vertex, Place>(Working_surface::place_property).first;
  working.input_face = working.mesh.add_property_map<Face, Face>(Working_surface::face_property).first;
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
  working.is_line = working.mesh.add_property_map<Edge, bool>(line_property, false).first;
}

inline void make_working_surface(const Mesh& surface, const Constraints& constraints, double maximum_edge_length,
                                 Working_surface& working)
{
  copy_surface(surface, working);
  mark_lines(working.mesh, constraints);
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

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_MAKE_WORKING_SURFACE_H
