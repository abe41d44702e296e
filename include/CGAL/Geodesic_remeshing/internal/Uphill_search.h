// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_UPHILL_SEARCH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_UPHILL_SEARCH_H

#include <CGAL/Geodesic_remeshing/internal/Fronts.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_order.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Searches from a saddle over the vertices above it, up to the fronts that have come down that far. Between them there
// is nothing but what one front has still to sweep.
class Uphill_search
{
public:
  Uphill_search(const Mesh& mesh, const Vertex_order& order, const Fronts& fronts)
    : m_mesh(mesh), m_metric(mesh), m_order(order), m_fronts(fronts), m_length(mesh.number_of_vertices(), infinity),
      m_from(mesh.number_of_vertices()), m_is_barred(mesh.number_of_vertices(), 0)
  {}

  // Goes over free vertices from a neighbour of the saddle until `is_found(v)`.
  template <class IsFound>
  void until(Vertex saddle, Vertex neighbour, const IsFound& is_found)
  {
    std::vector<Vertex> stack(1, neighbour);
    touch(neighbour, 0.);
    while(!stack.empty())
    {
      const Vertex v = stack.back();
      stack.pop_back();
      if(is_found(v))
        break;
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      {
        const Vertex w = m_mesh.source(h);
        if(m_fronts.is_taken(w) || m_order.rank[w] <= m_order.rank[saddle] || m_length[w] < infinity)
          continue;
        touch(w, 0.);
        stack.push_back(w);
      }
    }
    forget();
  }

  // The shortest way along edges from the saddle through one arc of its neighbours to a front: free vertices, then a
  // taken one.
  std::vector<Vertex> way_to_front(Vertex saddle, const std::vector<Vertex>& arc,
                                   const std::vector<std::vector<Vertex>>& other_ways)
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto relax = [&](Vertex from, Vertex to, double length) {
      if(m_order.rank[to] <= m_order.rank[saddle] || m_length[to] <= length || m_is_barred[to])
        return;
      touch(to, length);
      m_from[to] = from;
      queue.emplace(length, to);
    };
    bar(other_ways, 1);
    for(Vertex v : arc)
      relax(saddle, v, m_metric.length(saddle, v));
    std::vector<Vertex> way;
    while(!queue.empty() && way.empty())
    {
      const Entry top = queue.top();
      queue.pop();
      if(m_length[top.second] < top.first)
        continue;
      if(m_fronts.is_taken(top.second))
        for(Vertex v = top.second; v != saddle; v = m_from[v])
          way.push_back(v);
      else
        for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(top.second)))
          relax(top.second, m_mesh.source(h), top.first + m_metric.length(h));
    }
    std::reverse(way.begin(), way.end());
    bar(other_ways, 0);
    forget();
    return way;
  }

private:
  // Ways may end at the same vertex of a front, but not cross before.
  void bar(const std::vector<std::vector<Vertex>>& ways, const char value)
  {
    for(const std::vector<Vertex>& way : ways)
      for(Vertex v : way)
        m_is_barred[v] = value && !m_fronts.is_taken(v);
  }

  void touch(Vertex v, double length)
  {
    m_length[v] = length;
    m_touched.push_back(v);
  }

  void forget()
  {
    for(Vertex v : m_touched)
      m_length[v] = infinity;
    m_touched.clear();
  }

  const Mesh& m_mesh;
  const Metric m_metric;
  const Vertex_order& m_order;
  const Fronts& m_fronts;
  std::vector<double> m_length; // only what a search touched is reset after it
  std::vector<Vertex> m_from, m_touched;
  std::vector<char> m_is_barred;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_UPHILL_SEARCH_H
