// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FARTHEST_POINTS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FARTHEST_POINTS_H

#include <CGAL/Geodesic_remeshing/internal/Component_numbers.h>
#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Two vertices of one connected component, about as far apart as two can be.
struct Farthest_pair
{
  Vertex root;
  Vertex farthest; // from the root
  double distance;
  std::size_t number_of_runs; // when the distance stopped growing
};

// The component of each vertex, counted in the order of their first vertices; vertices without faces belong to none.
struct Components
{
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  explicit Components(const Intrinsic_triangulation& triangulation)
  {
    using Index = Intrinsic_triangulation::Index;
    const Index n = static_cast<Index>(triangulation.number_of_vertices());
    Component_numbers components(n);
    for(Index v = 0; v < n; ++v)
      for(auto spoke = triangulation.begin(v); spoke != triangulation.end(v); ++spoke)
        components.join(v, spoke->neighbor);
    std::size_t number;
    component_of =
        components.take(number, none, [&](const Index v) { return triangulation.begin(v) != triangulation.end(v); });
    for(Index v = 0; v < n; ++v)
      if(component_of[v] == first_vertex.size())
        first_vertex.push_back(Vertex(v));
  }

  std::vector<std::uint32_t> component_of;
  std::vector<Vertex> first_vertex;
};

// Marches from all roots at once, and finds what is farthest from each; the lower index decides between equals.
inline void find_farthest(Fast_marching& marching, const Components& components, std::vector<Farthest_pair>& pairs)
{
  marching.clear();
  for(Farthest_pair& pair : pairs)
  {
    marching.add_source(pair.root);
    pair.farthest = pair.root;
    pair.distance = 0.;
  }
  marching.march(Front_shape::circular);
  for(const Vertex v : marching.reached())
  {
    Farthest_pair& pair = pairs[components.component_of[v]];
    const double distance = marching.distance(v);
    if(distance < pair.distance || (!(distance > pair.distance) && pair.farthest < v))
      continue;
    pair.farthest = v;
    pair.distance = distance;
  }
}

// Section 4 of the paper: go to the farthest vertex, again and again, until it does not get farther. Leaves the
// distances from the roots in `marching`.
inline std::vector<Farthest_pair> farthest_pairs(Fast_marching& marching, const Components& components,
                                                 const std::vector<Vertex>& starts, double least_gain)
{
  // two to four runs are the rule; what later ones could still gain is less than the distances are sure of
  constexpr std::size_t most_runs = 6;

  std::vector<Farthest_pair> pairs;
  for(const Vertex v : starts)
    pairs.push_back(Farthest_pair{v, v, 0., 0});
  std::vector<double> diameter(pairs.size(), 0.);
  std::vector<char> is_growing(pairs.size(), true);
  for(std::size_t run = 1;; ++run)
  {
    find_farthest(marching, components, pairs);
    bool is_finished = true;
    for(std::size_t i = 0; i < pairs.size(); ++i)
    {
      if(!is_growing[i])
        continue;
      pairs[i].number_of_runs = run;
      is_growing[i] = run < most_runs && pairs[i].distance > diameter[i] * (1. + least_gain);
      if(!is_growing[i])
        continue;
      diameter[i] = pairs[i].distance;
      pairs[i].root = pairs[i].farthest;
      is_finished = false;
    }
    if(is_finished)
      return pairs;
  }
}

inline std::vector<Farthest_pair> farthest_pairs(Fast_marching& marching)
{
  const Components components(marching.triangulation());
  return farthest_pairs(marching, components, components.first_vertex, 1e-4);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FARTHEST_POINTS_H
