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

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>
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
    : m_mesh(mesh), m_is_line(is_line), m_is_on_line(is_on_line), m_cell(mesh.number_of_vertices(), none),
      m_distance(mesh.number_of_vertices(), infinity)
  {}

  // First along the lines, then from what lies on them and the other samples over the rest
  void run(const std::vector<Vertex>& samples)
  {
    std::vector<Vertex> on_lines, others;
    for(Vertex s : samples)
    {
      if(!s.is_valid())
        continue;
      m_distance[s] = 0.;
      m_cell[s] = s.idx();
      (m_is_on_line[s] ? on_lines : others).push_back(s);
    }
    const Metric metric(m_mesh);
    const double step = mean_length(metric);
    grow(on_lines, true, metric, step);
    for(Vertex v : m_mesh.vertices())
      if(m_is_on_line[v] && m_cell[v] != none)
        others.push_back(v);
    grow(others, false, metric, step);
  }

  // The vertices to contract, cell by cell, in each those on lines first and nearest to the sample first, so that all
  // become its neighbours in turn
  std::vector<Vertex> by_cell() const
  {
    std::vector<std::uint32_t> begin(m_mesh.number_of_vertices() + 1, 0);
    const auto is_grown = [this](Vertex v) { return m_cell[v] != none && m_cell[v] != v.idx(); };
    for(Vertex v : m_mesh.vertices())
      if(is_grown(v))
        ++begin[m_cell[v] + 1];
    for(std::size_t i = 1; i < begin.size(); ++i)
      begin[i] += begin[i - 1];
    std::vector<Vertex> result(begin.back());
    for(Vertex v : m_mesh.vertices())
      if(is_grown(v))
        result[begin[m_cell[v]]++] = v;
    // now each begins where the next one did
    for(std::size_t i = 0, first = 0; i + 1 < begin.size(); first = begin[i++])
      std::sort(result.begin() + first, result.begin() + begin[i], [this](Vertex v, Vertex w) {
        return std::make_tuple(!m_is_on_line[v], m_distance[v], v) <
               std::make_tuple(!m_is_on_line[w], m_distance[w], w);
      });
    return result;
  }

  // Of each vertex its sample
  std::vector<std::uint32_t> take_cells() { return std::move(m_cell); }

private:
  // Shortest paths along the edges: coarse for distances, but every vertex is joined to its sample by edges within the
  // cell. In rounds of about an edge's length, each in the order in which vertices were reached, and again if they are
  // reached on a shorter way: what is next in a heap may be anywhere on the surface.
  void grow(const std::vector<Vertex>& sources, bool along_lines, const Metric& metric, double step)
  {
    constexpr std::size_t most_rounds = 1024;
    std::vector<std::vector<std::pair<double, Vertex>>> rounds(1);
    const auto enter = [&](double distance, Vertex v) {
      const std::size_t i = distance < most_rounds * step ? static_cast<std::size_t>(distance / step) : most_rounds;
      if(i >= rounds.size())
        rounds.resize(i + 1);
      rounds[i].emplace_back(distance, v);
    };
    for(Vertex v : sources)
      enter(m_distance[v], v);
    for(std::size_t i = 0; i < rounds.size(); ++i)
    {
      for(std::size_t j = 0; j < rounds[i].size(); ++j)
      {
        const double here = rounds[i][j].first;
        const Vertex v = rounds[i][j].second;
        if(m_distance[v] < here)
          continue;
        for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        {
          const Vertex w = m_mesh.source(h);
          if(along_lines ? !m_is_line[m_mesh.edge(h)] : m_is_on_line[w] != 0)
            continue;
          const double d = here + metric.length(h);
          if(!(d < m_distance[w]))
            continue;
          m_distance[w] = d;
          m_cell[w] = m_cell[v];
          enter(d, w);
        }
      }
      std::vector<std::pair<double, Vertex>>().swap(rounds[i]);
    }
  }

  double mean_length(const Metric& metric) const
  {
    double sum = 0.;
    for(Edge e : m_mesh.edges())
      sum += metric.length(e);
    return (std::max)(sum / static_cast<double>(m_mesh.number_of_edges()), (std::numeric_limits<double>::min)());
  }

  const Mesh& m_mesh;
  const Mesh::Property_map<Edge, bool> m_is_line;
  const std::vector<char>& m_is_on_line;
  std::vector<std::uint32_t> m_cell;
  std::vector<double> m_distance; // of a vertex from its sample
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CELL_GROWTH_H
