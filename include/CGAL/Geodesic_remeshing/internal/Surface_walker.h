// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_WALKER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_WALKER_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Walks straight over a surface: a place and a tangent vector give the place reached (the discrete exponential map).
//
// The way is unfolded at every edge, in barycentric coordinates: with an edge from (0,0) to (1,0) and the apices of its
// two faces at (x,y) and (x',-y') the crossing is one linear map of the coordinates, so a step costs about a dozen
// multiplications, and its end is on the surface whatever the rounding. Nothing is projected: two sheets of a surface
// that nearly touch are as far apart as the way over the surface between them.
class Surface_walker
{
public:
  using Index = Lean_triangulation::Index;

  explicit Surface_walker(const Mesh& surface, const Constraints& constraints = Constraints(),
                          Concurrency concurrency = Concurrency());

  // Goes along the projection of `displacement` to the plane of the face, for the projection's length. Ends before the
  // lines, of which the boundary is one, and after `m_maximum_number_of_crossings` (a way around a degenerate vertex
  // need not end).
  Place walk(const Place& from, const Vector& displacement) const;

  // Unit normal of a face; that of a neighbour for a face without area; zero where there is none.
  const Vector& normal(const Face f) const { return m_frames[f].normal; }
  // That of a place on a line, zero where the faces that meet there look different ways.
  Vector normal_on_line(const Place& place) const;
  Point point(const Place& place) const;
  const Mesh& surface() const { return m_surface; }
  const Lean_triangulation& triangulation() const { return m_triangulation; } // its constrained edges are the lines

  // The faces that a place is in: one, two at an edge, all around at a vertex.
  template <class Visit>
  void for_each_face_at(const Place& place, const Visit& visit) const;

private:
  // The face's apex over a halfedge in the frame where the halfedge goes from (0,0) to (1,0).
  struct Apex
  {
    double x, y;
  };
  // Of a face: how its second and its third barycentric coordinate grow over it, and its normal.
  struct Frame
  {
    Vector second, third, normal;
  };

  void lay_out(Index f);
  void borrow_normals();
  void find_gradients(Index f);
  const Apex& apex(const Index h) const { return m_apices[h - Lean_triangulation::face(h)]; }
  std::array<double, 3> velocity(Face f, const Vector& displacement) const;
  void cross(Index h, Index o, std::array<double, 3>& at, std::array<double, 3>& by) const;

  const Mesh& m_surface;
  Lean_triangulation m_triangulation;
  std::vector<Frame> m_frames;
  std::vector<Apex> m_apices; // three a face
  std::size_t m_maximum_number_of_crossings;
};

inline Surface_walker::Surface_walker(const Mesh& surface, const Constraints& constraints,
                                      const Concurrency concurrency)
  : m_surface(surface),
    m_triangulation(surface,
                    [&](const Edge e) { return !constraints.is_line.empty() && constraints.is_line[e.idx()]; }),
    m_frames(surface.number_of_faces()), m_apices(3 * surface.number_of_faces())
    // A straight way through a mesh crosses some sqrt(faces) edges; the constant is generous, for elongated meshes.
    ,
    m_maximum_number_of_crossings(100 + 20 * static_cast<std::size_t>(std::sqrt(double(surface.number_of_faces()))))
{
  parallel_for(concurrency, m_frames.size(), [&](const std::size_t f) { lay_out(static_cast<Index>(f)); });
  borrow_normals();
  parallel_for(concurrency, m_frames.size(), [&](const std::size_t f) { find_gradients(static_cast<Index>(f)); });
}

