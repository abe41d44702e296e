// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DELAUNAY_FLIPS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DELAUNAY_FLIPS_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Makes the triangles between the samples Delaunay: an edge is flipped when the two triangles beside it, unfolded into
// a plane, are not, and those with the other diagonal are. Each is decided by an exact predicate; but the plane is
// another one for the other diagonal, which on a curved surface is shorter than when unfolded, and even on a flat one
// lengths are rounded: of four points nearly on a circle both diagonals can look wrong. The flips need not come to an
// end by themselves: their number is bounded.
class Delaunay_flipper
{
public:
  explicit Delaunay_flipper(Mesh& mesh) : m_mesh(mesh), m_metric(mesh), m_queued(mesh.number_of_edges(), 1) {}

  // Constrained edges stay.
  Delaunay_flipper(Mesh& mesh, const Mesh::Property_map<Edge, bool>& is_constrained) : Delaunay_flipper(mesh)
  {
    m_is_constrained = is_constrained;
    m_has_constraints = true;
  }

  std::size_t run()
  {
    m_queue.assign(m_mesh.edges().begin(), m_mesh.edges().end());
    std::reverse(m_queue.begin(), m_queue.end());
    const std::size_t bound = 8 * m_queue.size(); // some 0.5 flips an edge are what it takes
    std::size_t flips = 0;
    while(!m_queue.empty() && flips < bound)
    {
      const Edge e = m_queue.back();
      m_queue.pop_back();
      m_queued[e.idx()] = 0;
      if(m_mesh.is_border(e) || (m_has_constraints && m_is_constrained[e]) || !would_gain(m_mesh.halfedge(e)) ||
         !is_flippable(m_mesh.halfedge(e)))
        continue;
      flip(m_mesh.halfedge(e));
      ++flips;
    }
    return flips;
  }

private:
  using Point_2 = Kernel::Point_2;

  // The apex over the edge from a, the origin, to b on the x axis
  Point_2 apex(double squared_length, double length, Vertex a, Vertex b, Vertex c, double side) const
  {
    const double left = m_metric.squared_length(a, c), right = m_metric.squared_length(b, c);
    const double x = (squared_length + left - right) / (2. * length);
    return Point_2(x, side * std::sqrt((std::max)(0., left - x * x)));
  }

  // Whether the edge from a to b between the triangles with c at its left and d at its right is not Delaunay
  bool is_wrong(Vertex a, Vertex b, Vertex c, Vertex d) const
  {
    const double squared_length = m_metric.squared_length(a, b), length = std::sqrt(squared_length);
    if(!(length > 0.))
      return false;
    const Point_2 p = apex(squared_length, length, a, b, c, 1.), q = apex(squared_length, length, a, b, d, -1.);
    return side_of_oriented_circle(Point_2(0., 0.), Point_2(length, 0.), p, q) == ON_POSITIVE_SIDE;
  }

  bool would_gain(Halfedge h) const
  {
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h);
    const Vertex c = m_mesh.target(m_mesh.next(h)), d = m_mesh.target(m_mesh.next(m_mesh.opposite(h)));
    return is_wrong(a, b, c, d) && !is_wrong(d, c, a, b);
  }

  bool has_edge_to_spare(Vertex v) const { return m_mesh.degree(v) > (m_mesh.is_border(v) ? 2u : 3u); }

  // Not where the other diagonal is an edge already, a vertex would lose its third edge, or a face would turn over
  bool is_flippable(Halfedge h) const
  {
    const Halfedge o = m_mesh.opposite(h);
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h);
    const Vertex c = m_mesh.target(m_mesh.next(h)), d = m_mesh.target(m_mesh.next(o));
    if(c == d || m_mesh.halfedge(c, d).is_valid() || !has_edge_to_spare(a) || !has_edge_to_spare(b))
      return false;
    const Vector before = normal(a, b, c) + normal(b, a, d);
    return normal(c, d, b) * before > 0. && normal(d, c, a) * before > 0.;
  }

  Vector normal(Vertex u, Vertex v, Vertex w) const
  {
    return cross_product(Vector(m_mesh.point(u), m_mesh.point(v)), Vector(m_mesh.point(u), m_mesh.point(w)));
  }

  void flip(Halfedge h)
  {
    const Halfedge o = m_mesh.opposite(h);
    const Halfedge ring[4] = {m_mesh.next(h), m_mesh.prev(h), m_mesh.next(o), m_mesh.prev(o)};
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h), c = m_mesh.target(ring[0]), d = m_mesh.target(ring[2]);
    const Face f = m_mesh.face(h), g = m_mesh.face(o);
    m_mesh.set_target(h, c);
    m_mesh.set_target(o, d);
    set_triangle(f, h, ring[1], ring[2]); // d -> c -> a -> d
    set_triangle(g, o, ring[3], ring[0]); // c -> d -> b -> c
    m_mesh.set_halfedge(a, ring[1]);
    m_mesh.set_halfedge(b, ring[3]);
    m_mesh.set_halfedge(c, h);
    m_mesh.set_halfedge(d, o);
    for(Halfedge r : ring)
      if(!m_queued[m_mesh.edge(r).idx()])
      {
        m_queued[m_mesh.edge(r).idx()] = 1;
        m_queue.push_back(m_mesh.edge(r));
      }
  }

  void set_triangle(Face f, Halfedge a, Halfedge b, Halfedge c)
  {
    m_mesh.set_next(a, b);
    m_mesh.set_next(b, c);
    m_mesh.set_next(c, a);
    for(Halfedge h : {a, b, c})
      m_mesh.set_face(h, f);
    m_mesh.set_halfedge(f, a);
  }

  Mesh& m_mesh;
  const Metric m_metric;
  Mesh::Property_map<Edge, bool> m_is_constrained;
  bool m_has_constraints = false;
  std::vector<char> m_queued;
  std::vector<Edge> m_queue;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DELAUNAY_FLIPS_H
