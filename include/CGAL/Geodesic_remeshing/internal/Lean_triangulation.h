// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LEAN_TRIANGULATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LEAN_TRIANGULATION_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The connectivity of a triangle mesh in arrays, for the stages that read or change it millions of times.
//
// Face f has the halfedges 4f, 4f+1, 4f+2, from its vertex 0 to 1, 1 to 2 and 2 to 0, in the order of `vertices_of()`;
// hence `next()` needs neither memory nor division. A halfedge of the boundary has no opposite. Every change can be
// recorded in a journal and taken back: a search may try thousands of sequences of changes and keep none.
//
// Edges may be constrained: those that cover a line, of which the boundary is one. Flips, collapses and splits keep the
// lines what they are: their edges are shortened or divided along them, and never leave them.
class Lean_triangulation
{
public:
  using Index = std::uint32_t;
  static constexpr Index none = static_cast<Index>(-1);

  explicit Lean_triangulation(const Mesh& mesh) : Lean_triangulation(mesh, [](Edge) { return false; }) {}

  // `is_line(e)` tells the constrained edges; those of the boundary need not be told.
  template <class Is_line>
  Lean_triangulation(const Mesh& mesh, const Is_line& is_line);

  static Index face(const Index h) { return h >> 2; }
  static Index next(const Index h) { return (h & 3) == 2 ? h - 2 : h + 1; }
  static Index previous(const Index h) { return (h & 3) == 0 ? h + 2 : h - 1; }

  Index source(const Index h) const { return m_field[corner][h]; }
  Index target(const Index h) const { return m_field[corner][next(h)]; }
  Index apex(const Index h) const { return m_field[corner][previous(h)]; }
  Index opposite(const Index h) const { return m_field[across][h]; }

  bool is_constrained(const Index h) const { return (m_field[across][h | 3] >> (h & 3) & 1) != 0; }

  // The outgoing halfedges of a vertex, counterclockwise: starts at halfedge(v), ends at `none` (boundary) or there
  // again. The first is that of the boundary, where there is one; else a constrained one, where there is one.
  Index halfedge(const Index v) const { return m_field[outgoing][v]; }
  Index rotate(const Index h) const { return opposite(previous(h)); }

  Index valence(const Index v) const { return m_field[degree][v]; }
  bool is_removed(const Index v) const { return m_field[degree][v] == 0; }
  bool is_removed_face(const Index f) const { return m_field[corner][4 * f] == none; }
  bool is_border(const Index v) const { return opposite(halfedge(v)) == none; }
  bool is_on_line(const Index v) const { return is_constrained(halfedge(v)); }

  // Numbers of slots, removed ones included: the bounds of loops over vertices and faces.
  Index vertex_slots() const { return static_cast<Index>(m_field[degree].size()); }
  Index face_slots() const { return static_cast<Index>(m_field[corner].size() / 4); }
  std::size_t number_of_vertices() const { return m_field[counts][vertex_count]; }

  template <class Visit>
  void for_each_outgoing(const Index v, Visit&& visit) const
  {
    const Index first = halfedge(v);
    Index h = first;
    do
    {
      visit(h);
      h = rotate(h);
    } while(h != first && h != none);
  }

  // Neighbours counterclockwise. At the boundary the last one is only the source of an incoming halfedge.
  template <class Visit>
  void for_each_neighbor(const Index v, Visit&& visit) const
  {
    const Index first = halfedge(v);
    Index h = first, last;
    do
    {
      visit(target(h));
      last = previous(h);
      h = opposite(last);
    } while(h != first && h != none);
    if(h == none)
      visit(source(last));
  }

  bool are_neighbors(const Index v, const Index w) const
  {
    bool found = false;
    for_each_neighbor(v, [&](const Index x) { found = found || x == w; });
    return found;
  }

  // The number of constrained edges at a vertex
  Index line_degree(const Index v) const
  {
    Index number = is_border(v); // of the boundary's two edges only one is an outgoing halfedge
    for_each_outgoing(v, [&](const Index h) { number += is_constrained(h); });
    return number;
  }

  // Flips that make double edges or a vertex with less than three neighbours (two at the boundary) are not legal, nor
  // are those of constrained edges.
  bool is_flip_legal(Index h) const;
  Index flip(Index h); // returns a halfedge of the new edge
  // A vertex on a line disappears only along it and where it does not end or branch; two lines never become one.
  bool is_collapse_legal(Index h) const;
  void collapse(Index h); // target(h) disappears
  // The inverse of a collapse of an inner vertex: the new vertex takes over the faces of v counterclockwise from h1 to
  // h2, two outgoing halfedges of an inner vertex v, at least one face; source(h1) and the new vertex
  // become neighbours.
  Index split(Index h1, Index h2);
  Index split_edge(Index h); // a new vertex between source(h) and target(h)

  void record() { m_is_recording = true; }
  std::size_t mark() const { return m_journal.size(); }
  void undo_to(std::size_t mark);
  void forget()
  {
    m_journal.clear();
    m_is_recording = false;
  }
  void reserve_free(Index number_of_splits); // before recording: new slots are never taken back

private:
  enum Field : Index { corner, across, outgoing, degree, counts };
  enum Count : Index { vertex_count, free_vertex, free_face }; // the free slots form chains
  struct Change
  {
    Field field;
    Index at;
    Index old;
  };

