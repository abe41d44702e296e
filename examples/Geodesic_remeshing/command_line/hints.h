// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HINTS_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HINTS_H

#include "clean_up.h"
#include "options.h"
#include "stitch.h"
#include "t_junctions.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace command_line {

// What a look at the input makes one suspect, and which option would mend it: of scans and of what other programs
// wrote.
namespace internal {

using Vector = mesh_quality::Kernel::Vector_3;

inline std::string short_number(double x)
{
  std::ostringstream out;
  out.precision(2);
  out << x;
  return out.str();
}

// Rounded up, so that what is below this is below the result
inline std::string short_number_above(double x)
{
  const double unit = std::pow(10., std::floor(std::log10(x)) - 1.);
  return short_number(unit * (std::floor(x / unit) + 1.));
}

inline double target_edge_length(const Options& options, double area)
{
  if(options.edge_length)
    return *options.edge_length;
  const double faces =
      options.faces ? static_cast<double>(*options.faces) : 2. * static_cast<double>(*options.vertices);
  return std::sqrt(4. / std::sqrt(3.) * area / faces);
}

struct Parts
{
  std::vector<std::size_t> part_of; // of each face
  std::vector<double> area;
  std::vector<std::size_t> faces; // how many each has
  double whole = 0.;
  double tiny = 0.; // the area below which a part is not worth its vertices: that of four of the new triangles
};

inline Parts find_parts(const Mesh& mesh, const Options& options)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Parts parts;
  parts.part_of.resize(mesh.number_of_faces());
  const auto map = boost::make_iterator_property_map(parts.part_of.begin(), CGAL::get(boost::face_index, mesh));
  parts.area.resize(PMP::connected_components(mesh, map), 0.);
  parts.faces.resize(parts.area.size(), 0);
  for(const Mesh::Face_index f : mesh.faces())
  {
    parts.area[parts.part_of[f]] += PMP::face_area(f, mesh);
    ++parts.faces[parts.part_of[f]];
  }
  for(const double area : parts.area)
    parts.whole += area;
  const double length = target_edge_length(options, parts.whole);
  parts.tiny = std::sqrt(3.) * length * length;
  return parts;
}

