// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_REPAIR_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_REPAIR_H

#include "shared_walls.h"
#include "soup.h"
#include "touching_edges.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace command_line {

// What may be done to make a good mesh of a file
struct Repair_options
{
  bool do_repair = true;        // else what is no mesh is refused
  double stitch_tolerance = 0.; // vertices of the boundary no farther apart are made one; zero: none
  double drop_parts = 0.;       // parts with less than these percent of the area are left out
  std::size_t fill_holes = 0;   // holes with at most so many edges are closed
};

namespace internal {

namespace PMP = CGAL::Polygon_mesh_processing;

// Are there edges of a boundary that coincide, as in formats in which each face has points of its own?
inline bool has_open_seams(const Soup& soup)
{
  std::vector<std::pair<Point, Point>> open;
  for_each_edge(sorted_sides(soup), [&](auto first, auto last) {
    if(last - first == 1)
      open.push_back(std::minmax(soup.points[first->low], soup.points[first->high]));
  });
  std::sort(open.begin(), open.end());
  return std::adjacent_find(open.begin(), open.end()) != open.end();
}

struct Noun
{
  const char *one, *many;
};

constexpr Noun face_noun{"face", "faces"}, edge_noun{"edge", "edges"}, vertex_noun{"vertex", "vertices"};

inline void tell(std::vector<std::string>& repairs, const std::string& what, std::size_t number, const Noun& noun,
                 const std::string& which = std::string())
{
  if(number > 0)
    repairs.push_back(what + " " + std::to_string(number) + " " + (number == 1 ? noun.one : noun.many) + which);
}

inline std::size_t drop_degenerate_faces(Soup& soup)
{
  const auto kept = std::remove_if(soup.polygons.begin(), soup.polygons.end(), uses_a_vertex_twice);
  const std::size_t number = static_cast<std::size_t>(soup.polygons.end() - kept);
  soup.polygons.erase(kept, soup.polygons.end());
  return number;
}

// The vertices may have been duplicated in between, so the points tell.
inline bool is_turned(const Polygon& before, const Polygon& after, const std::vector<Point>& points)
{
  for(std::size_t i = 0; i < 3; ++i)
    if(points[before[0]] == points[after[i]])
      return points[before[1]] != points[after[(i + 1) % 3]];
  return false;
}

inline std::size_t number_of_edges_with_many_faces(const Soup& soup)
{
  std::size_t number = 0;
  for_each_edge(sorted_sides(soup), [&](auto first, auto last) { number += last - first > 2; });
  return number;
}

// Makes a mesh of the soup by the tools of CGAL, and tells what had to be done. Where more than two faces meet in an
// edge, or more than one fan in a vertex, these are duplicated, so that the faces no longer hang together there.
inline std::vector<std::string> repair(Soup& soup)
{
  std::vector<std::string> repairs;
  tell(repairs, "merged", PMP::merge_duplicate_points_in_polygon_soup(soup.points, soup.polygons),
       Noun{"duplicate point", "duplicate points"});
  tell(repairs, "dropped", drop_degenerate_faces(soup), face_noun, " with a vertex twice");
  tell(repairs, "dropped", Shared_walls(soup).drop(), face_noun, " of walls between solids that touch");
  tell(repairs, "dropped", PMP::merge_duplicate_polygons_in_polygon_soup(soup.points, soup.polygons),
       Noun{"duplicate face", "duplicate faces"});
  if(soup.polygons.empty())
    throw Input_error("has no face left after repair");
  // Of internal walls and fins nothing tells which two of the faces at an edge go on in each other.
  const std::size_t many = number_of_edges_with_many_faces(soup), parted = Touching_edges(soup).part();
  tell(repairs, "parted", parted, edge_noun, " with four faces or more, along which solids touch");
  tell(repairs, "cut open", many - parted, edge_noun, " with three faces or more, at which the surface branches");
  check_orientability(soup, sorted_sides(soup));
  const std::vector<Polygon> before = soup.polygons;
  const std::size_t points = soup.points.size();
  PMP::orient_polygon_soup(soup.points, soup.polygons);
  tell(repairs, "duplicated", soup.points.size() - points,
       Noun{"vertex that is not manifold", "vertices that are not manifold"});
  std::size_t turned = 0;
  for(std::size_t f = 0; f < before.size(); ++f)
    turned += is_turned(before[f], soup.polygons[f], soup.points);
  tell(repairs, "turned", turned, face_noun);
  return repairs;
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_REPAIR_H
