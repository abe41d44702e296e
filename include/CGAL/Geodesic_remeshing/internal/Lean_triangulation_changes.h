// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LEAN_TRIANGULATION_CHANGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LEAN_TRIANGULATION_CHANGES_H

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The changes of a `Lean_triangulation`. In all of them the halfedges of an edge that stays may change, and take their
// marks with them; the first halfedge of a vertex on a line stays that of the same line.

inline bool Lean_triangulation::is_flip_legal(const Index h) const
{
  const Index o = opposite(h);
  if(is_constrained(h))
    return false;
  const Index c = apex(h), d = apex(o);
  return is_degree_left(source(h)) && is_degree_left(target(h)) && c != d && !are_neighbors(c, d);
}

inline Lean_triangulation::Index Lean_triangulation::flip(const Index h)
{
  // (a,b,c) and (b,a,d) become (a,d,c) and (b,c,d).
  const Index o = opposite(h), hn = next(h), on = next(o);
  const Index a = source(h), b = source(o), c = apex(h), d = apex(o);
  const Index bc = opposite(hn), ad = opposite(on);
  const bool is_bc_line = is_constrained(hn), is_ad_line = is_constrained(on);
  set(corner, hn, d);
  set(corner, on, c);
  glue(hn, on);
  set(across, h, ad);
  if(ad != none)
    set(across, ad, h);
  set(across, o, bc);
  if(bc != none)
    set(across, bc, o);
  constrain(h, is_ad_line);
  constrain(o, is_bc_line);
  constrain(hn, false);
  constrain(on, false);
  if(halfedge(a) == on)
    set(outgoing, a, h);
  if(halfedge(b) == hn)
    set(outgoing, b, o);
  set(degree, a, valence(a) - 1);
  set(degree, b, valence(b) - 1);
  set(degree, c, valence(c) + 1);
  set(degree, d, valence(d) + 1);
  return hn;
}

inline bool Lean_triangulation::is_collapse_legal(const Index h) const
{
  const Index o = opposite(h), a = source(h), b = target(h);
  const bool is_at_boundary = o == none;
  if(is_on_line(b) && (!is_constrained(h) || line_degree(b) != 2))
    return false;
  if(!is_degree_left(apex(h)) || (is_constrained(next(h)) && is_constrained(previous(h))))
    return false;
  if(!is_at_boundary && (!is_degree_left(apex(o)) || (is_constrained(next(o)) && is_constrained(previous(o)))))
    return false;
  if(valence(a) + valence(b) < (is_at_boundary ? 5 : 7))
    return false;
  // Link condition: a and b have no other neighbours in common than those two.
  Index common = 0;
  for_each_neighbor(b, [&](const Index x) { common += are_neighbors(a, x); });
  return common == (is_at_boundary ? 1 : 2);
}

// Of the outgoing halfedges of b from `first` to the one before `last` the constrained one, and `last` if none is.
inline Lean_triangulation::Index Lean_triangulation::line_between(const Index first, const Index last) const
{
  Index g = first;
  while(g != last && !is_constrained(g))
    g = rotate(g);
  return g;
}

// Of a face that goes two edges become one, that of the halfedges x and y beyond them.
inline void Lean_triangulation::merge_edges(const Index x, const Index y, const bool is_line)
{
  glue(x, y);
  if(x != none)
    constrain(x, is_line);
  if(y != none)
    constrain(y, is_line);
}

inline void Lean_triangulation::collapse(const Index h)
{
  const Index o = opposite(h), hn = next(h), hp = previous(h);
  const Index a = source(h), b = target(h), c = source(hp), x = opposite(hn), y = opposite(hp);
  const Index on = o == none ? none : next(o), op = o == none ? none : previous(o);
  const Index z = o == none ? none : opposite(on), w = o == none ? halfedge(b) : opposite(op);
  if(halfedge(a) == h)
  {
    const Index line = is_constrained(h) ? line_between(w, hn) : hn;
    set(outgoing, a, line == hn ? y : line);
  }
  for(Index g = w; g != hn; g = rotate(g))
    set(corner, g, a);
  if(halfedge(c) == hp)
    set(outgoing, c, x);
  set(degree, a, valence(a) + valence(b) - (o == none ? 3 : 4));
  set(degree, c, valence(c) - 1);
  merge_edges(x, y, is_constrained(hn) || is_constrained(hp));
  remove_face(face(h));
  if(o != none)
  {
    const Index d = source(op);
    if(halfedge(a) == on)
      set(outgoing, a, w);
    if(halfedge(d) == op)
      set(outgoing, d, z);
    set(degree, d, valence(d) - 1);
    merge_edges(z, w, is_constrained(on) || is_constrained(op));
    remove_face(face(o));
  }
  remove_vertex(b);
}

inline Lean_triangulation::Index Lean_triangulation::split(const Index h1, const Index h2)
{
  const Index v = source(h1), c = target(h1), d = target(h2);
  const Index o1 = opposite(h1), p2 = opposite(h2), w = new_vertex();
  Index taken = 0;
  for(Index g = h1; g != h2; g = rotate(g), ++taken)
    set(corner, g, w);
  const Index f1 = new_face(v, c, w), f2 = new_face(w, d, v);
  glue(4 * f1, o1);
  glue(4 * f1 + 1, h1);
  glue(4 * f1 + 2, 4 * f2 + 2);
  glue(4 * f2, p2);
  glue(4 * f2 + 1, h2);
  set(outgoing, w, h1);
  set(outgoing, v, h2);
  set(degree, w, taken + 2);
  set(degree, v, valence(v) - taken + 2);
  set(degree, c, valence(c) + 1);
  set(degree, d, valence(d) + 1);
  return w;
}

// The faces (a,b,c) and (b,a,d) become (a,w,c), (w,b,c) and (w,a,d), (b,w,d).
inline Lean_triangulation::Index Lean_triangulation::split_edge(const Index h)
{
  const Index o = opposite(h), hn = next(h), b = target(h), c = apex(h), w = new_vertex();
  const bool is_line = is_constrained(h);
  const Index f = new_face(w, b, c);
  constrain(4 * f, is_line);
  constrain(4 * f + 1, is_constrained(hn));
  constrain(hn, false);
  glue(4 * f + 1, opposite(hn));
  glue(4 * f + 2, hn);
  set(across, 4 * f, none);
  set(corner, hn, w);
  set(outgoing, w, 4 * f);
  set(degree, w, o == none ? 3 : 4);
  set(degree, c, valence(c) + 1);
  if(halfedge(b) == hn)
    set(outgoing, b, 4 * f + 1);
  if(o == none)
    return w;
  const Index op = previous(o), d = apex(o), g = new_face(b, w, d);
  constrain(4 * g, is_line);
  constrain(4 * g + 2, is_constrained(op));
  constrain(op, false);
  glue(4 * g + 2, opposite(op));
  glue(4 * g + 1, op);
  glue(4 * g, 4 * f);
  set(corner, o, w);
  set(degree, d, valence(d) + 1);
  if(halfedge(b) == o)
    set(outgoing, b, 4 * g);
  if(halfedge(d) == op)
    set(outgoing, d, 4 * g + 2);
  return w;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LEAN_TRIANGULATION_CHANGES_H
