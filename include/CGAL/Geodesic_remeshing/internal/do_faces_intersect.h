// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DO_FACES_INTERSECT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DO_FACES_INTERSECT_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline Kernel::Triangle_3 triangle_of(const Remeshed_surface& remeshed, const Lean_triangulation::Index f)
{
  const Lean_triangulation& table = remeshed.connectivity();
  return {remeshed.spot(table.source(4 * f)).point, remeshed.spot(table.source(4 * f + 1)).point,
          remeshed.spot(table.source(4 * f + 2)).point};
}

struct Face_box
{
  std::array<double, 3> low = {{infinity, infinity, infinity}}, high = {{-infinity, -infinity, -infinity}};
};

inline Face_box box_of(const Remeshed_surface& remeshed, const Lean_triangulation::Index f)
{
  Face_box box;
  for(Lean_triangulation::Index h = 4 * f; h < 4 * f + 3; ++h)
    for(int i = 0; i < 3; ++i)
    {
      const double x = remeshed.spot(remeshed.connectivity().source(h)).point[i];
      box.low[i] = (std::min)(box.low[i], x);
      box.high[i] = (std::max)(box.high[i], x);
    }
  return box;
}

inline bool do_overlap(const Face_box& a, const Face_box& b)
{
  for(int i = 0; i < 3; ++i)
    if(a.low[i] > b.high[i] || b.low[i] > a.high[i])
      return false;
  return true;
}

// By a plane across the way between the centers, with a distance far above the rounding.
inline bool are_apart(const Remeshed_surface& remeshed, const Lean_triangulation::Index f,
                      const Lean_triangulation::Index g)
{
  using Index = Lean_triangulation::Index;
  const auto point = [&](const Index h) -> const Point& {
    return remeshed.spot(remeshed.connectivity().source(h)).point;
  };
  const Point& origin = point(4 * f);
  Vector way(0., 0., 0.);
  for(Index i = 0; i < 3; ++i)
    way = way + (point(4 * g + i) - point(4 * f + i));
  double end = -infinity, start = infinity;
  for(Index i = 0; i < 3; ++i)
  {
    end = (std::max)(end, (point(4 * f + i) - origin) * way);
    start = (std::min)(start, (point(4 * g + i) - origin) * way);
  }
  return start - end > 1e-3 * way.squared_length();
}

// The same for the sides of two faces across from a corner that they share, by a plane through it.
inline bool are_apart_at_corner(const Remeshed_surface& remeshed, const Lean_triangulation::Index h,
                                const Lean_triangulation::Index k)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const Point& corner = remeshed.spot(table.source(h)).point;
  const auto way_to = [&](const Lean_triangulation::Index v) { return remeshed.spot(v).point - corner; };
  const Vector a = way_to(table.target(h)), b = way_to(table.apex(h)), c = way_to(table.target(k)),
               d = way_to(table.apex(k));
  const Vector way = c + d - a - b;
  const double far = 1e-3 * way.squared_length();
  return (std::max)(a * way, b * way) < -far && (std::min)(c * way, d * way) > far;
}

// Whether two faces have more in common than their vertices. Not asked of two that share an edge: if one lies on the
// other it is a turned face, which `find_turned_faces()` finds.
inline bool do_faces_intersect(const Remeshed_surface& remeshed, const Lean_triangulation::Index f,
                               const Lean_triangulation::Index g)
{
  const Lean_triangulation& table = remeshed.connectivity();
  Lean_triangulation::Index h = Lean_triangulation::none, k = h;
  int shared = 0;
  for(Lean_triangulation::Index i = 4 * f; i < 4 * f + 3; ++i)
    for(Lean_triangulation::Index j = 4 * g; j < 4 * g + 3; ++j)
      if(table.source(i) == table.source(j))
      {
        ++shared;
        h = i;
        k = j;
      }
  if(shared > 1 || (shared == 1 ? are_apart_at_corner(remeshed, h, k) : are_apart(remeshed, f, g)))
    return false;
  const Kernel::Triangle_3 s = triangle_of(remeshed, f), t = triangle_of(remeshed, g);
  if(s.is_degenerate() || t.is_degenerate())
    return false; // the predicates do not take faces of no area, and parting them from others would not mend them
  if(shared == 0)
    return do_intersect(s, t);
  const auto opposite = [&](const Lean_triangulation::Index i) {
    return Kernel::Segment_3(remeshed.spot(table.target(i)).point, remeshed.spot(table.apex(i)).point);
  };
  return do_intersect(opposite(h), t) || do_intersect(opposite(k), s);
}

// How many pairs of a face at one of the vertices and one near them, no farther than two faces beyond, intersect; no
// more than so many. A pair of two faces at the vertices counts twice.
template <class Vertices>
std::size_t number_of_intersections_near(const Remeshed_surface& remeshed, const Vertices& vertices,
                                         const std::size_t most)
{
  using Index = Lean_triangulation::Index;
  const Lean_triangulation& table = remeshed.connectivity();
  std::vector<Index> around(vertices.begin(), vertices.end()), faces;
  const auto add_faces = [&] {
    for(const Index v : around)
      table.for_each_outgoing(v, [&](const Index h) { faces.push_back(Lean_triangulation::face(h)); });
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  };
  add_faces();
  const std::vector<Index> changed = faces;
  for(int ring = 0; ring < 2; ++ring)
  {
    around.clear();
    for(const Index f : faces)
      for(Index h = 4 * f; h < 4 * f + 3; ++h)
        around.push_back(table.source(h));
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    add_faces();
  }
  std::vector<Face_box> boxes;
  for(const Index f : faces)
    boxes.push_back(box_of(remeshed, f));
  std::size_t number = 0;
  for(std::size_t k = 0; k < changed.size() && number < most; ++k)
  {
    const Index f = changed[k];
    const Face_box box = box_of(remeshed, f);
    for(std::size_t i = 0; i < faces.size() && number < most; ++i)
      number += f != faces[i] && do_overlap(box, boxes[i]) && do_faces_intersect(remeshed, f, faces[i]);
  }
  return number;
}

// Whether any does
template <class Vertices>
bool has_intersections_near(const Remeshed_surface& remeshed, const Vertices& vertices)
{
  return number_of_intersections_near(remeshed, vertices, 1) > 0;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DO_FACES_INTERSECT_H