// The squared length of the shortest edge at each vertex that has a length
inline std::vector<double> shortest_edges(const Mesh& mesh)
{
  std::vector<double> shortest(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(const auto e : mesh.edges())
  {
    const auto v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    const double squared = CGAL::squared_distance(mesh.point(v), mesh.point(w));
    if(squared > 0.)
      for(const auto u : {v, w})
        shortest[u] = (std::min)(shortest[u], squared);
  }
  return shortest;
}

// From each vertex towards its faces
inline std::vector<Vector> ways_inside(const Mesh& mesh)
{
  std::vector<Vector> ways(mesh.number_of_vertices(), Vector(CGAL::NULL_VECTOR));
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
      for(const auto v : {mesh.source(h), mesh.target(mesh.next(h))})
        ways[mesh.target(h)] += mesh.point(v) - mesh.point(mesh.target(h));
  return ways;
}

// Whether two sheets lie on different sides of where they end: not those of a folded cloth, one above the other
inline bool face_each_other(const Vector& v, const Vector& w)
{
  return v * w < .5 * std::sqrt(v.squared_length() * w.squared_length());
}

// Cracks: many vertices of the boundary have another one, not beside them, at a distance that is small for an edge.
// Across a narrow band of long triangles it is not small for the edges there.
inline std::string hint_at_cracks(const Mesh& mesh)
{
  std::vector<Point> points;
  std::vector<std::size_t> boundary;
  std::vector<Mesh::Vertex_index> next(mesh.number_of_vertices()), previous(mesh.number_of_vertices());
  double length = 0.;
  for(const auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      boundary.push_back(mesh.target(h));
      next[mesh.source(h)] = mesh.target(h);
      previous[mesh.target(h)] = mesh.source(h);
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    }
  if(boundary.empty() || !(length > 0.))
    return "";
  const Near_points near(points, boundary, .1 * length / static_cast<double>(boundary.size()));
  const std::vector<double> shortest = shortest_edges(mesh);
  const auto inside = ways_inside(mesh);
  std::size_t number = 0;
  double farthest = 0.;
  for(const std::size_t v : boundary)
  {
    double nearest = shortest[v];
    near.for_each_near(v, [&](const std::size_t w) {
      // those at the same point have been parted by the repair, or by who made the file
      if(w != v && w != next[v] && w != previous[v] && points[w] != points[v] && face_each_other(inside[v], inside[w]))
        nearest = (std::min)(nearest, CGAL::squared_distance(points[v], points[w]));
    });
    if(nearest < shortest[v])
    {
      ++number;
      farthest = (std::max)(farthest, std::sqrt(nearest));
    }
  }
  if(number < 10 || 4 * number < boundary.size())
    return "";
  return std::to_string(number) + " of the " + std::to_string(boundary.size()) +
         " vertices of the boundary are next to others (--stitch " + short_number_above(farthest) + " joins them)";
}

// T-junctions, as between pieces with edges of different lengths: vertices of the boundary lie on edges of it.
inline std::string hint_at_t_junctions(const Mesh& mesh)
{
  std::vector<Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  double length = 0.;
  for(const auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h))
    {
      edges.emplace_back(mesh.source(h), mesh.target(h));
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    }
  if(edges.empty() || !(length > 0.))
    return "";
  length /= static_cast<double>(edges.size());
  double farthest = 1e-6 * length;
  std::vector<std::size_t> vertices;
  for(const T_junction& t : find_t_junctions(points, edges, .01 * length))
  {
    vertices.push_back(t.vertex);
    farthest = (std::max)(farthest, t.distance);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  if(vertices.size() < 10 || 10 * vertices.size() < edges.size())
    return "";
  return std::to_string(vertices.size()) + " of the " + std::to_string(edges.size()) +
         " vertices of the boundary are on edges of it (--stitch " + short_number_above(farthest) + " joins them)";
}

inline std::string hint_at_tiny_parts(const Parts& parts)
{
  std::size_t number = 0;
  double largest = 0., sum = 0.;
  for(const double area : parts.area)
    if(area < parts.tiny)
    {
      ++number;
      largest = (std::max)(largest, area);
      sum += area;
    }
  if(number == 0 || sum > .1 * parts.whole || !(largest > 0.))
    return "";
  return std::to_string(number) + " of the " + std::to_string(parts.area.size()) +
         (number == 1 ? " parts is" : " parts are") + " smaller than four of the new triangles (--drop-parts " +
         short_number_above(100. * largest / parts.whole) + (number == 1 ? " leaves it out)" : " leaves them out)");
}

// Not what a sheet ends at: around a disc of n faces there are 2.3 sqrt(n) edges. That counts faces of the input, as a
// single point far away makes all areas and new edges large.
inline bool is_small_for(const Parts& parts, std::size_t part, std::size_t edges)
{
  return edges < parts.faces[part] / edges;
}

// Of parts that are larger, holes around which there are at most four of the new edges
inline std::string hint_at_tiny_holes(const Mesh& mesh, const Parts& parts, double edge_length)
{
  std::vector<std::size_t> tiny;                                          // their numbers of edges
  std::size_t fewest_of_others = std::numeric_limits<std::size_t>::max(); // which are not to be closed
  for(const Mesh::Halfedge_index hole : holes_of(mesh))
  {
    std::size_t edges = 0;
    double length = 0.;
    for(const auto h : mesh.halfedges_around_face(hole))
    {
      ++edges;
      length += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    }
    const std::size_t part = parts.part_of[mesh.face(mesh.opposite(hole))];
    if(parts.area[part] < parts.tiny)
      continue;
    if(length < 4. * edge_length && is_small_for(parts, part, edges))
      tiny.push_back(edges);
    else
      fewest_of_others = (std::min)(fewest_of_others, edges);
  }
  tiny.erase(std::remove_if(tiny.begin(), tiny.end(), [&](std::size_t n) { return n >= fewest_of_others; }),
             tiny.end());
  if(tiny.empty())
    return "";
  return std::to_string(tiny.size()) + (tiny.size() == 1 ? " hole is" : " holes are") +
         " no longer around than four of the new edges (--fill-holes " +
         std::to_string(*std::max_element(tiny.begin(), tiny.end())) +
         (tiny.size() == 1 ? " closes it)" : " closes them)");
}

} // namespace internal

// One line, empty where there is nothing to say. Behind cracks, parts and holes are not what they seem.
inline std::string hints(const Mesh& mesh, const Options& options)
{
  const std::string cracks = internal::hint_at_cracks(mesh);
  if(!cracks.empty())
    return cracks;
  const std::string junctions = internal::hint_at_t_junctions(mesh);
  if(!junctions.empty())
    return junctions;
  const internal::Parts parts = internal::find_parts(mesh, options);
  const std::string tiny_parts = internal::hint_at_tiny_parts(parts);
  const std::string holes =
      internal::hint_at_tiny_holes(mesh, parts, internal::target_edge_length(options, parts.whole));
  return tiny_parts + (tiny_parts.empty() || holes.empty() ? "" : "; ") + holes;
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HINTS_H
