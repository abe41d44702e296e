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

#include <CGAL/Geodesic_remeshing/internal/Cell_growth.h>
#include <CGAL/Geodesic_remeshing/internal/open_separating_triangles.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cstdint>
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
    : Cell_contractor(mesh, samples, mesh.add_property_map<Edge, bool>(line_property, false).first)
  {}

  Cell_contractor(Mesh& mesh, const std::vector<Vertex>& samples, Line_map is_line)
    : m_mesh(mesh), m_is_line(is_line), m_is_on_line(mesh.number_of_vertices(), 0),
      m_mark(mesh.number_of_vertices(), none)
  {
    for(Edge e : mesh.edges())
    {
      m_is_line[e] = m_is_line[e] || mesh.is_border(e);
      if(m_is_line[e])
        m_is_on_line[mesh.vertex(e, 0)] = m_is_on_line[mesh.vertex(e, 1)] = 1;
    }
    Cell_growth growth(m_mesh, m_is_line, m_is_on_line);
    growth.run(samples);
    m_grown = growth.by_cell();
    m_cell = growth.take_cells();
  }

  // Contracts all cells. A vertex that cannot go yet, since its contraction would pinch the surface, may go when
  // others have gone: tried until nothing changes. Returns the vertices left over, where samples are too few for the
  // topology.
  std::vector<Vertex> run()
  {
    std::vector<Vertex> left = std::move(m_grown);
    for(bool into_any_neighbour : {false, true})
      for(std::size_t before = left.size() + 1; left.size() < before && !left.empty();)
      {
        before = left.size();
        left = contract(left, into_any_neighbour);
      }
    left.erase(std::remove_if(left.begin(), left.end(), [this](Vertex v) { return contract_along_line(v); }),
               left.end());
    return left;
  }

private:
  static constexpr std::uint32_t none = Cell_growth::none;

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
    if(!to_sample.is_valid() || common != (m_mesh.is_border(m_mesh.edge(to_sample)) ? 1 : 2) ||
       !keeps_lines(to_sample) || is_tetrahedron(to_sample))
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

  // What is left on a line is in the way of its edges: where a separating triangle keeps it from going, flips open
  // that.
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
    const auto valence_is_three = [this](Halfedge g) {
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
  std::vector<std::uint32_t> m_cell; // of a vertex: its sample
  std::vector<std::uint32_t> m_mark; // of a vertex: the sample whose ring was marked last and holds it
  std::vector<Vertex> m_grown;       // all vertices but the samples, cell by cell, nearest to their sample first
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONTRACT_CELLS_H
