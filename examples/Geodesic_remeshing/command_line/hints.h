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
#include <CGAL/Polygon_mesh_processing/detect_features.h>
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

constexpr double sharp_angle = 60.; // in degrees

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
  for(const Mesh::Face_index f : mesh.faces())
    parts.area[parts.part_of[f]] += PMP::face_area(f, mesh);
  for(const double area : parts.area)
    parts.whole += area;
  const double length = target_edge_length(options, parts.whole);
  parts.tiny = std::sqrt(3.) * length * length;
  return parts;
}

// Cracks: many vertices of the boundary have another one, not beside them, at a distance that is small for an edge.
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
  std::size_t number = 0;
  double farthest = 0.;
  for(const std::size_t v : boundary)
  {
    double nearest = std::numeric_limits<double>::infinity();
    near.for_each_near(v, [&](const std::size_t w) {
      // those at the same point have been parted by the repair, or by who made the file
      if(w != v && w != next[v] && w != previous[v] && points[w] != points[v])
        nearest = (std::min)(nearest, CGAL::squared_distance(points[v], points[w]));
    });
    if(nearest < std::numeric_limits<double>::infinity())
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
         " parts are smaller than four of the new triangles (--drop-parts " +
         short_number_above(100. * largest / parts.whole) + " leaves them out)";
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
    if(parts.area[parts.part_of[mesh.face(mesh.opposite(hole))]] < parts.tiny)
      continue;
    if(length < 4. * edge_length)
      tiny.push_back(edges);
    else
      fewest_of_others = (std::min)(fewest_of_others, edges);
  }
  tiny.erase(std::remove_if(tiny.begin(), tiny.end(), [&](std::size_t n) { return n >= fewest_of_others; }),
             tiny.end());
  if(tiny.empty())
    return "";
  return std::to_string(tiny.size()) + " holes are no longer around than four of the new edges (--fill-holes " +
         std::to_string(*std::max_element(tiny.begin(), tiny.end())) + " closes them)";
}

inline double length_of(const Mesh& mesh, Mesh::Edge_index e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

// Whether the way over a vertex, by the edges of these two halfedges to it, goes nearly straight on
inline bool goes_straight_on(const Mesh& mesh, Mesh::Halfedge_index h, Mesh::Halfedge_index g)
{
  const Point& p = mesh.point(mesh.target(h));
  return CGAL::approximate_angle(mesh.point(mesh.source(h)), p, mesh.point(mesh.source(g))) > 135.;
}

// The length of all sharp edges, and of those in rows that go straight on for longer than `least`
inline std::pair<double, double> lengths_of_sharp_edges(const Mesh& mesh, double least)
{
  std::vector<char> is_sharp(mesh.number_of_edges(), 0);
  CGAL::Polygon_mesh_processing::detect_sharp_edges(
      mesh, sharp_angle, boost::make_iterator_property_map(is_sharp.begin(), CGAL::get(boost::edge_index, mesh)));
  for(const auto e : mesh.edges())
    is_sharp[e.idx()] = is_sharp[e.idx()] && !mesh.is_border(e); // which are kept anyway
  Disjoint_sets rows(mesh.number_of_edges());
  for(const auto v : mesh.vertices())
  {
    std::vector<Mesh::Halfedge_index> sharp;
    for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(is_sharp[mesh.edge(h).idx()])
        sharp.push_back(h);
    if(sharp.size() == 2 && goes_straight_on(mesh, sharp[0], sharp[1]))
      rows.union_set(mesh.edge(sharp[0]).idx(), mesh.edge(sharp[1]).idx());
  }
  std::vector<double> length(mesh.number_of_edges(), 0.);
  for(const auto e : mesh.edges())
    if(is_sharp[e.idx()])
      length[rows.find_set(e.idx())] += length_of(mesh, e);
  std::pair<double, double> result(0., 0.);
  for(const double l : length)
  {
    result.first += l;
    result.second += l > least ? l : 0.;
  }
  return result;
}

} // namespace internal

// After remeshing. Machine parts: their sharp edges are in long rows, those of noise and of coarse models are not. Some
// are kept without being asked for, the long creases of an input of few faces; they are marked in the output.
inline std::string hint_at_sharp_edges(const Mesh& mesh, double edge_length, const Mesh& output,
                                       Mesh::Property_map<Mesh::Edge_index, bool> is_line)
{
  double kept = 0.;
  for(const auto e : output.edges())
    if(is_line[e] && !output.is_border(e))
      kept += internal::length_of(output, e);
  const auto [all, in_rows] = internal::lengths_of_sharp_edges(mesh, 4. * edge_length);
  if(in_rows < 1.5 * std::sqrt(CGAL::Polygon_mesh_processing::area(mesh)) || in_rows < all * 2. / 3. ||
     kept > .5 * in_rows)
    return "";
  return "sharp edges of the input are cut off (--feature-angle " + internal::short_number(internal::sharp_angle) +
         " keeps them)";
}

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
