// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SEARCH_EFFORT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SEARCH_EFFORT_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How long and how freely is searched.
struct Search_effort
{
  std::size_t nodes = 40;           // looked at in one search, times its depth
  std::size_t settlements = 4;      // tried in one search
  int barrier = 0;                  // the most by which the energy may be above that of the start
  double least_angle = 30.;         // around what is found
  bool finds_intersections = false; // which what is found is refused for
};

// On a mesh of few vertices limbs are as thick as edges are long: a tenth of the vertices is irregular, each near to
// others, and what parts them takes longer searches. There is time for these: the whole takes a quarter of a second at
// 1,000 vertices. Lines leave the searches less freedom, and are followed less evenly after them.
inline bool is_small(const Remeshed_surface& remeshed, const std::size_t number_of_vertices)
{
  return number_of_vertices <= 4000 && !remeshed.has_lines();
}

// Above that, where the whole takes a fifth of a second there is time for searches that are not linear, and for care
// with angles.
inline bool is_moderate(const Remeshed_surface& remeshed, const std::size_t number_of_vertices)
{
  return number_of_vertices < 10000 && !is_small(remeshed, number_of_vertices) && !remeshed.has_lines();
}

// One step of an excess is what the energy may rise by on the way: then one pair may divide into two that glide in
// other directions, to where they meet a third. The fewer vertices, the more time there is for that: with 16 nodes a
// step 3.9 in place of 4.7 percent of the vertices are irregular on sixteen models at 5,000, with 40 3.7, with 80 3.5.
// Beside lines, above all those that are kept, many stay irregular whatever is tried: of 3,657 searches on anchor_dense
// 134 found something, after 16 nodes in the mean, and the others looked at 133 each. With 16 instead of 40 a step most
// meshes with lines have the same figures, for up to a third less time.
inline Search_effort search_effort(const Remeshed_surface& remeshed, const std::size_t number_of_vertices)
{
  constexpr int one_step = 6;
  Search_effort effort;
  if(is_small(remeshed, number_of_vertices))
  {
    const std::size_t factor = (std::max)(std::size_t(2), 4000 / (std::max)(number_of_vertices, std::size_t(1000)));
    effort.nodes *= factor;
    effort.settlements *= factor;
    effort.barrier = one_step;
    effort.finds_intersections = true;
  }
  else if(is_moderate(remeshed, number_of_vertices))
  {
    effort.nodes = 80000 / number_of_vertices;
    effort.barrier = one_step;
    effort.least_angle = 33.;
  }
  else if(remeshed.has_lines())
    effort.nodes = 16;
  return effort;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SEARCH_EFFORT_H
