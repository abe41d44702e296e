// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_HAS_INTERSECTIONS_ANYWHERE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_HAS_INTERSECTIONS_ANYWHERE_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/do_faces_intersect.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Whether a face at one of the vertices intersects any other. Looks at all faces: for few questions.
template <class Vertices>
bool has_intersections_anywhere(const Remeshed_surface& remeshed, const Vertices& vertices)
{
  using Index = Lean_triangulation::Index;
  const Lean_triangulation& table = remeshed.connectivity();
  std::vector<std::pair<Index, Face_box>> changed;
  Face_box all;
  for(const Index v : vertices)
    table.for_each_outgoing(v, [&](const Index h) {
      const Index f = Lean_triangulation::face(h);
      changed.emplace_back(f, box_of(remeshed, f));
      for(int i = 0; i < 3; ++i)
      {
        all.low[i] = (std::min)(all.low[i], changed.back().second.low[i]);
        all.high[i] = (std::max)(all.high[i], changed.back().second.high[i]);
      }
    });
  for(Index f = 0; f < table.face_slots(); ++f)
  {
    if(table.is_removed_face(f))
      continue;
    const Face_box box = box_of(remeshed, f);
    if(do_overlap(box, all))
      for(const auto& other : changed)
        if(f != other.first && do_overlap(box, other.second) && do_faces_intersect(remeshed, f, other.first))
          return true;
  }
  return false;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_HAS_INTERSECTIONS_ANYWHERE_H
