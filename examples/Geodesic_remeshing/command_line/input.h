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

#include "../include/mesh_quality.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace command_line {

using mesh_quality::Mesh;
using mesh_quality::Point;

// the vertex property of a mesh read: the number that the file has for it, which has vertices that no face uses as well
constexpr const char* index_in_file = "v:index_in_file";

// exit status 2
struct Input_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

namespace internal {

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

// The readers of CGAL write several lines to std::cerr when a file is damaged; our promise is one line.
class Silent_errors
{
public:
  Silent_errors() : m_buffer(std::cerr.rdbuf(nullptr)) {}
  ~Silent_errors()
  {
    std::cerr.rdbuf(m_buffer);
    std::cerr.clear();
  }
  Silent_errors(const Silent_errors&) = delete;
  Silent_errors& operator=(const Silent_errors&) = delete;

private:
  std::streambuf* m_buffer;
};

inline Soup read_soup(const std::string& file_name)
{
  if(!std::ifstream(file_name))
    throw Input_error("cannot be opened");
  Soup soup;
  bool read = false;
  try
  {
    const Silent_errors silence;
    read = CGAL::IO::read_polygon_soup(file_name, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  }
  catch(const std::exception&)
  {
    // a damaged header can ask for more memory than there is
  }
  if(!read)
    throw Input_error("cannot be read as a mesh (OFF, OBJ, PLY, STL or TS, according to its ending)");
  return soup;
}

inline std::string face_name(std::size_t f)
{
  return "face " + std::to_string(f);
}

inline void check_points_and_polygons(const Soup& soup)
{
  if(soup.points.empty() || soup.polygons.empty())
    throw Input_error("is empty: " + std::to_string(soup.points.size()) + " vertices, " +
                      std::to_string(soup.polygons.size()) + " faces");
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const Point& p = soup.points[v];
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Input_error("vertex " + std::to_string(v) + " has a coordinate that is not finite");
  }
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    const auto& polygon = soup.polygons[f];
    if(polygon.size() != 3)
      throw Input_error("is not triangulated: " + face_name(f) + " has " + std::to_string(polygon.size()) +
                        " vertices");
    for(const std::size_t v : polygon)
      if(v >= soup.points.size())
        throw Input_error(face_name(f) + " uses vertex " + std::to_string(v) + ", which does not exist");
    if(polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      throw Input_error(face_name(f) + " uses a vertex twice");
  }
}

// one side of a face: the edge, and whether the face runs through it from its lower to its higher vertex
struct Side
{
  std::size_t low;
  std::size_t high;
  std::size_t face;
  bool ascending;
};

inline std::vector<Side> sorted_sides(const Soup& soup)
{
  std::vector<Side> sides;
  sides.reserve(3 * soup.polygons.size());
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t a = soup.polygons[f][i];
      const std::size_t b = soup.polygons[f][(i + 1) % 3];
      sides.push_back({(std::min)(a, b), (std::max)(a, b), f, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::make_pair(s.low, s.high) != std::make_pair(t.low, t.high)
               ? std::make_pair(s.low, s.high) < std::make_pair(t.low, t.high)
               : s.face < t.face;
  });
  return sides;
}

// Every edge must lie on two faces that go through it in opposite directions.
inline void check_edges(const std::vector<Side>& sides)
{
  for(std::size_t first = 0; first < sides.size();)
  {
    std::size_t last = first + 1;
    while(last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high)
      ++last;
    const std::string edge =
        "edge (" + std::to_string(sides[first].low) + ", " + std::to_string(sides[first].high) + ")";
    if(last - first > 2)
      throw Input_error("is not manifold: " + edge + " has " + std::to_string(last - first) + " faces, among them " +
                        face_name(sides[first].face) + " and " + face_name(sides[first + 1].face));
    if(last - first == 1)
      throw Input_error("has a boundary, which is not supported yet: " + edge + " belongs to " +
                        face_name(sides[first].face) + " only");
    if(sides[first].ascending == sides[first + 1].ascending)
      throw Input_error("is not oriented: " + face_name(sides[first].face) + " and " +
                        face_name(sides[first + 1].face) + " run through " + edge + " in the same direction");
    first = last;
  }
}

// The faces around a vertex must form one fan: as many as are met by walking once around it.
inline void check_vertices(const Soup& soup, const std::vector<Side>& sides)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  // across[3 f + i]: the face behind the side from corner i of f to the next one (edges are in order by now)
  std::vector<std::size_t> across(3 * soup.polygons.size());
  const auto corner = [&](std::size_t f, std::size_t v) {
    const auto& p = soup.polygons[f];
    return p[0] == v ? std::size_t(0) : p[1] == v ? std::size_t(1) : std::size_t(2);
  };
  for(std::size_t s = 0; s < sides.size(); s += 2)
    for(std::size_t k = 0; k < 2; ++k)
    {
      const Side& side = sides[s + k];
      const std::size_t start = side.ascending ? side.low : side.high;
      across[3 * side.face + corner(side.face, start)] = sides[s + 1 - k].face;
    }
  std::vector<std::size_t> faces_at(soup.points.size(), 0);
  std::vector<std::size_t> first_face(soup.points.size(), none);
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    for(const std::size_t v : soup.polygons[f])
    {
      ++faces_at[v];
      if(first_face[v] == none)
        first_face[v] = f;
    }
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    if(first_face[v] == none)
      continue;
    std::size_t met = 0;
    std::size_t f = first_face[v];
    do
    {
      f = across[3 * f + corner(f, v)];
      ++met;
    } while(f != first_face[v]);
    if(met != faces_at[v])
      throw Input_error("is not manifold: the faces around vertex " + std::to_string(v) + " form more than one fan");
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

} // namespace internal

struct Input
{
  Mesh mesh;
  std::size_t vertices_in_file;
};

// The closed triangle mesh of a file; says what is wrong, and where, if it holds no such thing.
inline Input read_mesh(const std::string& file_name)
{
  try
  {
    const internal::Soup soup = internal::read_soup(file_name);
    internal::check_points_and_polygons(soup);
    const auto sides = internal::sorted_sides(soup);
    internal::check_edges(sides);
    internal::check_vertices(soup, sides);
    return {internal::make_mesh(soup), soup.points.size()};
  }
  catch(const Input_error& error)
  {
    throw Input_error(file_name + " " + error.what());
  }
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_H
