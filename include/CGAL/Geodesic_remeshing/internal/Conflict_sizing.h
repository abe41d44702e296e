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
#include <CGAL/Geodesic_remeshing/internal/self_intersections.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Calls `visit(s, place)` for all of the surface's simplices and all conflicts whose boxes overlap, in any order.
template <class Simplices, class Box_of, class Visit>
void for_each_near(const Simplices& simplices, const Box_of& box_of, const std::vector<Conflict_place>& conflicts,
                   const Visit& visit)
{
  using Simplex = std::decay_t<decltype(*simplices.begin())>;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> places, boxes; // the latter of those near any, most often few
  Bbox_3 all;
  for(std::size_t i = 0; i < conflicts.size(); ++i)
  {
    const Vector way(conflicts[i].radius, conflicts[i].radius, conflicts[i].radius);
    places.emplace_back((conflicts[i].center - way).bbox() + (conflicts[i].center + way).bbox(), i);
    all += places.back().bbox();
  }
  for(const Simplex s : simplices)
    if(const Bbox_3 box = box_of(s); do_overlap(box, all))
      boxes.emplace_back(box, s);
  box_intersection_d(boxes.begin(), boxes.end(), places.begin(), places.end(),
                     [&](const Box& simplex, const Box& place) {
                       visit(Simplex(static_cast<Mesh::size_type>(simplex.info())), conflicts[place.info()]);
                     });
}

// Whether the input itself intersects where there are conflicts: then no triangles are small enough.
inline bool is_input_in_conflict(const Mesh& surface, const std::vector<Conflict_place>& conflicts)
{
  const auto box_of = [&](const Face f) {
    const auto v = vertices_of(surface, f);
    return surface.point(v[0]).bbox() + surface.point(v[1]).bbox() + surface.point(v[2]).bbox();
  };
  std::vector<Face> near;
  for_each_near(surface.faces(), box_of, conflicts, [&](const Face f, const Conflict_place&) { near.push_back(f); });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return !self_intersections(near, surface).empty();
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
    const auto box_of = [&](const Vertex v) { return m_surface.point(v).bbox(); };
    for_each_near(m_surface.vertices(), box_of, conflicts, [&](const Vertex v, const Conflict_place& place) {
      if(squared_distance(m_surface.point(v), place.center) <= CGAL::square(place.radius))
        is_near[v] = 1;
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
