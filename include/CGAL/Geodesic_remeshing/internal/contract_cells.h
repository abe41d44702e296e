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
#include <CGAL/Geodesic_remeshing/internal/open_separating_triangles.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Geodesic Voronoi cells of the samples and their dual (paper, section 6), for a strip of any topology: cells are
// grown along the edges of the working surface, and each is contracted into its sample, edge by edge, under the link
// condition. A contraction under that condition keeps the surface what it is, so the dual is a manifold of the same
// topology by construction, without a look at what the strip is. Lines, of which the boundary is always one, are
// kept: their vertices are contracted along them only, so that the samples on a line end up joined by edges along it.
class Cell_contractor
{
public:
  using Line_map = Mesh::Property_map<Edge, bool>;

  Cell_contractor(Mesh& mesh, const std::vector<Vertex>& samples)
    : Cell_contractor(mesh, samples, mesh.add_property_map<Edge, bool>("e:line", false).first)
  {}

  Cell_contractor(Mesh& mesh, const std::vector<Vertex>& samples, Line_map is_line)
    : m_mesh(mesh), m_is_line(is_line), m_is_on_line(mesh.number_of_vertices(), 0),
      m_cell(mesh.number_of_vertices(), none), m_mark(mesh.number_of_vertices(), none)
  {
    for(Edge e : mesh.edges())
    {
      m_is_line[e] = m_is_line[e] || mesh.is_border(e);
      if(m_is_line[e])
        m_is_on_line[mesh.vertex(e, 0)] = m_is_on_line[mesh.vertex(e, 1)] = 1;
    }
    grow_cells(samples);
  }

  // Contracts all cells. A vertex that cannot go yet, since its contraction would pinch the surface, may go when
  // others have gone: tried until nothing changes. Returns the vertices left over, where samples are too few for the
  // topology.
  std::vector<Vertex> run()
  {
    std::vector<Vertex> left = by_cell();
    for(bool into_any_neighbour : {false, true})
      for(std::size_t before = left.size() + 1; left.size() < before && !left.empty();)
      {
        before = left.size();
        left = contract(left, into_any_neighbour);
      }
    left.erase(std::remove_if(left.begin(), left.end(), [this](Vertex v) { return contract_along_line(v); }), left.end());
    return left;
  }

private:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  using Entry = std::pair<double, Vertex>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  // First along the lines, then from what lies on them and the other samples over the rest
  void grow_cells(const std::vector<Vertex>& samples)
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
    if(!to_sample.is_valid() || common != (m_mesh.is_border(m_mesh.edge(to_sample)) ? 1 : 2) || !keeps_lines(to_sample)
       || is_tetrahedron(to_sample))
      return false;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_mesh.source(h) != sample)
        m_mark[m_mesh.source(h)] = sample.idx();
    remove_source(to_sample);
    return true;
  }

  // A vertex on a line goes along the line only, and not where two lines would become one.
  bool keeps_lines(Halfedge h) const
  {
    if(!m_is_on_line[m_mesh.source(h)])
      return true;
    if(!m_is_line[m_mesh.edge(h)])
      return false;
    for(Halfedge g : {h, m_mesh.opposite(h)})
      if(!m_mesh.is_border(g) && m_is_line[m_mesh.edge(m_mesh.next(g))] && m_is_line[m_mesh.edge(m_mesh.prev(g))])
        return false;
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

  // What is left on a line is in the way of its edges: where a separating triangle keeps it from going, flips open that.
  bool contract_along_line(Vertex v)
  {
    if(!m_is_on_line[v])
      return false;
    std::vector<Halfedge> along;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_is_line[m_mesh.edge(h)])
        along.push_back(m_mesh.opposite(h));
    for(Halfedge h : along)
    {
      open_separating_triangles(m_mesh, h, [this](Edge e) { return m_is_line[e] != 0; });
      mark_ring(m_mesh.target(h));
      if(contract_into(v, m_mesh.target(h)))
        return true;
    }
    return false;
  }

  bool is_tetrahedron(Halfedge h) const
  {
    const auto valence_is_three = [this](Halfedge g)
    {
      Halfedge around = g;
      for(int i = 0; i < 3; ++i, around = m_mesh.opposite(m_mesh.next(around)))
        if(m_mesh.is_border(around))
          return false;
      return around == g;
    };
    return valence_is_three(h) && valence_is_three(m_mesh.opposite(h));
  }

  // Removes the source of h and the faces of its edge, two or on the boundary one; the edges of the source become
  // edges of the target.
  void remove_source(Halfedge h)
  {
    const Halfedge o = m_mesh.opposite(h);
    const Vertex u = m_mesh.source(h), s = m_mesh.target(h);
    const Halfedge start = m_mesh.prev(h);
    Halfedge around = start;
    do
    {
      m_mesh.set_target(around, s);
      around = m_mesh.opposite(m_mesh.next(around));
    } while(around != start);
    const Halfedge left = m_mesh.next(h), right = m_mesh.prev(o);
    const bool left_is_open = m_mesh.is_border(h);
    remove_side(h, left, start);
    remove_side(o, right, m_mesh.next(o));
    m_mesh.set_halfedge(s, left_is_open ? right : m_mesh.opposite(left));
    m_mesh.remove_edge(m_mesh.edge(h));
    m_mesh.remove_vertex(u);
  }

  // Removes the face of a halfedge of the edge that goes, and of the face's other two edges the one at the vertex
  // that goes
  void remove_side(Halfedge h, Halfedge kept, Halfedge gone)
  {
    if(m_mesh.is_border(h))
    {
      m_mesh.set_next(m_mesh.prev(h), m_mesh.next(h));
      return;
    }
    m_mesh.remove_face(m_mesh.face(h));
    replace(m_mesh.opposite(gone), kept);
    if(m_is_line[m_mesh.edge(gone)])
      m_is_line[m_mesh.edge(kept)] = true;
    for(Halfedge g : {kept, m_mesh.opposite(kept)})
      m_mesh.set_halfedge(m_mesh.target(g), g);
    m_mesh.remove_edge(m_mesh.edge(gone));
  }

  // Puts `kept` where `gone` is in the cycle of its face
  void replace(Halfedge gone, Halfedge kept)
  {
    const Face f = m_mesh.face(gone);
    m_mesh.set_next(m_mesh.prev(gone), kept);
    m_mesh.set_next(kept, m_mesh.next(gone));
    m_mesh.set_face(kept, f);
    if(f != Mesh::null_face())
      m_mesh.set_halfedge(f, kept);
  }

  Mesh& m_mesh;
  Line_map m_is_line;
  std::vector<char> m_is_on_line;
  std::vector<std::uint32_t> m_cell;  // of a vertex: its sample
  std::vector<std::uint32_t> m_mark;  // of a vertex: the sample whose ring was marked last and holds it
  std::vector<Vertex> m_grown;        // all vertices but the samples, nearest to their sample first
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONTRACT_CELLS_H
