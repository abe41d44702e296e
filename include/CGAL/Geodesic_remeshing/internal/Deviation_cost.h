// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_COST_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_COST_H

#include <CGAL/Geodesic_remeshing/internal/Deviations.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/distance_to_ring.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far the triangles around a vertex are from the input, and the input from them, as one number for many positions
// of the vertex. What is measured, points of the triangles and vertices of the input, is gathered once.
class Deviation_cost
{
public:
  using Index = Lean_triangulation::Index;
  using Spot = Remeshed_surface::Spot;

  // `nearest` may be that of some steps ago.
  Deviation_cost(const Remeshed_surface& remeshed, const Nearest_vertices& nearest, const Deviations& deviations)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_input(remeshed.walker().triangulation()),
      m_nearest(nearest), m_deviations(deviations), m_stamp(m_input.vertex_slots(), 0)
  {}

  void gather(Index v, const Vertex_ring& ring);

  // With the vertex of the ring at `spot`: the sum of the sixth powers of the deviations, of which the largest make up
  // nearly all. `unit` is a squared distance. No more than something above the limit where it is above the limit.
  double operator()(const Vertex_ring& ring, const Spot& spot, double unit, double limit);

private:
  // A vertex of the input, or a point of the triangle between the ring's vertices i and i + 1: its center, or, so far
  // along, one of the edge to i. That is sought on the input from where it was found last.
  struct Probe
  {
    Index of_input, i, face;
    double part;
    bool is_center;
  };

  // A face is within its radius around its center.
  struct Outer_face
  {
    Index f;
    Point center;
    double radius;
  };

  void gather_outer_faces(Index v);
  void gather_samples(Index v);
  const Point& point(const Index h) const { return m_remeshed.spot(m_table.source(h)).point; }
  double deviation(const Vertex_ring& ring, const Spot& spot, Probe& probe, double large) const;

  const Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const Lean_triangulation& m_input;
  const Nearest_vertices& m_nearest;
  const Deviations& m_deviations;
  std::vector<Index> m_stamp; // of the input's vertices: when they were looked at
  Index m_time = 0;
  std::vector<Index> m_samples; // vertices of the input
  std::vector<Outer_face> m_outer;
  std::vector<Probe> m_probes;
};

// Those around the neighbors of v, but not around v
inline void Deviation_cost::gather_outer_faces(const Index v)
{
  m_outer.clear();
  m_table.for_each_neighbor(v, [&](const Index w) {
    m_table.for_each_outgoing(w, [&](const Index h) {
      const Index f = Lean_triangulation::face(h);
      const auto is_corner = [&](const Index u) {
        return m_table.source(4 * f) == u || m_table.source(4 * f + 1) == u || m_table.source(4 * f + 2) == u;
      };
      const auto is_known = [&] {
        return std::any_of(m_outer.begin(), m_outer.end(), [&](const Outer_face& face) { return face.f == f; });
      };
      if(is_corner(v) || is_known())
        return;
      const Point center = CGAL::centroid(point(4 * f), point(4 * f + 1), point(4 * f + 2));
      double farthest = 0.;
      for(Index k = 4 * f; k < 4 * f + 3; ++k)
        farthest = (std::max)(farthest, CGAL::squared_distance(center, point(k)));
      m_outer.push_back({f, center, std::sqrt(farthest)});
    });
  });
}

// The vertices of the input that no triangle is much nearer to than those around v, sought from where v and its
// neighbors are as far as their nearest vertex is one of these
inline void Deviation_cost::gather_samples(const Index v)
{
  ++m_time;
  m_samples.clear();
  const auto enter = [&](const Index x) {
    if(m_stamp[x] == m_time)
      return;
    m_stamp[x] = m_time;
    bool is_near = m_nearest.vertex[x] == v;
    m_table.for_each_neighbor(v, [&](const Index w) { is_near = is_near || m_nearest.vertex[x] == w; });
    if(is_near)
      m_samples.push_back(x);
  };
  const auto enter_around = [&](const Index w) {
    const Index f = static_cast<Index>(m_remeshed.spot(w).place.face);
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      enter(m_input.source(h));
  };
  enter_around(v);
  m_table.for_each_neighbor(v, enter_around);
  for(std::size_t i = 0; i < m_samples.size(); ++i)
    m_input.for_each_neighbor(m_samples[i], enter);
  gather_outer_faces(v);
  const auto is_nearer_to_others = [&](const Index x) {
    const Point& p = m_deviations.input_point(x);
    const double here = .99 * squared_distance_to_ring(m_remeshed, p, v, 0.), reach = std::sqrt(here);
    return std::any_of(m_outer.begin(), m_outer.end(), [&](const Outer_face& face) {
      return CGAL::squared_distance(p, face.center) < CGAL::square(reach + face.radius) &&
             nearest_in_triangle(p, point(4 * face.f), point(4 * face.f + 1), point(4 * face.f + 2)).squared_distance <
                 here;
    });
  };
  m_samples.erase(std::remove_if(m_samples.begin(), m_samples.end(), is_nearer_to_others), m_samples.end());
}

inline void Deviation_cost::gather(const Index v, const Vertex_ring& ring)
{
  // Where the input is not finer than the triangulation its edges cross the triangles' anywhere: with the middles alone
  // the distance grew there.
  constexpr std::array<double, 3> parts = {{.25, .5, .75}};
  constexpr Index none = Lean_triangulation::none;
  const Index face = static_cast<Index>(m_remeshed.spot(v).place.face);
  gather_samples(v);
  m_probes.clear();
  for(Index i = 0; i < ring.size(); ++i)
  {
    for(const double part : parts)
      m_probes.push_back({none, i, face, part, false});
    m_probes.push_back({none, i, face, 0., true});
  }
  for(const Index x : m_samples)
    m_probes.push_back({x, 0, none, 0., false});
}

inline double Deviation_cost::deviation(const Vertex_ring& ring, const Spot& spot, Probe& probe,
                                        const double large) const
{
  const Spot &a = ring[probe.i], &b = ring[(probe.i + 1) % ring.size()];
  if(probe.of_input == Lean_triangulation::none)
    return m_deviations.from_input(probe.is_center ? CGAL::centroid(spot.point, a.point, b.point)
                                                   : spot.point + probe.part * (a.point - spot.point),
                                   probe.face, large, a);
  const Point& p = m_deviations.input_point(probe.of_input);
  double least = infinity;
  for(std::size_t i = 0; i < ring.size(); ++i)
    least = (std::min)(
        least, nearest_in_triangle(p, spot.point, ring[i].point, ring[(i + 1) % ring.size()].point).squared_distance);
  return least;
}

// The largest deviation comes first the next time: most positions are no better, and are seen to be at once.
inline double Deviation_cost::operator()(const Vertex_ring& ring, const Spot& spot, const double unit,
                                         const double limit)
{
  double sum = 0., most = -1.;
  std::size_t worst = 0;
  for(std::size_t i = 0; i < m_probes.size() && sum <= limit; ++i)
  {
    const double x = deviation(ring, spot, m_probes[i], .3 * unit) / unit;
    if(x > most)
    {
      most = x;
      worst = i;
    }
    sum += x * x * x;
  }
  std::rotate(m_probes.begin(), m_probes.begin() + worst, m_probes.begin() + worst + 1);
  return sum;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_COST_H
