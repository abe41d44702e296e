// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHARP_EDGES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHARP_EDGES_H

#include "hints.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace command_line {

namespace internal {

constexpr double sharp_angle = 60.; // in degrees

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

// After remeshing with features. Machines with all their bundles of rods and letters have more lines than a small
// number of vertices can follow.
inline std::string hint_at_many_lines(const Mesh& output, Mesh::Property_map<Mesh::Edge_index, bool> is_line)
{
  std::size_t number = 0;
  for(const auto v : output.vertices())
  {
    const auto around = output.halfedges_around_target(output.halfedge(v));
    number += std::any_of(around.begin(), around.end(), [&](const auto h) { return is_line[output.edge(h)]; });
  }
  if(4 * number < 3 * output.number_of_vertices())
    return "";
  return std::to_string(number) + " of the " + std::to_string(output.number_of_vertices()) +
         " vertices lie on lines, which leaves few for what is between them (more vertices, or a larger " +
         "--feature-angle, give better triangles)";
}

// After remeshing with lines kept exactly. Where bodies were cut at each other these have edges of any length.
inline std::string hint_at_short_kept_edges(double edge_length, const Mesh& output,
                                            Mesh::Property_map<Mesh::Edge_index, bool> is_line)
{
  std::size_t number = 0;
  for(const auto e : output.edges())
    number += (is_line[e] || output.is_border(e)) && internal::length_of(output, e) < edge_length / 5.;
  if(number < output.number_of_faces() / 20)
    return "";
  return std::to_string(number) +
         " of the edges kept are shorter than a fifth of the others, and the triangles at them " +
         "are thin (without --protect lines get vertices as far apart as elsewhere)";
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHARP_EDGES_H
