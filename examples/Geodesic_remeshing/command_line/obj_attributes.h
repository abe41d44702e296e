// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OBJ_ATTRIBUTES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OBJ_ATTRIBUTES_H

#include "soup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace command_line {

// What CGAL's readers and writers of OBJ files leave out: texture coordinates of corners, and colors of vertices, which
// many programs write behind the coordinates
using Texture_coordinates = std::array<double, 2>;
using Texture_map = Mesh::Property_map<Mesh::Halfedge_index, Texture_coordinates>; // of the corner at the target
using Color = mesh_quality::Kernel::Vector_3; // red, green and blue, in the unit of the file
using Color_map = Mesh::Property_map<Mesh::Vertex_index, Color>;

// What an OBJ file may have beside the mesh
struct Obj_attributes
{
  std::optional<Texture_map> texture;
  std::optional<Color_map> colors;
};

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

// A corner without texture coordinates has none of them.
inline std::optional<Obj_corner> obj_corner(const std::string& word, std::size_t vertices, std::size_t textures)
{
  const std::size_t slash = word.find('/');
  if(slash == std::string::npos || slash + 1 == word.size() || word[slash + 1] == '/')
    return std::nullopt;
  return Obj_corner{obj_index(word.substr(0, slash), vertices), obj_index(word.substr(slash + 1), textures)};
}

// The part of an OBJ file that is carried over. Corners are those of the mesh's faces, which are those of the file or
// parts of them, in its order.
class Obj_reader
{
public:
  Obj_reader(const std::string& file_name, Mesh& mesh, Texture_map uv)
    : m_file_name(file_name), m_mesh(mesh),
      m_index(mesh.property_map<Mesh::Vertex_index, std::size_t>(index_in_file).value()),
      m_face_index(mesh.property_map<Mesh::Face_index, std::size_t>(face_in_file).value()), m_uv(uv),
      m_face(mesh.faces().begin())
  {}

  void read_line(const std::string& line)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if(word == "v")
      read_vertex(words);
    else if(word == "vt")
    {
      Texture_coordinates at{};
      if(!(words >> at[0] >> at[1]))
        throw Input_error(m_file_name + " has texture coordinates that are no numbers: " + line);
      m_coordinates.push_back(at);
    }
    else if(word == "f" && m_face != m_mesh.faces().end())
      read_face(words);
  }

  bool has_texture() const { return m_has_texture; }
  bool has_colors() const { return m_vertices > 0 && m_colors.size() == m_vertices; }
  const Color& color(Mesh::Vertex_index v) const { return m_colors[m_index[v]]; }

private:
  // Three numbers more than a point has are its colour.
  void read_vertex(std::istringstream& words)
  {
    ++m_vertices;
    std::array<double, 6> numbers{};
    std::size_t n = 0;
    while(n < numbers.size() && words >> numbers[n])
      ++n;
    if(n == numbers.size())
      m_colors.emplace_back(numbers[3], numbers[4], numbers[5]);
  }

  void read_face(std::istringstream& words)
  {
    std::vector<Obj_corner> corners;
    for(std::string word; words >> word;)
    {
      const auto corner = obj_corner(word, m_vertices, m_coordinates.size());
      m_has_texture = m_has_texture && corner;
      if(corner)
        corners.push_back(*corner);
    }
    for(; m_face != m_mesh.faces().end() && m_face_index[*m_face] == m_faces; ++m_face)
      for(const auto h : m_mesh.halfedges_around_face(m_mesh.halfedge(*m_face)))
        for(const Obj_corner& corner : corners)
          if(m_index[m_mesh.target(h)] == corner.vertex)
            m_uv[h] = m_coordinates[corner.texture];
    ++m_faces;
  }

  const std::string m_file_name;
  const Mesh& m_mesh;
  const Mesh::Property_map<Mesh::Vertex_index, std::size_t> m_index;
  const Mesh::Property_map<Mesh::Face_index, std::size_t> m_face_index;
  Texture_map m_uv;
  Mesh::Face_range::iterator m_face;
  std::size_t m_vertices = 0, m_faces = 0;
  std::vector<Texture_coordinates> m_coordinates;
  std::vector<Color> m_colors;
  bool m_has_texture = true;
};

} // namespace internal

// Reads the attributes of a file that has been read as the mesh, and marks the edges where the texture jumps.
inline Obj_attributes read_obj_attributes(const Input_file& file, Mesh& mesh,
                                          Mesh::Property_map<Mesh::Edge_index, bool> seams)
{
  const auto in = file.open();
  const Texture_map uv = mesh.add_property_map<Mesh::Halfedge_index, Texture_coordinates>("h:uv").first;
  internal::Obj_reader reader(file.name(), mesh, uv);
  for(std::string line; std::getline(*in, line);)
    reader.read_line(line);
  Obj_attributes result;
  if(!reader.has_texture() && !reader.has_colors())
    throw Input_error(file.name() + " has vertices without colors and a face without texture coordinates");
  if(reader.has_colors())
  {
    result.colors = mesh.add_property_map<Mesh::Vertex_index, Color>("v:obj_color", Color(0., 0., 0.)).first;
    for(const auto v : mesh.vertices())
      (*result.colors)[v] = reader.color(v);
  }
  if(!reader.has_texture())
    return result;
  result.texture = uv;
  for(const auto e : mesh.edges())
  {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    seams[e] = !mesh.is_border(e) && (uv[h] != uv[mesh.prev(o)] || uv[o] != uv[mesh.prev(h)]);
  }
  return result;
}

// A vertex has as many texture coordinates as differ at its corners.
inline void write_obj(std::ostream& out, const Mesh& mesh, const Obj_attributes& attributes)
{
  for(const auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    out << "v " << p.x() << " " << p.y() << " " << p.z();
    if(attributes.colors)
      out << " " << (*attributes.colors)[v];
    out << "\n";
  }
  std::vector<std::vector<std::pair<Texture_coordinates, std::size_t>>> at(mesh.number_of_vertices());
  std::size_t number = 0;
  std::ostringstream faces;
  for(const auto f : mesh.faces())
  {
    faces << "f";
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
    {
      faces << " " << mesh.target(h) + 1;
      if(!attributes.texture)
        continue;
      const Texture_coordinates& uv = (*attributes.texture)[h];
      auto& known = at[mesh.target(h)];
      auto found = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == uv; });
      if(found == known.end())
      {
        out << "vt " << uv[0] << " " << uv[1] << "\n";
        found = known.insert(known.end(), {uv, ++number});
      }
      faces << "/" << found->second;
    }
    faces << "\n";
  }
  out << faces.str();
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OBJ_ATTRIBUTES_H
