// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_WALK_INTO_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_WALK_INTO_H

#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// At an edge or a vertex a walk may begin in any of the faces there: in the one from which it comes nearest to where it
// is to go.
inline Place walk_into(const Surface_walker& walker, const Place& from, const Vector& way)
{
  const Point goal = walker.point(from) + way;
  Place best = from;
  double least = infinity;
  walker.for_each_face_at(from, [&](Face f) {
    const Place place = walker.walk(Place{f, coordinates_in(walker.surface(), from, f)}, way);
    const double distance = squared_distance(walker.point(place), goal);
    if(distance < least)
    {
      least = distance;
      best = place;
    }
  });
  return best;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_WALK_INTO_H
