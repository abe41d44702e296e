// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TRIANGULATE_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TRIANGULATE_H

#include "repair.h"
#include "soup.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace command_line {
namespace internal {

// What some exporters write for a triangle: a polygon with one vertex twice in succession
inline void drop_repetitions(Polygon& polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while(polygon.size() > 1 && polygon.front() == polygon.back())
    polygon.pop_back();
  if(polygon.size() < 3)
    polygon.resize(3, polygon.back()); // a degenerate triangle, for the repair
}

// A hole that is joined to the outer boundary by a bridge is passed once in each direction there. Twice in the same is
// no face.
inline bool goes_twice_along_an_edge(const Polygon& polygon)
{
  std::vector<std::pair<std::size_t, std::size_t>> sides;
  for(std::size_t i = 0; i < polygon.size(); ++i)
    sides.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
  std::sort(sides.begin(), sides.end());
  return std::adjacent_find(sides.begin(), sides.end()) != sides.end();
}

// None if it cannot be done
inline std::vector<Polygon> triangles_of(Polygon polygon, const std::vector<Point>& points)
{
  drop_repetitions(polygon);
  std::vector<Polygon> triangles{polygon};
  if(polygon.size() == 3)
    return triangles;
  if(goes_twice_along_an_edge(polygon))
    return {};
  try
  {
    if(CGAL::Polygon_mesh_processing::triangulate_polygons(points, triangles))
      return triangles;
  }
  catch(const std::exception&)
  {
    // a precondition of CGAL, where it is checked
  }
  return {};
}

// Divides the faces with more than three vertices; the vertices keep their numbers. Gives for each face the number of
// the one in the file.
inline std::vector<std::size_t> triangulate(Soup& soup, const Repair_options& options,
                                            std::vector<std::string>& repairs)
{
  std::size_t number_divided = 0;
  std::vector<Polygon> triangles;
  std::vector<std::size_t> face_in_file;
  triangles.reserve(soup.polygons.size());
  face_in_file.reserve(soup.polygons.size());
  for(std::size_t f = 0; f < soup.polygons.size(); ++f)
  {
    Polygon& polygon = soup.polygons[f];
    if(polygon.size() == 3)
      triangles.push_back(std::move(polygon));
    else
    {
      const std::string fault = face_name(f) + " has " + std::to_string(polygon.size()) + " vertices";
      if(!options.do_repair)
        throw Input_error("is not triangulated: " + fault);
      const std::vector<Polygon> parts = triangles_of(polygon, soup.points);
      if(parts.empty())
        throw Input_error("cannot be triangulated: " + fault + ", and no simple boundary");
      ++number_divided;
      triangles.insert(triangles.end(), parts.begin(), parts.end());
    }
    face_in_file.resize(triangles.size(), f);
  }
  soup.polygons = std::move(triangles);
  tell(repairs, "triangulated", number_divided, face_noun, " with more than three vertices");
  return face_in_file;
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_TRIANGULATE_H
