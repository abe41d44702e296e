// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIND_ROOTS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIND_ROOTS_H

#include <CGAL/Geodesic_remeshing/internal/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far the vertices are from the sources along edges (Dijkstra). That is up to a seventh more than the geodesic
// distance, and comes for a fraction of its time: enough to tell which vertex is about the farthest.
class Edge_distances
{
public:
  using Index = Intrinsic_triangulation::Index;

  explicit Edge_distances(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation), m_distance(triangulation.number_of_vertices())
  {}

  const std::vector<double>& from(const std::vector<Vertex>& sources)
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::fill(m_distance.begin(), m_distance.end(), infinity);
    const auto reach = [&](const Index v, const double distance) {
      if(!(distance < m_distance[v]))
        return;
      m_distance[v] = distance;
      queue.emplace(distance, v);
    };
    for(const Vertex v : sources)
      reach(static_cast<Index>(v), 0.);
    while(!queue.empty())
    {
      const auto [distance, v] = queue.top();
      queue.pop();
      if(m_distance[v] < distance)
        continue; // nearer since
      for(auto spoke = m_triangulation.begin(v); spoke != m_triangulation.end(v); ++spoke)
        reach(spoke->neighbor, distance + spoke->length);
    }
    return m_distance;
  }

private:
  const Intrinsic_triangulation& m_triangulation;
  std::vector<double> m_distance;
};

// Of every connected component the vertex farthest, straight through space, from the middle of the component
inline std::vector<Vertex> outermost_vertices(const Mesh& mesh, const std::vector<std::uint32_t>& component_of,
                                              const std::size_t number)
{
  std::vector<Vector> middle(number, Vector(0., 0., 0.));
  std::vector<double> count(number, 0.), farthest(number, -1.);
  for(const Vertex v : mesh.vertices())
  {
    middle[component_of[v]] = middle[component_of[v]] + Vector(CGAL::ORIGIN, mesh.point(v));
    count[component_of[v]] += 1.;
  }
  std::vector<Vertex> result(number);
  for(const Vertex v : mesh.vertices())
  {
    const std::size_t c = component_of[v];
    const double distance = (Vector(CGAL::ORIGIN, mesh.point(v)) - middle[c] / count[c]).squared_length();
    if(distance > farthest[c])
    {
      farthest[c] = distance;
      result[c] = v;
    }
  }
  return result;
}

// For every connected component a vertex at one of its far ends, in the order of the components' first vertices (paper,
// section 4: the farthest vertex, the farthest from that one, and so on). Begun at an outermost vertex and content with
// one percent, the search takes two or three steps.
inline std::vector<Vertex> find_roots(const Mesh& mesh, const Intrinsic_triangulation& triangulation,
                                      const std::vector<std::uint32_t>& component_of, const std::size_t number)
{
  constexpr double least_gain = 1e-2;
  constexpr int most_steps = 6;

  std::vector<Vertex> roots = outermost_vertices(mesh, component_of, number);
  std::vector<double> diameter(number, 0.);
  Edge_distances distances(triangulation);
  bool is_growing = true;
  for(int step = 0; step < most_steps && is_growing; ++step)
  {
    const std::vector<double>& distance = distances.from(roots);
    std::vector<Vertex> farthest = roots; // the lower index of equals
    for(const Vertex v : mesh.vertices())
      if(distance[v] > distance[farthest[component_of[v]]])
        farthest[component_of[v]] = v;
    is_growing = false;
    for(std::size_t c = 0; c < number; ++c)
    {
      if(!(distance[farthest[c]] > diameter[c] * (1. + least_gain)))
        continue;
      diameter[c] = distance[farthest[c]];
      roots[c] = farthest[c];
      is_growing = true;
    }
  }
  return roots;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIND_ROOTS_H
