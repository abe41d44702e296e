// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CONSTRAINTS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CONSTRAINTS_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/find_corners.h>
#include <CGAL/Geodesic_remeshing/internal/find_creases.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What an angle bound finds beside the features: spurs and specks shorter than the new edges, which could not show
// them. Only what nobody has asked for is taken away; a spur gone may leave another one.
inline void remove_specks(const Mesh& mesh, double edge_length, const std::vector<char>& is_given,
                          const std::vector<char>& is_kept_vertex, std::vector<char>& is_line)
{
  const Metric metric(mesh);
  for(bool changed = true; changed;)
  {
    changed = false;
    const auto on_line = [&](Edge e) { return is_line[e.idx()] != 0; };
    const std::vector<int> degree = degrees_on_lines(mesh, on_line);
    const auto is_end = [&](Vertex v) { return degree[v] == 1 && !is_kept_vertex[v.idx()]; };
    for(const Line_piece& piece : trace_lines(mesh, on_line, [&](Vertex v) { return degree[v] != 2; }))
    {
      const int ends = is_end(mesh.source(piece.halfedges.front())) + is_end(mesh.target(piece.halfedges.back()));
      const double shortest = piece.is_ring ? .75 : ends;
      const bool some_given = std::any_of(piece.halfedges.begin(), piece.halfedges.end(),
                                          [&](Halfedge h) { return is_given[mesh.edge(h).idx()] != 0; });
      if(length_of(metric, piece) < shortest * edge_length && !some_given)
      {
        changed = true;
        for(Halfedge h : piece.halfedges)
          is_line[mesh.edge(h).idx()] = 0;
      }
    }
  }
}

inline void add_features(const Mesh& mesh, double edge_length, double angle_in_degrees, Constraints& constraints)
{
  const std::vector<char> is_given = constraints.is_line;
  const std::vector<char> is_sharp = find_sharp_edges(mesh, angle_in_degrees);
  for(Edge e : mesh.edges())
    constraints.is_line[e.idx()] |= is_sharp[e.idx()];
  remove_specks(mesh, edge_length, is_given, constraints.is_corner, constraints.is_line);
  constraints.has_features = std::any_of(mesh.edges().begin(), mesh.edges().end(), [&](const Edge e) {
    return is_sharp[e.idx()] != 0 && constraints.is_line[e.idx()] != 0;
  });
  find_cone_tips(mesh, edge_length, constraints);
}

template <class TriangleMesh, class NamedParameters>
void mark_given_lines(const TriangleMesh& tmesh, const NamedParameters& np, const Input_surface<TriangleMesh>& input,
                      std::vector<char>& is_line)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  const Mesh& mesh = input.mesh;
  for(Edge e : mesh.edges())
    is_line[e.idx()] = mesh.is_border(e);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
  {
    const auto is_constrained = get_parameter(np, internal_np::edge_is_constrained);
    std::size_t i = 0;
    for(auto e : edges(tmesh))
      is_line[input.copy_of_edge(i++).idx()] |= get(is_constrained, e) ? 1 : 0;
  }
  if constexpr(!is_default_parameter<NamedParameters, internal_np::face_patch_t>::value)
  {
    const auto patch = get_parameter(np, internal_np::face_patch);
    for(Edge e : mesh.edges())
      if(!mesh.is_border(e) && get(patch, input.face_of[mesh.face(mesh.halfedge(e, 0))]) !=
                                   get(patch, input.face_of[mesh.face(mesh.halfedge(e, 1))]))
        is_line[e.idx()] = 1;
  }
}

// Where edges are to stay as they are, their ends have to.
inline void mark_ends_of_lines(const Mesh& mesh, Constraints& constraints)
{
  for(Edge e : mesh.edges())
    for(int i = 0; i < 2; ++i)
      constraints.is_corner[mesh.vertex(e, i).idx()] |= constraints.is_line[e.idx()];
}

// Of all lines the boundary only, with its corners
inline Constraints find_boundary(const Mesh& mesh, double edge_length)
{
  Constraints result{std::vector<char>(mesh.number_of_edges(), 0), std::vector<char>(mesh.number_of_vertices(), 0)};
  for(Edge e : mesh.edges())
    result.is_line[e.idx()] = mesh.is_border(e);
  find_corners(mesh, edge_length, result);
  return result;
}

// All that the output has to follow: the boundary, the features, the edges and vertices that the user has
// constrained, and the borders of his patches.
template <class TriangleMesh, class NamedParameters>
Constraints find_constraints(const TriangleMesh& tmesh, const NamedParameters& np,
                             const Input_surface<TriangleMesh>& input, double edge_length)
{
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::is_default_parameter;
  const Mesh& mesh = input.mesh;
  Constraints result{std::vector<char>(mesh.number_of_edges(), 0), std::vector<char>(mesh.number_of_vertices(), 0)};
  mark_given_lines(tmesh, np, input, result.is_line);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value)
  {
    const auto is_constrained = get_parameter(np, internal_np::vertex_is_constrained);
    for(Vertex v : mesh.vertices())
      result.is_corner[v.idx()] = get(is_constrained, input.vertex_of[v.idx()]) ? 1 : 0;
  }
  if constexpr(!is_default_parameter<NamedParameters, internal_np::protect_constraints_t>::value)
    result.are_kept = get_parameter(np, internal_np::protect_constraints);
  if constexpr(!is_default_parameter<NamedParameters, internal_np::features_angle_bound_t>::value)
  {
    const double bound = CGAL::to_double(get_parameter(np, internal_np::features_angle_bound));
    if(!(bound > 0.))
      reject("the angle bound of features must be positive");
    if(bound <= 180.)
      add_features(mesh, edge_length, bound, result);
  }
  else if(!result.are_kept)
    add_long_creases(mesh, edge_length, result);
  if(result.are_kept)
    mark_ends_of_lines(mesh, result);
  find_corners(mesh, edge_length, result);
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CONSTRAINTS_H
