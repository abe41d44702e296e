// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TRANSFER_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TRANSFER_H

#include "input.h"
#include "obj_attributes.h"

#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace command_line {

using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

// What the file of the input has beside points and faces, carried over to the output (--transfer): from PLY to PLY all
// scalar properties, colours and normals of vertices and faces; from OBJ to OBJ the texture coordinates, their seams
// being constrained edges, and the colours of vertices.
class Transfer
{
public:
  // Nothing is carried over if it is not wanted.
  Transfer(bool is_wanted, const Input_file& file, Input& input, Mesh& output)
    : m_input(input.mesh), m_output(output),
      m_seams(input.mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first),
      m_locations(output.add_property_map<Mesh::Vertex_index, Location>("v:place on input").first)
  {
    if(!is_wanted)
      return;
    if(!input.mesh.property_map<Mesh::Face_index, std::size_t>(face_in_file))
      throw Input_error(file.name() + " had to be repaired: its properties do not belong to the mesh any more");
    if(file.format() == "obj")
      m_obj = read_obj_attributes(file, m_input, m_seams);
    else
      read_ply(file, input);
  }

  static bool is_possible(const std::string& input_format, const std::string& output_format)
  {
    return input_format == output_format && (input_format == "ply" || input_format == "obj");
  }

  const Mesh::Property_map<Mesh::Edge_index, bool>& seams() const { return m_seams; }
  const Mesh::Property_map<Mesh::Vertex_index, Location>& locations() const { return m_locations; }

  // After remeshing. What it adds to the output is written with it as PLY.
  void run()
  {
    for(const auto& carry : m_vertex_properties)
      carry();
    for(const auto& carry : m_face_properties)
      carry();
    if(m_obj.colors)
    {
      m_output_obj.colors =
          m_output.add_property_map<Mesh::Vertex_index, Color>("v:obj_color", Color(0., 0., 0.)).first;
      CGAL::Geodesic_remeshing::transfer_vertex_property(m_input, *m_obj.colors, m_output, m_locations,
                                                         *m_output_obj.colors);
    }
    if(!m_obj.texture)
      return;
    m_output_obj.texture = m_output.add_property_map<Mesh::Halfedge_index, Texture_coordinates>("h:uv").first;
    CGAL::Geodesic_remeshing::transfer_corner_property(m_input, *m_obj.texture, m_output, m_locations,
                                                       *m_output_obj.texture);
  }

  bool is_from_obj() const { return m_obj.texture || m_obj.colors; }
  void write_obj(std::ostream& out) const { command_line::write_obj(out, m_output, m_output_obj); }

private:
  void read_ply(const Input_file& file, const Input& input)
  {
    const auto in = file.open();
    bool read = false;
    try
    {
      const internal::Silent_errors silence;
      read = CGAL::IO::read_PLY(*in, m_file);
    }
    catch(const std::exception&)
    {
      // as for any other damaged file
    }
    if(!read || m_file.number_of_vertices() != input.vertices_in_file ||
       m_file.number_of_faces() != input.faces_in_file)
      throw Input_error(file.name() + " has properties that cannot be read");
    const std::vector<std::string> names = m_file.properties<Mesh::Vertex_index>();
    for(const std::string& name : std::set<std::string>(names.begin(), names.end()))
      add_vertex_property<double, float, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                          std::uint32_t, CGAL::IO::Color, mesh_quality::Kernel::Vector_3>(name);
    for(const std::string& name : m_file.properties<Mesh::Face_index>())
      add_face_property<double, float, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                        std::uint32_t, CGAL::IO::Color>(name);
  }

  // With the one of these types that the property has
  template <class... Values>
  void add_vertex_property(const std::string& name)
  {
    (add_one_vertex_property<Values>(name), ...);
  }
  template <class... Values>
  void add_face_property(const std::string& name)
  {
    (add_one_face_property<Values>(name), ...);
  }

  template <class Value>
  void add_one_vertex_property(const std::string& name)
  {
    const auto in_file = m_file.property_map<Mesh::Vertex_index, Value>(name);
    if(!in_file || name == "v:removed")
      return;
    auto values = m_input.add_property_map<Mesh::Vertex_index, Value>("v:carried:" + name).first;
    const auto index = m_input.property_map<Mesh::Vertex_index, std::size_t>(index_in_file).value();
    for(const auto v : m_input.vertices())
      values[v] = (*in_file)[Mesh::Vertex_index(static_cast<Mesh::size_type>(index[v]))];
    m_vertex_properties.push_back([this, name, values] {
      CGAL::Geodesic_remeshing::transfer_vertex_property(
          m_input, values, m_output, m_locations,
          m_output.add_property_map<Mesh::Vertex_index, Value>(name == "v:point" ? "v:point_in_file" : name).first);
    });
  }

  template <class Value>
  void add_one_face_property(const std::string& name)
  {
    const auto in_file = m_file.property_map<Mesh::Face_index, Value>(name);
    if(!in_file || name == "f:removed")
      return;
    auto values = m_input.add_property_map<Mesh::Face_index, Value>("f:carried:" + name).first;
    const auto index = m_input.property_map<Mesh::Face_index, std::size_t>(face_in_file).value();
    for(const auto f : m_input.faces())
      values[f] = (*in_file)[Mesh::Face_index(static_cast<Mesh::size_type>(index[f]))];
    m_face_properties.push_back([this, name, values] {
      CGAL::Geodesic_remeshing::transfer_face_property(m_input, values, m_output, m_locations,
                                                       m_output.add_property_map<Mesh::Face_index, Value>(name).first);
    });
  }

  Mesh& m_input;
  Mesh& m_output;
  Mesh m_file;
  Mesh::Property_map<Mesh::Edge_index, bool> m_seams;
  Mesh::Property_map<Mesh::Vertex_index, Location> m_locations;
  std::vector<std::function<void()>> m_vertex_properties, m_face_properties;
  Obj_attributes m_obj, m_output_obj;
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TRANSFER_H