  void set(const Field field, const Index at, const Index value)
  {
    Index& place = m_field[field][at];
    if(m_is_recording)
      m_journal.push_back({field, at, place});
    place = value;
  }

  // The fourth slot of a face has no halfedge: there the bits of the other three are kept.
  void constrain(const Index h, const bool value)
  {
    const Index bits = m_field[across][h | 3], bit = Index(1) << (h & 3);
    if(((bits & bit) != 0) != value)
      set(across, h | 3, bits ^ bit);
  }

  bool is_degree_left(const Index v) const { return valence(v) > (is_border(v) ? 2u : 3u); }
  Index line_between(Index first, Index last) const;
  void merge_edges(Index x, Index y, bool is_line);

  void glue(const Index h, const Index o)
  {
    if(h != none)
      set(across, h, o);
    if(o != none)
      set(across, o, h);
  }

  Index new_vertex();
  Index new_face(Index u, Index v, Index w);
  void remove_vertex(Index v);
  void remove_face(Index f);

  std::array<std::vector<Index>, 5> m_field;
  std::vector<Change> m_journal;
  bool m_is_recording = false;
};

template <class Is_line>
Lean_triangulation::Lean_triangulation(const Mesh& mesh, const Is_line& is_line)
{
  CGAL_precondition(!mesh.has_garbage());
  const std::size_t n = mesh.number_of_vertices();
  m_field[corner].assign(4 * mesh.number_of_faces(), none);
  m_field[across].assign(4 * mesh.number_of_faces(), none);
  m_field[outgoing].assign(n, none);
  m_field[degree].assign(n, 0);
  m_field[counts] = {static_cast<Index>(n), none, none};

  std::vector<Index> number(mesh.number_of_halfedges(), none);
  for(const Face f : mesh.faces())
  {
    Halfedge h = mesh.halfedge(f);
    for(Index i = 0; i < 3; ++i, h = mesh.next(h))
    {
      number[h] = 4 * f + i;
      m_field[corner][4 * f + i] = mesh.source(h);
    }
  }
  for(Index f = 0; f < face_slots(); ++f)
    m_field[across][4 * f + 3] = 0;
  for(const Halfedge h : mesh.halfedges())
  {
    if(number[h] == none)
      continue;
    const Index o = number[mesh.opposite(h)], v = mesh.source(h), first = m_field[outgoing][v];
    m_field[across][number[h]] = o;
    m_field[degree][v] += 1;
    constrain(number[h], o == none || is_line(mesh.edge(h)));
    // Where there is no line any halfedge, so the last one seen.
    if(first == none || o == none || (opposite(first) != none && (is_constrained(number[h]) || !is_constrained(first))))
      m_field[outgoing][v] = number[h];
    if(o == none)
      m_field[degree][mesh.target(h)] += 1;
  }
}

inline void Lean_triangulation::undo_to(const std::size_t mark)
{
  for(; m_journal.size() > mark; m_journal.pop_back())
    m_field[m_journal.back().field][m_journal.back().at] = m_journal.back().old;
}

inline void Lean_triangulation::reserve_free(const Index number_of_splits)
{
  CGAL_precondition(!m_is_recording);
  Index vertices = 0, faces = 0;
  for(Index v = m_field[counts][free_vertex]; v != none && vertices < number_of_splits; v = m_field[outgoing][v])
    ++vertices;
  for(Index f = m_field[counts][free_face]; f != none && faces < 2 * number_of_splits; f = m_field[across][4 * f])
    ++faces;
  for(; vertices < number_of_splits; ++vertices)
  {
    m_field[outgoing].push_back(m_field[counts][free_vertex]);
    m_field[degree].push_back(0);
    m_field[counts][free_vertex] = vertex_slots() - 1;
  }
  for(; faces < 2 * number_of_splits; ++faces)
  {
    m_field[corner].insert(m_field[corner].end(), 4, none);
    m_field[across].insert(m_field[across].end(), 4, none);
    m_field[across][4 * (face_slots() - 1)] = m_field[counts][free_face];
    m_field[counts][free_face] = face_slots() - 1;
  }
}

inline Lean_triangulation::Index Lean_triangulation::new_vertex()
{
  const Index v = m_field[counts][free_vertex];
  CGAL_precondition(v != none);
  set(counts, free_vertex, m_field[outgoing][v]);
  set(counts, vertex_count, m_field[counts][vertex_count] + 1);
  return v;
}

inline Lean_triangulation::Index Lean_triangulation::new_face(const Index u, const Index v, const Index w)
{
  const Index f = m_field[counts][free_face];
  CGAL_precondition(f != none);
  set(counts, free_face, m_field[across][4 * f]);
  set(across, 4 * f + 3, 0);
  set(corner, 4 * f, u);
  set(corner, 4 * f + 1, v);
  set(corner, 4 * f + 2, w);
  return f;
}

inline void Lean_triangulation::remove_vertex(const Index v)
{
  set(degree, v, 0);
  set(outgoing, v, m_field[counts][free_vertex]);
  set(counts, free_vertex, v);
  set(counts, vertex_count, m_field[counts][vertex_count] - 1);
}

inline void Lean_triangulation::remove_face(const Index f)
{
  for(Index i = 0; i < 3; ++i)
    set(corner, 4 * f + i, none);
  set(across, 4 * f, m_field[counts][free_face]);
  set(counts, free_face, f);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation_changes.h>

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LEAN_TRIANGULATION_H