inline void Surface_walker::lay_out(const Index f)
{
  std::array<Point, 3> p;
  for(Index i = 0; i < 3; ++i)
    p[i] = m_surface.point(Vertex(m_triangulation.source(4 * f + i)));
  const std::array<Vector, 3> e = {{p[1] - p[0], p[2] - p[1], p[0] - p[2]}};
  const std::array<double, 3> l = {{e[0].squared_length(), e[1].squared_length(), e[2].squared_length()}};
  const Vector product = cross_product(e[0], e[1]);
  const double area = std::sqrt(product.squared_length());
  // A face without area or with a point for an edge gets a little of both, far above the rounding and far below
  // what matters: then every apex is finite and every crossing possible.
  const double longest = (std::max)({l[0], l[1], l[2], (std::numeric_limits<double>::min)()});
  const double least_area = 1e-10 * longest, least_length = 1e-20 * longest;
  m_frames[f].normal = area > least_area ? product / area : Vector(0., 0., 0.);
  for(Index i = 0; i < 3; ++i)
  {
    const double length = (std::max)(l[i], least_length);
    m_apices[3 * f + i] = {-(e[i] * e[(i + 2) % 3]) / length, (std::max)(area, least_area) / length};
  }
}

// Faces without area have no normal of their own, but that of a neighbour, or of one beyond.
inline void Surface_walker::borrow_normals()
{
  std::vector<Index> lenders;
  const auto for_each_neighbor = [&](const Index f, const auto& visit) {
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      if(m_triangulation.opposite(h) != Lean_triangulation::none)
        visit(Lean_triangulation::face(m_triangulation.opposite(h)));
  };
  for(Index f = 0; f < m_triangulation.face_slots(); ++f)
    if(m_frames[f].normal == NULL_VECTOR)
      for_each_neighbor(f, [&](const Index g) {
        if(m_frames[g].normal != NULL_VECTOR)
          lenders.push_back(g);
      });
  for(std::size_t i = 0; i < lenders.size(); ++i)
    for_each_neighbor(lenders[i], [&](const Index f) {
      if(m_frames[f].normal == NULL_VECTOR)
      {
        m_frames[f].normal = m_frames[lenders[i]].normal;
        lenders.push_back(f);
      }
    });
}

// As `point_at()`, which has to go through the mesh' halfedges.
inline Point Surface_walker::point(const Place& place) const
{
  const Index h = 4 * static_cast<Index>(place.face);
  const Point& p = m_surface.point(Vertex(m_triangulation.source(h)));
  const Point& q = m_surface.point(Vertex(m_triangulation.source(h + 1)));
  const Point& r = m_surface.point(Vertex(m_triangulation.source(h + 2)));
  const auto& c = place.coordinates;
  return Point(c[0] * p.x() + c[1] * q.x() + c[2] * r.x(), c[0] * p.y() + c[1] * q.y() + c[2] * r.y(),
               c[0] * p.z() + c[1] * q.z() + c[2] * r.z());
}

template <class Visit>
void Surface_walker::for_each_face_at(const Place& place, const Visit& visit) const
{
  const auto& c = place.coordinates;
  const Index f = place.face, zeros = !(c[0] > 0.) + !(c[1] > 0.) + !(c[2] > 0.);
  if(zeros < 2)
  {
    visit(place.face);
    const Index edge = !(c[0] > 0.) ? 1 : !(c[1] > 0.) ? 2 : 0;
    const Index o = zeros == 1 ? m_triangulation.opposite(4 * f + edge) : Lean_triangulation::none;
    if(o != Lean_triangulation::none)
      visit(Face(Lean_triangulation::face(o)));
    return;
  }
  const Index corner = c[0] > 0. ? 0 : c[1] > 0. ? 1 : 2;
  m_triangulation.for_each_outgoing(m_triangulation.source(4 * f + corner),
                                    [&](const Index h) { visit(Face(Lean_triangulation::face(h))); });
}

inline Vector Surface_walker::normal_on_line(const Place& place) const
{
  constexpr double least_cosine = .7;
  Vector sum(0., 0., 0.);
  for_each_face_at(place, [&](const Face f) { sum = sum + normal(f); });
  const double length = std::sqrt(sum.squared_length());
  bool is_smooth = length > 0.;
  for_each_face_at(place, [&](const Face f) { is_smooth = is_smooth && normal(f) * sum >= least_cosine * length; });
  return is_smooth ? sum / length : Vector(0., 0., 0.);
}

