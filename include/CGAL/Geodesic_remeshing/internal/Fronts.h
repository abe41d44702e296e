// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FRONTS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FRONTS_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The set of the vertices that the fronts have passed ("taken"), as a complex: the vertices and all edges and faces
// between them. Its topology is known at all times, because a vertex is taken only
//  - as a new component of its own (the centre of a leaf),
//  - along a bridge through a saddle (the meeting of two fronts), or
//  - when its taken neighbours form exactly one arc, which changes nothing: a front moves on by one vertex.
// Therefore what a front sweeps between two events is an annulus, and around a centre a disc, on a surface of any
// genus.
class Fronts
{
public:
  explicit Fronts(const Mesh& mesh)
    : m_mesh(mesh), m_taken(mesh.number_of_vertices(), 0), m_deferred(mesh.number_of_vertices(), 0),
      m_seen(mesh.number_of_halfedges(), 0)
  {}

  bool is_taken(Vertex v) const { return m_taken[v] != 0; }

  void take(Vertex v) { m_taken[v] = 1; }

  // Takes the vertices in their order where that moves a front without changing its topology, and where it is the right
  // front: `is_own(w)` for a taken neighbour. A vertex where the front would meet itself or another waits until it can
  // be taken. Calls `took(v)` for each vertex taken.
  template <class Range, class IsOwn, class Took>
  void sweep(const Range& candidates, const IsOwn& is_own, const Took& took)
  {
    for(Vertex v : candidates)
    {
      m_stack.push_back(v);
      while(!m_stack.empty())
      {
        const Vertex w = m_stack.back();
        m_stack.pop_back();
        if(m_taken[w])
          continue;
        if(number_of_taken_arcs(w) != 1 || !is_beside(w, is_own))
        {
          m_deferred[w] = 1;
          continue;
        }
        take(w);
        took(w);
        for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(w)))
          if(m_deferred[m_mesh.source(h)] && !m_taken[m_mesh.source(h)])
            m_stack.push_back(m_mesh.source(h));
      }
    }
    for(Vertex v : candidates)
      m_deferred[v] = 0; // what still waits belongs to the regions below
  }

  // The fronts that pass the vertices of a bridge: each a cycle of halfedges from a taken to a free vertex.
  std::vector<std::vector<Halfedge>> fronts_at(const std::vector<Vertex>& bridge)
  {
    std::vector<std::vector<Halfedge>> result;
    for(Vertex v : bridge)
      for(Halfedge in : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
        if(is_crossed(m_mesh.opposite(in)) && !m_seen[m_mesh.opposite(in)])
          result.push_back(front_through(m_mesh.opposite(in)));
    for(const auto& front : result)
      for(Halfedge h : front)
        m_seen[h] = 0;
    return result;
  }

private:
  bool is_crossed(Halfedge h) const { return m_taken[m_mesh.source(h)] && !m_taken[m_mesh.target(h)]; }

  // The front crosses a halfedge, then one of the two other edges of the face on its left: the one whose ends differ.
  Halfedge next_crossed(Halfedge h) const
  {
    const Halfedge n = m_mesh.next(h);
    return m_taken[m_mesh.target(n)] ? m_mesh.opposite(n) : m_mesh.opposite(m_mesh.next(n));
  }

  std::vector<Halfedge> front_through(Halfedge start)
  {
    std::vector<Halfedge> front;
    Halfedge h = start;
    do
    {
      CGAL_assertion(is_crossed(h));
      m_seen[h] = 1;
      front.push_back(h);
      h = next_crossed(h);
    } while(h != start);
    return front;
  }

  int number_of_taken_arcs(Vertex v) const
  {
    int arcs = 0;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      // the neighbour after source(h) around v
      const Halfedge following = m_mesh.opposite(m_mesh.next(h));
      arcs += m_taken[m_mesh.source(h)] && !m_taken[m_mesh.source(following)];
    }
    return arcs; // a closed ring of taken neighbours has none: that vertex would close a hole
  }

  template <class IsOwn>
  bool is_beside(Vertex v, const IsOwn& is_own) const
  {
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
      if(m_taken[m_mesh.source(h)] && is_own(m_mesh.source(h)))
        return true;
    return false;
  }

  const Mesh& m_mesh;
  std::vector<char> m_taken, m_deferred, m_seen;
  std::vector<Vertex> m_stack;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FRONTS_H
