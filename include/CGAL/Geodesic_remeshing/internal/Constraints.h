// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CONSTRAINTS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CONSTRAINTS_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What of the input the output has to follow (paper, section 6, on feature curves): lines that its edges cover and
// corners that are among its vertices.
struct Constraints
{
  std::vector<char> is_line;   // of an edge: on the boundary, a feature, constrained, or between two patches
  std::vector<char> is_corner; // of a vertex
  bool are_kept = false;       // the edges on lines are to be edges of the output; then their ends are corners
  bool has_features = false;   // sharp edges were asked for, and there are some

  bool empty() const { return !has_any(is_line) && !has_any(is_corner); }

private:
  static bool has_any(const std::vector<char>& marks)
  {
    return std::find(marks.begin(), marks.end(), 1) != marks.end();
  }
};

// Whether a place is a vertex of the surface that is a corner, but for rounding
inline bool is_at_corner(const Mesh& surface, const Constraints& constraints, const Place& place)
{
  for(int i = 0; i < 3 && !constraints.is_corner.empty(); ++i)
    if(place.coordinates[i] > 1. - 1e-9)
      return constraints.is_corner[vertices_of(surface, place.face)[i]] != 0;
  return false;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONSTRAINTS_H