// In the frame of the first edge, and across it by the normal, which a face without area has borrowed. Where the edge
// is a point nothing moves.
inline void Surface_walker::find_gradients(const Index f)
{
  Frame& frame = m_frames[f];
  const Vector edge = m_surface.point(Vertex(m_triangulation.source(4 * f + 1))) -
                      m_surface.point(Vertex(m_triangulation.source(4 * f)));
  const double length = edge.squared_length();
  frame.second = frame.third = Vector(0., 0., 0.);
  if(!(length > 0.))
    return;
  frame.third = cross_product(frame.normal, edge) / length / apex(4 * f).y;
  frame.second = edge / length - apex(4 * f).x * frame.third;
}

// The displacement as the change of the barycentric coordinates.
inline std::array<double, 3> Surface_walker::velocity(const Face f, const Vector& displacement) const
{
  const double second = displacement * m_frames[f].second, third = displacement * m_frames[f].third;
  return {{-second - third, second, third}};
}

// Rewrites coordinates and velocity of the face of h, which the way leaves through h, for the face of o = opposite(h).
inline void Surface_walker::cross(const Index h, const Index o, std::array<double, 3>& at,
                                  std::array<double, 3>& by) const
{
  const Apex &left = apex(h), &right = apex(o);
  const Index i = h & 3, j = o & 3;
  // The old apex in terms of the source of h, its target and the new apex: (1 - s - u, s, u). That o runs the
  // other way is why its x is taken from 1.
  const double u = -left.y / right.y, s = left.x - u * (1. - right.x);
  const double at_source = at[i], at_target = at[(i + 1) % 3];
  const double by_target = by[(i + 1) % 3] + s * by[(i + 2) % 3], by_apex = u * by[(i + 2) % 3];
  at[j] = at_target;
  at[(j + 1) % 3] = at_source;
  at[(j + 2) % 3] = 0.;
  by[j] = by_target;
  by[(j + 1) % 3] = -by_target - by_apex;
  by[(j + 2) % 3] = by_apex;
}

inline Place Surface_walker::walk(const Place& from, const Vector& displacement) const
{
  constexpr double fastest = 1e100;
  Index f = from.face;
  std::array<double, 3> at = from.coordinates, by = velocity(from.face, displacement);
  // Most ways end in the face where they begin.
  const std::array<double, 3> end = {{at[0] + by[0], at[1] + by[1], at[2] + by[2]}};
  if(end[0] > 0. && end[1] > 0. && end[2] > 0.)
    return Place{from.face, end};
  for(std::size_t crossings = 0; crossings < m_maximum_number_of_crossings; ++crossings)
  {
    // Among faces without area the way can turn for ever, faster at each crossing.
    if(!(std::abs(by[0]) + std::abs(by[1]) + std::abs(by[2]) < fastest))
      break;
    // The first coordinate to reach zero on the way names the edge crossed.
    Index exit = 3;
    double time = 1.;
    for(Index i = 0; i < 3; ++i)
      if(by[i] < 0. && at[i] < -by[i] * time)
      {
        time = at[i] / -by[i];
        exit = i;
      }
    for(Index i = 0; i < 3 && exit == 3; ++i) // the end may be on a line
      if(by[i] < 0. && !(at[i] + by[i] > 0.) && m_triangulation.is_constrained(4 * f + (i + 1) % 3))
        exit = i;
    const Index h = 4 * f + (exit + 1) % 3;
    const bool is_stopped = exit != 3 && m_triangulation.is_constrained(h);
    if(is_stopped)
      time *= .5; // not onto the line, where there is no place but for the line's own vertices
    for(Index i = 0; i < 3; ++i)
    {
      at[i] += time * by[i];
      by[i] *= 1. - time;
    }
    if(exit == 3 || is_stopped)
      break;
    at[exit] = 0.;
    const Index o = m_triangulation.opposite(h);
    cross(h, o, at, by);
    f = Lean_triangulation::face(o);
  }
  // Rounding leaves at most a last bit below zero, and the sum off one by as much.
  for(double& c : at)
    c = (std::max)(c, 0.);
  const double sum = at[0] + at[1] + at[2];
  return Place{Face(f), {{at[0] / sum, at[1] / sum, at[2] / sum}}};
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_WALKER_H
