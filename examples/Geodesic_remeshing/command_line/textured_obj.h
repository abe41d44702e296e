// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TEXTURED_OBJ_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TEXTURED_OBJ_H

#include "soup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace command_line {

// The texture coordinates of OBJ files, which CGAL's readers leave out: of the corner at the target of a halfedge in its face
using Texture_coordinates = std::array<double, 2>;
using Texture_map = Mesh::Property_map<Mesh::Halfedge_index, Texture_coordinates>;

namespace internal {

struct Obj_corner
{
  std::size_t vertex;
  std::size_t texture;
};

// An index of an OBJ file, from 1 on or back from the last element, as one from 0 on
inline std::size_t obj_index(const std::string& word, std::size_t number)
{
  long index = 0;
  std::istringstream(word) >> index;
  if(index < 0)
    index += static_cast<long>(number) + 1;
  if(index < 1 || index > static_cast<long>(number))
    throw Input_error("has a face with the index \"" + word + "\"");
  return static_cast<std::size_t>(index - 1);
}

inline Obj_corner obj_corner(const std::string& word, std::size_t vertices, std::size_t textures)
{
  const std::size_t slash = word.find('/');
  if(slash == std::string::npos || slash + 1 == word.size() || word[slash + 1] == '/')
    throw Input_error("has a face without texture coordinates");
  return {obj_index(word.substr(0, slash), vertices), obj_index(word.substr(slash + 1), textures)};
}

} // namespace internal

// Reads the texture coordinates of the file that the mesh was read from, and marks the edges at which they jump.
inline Texture_map read_texture(const Input_file& file, Mesh& mesh, Mesh::Property_map<Mesh::Edge_index, bool> seams)
{
  const auto in = file.open();
  std::vector<Texture_coordinates> coordinates;
  std::size_t vertices = 0;
  const auto index = mesh.property_map<Mesh::Vertex_index, std::size_t>(index_in_file).value();
  Texture_map uv = mesh.add_property_map<Mesh::Halfedge_index, Texture_coordinates>("h:uv").first;
  auto face = mesh.faces().begin(); // those of the file, in its order
  for(std::string line; std::getline(*in, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if(word == "v")
      ++vertices;
    else if(word == "vt")
    {
      Texture_coordinates at{};
      if(!(words >> at[0] >> at[1]))
        throw Input_error(file.name() + " has texture coordinates that are no numbers: " + line);
      coordinates.push_back(at);
    }
    else if(word == "f" && face != mesh.faces().end())
    {
      for(; words >> word;)
      {
        const auto corner = internal::obj_corner(word, vertices, coordinates.size());
        for(const auto h : mesh.halfedges_around_face(mesh.halfedge(*face)))
          if(index[mesh.target(h)] == corner.vertex)
            uv[h] = coordinates[corner.texture];
      }
      ++face;
    }
  }
  for(const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    seams[e] = !mesh.is_border(e) && (uv[h] != uv[mesh.prev(o)] || uv[o] != uv[mesh.prev(h)]);
  }
  return uv;
}

// Each vertex has as many lines of texture coordinates as there are different ones at it.
inline void write_textured_obj(std::ostream& out, const Mesh& mesh, const Texture_map& uv)
{
  std::vector<std::vector<std::pair<Texture_coordinates, std::size_t>>> at(mesh.number_of_vertices());
  std::size_t number = 0;
  for(const auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    out << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  std::ostringstream faces;
  for(const auto f : mesh.faces())
  {
    faces << "f";
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    {
      auto& known = at[mesh.target(h)];
      auto found = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == uv[h]; });
      if(found == known.end())
      {
        out << "vt " << uv[h][0] << " " << uv[h][1] << "\n";
        found = known.insert(known.end(), {uv[h], ++number});
      }
      faces << " " << mesh.target(h) + 1 << "/" << found->second;
    }
    faces << "\n";
  }
  out << faces.str();
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TEXTURED_OBJ_H
