// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_H

#include "clean_up.h"
#include "repair.h"
#include "soup.h"
#include "stitch.h"
#include "t_junctions.h"
#include "triangulate.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace command_line {

// The mesh of a file
struct Input
{
  Mesh mesh;
  std::size_t vertices_in_file, faces_in_file;
  std::vector<std::string> repairs; // what was done to make a mesh of it, in words
};

namespace internal {

// What is wrong with the soup as a mesh, if anything
inline std::optional<std::string> fault(const Soup& soup)
{
  try
  {
    for(std::size_t f = 0; f < soup.polygons.size(); ++f)
      if(uses_a_vertex_twice(soup.polygons[f]))
        throw Input_error(face_name(f) + " uses a vertex twice");
    const auto sides = sorted_sides(soup);
    check_orientability(soup, sides);
    check_edges(sides);
    check_vertices(soup, sides);
    return std::nullopt;
  }
  catch(const Input_error& error)
  {
    return error.what();
  }
}

// Vertices that no face uses are left out.
inline Mesh make_mesh(const Soup& soup)
{
  std::vector<bool> used(soup.points.size(), false);
  for(const auto& polygon : soup.polygons)
    for(const std::size_t v : polygon)
      used[v] = true;
  Mesh mesh;
  auto index = mesh.add_property_map<Mesh::Vertex_index, std::size_t>(index_in_file).first;
  std::vector<Mesh::Vertex_index> vertices(soup.points.size());
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(used[v])
    {
      vertices[v] = mesh.add_vertex(soup.points[v]);
      index[vertices[v]] = v;
    }
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    const auto& p = soup.polygons[f];
    if(mesh.add_face(vertices[p[0]], vertices[p[1]], vertices[p[2]]) == Mesh::null_face())
      throw Input_error("is not manifold: " + face_name(f) + " cannot be added");
  }
  return mesh;
}

// What is no mesh is made one, or refused with what is wrong, and where.
inline void mend(Soup& soup, const Repair_options& options, std::vector<std::string>& repairs)
{
  if(options.stitch_tolerance > 0.)
  {
    tell(repairs, "stitched", stitch(soup, options.stitch_tolerance), vertex_noun, " of the boundary to others");
    tell(repairs, "dropped", drop_degenerate_faces(soup), face_noun, " with a vertex twice");
    if(soup.polygons.empty())
      throw Input_error("has no face left after stitching");
    tell(repairs, "divided edges of the boundary at", stitch_t_junctions(soup, options.stitch_tolerance), vertex_noun,
         " of others");
  }
  const auto wrong = fault(soup);
  if(wrong && !options.do_repair)
    throw Input_error(*wrong);
  if(!options.do_repair || (!wrong && !has_open_seams(soup)))
    return;
  for(const std::string& done : repair(soup))
    repairs.push_back(done);
  if(const auto left = fault(soup))
    throw Input_error(*left);
}

// Either the numbers that the file has for faces, or none of its numbers, if they are no longer those of the mesh
inline void number_as_in_file(Mesh& mesh, const std::vector<std::size_t>& face, bool is_changed)
{
  if(is_changed)
  {
    auto index = mesh.property_map<Mesh::Vertex_index, std::size_t>(index_in_file).value();
    mesh.remove_property_map(index);
    return;
  }
  auto index = mesh.add_property_map<Mesh::Face_index, std::size_t>(face_in_file).first;
  for(const auto f : mesh.faces())
    index[f] = face[f];
}

} // namespace internal

// The triangle mesh of a file
inline Input read_mesh(const Input_file& file, const Repair_options& options)
{
  try
  {
    internal::Soup soup = internal::read_soup(file);
    internal::check_points_and_polygons(soup);
    const std::size_t vertices_in_file = soup.points.size(), faces_in_file = soup.polygons.size();
    std::vector<std::string> divisions, repairs;
    const std::vector<std::size_t> face = internal::triangulate(soup, options, divisions);
    internal::mend(soup, options, repairs);
    Input input{internal::make_mesh(soup), vertices_in_file, faces_in_file, {}};
    if(options.drop_parts > 0.)
      internal::tell(repairs, "dropped", internal::drop_small_parts(input.mesh, options.drop_parts),
                     internal::Noun{"small part", "small parts"});
    if(options.fill_holes > 0)
      internal::tell(repairs, "filled", internal::fill_small_holes(input.mesh, options.fill_holes),
                     internal::Noun{"hole", "holes"});
    internal::number_as_in_file(input.mesh, face, !repairs.empty());
    input.repairs = divisions;
    input.repairs.insert(input.repairs.end(), repairs.begin(), repairs.end());
    return input;
  }
  catch(const Input_error& error)
  {
    throw Input_error(file.name() + " " + error.what());
  }
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_H
