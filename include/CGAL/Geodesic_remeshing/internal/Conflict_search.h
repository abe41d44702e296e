// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_SEARCH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_SEARCH_H

#include <CGAL/Geodesic_remeshing/internal/Intersection_search.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Faces that intersect others or look against the surface
struct Conflicts
{
  std::size_t number = 0;                       // of the pairs that intersect and of the faces that are turned
  std::vector<Lean_triangulation::Index> faces; // in any of them, sorted
};

// Whether a face looks against the surface: at its corners, and where one gets to from the nearest of them by walking
// towards its centre. At a crease each of two sides may be meant.
inline bool is_turned_over(const Remeshed_surface& remeshed, const Lean_triangulation::Index f)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const Surface_walker& walker = remeshed.walker();
  const Kernel::Triangle_3 triangle = triangle_of(remeshed, f);
  const Vector normal = cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const auto is_against = [&](const Face g) { return walker.normal(g) * normal < 0.; };
  for(Lean_triangulation::Index h = 4 * f; h < 4 * f + 3; ++h)
  {
    bool may_be_against = false;
    walker.for_each_face_at(remeshed.spot(table.source(h)).place,
                            [&](const Face g) { may_be_against = may_be_against || is_against(g); });
    if(!may_be_against)
      return false;
  }
  const Point center = CGAL::centroid(triangle);
  double least = infinity;
  Face nearest;
  for(Lean_triangulation::Index h = 4 * f; h < 4 * f + 3; ++h)
  {
    const Remeshed_surface::Spot& spot = remeshed.spot(table.source(h));
    const auto look_from = [&](const Face g) {
      const Place from{g, coordinates_in(walker.surface(), spot.place, g)};
      const Place place = walker.walk(from, center - spot.point);
      const double distance = squared_distance(walker.point(place), center);
      if(distance < least)
      {
        least = distance;
        nearest = place.face;
      }
    };
    walker.for_each_face_at(spot.place, look_from);
  }
  return is_against(nearest);
}

inline std::vector<Lean_triangulation::Index> find_turned_faces(const Remeshed_surface& remeshed)
{
  const Lean_triangulation& table = remeshed.connectivity();
  return parallel_list(remeshed.block_size().concurrency, table.face_slots(), [&](const Lean_triangulation::Index f) {
    return !table.is_removed_face(f) &&
           (remeshed.badness(table.source(4 * f), table.source(4 * f + 1), table.source(4 * f + 2)) >= turned_badness ||
            is_turned_over(remeshed, f));
  });
}

inline Conflicts find_conflicts(const Remeshed_surface& remeshed)
{
  Conflicts result;
  result.faces = find_turned_faces(remeshed);
  result.number = result.faces.size();
  for(const Intersection_search::Pair& pair : Intersection_search(remeshed).run())
  {
    ++result.number;
    result.faces.insert(result.faces.end(), {pair.first, pair.second});
  }
  std::sort(result.faces.begin(), result.faces.end());
  result.faces.erase(std::unique(result.faces.begin(), result.faces.end()), result.faces.end());
  return result;
}

// More are not a few places that need more vertices: attempts take their time and leave most. The limit is not a fine
// one: with 80 and with 250 in place of 120 the results are the same on CGAL's 148 meshes remeshed to 300 vertices.
inline std::size_t most_conflicts(const std::size_t number_of_vertices)
{
  return 120 + number_of_vertices / 200;
}

// Of all faces
inline double worst_badness_of(const Remeshed_surface& remeshed)
{
  const Lean_triangulation& table = remeshed.connectivity();
  double result = 0.;
  for(Lean_triangulation::Index f = 0; f < table.face_slots(); ++f)
    if(!table.is_removed_face(f))
      result =
          (std::max)(result, remeshed.badness(table.source(4 * f), table.source(4 * f + 1), table.source(4 * f + 2)));
  return result;
}

// Where such a face is, for those who do not know the triangulation
struct Conflict_place
{
  Point center;
  double radius;
  std::array<Face, 3> faces; // of the input, at the corners
};

struct Conflict_places
{
  std::size_t number = 0;             // of the conflicts
  std::vector<Conflict_place> places; // of the faces in them; none if another attempt is not worth it
};

inline Conflict_places places_of(const Remeshed_surface& remeshed, const Conflicts& conflicts)
{
  Conflict_places result{conflicts.number, {}};
  for(const Lean_triangulation::Index f : conflicts.faces)
  {
    Conflict_place place{CGAL::centroid(triangle_of(remeshed, f)), 0., {}};
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Remeshed_surface::Spot& spot =
          remeshed.spot(remeshed.connectivity().source(static_cast<Lean_triangulation::Index>(4 * f + i)));
      place.radius = (std::max)(place.radius, std::sqrt(squared_distance(place.center, spot.point)));
      place.faces[i] = spot.place.face;
    }
    result.places.push_back(place);
  }
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_SEARCH_H
