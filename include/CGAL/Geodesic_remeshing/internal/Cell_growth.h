// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CELL_GROWTH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CELL_GROWTH_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Grows the Voronoi cells of samples over the edges of the working surface (paper, section 6).
class Cell_growth
{
public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  Cell_growth(const Mesh& mesh, const Mesh::Property_map<Edge, bool>& is_line, const std::vector<char>& is_on_line)
    : m_mesh(mesh), m_is_line(is_line), m_is_on_line(is_on_line), m_cell(mesh.number_of_vertices(), none)
  {}

  // First along the lines, then from what lies on them and the other samples over the rest
  void run(const std::vector<Vertex>& samples)
  {
    std::vector<double> distance(m_mesh.number_of_vertices(), infinity);
    Queue on_lines, others;
    for(Vertex s : samples)
    {
      if(!s.is_valid())
        continue;
      distance[s] = 0.;
      m_cell[s] = s.idx();
      (m_is_on_line[s] ? on_lines : others).emplace(0., s);
    }
    m_grown.reserve(m_mesh.number_of_vertices());
    grow(on_lines, distance, true);
    for(Vertex v : m_mesh.vertices())
      if(m_is_on_line[v] && m_cell[v] != none)
        others.emplace(distance[v], v);
    grow(others, distance, false);
  }

  // The vertices to contract, cell by cell, in each nearest to the sample first, so that all become its neighbours in
  // turn
  std::vector<Vertex> by_cell() const
  {
    std::vector<std::uint32_t> begin(m_mesh.number_of_vertices() + 1, 0);
    for(Vertex v : m_grown)
      ++begin[m_cell[v] + 1];
    for(std::size_t i = 1; i < begin.size(); ++i)
      begin[i] += begin[i - 1];
    std::vector<Vertex> result(m_grown.size());
    for(Vertex v : m_grown)
      result[begin[m_cell[v]]++] = v;
    return result;
  }

  // Of each vertex its sample
  std::vector<std::uint32_t> take_cells() { return std::move(m_cell); }

private:
  using Entry = std::pair<double, Vertex>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  // Dijkstra over the edges: coarse for distances, but every vertex is joined to its sample by edges within the cell
  void grow(Queue& queue, std::vector<double>& distance, bool along_lines)
  {
    const Metric metric(m_mesh);
    while(!queue.empty())
    {
      const Entry top = queue.top();
      queue.pop();
      const Vertex v = top.second;
      if(distance[v] < top.first)
        continue;
      if(m_cell[v] != v.idx() && (m_is_on_line[v] != 0) == along_lines)
        m_grown.push_back(v);
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      {
        const Vertex w = m_mesh.source(h);
        if(along_lines ? !m_is_line[m_mesh.edge(h)] : m_is_on_line[w] != 0)
          continue;
        const double d = top.first + metric.length(h);
        if(!(d < distance[w]))
          continue;
        distance[w] = d;
        m_cell[w] = m_cell[v];
        queue.emplace(d, w);
      }
    }
  }

  const Mesh& m_mesh;
  const Mesh::Property_map<Edge, bool> m_is_line;
  const std::vector<char>& m_is_on_line;
  std::vector<std::uint32_t> m_cell;
  std::vector<Vertex> m_grown; // all vertices but the samples, nearest to their sample first
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CELL_GROWTH_H
