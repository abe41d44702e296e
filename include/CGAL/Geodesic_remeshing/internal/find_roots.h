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
#include <iterator>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far the vertices are from the sources along edges. That is up to a seventh more than the geodesic distance, and
// comes for a fraction of its time: enough to tell which vertex is about the farthest. The vertices are taken in steps
// of one mean edge length, in any order within a step and as often as they get nearer.
class Edge_distances
{
public:
  using Index = Intrinsic_triangulation::Index;

  explicit Edge_distances(const Intrinsic_triangulation& triangulation)
    : m_triangulation(triangulation), m_distance(triangulation.number_of_vertices())
  {
    double sum = 0.;
    std::size_t number = 0;
    for(Index v = 0; v < m_distance.size(); ++v)
      for(auto spoke = triangulation.begin(v); spoke != triangulation.end(v); ++spoke, ++number)
        sum += spoke->length;
    m_step = number > 0 ? sum / static_cast<double>(number) : 0.;
  }

  const std::vector<double>& from(const std::vector<Vertex>& sources)
  {
    std::fill(m_distance.begin(), m_distance.end(), infinity);
    for(const Vertex v : sources)
    {
      m_distance[v] = 0.;
      m_now.push_back(static_cast<Index>(v));
    }
    double limit = m_step;
    for(take_up_to(limit); leave_those_beyond(limit); take_up_to(limit))
    {
      limit = infinity;
      for(const Index v : m_later)
        limit = (std::min)(limit, m_distance[v]);
      limit += m_step;
      std::copy_if(m_later.begin(), m_later.end(), std::back_inserter(m_now),
                   [&](const Index v) { return m_distance[v] <= limit; });
    }
    return m_distance;
  }

private:
  // Those of `m_now` and what they bring nearer than `limit`; the rest of that is for later.
  void take_up_to(const double limit)
  {
    while(!m_now.empty())
    {
      const Index v = m_now.back();
      m_now.pop_back();
      for(auto spoke = m_triangulation.begin(v); spoke != m_triangulation.end(v); ++spoke)
      {
        const Index w = spoke->neighbor;
        const double distance = m_distance[v] + spoke->length;
        if(!(distance < m_distance[w]))
          continue;
        const bool is_queued = m_distance[w] < infinity && m_distance[w] > limit;
        m_distance[w] = distance;
        if(distance <= limit)
          m_now.push_back(w);
        else if(!is_queued)
          m_later.push_back(w);
      }
    }
  }

  // Of those for later. Are there any?
  bool leave_those_beyond(const double limit)
  {
    m_later.erase(std::remove_if(m_later.begin(), m_later.end(), [&](const Index v) { return m_distance[v] <= limit; }),
                  m_later.end());
    return !m_later.empty();
  }

  const Intrinsic_triangulation& m_triangulation;
  double m_step;
  std::vector<double> m_distance;
  std::vector<Index> m_now, m_later;
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
