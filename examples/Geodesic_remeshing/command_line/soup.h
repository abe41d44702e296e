// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SOUP_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SOUP_H

#include "../include/mesh_quality.h"
#include "input_file.h"
#include "possible_files.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <istream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace command_line {

using mesh_quality::Mesh;
using mesh_quality::Point;

// Properties of a mesh read, while its vertices are those of the file: the number that the file has for a vertex, which
// has vertices that no face uses as well, and the one for a face, of which several triangles may have been made
constexpr const char* index_in_file = "v:index_in_file";
constexpr const char* face_in_file = "f:face_in_file";

// exit status 2
struct Input_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

namespace internal {

struct Soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
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

inline std::string in_small_letters(std::istream& in)
{
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

inline bool read_soup(const Input_file& file, Soup& soup)
{
  const auto in = file.open();
  if(file.format() == "off")
    return is_off_possible(*file.open()) && CGAL::IO::read_OFF(*in, soup.points, soup.polygons);
  if(file.format() == "obj")
    return CGAL::IO::read_OBJ(*in, soup.points, soup.polygons);
  if(file.format() == "ply")
    return is_ply_possible(*file.open()) && CGAL::IO::read_PLY(*in, soup.points, soup.polygons);
  if(file.format() == "ts")
    return CGAL::IO::read_GOCAD(*in, soup.points, soup.polygons);
  if(file.format() != "stl")
    return false;
  CGAL::IO::set_binary_mode(*in); // a text may be taken for binary
  if(CGAL::IO::read_STL(*in, soup.points, soup.polygons))
    return true;
  const auto read_text = [&](std::istream& text) {
    soup = Soup();
    return CGAL::IO::read_STL(text, soup.points, soup.polygons, CGAL::parameters::use_binary_mode(false));
  };
  if(read_text(*file.open()))
    return true;
  const std::string small = in_small_letters(*file.open()); // some programs write capital ones
  std::istringstream text(small);
  return small.rfind("solid", 0) == 0 && read_text(text);
}

inline Soup read_soup(const Input_file& file)
{
  if(!*file.open())
    throw Input_error("cannot be opened");
  Soup soup;
  bool read = false;
  try
  {
    const Silent_errors silence;
    read = read_soup(file, soup);
  }
  catch(const std::exception&)
  {
    // a damaged header can ask for more memory than there is
  }
  if(!read)
    throw Input_error("cannot be read as a mesh (OFF, OBJ, PLY, STL or TS, according to its ending or --input-format)");
  return soup;
}

inline std::string face_name(std::size_t f)
{
  return "face " + std::to_string(f);
}

inline bool uses_a_vertex_twice(const Polygon& polygon)
{
  return polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0];
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
    if(polygon.size() < 3)
      throw Input_error(face_name(f) + " has " + std::to_string(polygon.size()) + " vertices");
    for(const std::size_t v : polygon)
      if(v >= soup.points.size())
        throw Input_error(face_name(f) + " uses vertex " + std::to_string(v) + ", which does not exist");
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
    return std::tie(s.low, s.high, s.face) < std::tie(t.low, t.high, t.face);
  });
  return sides;
}

// Calls `visit(begin, end)` with the sides of each edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit)
{
  for(auto first = sides.begin(); first != sides.end();)
  {
    const auto last =
        std::find_if(first, sides.end(), [&](const Side& s) { return s.low != first->low || s.high != first->high; });
    visit(first, last);
    first = last;
  }
}

inline std::string edge_name(const Side& side)
{
  return "edge (" + std::to_string(side.low) + ", " + std::to_string(side.high) + ")";
}

// An edge has one face, or two that go through it in opposite directions.
inline void check_edges(const std::vector<Side>& sides)
{
  for_each_edge(sides, [](auto first, auto last) {
    if(last - first > 2)
      throw Input_error("is not manifold: " + edge_name(*first) + " has " + std::to_string(last - first) +
                        " faces, among them " + face_name(first->face) + " and " + face_name(first[1].face));
    if(last - first == 2 && first->ascending == first[1].ascending)
      throw Input_error("is not oriented: " + face_name(first->face) + " and " + face_name(first[1].face) +
                        " run through " + edge_name(*first) + " in the same direction");
  });
}

using Disjoint_sets = boost::disjoint_sets_with_storage<>;

// The faces around a vertex must form one fan: their corners there are joined across edges.
inline void check_vertices(const Soup& soup, const std::vector<Side>& sides)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  const auto corner = [&](std::size_t f, std::size_t v) {
    const auto& p = soup.polygons[f];
    return 3 * f + (p[0] == v ? 0 : p[1] == v ? 1 : 2);
  };
  Disjoint_sets fans(3 * soup.polygons.size());
  for_each_edge(sides, [&](auto first, auto last) {
    for(auto s = first + 1; s < last; ++s)
      for(const std::size_t v : {first->low, first->high})
        fans.union_set(corner(first->face, v), corner(s->face, v));
  });
  std::vector<std::size_t> fan_of(soup.points.size(), none);
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
    for(std::size_t i = 0; i < 3; ++i)
    {
      std::size_t& fan = fan_of[soup.polygons[f][i]];
      if(fan != none && fan != fans.find_set(3 * f + i))
        throw Input_error("is not manifold: the faces around vertex " + std::to_string(soup.polygons[f][i]) +
                          " form more than one fan");
      fan = fans.find_set(3 * f + i);
    }
}

// A one-sided surface, as that of Moebius, has no orientation; only cutting it open would give it one. A face as it is
// and the face turned over are two elements here: those that must go together are united, and none may meet its own
// opposite.
inline void check_orientability(const Soup& soup, const std::vector<Side>& sides)
{
  const std::size_t n = soup.polygons.size();
  Disjoint_sets sets(2 * n);
  for_each_edge(sides, [&](auto first, auto last) {
    if(last - first != 2)
      return;
    const std::size_t f = first->face, g = first[1].face, turned = first->ascending == first[1].ascending ? n : 0;
    sets.union_set(f, g + turned);
    sets.union_set(f + n, g + n - turned);
  });
  for(std::size_t f = 0; f < n; ++f)
    if(sets.find_set(f) == sets.find_set(f + n))
      throw Input_error("cannot be oriented: its surface has one side only, seen from " + face_name(f));
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SOUP_H
