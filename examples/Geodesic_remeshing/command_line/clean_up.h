// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_CLEAN_UP_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_CLEAN_UP_H

#include "soup.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace command_line {

// What a scan has too much and too little of: splinters beside the surface, and holes in it.
namespace internal {

// Parts with less than these percent of the area go; the largest stays in any case.
inline std::size_t drop_small_parts(Mesh& mesh, double percent)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  auto part = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  std::vector<double> area(PMP::connected_components(mesh, part), 0.);
  for(const Mesh::Face_index f : mesh.faces())
    area[part[f]] += PMP::face_area(f, mesh);
  double whole = 0.;
  for(const double a : area)
    whole += a;
  const double least = (std::min)(percent / 100. * whole, *std::max_element(area.begin(), area.end()));
  std::vector<std::size_t> small;
  for(std::size_t i = 0; i < area.size(); ++i)
    if(area[i] < least)
      small.push_back(i);
  PMP::remove_connected_components(mesh, small, part);
  mesh.remove_property_map(part);
  mesh.collect_garbage();
  return small.size();
}

// A halfedge of each. (The function of CGAL for this has moved to other headers since 6.0.)
inline std::vector<Mesh::Halfedge_index> holes_of(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> holes;
  std::vector<bool> seen(mesh.number_of_halfedges(), false);
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(mesh.is_border(h) && !seen[h])
    {
      holes.push_back(h);
      for(const Mesh::Halfedge_index g : mesh.halfedges_around_face(h))
        seen[g] = true;
    }
  return holes;
}

// Holes with at most so many edges are closed.
inline std::size_t fill_small_holes(Mesh& mesh, std::size_t edges)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::size_t number = 0;
  for(const Mesh::Halfedge_index hole : holes_of(mesh))
  {
    const auto around = mesh.halfedges_around_face(hole);
    if(static_cast<std::size_t>(std::distance(around.begin(), around.end())) > edges)
      continue;
    // CGAL takes a hole that it enters by an edge without length for a polyline whose first point is told again at its
    // end, and leaves a face with four vertices.
    const auto entrance = std::find_if(around.begin(), around.end(), [&](const Mesh::Halfedge_index h) {
      return mesh.point(mesh.source(h)) != mesh.point(mesh.target(h));
    });
    if(entrance == around.end())
      continue;
    std::vector<Mesh::Face_index> patch;
    PMP::triangulate_hole(mesh, *entrance, CGAL::parameters::face_output_iterator(std::back_inserter(patch)));
    number += patch.empty() ? 0 : 1;
  }
  return number;
}

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_CLEAN_UP_H
