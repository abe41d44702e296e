// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_SIZING_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_SIZING_H

#include <CGAL/Geodesic_remeshing/internal/Conflict_search.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline Bbox_3 box_of(const Conflict_place& place)
{
  const Vector way(place.radius, place.radius, place.radius);
  return (place.center - way).bbox() + (place.center + way).bbox();
}

// Whether the input itself intersects where there are conflicts: then no triangles are small enough.
inline bool is_input_in_conflict(const Mesh& surface, const std::vector<Conflict_place>& conflicts)
{
  const auto box_of_face = [&](const Face f) {
    const auto v = vertices_of(surface, f);
    return surface.point(v[0]).bbox() + surface.point(v[1]).bbox() + surface.point(v[2]).bbox();
  };
  std::vector<Bbox_3> boxes;
  for(const Conflict_place& place : conflicts)
    boxes.push_back(box_of(place));
  std::vector<Face> near;
  for(const Face f : surface.faces())
  {
    const Bbox_3 box = box_of_face(f);
    if(std::any_of(boxes.begin(), boxes.end(), [&](const Bbox_3& b) { return do_overlap(box, b); }))
      near.push_back(f);
  }
  std::vector<std::pair<Face, Face>> pairs;
  Polygon_mesh_processing::self_intersections(near, surface, std::back_inserter(pairs));
  return !pairs.empty();
}

// What lengths edges are to have so that faces that were in conflict will not be: shorter ones there, and steeper
// grown than a sizing wishes for its own sake, as few vertices are to be spared for it.
class Conflict_sizing
{
public:
  Conflict_sizing(const Mesh& surface, std::vector<double> wishes, const Sizing_limits& limits)
    : m_surface(surface), m_wishes(std::move(wishes)), m_limits(limits)
  {
    m_wishes.resize(surface.number_of_vertices(), 1.);
    m_limits.gradation = (std::max)(m_limits.gradation, .3);
  }

  const std::vector<double>& wishes() const { return m_wishes; }
  const Sizing_limits& limits() const { return m_limits; }

  void shorten(const std::vector<Conflict_place>& conflicts)
  {
    std::vector<char> is_near(m_wishes.size(), 0);
    for(const Conflict_place& place : conflicts)
      for(const Face f : place.faces)
        for(const Vertex v : vertices_of(m_surface, f))
          is_near[v] = 1;
    for(const Vertex v : m_surface.vertices())
      is_near[v] = is_near[v] || std::any_of(conflicts.begin(), conflicts.end(), [&](const Conflict_place& place) {
                     return squared_distance(m_surface.point(v), place.center) <= CGAL::square(place.radius);
                   });
    for(std::size_t v = 0; v < is_near.size(); ++v)
      m_wishes[v] *= is_near[v] ? .6 : 1.;
  }

private:
  const Mesh& m_surface;
  std::vector<double> m_wishes;
  Sizing_limits m_limits;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_SIZING_H
