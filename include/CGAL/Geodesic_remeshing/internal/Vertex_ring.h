// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_RING_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_RING_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The triangles around a vertex, gathered once for the many questions of a step: where their centre is, how good they
// are, and how good they would be if the vertex were elsewhere. Valid as long as nothing but the vertex itself changes.
class Vertex_ring
{
public:
  using Index = Lean_triangulation::Index;
  using Spot = Remeshed_surface::Spot;

  Vertex_ring(const Remeshed_surface& remeshed, Index v);

  Vector way_to_center() const;
  double badness() const { return badness(m_remeshed.spot(m_vertex), infinity); }
  // That of the ring if its centre were at `spot`, turned where it may not be; no more than something above the limit
  // where it is above the limit.
  double badness(const Spot& spot, double limit) const;
  // Whether that is below the limit, which is itself below that of a turned triangle: it takes no division.
  bool is_below(double limit, const Spot& spot) const;

  // 0 if all vertices are in the block; else in which bits they differ from that in the middle
  Index bits_beyond(const Block block) const
  {
    const Spot* const first = &m_remeshed.spot(0);
    Index bits = block.bits_beyond(m_vertex, block.begin);
    for(const Spot* spot : m_around)
      bits |= block.bits_beyond(static_cast<Index>(spot - first), m_vertex);
    return bits;
  }
  // Calls `visit(a, b)` for the points of each edge opposite to the vertex.
  template <class Visit>
  void for_each_rim(const Visit& visit) const
  {
    const Point* last = m_is_closed ? &m_around.back()->point : &m_around.front()->point;
    for(auto i = m_around.begin() + !m_is_closed; i != m_around.end(); last = &(*i++)->point)
      visit(*last, (*i)->point);
  }
  std::size_t size() const { return m_around.size(); } // of the neighbours
  const Spot& operator[](const std::size_t i) const { return *m_around[i]; }

private:
  // Calls `visit(first, second, squared lengths of the edges to the first, to the second and between them, normal)` for
  // each triangle, as long as it returns true. What one shares with the next is computed once: of all that is asked in
  // the improvement this is asked most often.
  template <class Visit>
  bool for_each_triangle(const Spot& spot, const Visit& visit) const;

  const Remeshed_surface& m_remeshed;
  const Index m_vertex;
  boost::container::small_vector<const Spot*, 16> m_around;
  bool m_is_closed;
};

inline Vertex_ring::Vertex_ring(const Remeshed_surface& remeshed, const Index v) : m_remeshed(remeshed), m_vertex(v)
{
  const Lean_triangulation& table = remeshed.connectivity();
  m_around.resize(table.valence(v), boost::container::default_init);
  const Spot** next = m_around.data();
  table.for_each_neighbor(v, [&](const Index w) { *next++ = &remeshed.spot(w); });
  CGAL_assertion(next == m_around.data() + m_around.size());
  m_is_closed = !table.is_border(v);
}

template <class Visit>
bool Vertex_ring::for_each_triangle(const Spot& spot, const Visit& visit) const
{
  const Spot* last = m_is_closed ? m_around.back() : m_around.front();
  Vector a = last->point - spot.point;
  double x = a.squared_length();
  for(auto i = m_around.begin() + !m_is_closed; i != m_around.end(); ++i)
  {
    const Spot* next = *i;
    const Vector b = next->point - spot.point;
    const double y = b.squared_length(), z = CGAL::squared_distance(next->point, last->point);
    if(!visit(*last, *next, x, y, z, cross_product(a, b)))
      return false;
    last = next;
    a = b;
    x = y;
  }
  return true;
}

inline double Vertex_ring::badness(const Spot& spot, const double limit) const
{
  double sum = m_remeshed.may_be_at(m_vertex, spot) ? 0. : turned_badness;
  for_each_triangle(spot, [&](const Spot& v, const Spot& w, const double x, const double y, const double z,
                              const Vector& normal) {
    sum =
        add_badness(sum, m_remeshed.is_turned(spot, v, w, normal) ? turned_badness
                                                                  : triangle_badness(x, y, z, normal.squared_length()));
    return sum <= limit;
  });
  return sum;
}

inline bool Vertex_ring::is_below(const double limit, const Spot& spot) const
{
  return m_remeshed.may_be_at(m_vertex, spot) &&
         for_each_triangle(spot, [&](const Spot& v, const Spot& w, const double x, const double y, const double z,
                                     const Vector& normal) {
           return is_badness_below(limit, x, y, z, normal.squared_length()) &&
                  !m_remeshed.is_turned(spot, v, w, normal);
         });
}

inline Vector Vertex_ring::way_to_center() const
{
  const Spot& spot = m_remeshed.spot(m_vertex);
  // In units of the length that the edge is to have, so that all pull alike. Without, a sizing is kept more exactly: to
  // 2 percent in place of 8 where it changes fourfold over a sphere. With, vertices gather where they are wanted: the
  // RMS distance of sizings by curvature is 3 to 5 percent less.
  const auto way_to = [&](const Spot& other) {
    const Vector way = other.point - spot.point;
    return m_remeshed.metric().is_uniform() ? way : 2. * spot.size / (spot.size + other.size) * way;
  };
  Vector sum(0., 0., 0.);
  for(const Spot* other : m_around)
    sum = sum + way_to(*other);
  const Vector way = sum / static_cast<double>(m_around.size());
  if(!m_remeshed.is_on_line(m_vertex))
    return way;
  // Evenly between those beside it on the line, to cover bent lines, and in the middle of all, for the angles.
  Vector along(0., 0., 0.);
  m_remeshed.for_each_neighbor_on_line(m_vertex,
                                       [&](const Index w) { along = along + .5 * way_to(m_remeshed.spot(w)); });
  return .5 * (way + along);
}

inline double Remeshed_surface::ring_badness(const Index v) const
{
  return Vertex_ring(*this, v).badness();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_RING_H
