// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SIZING_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SIZING_H

#include "input.h"

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace command_line {

namespace internal {

inline std::vector<double> read_numbers(const std::string& file_name)
{
  std::ifstream in(file_name);
  if(!in)
    throw Input_error("cannot be opened");
  std::vector<double> numbers;
  for(std::string word; in >> word;)
  {
    std::size_t used = 0;
    double number = 0.;
    try
    {
      number = std::stod(word, &used);
    }
    catch(const std::exception&)
    {
      // said below
    }
    if(used != word.size())
      throw Input_error("has \"" + word.substr(0, 40) + "\" for number " + std::to_string(numbers.size()));
    numbers.push_back(number);
  }
  return numbers;
}

template <class Number>
bool append_property(const Mesh& mesh, std::vector<double>& numbers)
{
  const auto map = mesh.property_map<Mesh::Vertex_index, Number>("v:sizing");
  if(!map)
    return false;
  for(const auto v : mesh.vertices())
    numbers.push_back(static_cast<double>((*map)[v]));
  return true;
}

inline std::vector<double> read_ply_property(const std::string& file_name)
{
  std::ifstream in(file_name, std::ios::binary);
  if(!in)
    throw Input_error("cannot be opened");
  Mesh mesh;
  std::vector<double> numbers;
  bool read = false;
  try
  {
    const Silent_errors silence;
    read = CGAL::IO::read_PLY(in, mesh);
  }
  catch(const std::exception&)
  {
    // as for any other damaged file
  }
  if(!read)
    throw Input_error("cannot be read as PLY");
  if(!append_property<double>(mesh, numbers) && !append_property<float>(mesh, numbers))
    throw Input_error("has no vertex property \"sizing\" of type float or double");
  return numbers;
}

} // namespace internal

// The numbers of a file, one for each vertex of the input file in its order, by vertex of the mesh.
inline Mesh::Property_map<Mesh::Vertex_index, double> read_sizing(const std::string& file_name, Mesh& mesh,
                                                                  std::size_t number_of_vertices)
{
  try
  {
    std::string ending = file_name.substr((std::min)(file_name.size(), file_name.rfind('.')));
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::vector<double> numbers =
        ending == ".ply" ? internal::read_ply_property(file_name) : internal::read_numbers(file_name);
    if(numbers.size() != number_of_vertices)
      throw Input_error("has " + std::to_string(numbers.size()) + " numbers for " + std::to_string(number_of_vertices) +
                        " vertices");
    const auto index_map = mesh.property_map<Mesh::Vertex_index, std::size_t>(index_in_file);
    if(!index_map)
      throw Input_error("does not fit: the mesh had to be repaired, and its vertices are no longer those of its file");
    const auto index = *index_map;
    auto sizing = mesh.add_property_map<Mesh::Vertex_index, double>("v:sizing").first;
    for(const auto v : mesh.vertices())
    {
      sizing[v] = numbers[index[v]];
      if(!(sizing[v] > 0.) || !std::isfinite(sizing[v]))
        throw Input_error("has a size for vertex " + std::to_string(index[v]) + " that is not positive and finite");
    }
    return sizing;
  }
  catch(const Input_error& error)
  {
    throw Input_error(file_name + " " + error.what());
  }
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SIZING_H
