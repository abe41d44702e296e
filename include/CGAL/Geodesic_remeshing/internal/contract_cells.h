// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CONTRACT_CELLS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CONTRACT_CELLS_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Geodesic Voronoi cells of the samples and their dual (paper, section 6), for a strip of any topology: cells are grown
// along the edges of the working surface, and each is contracted into its sample, edge by edge, under the link condition. A
// contraction under that condition keeps the surface what it is, so the dual is a manifold of the same topology by
// construction, without a look at what the strip is.
class Cell_contractor
{
public:
  Cell_contractor(Mesh& mesh, const std::vector<Vertex>& samples)
    : m_mesh(mesh), m_cell(mesh.number_of_vertices(), none), m_mark(mesh.number_of_vertices(), none)
  {
    grow_cells(samples);
  }

  // Contracts all cells. A vertex that cannot go yet, since its contraction would pinch the surface, may go when others have
  // gone: tried until nothing changes. Returns the vertices left over, where samples are too few for the topology.
  std::vector<Vertex> run()
  {
    std::vector<Vertex> left = by_cell();
    for(bool into_any_neighbour : {false, true})
      for(std::size_t before = left.size() + 1; left.size() < before && !left.empty();)
      {
        before = left.size();
        left = contract(left, into_any_neighbour);
      }
    return left;
  }

private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  // Dijkstra over the edges: coarse for distances, but every vertex is joined to its sample by edges within the cell
  void grow_cells(const std::vector<Vertex>& samples)
  {
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const Metric metric(m_mesh);
    std::vector<double> distance(m_mesh.number_of_vertices(), infinity);
    for(Vertex s : samples)
    {
      if(!s.is_valid())
        continue;
      distance[s] = 0.;
      m_cell[s] = s.idx();
      queue.emplace(0., s);
    }
    m_grown.reserve(m_mesh.number_of_vertices());
    while(!queue.empty())
    {
      const Entry top = queue.top();
      queue.pop();
      const Vertex v = top.second;
      if(distance[v] < top.first)
        continue;
      if(m_cell[v] != v.idx())
        m_grown.push_back(v);
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      {
        const Vertex w = m_mesh.source(h);
        const double d = top.first + metric.length(h);
        if(!(d < distance[w]))
          continue;
        distance[w] = d;
        m_cell[w] = m_cell[v];
        queue.emplace(d, w);
      }
    }
  }

  // The vertices to contract, cell by cell, in each nearest to the sample first, so that all become its neighbours in turn
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

  std::vector<Vertex> contract(const std::vector<Vertex>& vertices, bool into_any_neighbour)
  {
    std::vector<Vertex> left;
    std::uint32_t marked = none;
    for(Vertex v : vertices)
    {
      if(into_any_neighbour)
      {
        if(!contract_into_any(v))
          left.push_back(v);
        marked = none;
        continue;
      }
      const Vertex sample(m_cell[v]);
      if(marked != m_cell[v])
        mark_ring(sample);
      marked = m_cell[v];
      if(!contract_into(v, sample))
        left.push_back(v);
    }
    return left;
  }

  // The neighbours of the sample; it is not a neighbour of itself
  void mark_ring(Vertex sample)
  {
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(sample)))
      m_mark[m_mesh.source(h)] = sample.idx();
  }

  bool contract_into(Vertex v, Vertex sample)
  {
    Halfedge to_sample;
    int common = 0;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      const Vertex w = m_mesh.source(h);
      if(w == sample)
        to_sample = m_mesh.opposite(h);
      else
        common += m_mark[w] == sample.idx();
    }
    if(!to_sample.is_valid() || common != 2 || is_tetrahedron(to_sample))
      return false;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_mesh.source(h) != sample)
        m_mark[m_mesh.source(h)] = sample.idx();
    remove_source(to_sample);
    return true;
  }

  bool contract_into_any(Vertex v)
  {
    std::vector<Vertex> ring;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      ring.push_back(m_mesh.source(h));
    for(Vertex w : ring)
    {
      for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(w)))
        m_mark[m_mesh.source(h)] = w.idx();
      if(contract_into(v, w))
        return true;
    }
    return false;
  }

  bool is_tetrahedron(Halfedge h) const
  {
    const auto valence_is_three = [this](Halfedge g)
    { return m_mesh.opposite(m_mesh.next(m_mesh.opposite(m_mesh.next(m_mesh.opposite(m_mesh.next(g)))))) == g; };
    return valence_is_three(h) && valence_is_three(m_mesh.opposite(h));
  }

  // Removes the source of h and the two faces of its edge; the edges of the source become edges of the target.
  void remove_source(Halfedge h)
  {
    const Halfedge o = m_mesh.opposite(h);
    const Vertex u = m_mesh.source(h), s = m_mesh.target(h);
    const Face f = m_mesh.face(h), g = m_mesh.face(o);
    const Halfedge kept_left = m_mesh.next(h), gone_left = m_mesh.prev(h);
    const Halfedge gone_right = m_mesh.next(o), kept_right = m_mesh.prev(o);
    Halfedge around = gone_left;
    do
    {
      m_mesh.set_target(around, s);
      around = m_mesh.opposite(m_mesh.next(around));
    } while(around != gone_left);
    replace(m_mesh.opposite(gone_left), kept_left);
    replace(m_mesh.opposite(gone_right), kept_right);
    m_mesh.set_halfedge(s, m_mesh.opposite(kept_left));
    m_mesh.set_halfedge(m_mesh.target(kept_left), kept_left);
    m_mesh.set_halfedge(m_mesh.source(kept_right), m_mesh.opposite(kept_right));
    m_mesh.remove_edge(m_mesh.edge(h));
    m_mesh.remove_edge(m_mesh.edge(gone_left));
    m_mesh.remove_edge(m_mesh.edge(gone_right));
    m_mesh.remove_face(f);
    m_mesh.remove_face(g);
    m_mesh.remove_vertex(u);
  }

  // Puts `kept` where `gone` is in the cycle of its face
  void replace(Halfedge gone, Halfedge kept)
  {
    const Face f = m_mesh.face(gone);
    m_mesh.set_next(m_mesh.prev(gone), kept);
    m_mesh.set_next(kept, m_mesh.next(gone));
    m_mesh.set_face(kept, f);
    m_mesh.set_halfedge(f, kept);
  }

  Mesh& m_mesh;
  std::vector<std::uint32_t> m_cell;  // of a vertex: its sample
  std::vector<std::uint32_t> m_mark;  // of a vertex: the sample whose ring was marked last and holds it
  std::vector<Vertex> m_grown;        // all vertices but the samples, nearest to their sample first
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONTRACT_CELLS_H
