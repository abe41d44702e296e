// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INSERT_SAMPLES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INSERT_SAMPLES_H

#include <CGAL/Geodesic_remeshing/internal/Curve_sampler.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Makes samples vertices of the working surface: a vertex nearby becomes the sample, or an edge or a face is split at
// it. Those on lines become vertices of their line, the others never do.
class Sample_inserter
{
public:
  // Nearer than `snap`, in the metric, to a vertex, a sample takes that vertex over; its own place is kept, only the
  // cells that are to be grown around it begin at the vertex.
  Sample_inserter(const Mesh& surface, Working_surface& working, double snap)
    : m_surface(surface), m_working(working), m_mesh(working.mesh), m_input_metric(surface), m_squared_snap(snap * snap)
  {}

  // The vertices of the samples, in their order; an invalid one where two samples coincide, or one that is not on a
  // line lies at one.
  std::vector<Vertex> run(const std::vector<Sample>& samples)
  {
    m_is_sample.assign(m_mesh.number_of_vertices(), 0);
    mark_lines();
    std::vector<Vertex> result;
    result.reserve(samples.size());
    for(std::size_t i = 0; i < samples.size(); ++i)
    {
      const Sample& s = samples[i];
      const bool is_last_on_edge = i + 1 == samples.size() || samples[i + 1].line != s.line;
      const Vertex v = s.vertex.is_valid() ? s.vertex
                       : s.line.is_valid() ? insert_on_line(s, is_last_on_edge)
                                           : insert(s);
      result.push_back(v);
      m_is_sample.resize(m_mesh.number_of_vertices(), 0);
      m_is_on_line.resize(m_mesh.number_of_vertices(), s.line.is_valid());
      if(v.is_valid())
        m_is_sample[v] = 1;
    }
    // Only now, since until all are inserted the vertices must lie where the connectivity has them
    for(std::size_t i = 0; i < samples.size(); ++i)
      if(result[i].is_valid())
        put_vertex(m_working, m_input_metric, result[i], samples[i].point, samples[i].place);
    return result;
  }

private:
  void mark_lines()
  {
    m_is_on_line.assign(m_mesh.number_of_vertices(), 0);
    for(Edge e : m_mesh.edges())
      if(m_working.is_line[e])
        m_is_on_line[m_mesh.vertex(e, 0)] = m_is_on_line[m_mesh.vertex(e, 1)] = 1;
  }

  // The samples come in their order along the line, so that after a split the halfedge is what is left up to its
  // target. That vertex is taken over only by the last sample on the halfedge, or the order would change.
  Vertex insert_on_line(const Sample& s, bool is_last_on_edge)
  {
    const auto is_near = [&](Vertex v) {
      return !m_is_sample[v] && CGAL::squared_distance(s.point, m_mesh.point(v)) <= m_squared_snap * s.size * s.size;
    };
    if(is_near(m_mesh.source(s.line)))
      return m_mesh.source(s.line);
    if(is_last_on_edge && is_near(m_mesh.target(s.line)))
      return m_mesh.target(s.line);
    return split_edge_at(m_working, m_input_metric, s.line, s.point, s.place);
  }

  // Walks over the faces that the input face has been split into, to the one that holds the place. All of them are
  // known by their corners' coordinates in the input face, so this is plane geometry.
  Face locate(const Sample& s, std::array<double, 3>& weights) const
  {
    Face f = s.face;
    for(int steps = 0; steps < 64; ++steps)
    {
      weights = weights_in(f, s.place);
      const int worst = static_cast<int>(std::min_element(weights.begin(), weights.end()) - weights.begin());
      if(weights[worst] > -1e-9)
        break;
      const Face g = m_mesh.face(m_mesh.opposite(halfedge_opposite_to(f, worst)));
      if(g == Mesh::null_face() || m_working.input_face[g] != s.place.face)
        break; // on the border of the input face, but for rounding
      f = g;
    }
    double sum = 0.;
    for(double& w : weights)
      sum += w = (std::max)(w, 0.);
    for(double& w : weights)
      w = sum > 0. ? w / sum : 1. / 3.;
    return f;
  }

  std::array<double, 3> weights_in(Face f, const Place& place) const
  {
    std::array<std::array<double, 3>, 3> c;
    const auto v = vertices_of(m_mesh, f);
    for(int i = 0; i < 3; ++i)
      c[i] = coordinates_in(m_surface, m_working.place[v[i]], place.face);
    const auto area = [](const std::array<double, 3>& a, const std::array<double, 3>& b,
                         const std::array<double, 3>& d) {
      return (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]);
    };
    const double whole = area(c[0], c[1], c[2]);
    const auto& p = place.coordinates;
    if(!(std::abs(whole) > 0.))
      return {{1. / 3., 1. / 3., 1. / 3.}};
    return {{area(p, c[1], c[2]) / whole, area(c[0], p, c[2]) / whole, area(c[0], c[1], p) / whole}};
  }

  Vertex insert(const Sample& s)
  {
    std::array<double, 3> weights;
    const Face f = locate(s, weights);
    Vertex nearest;
    double distance = infinity;
    for(Vertex v : vertices_of(m_mesh, f))
    {
      const double d = CGAL::squared_distance(s.point, m_mesh.point(v));
      if(d < distance)
      {
        distance = d;
        nearest = v;
      }
    }
    const double squared_snap = m_squared_snap * s.size * s.size;
    if(distance <= squared_snap && !m_is_sample[nearest] && !m_is_on_line[nearest])
      return nearest;
    if(!(distance > 1e-12 * squared_snap))
      return Vertex();
    const int low = static_cast<int>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    const Halfedge side = halfedge_opposite_to(f, low);
    const bool is_line = m_working.is_line[m_mesh.edge(side)];
    if(weights[low] < .01 && is_line)
      return Vertex(); // as good as on a line, where it does not belong
    // a split of the face near one of its edges would leave a sliver
    return weights[low] < .1 && !is_line ? split_edge(side, low, weights) : split_face(f, s);
  }

  Halfedge halfedge_opposite_to(Face f, int corner) const
  {
    Halfedge h = m_mesh.halfedge(f);
    for(int i = 2; i != corner; i = (i + 1) % 3)
      h = m_mesh.next(h);
    return h;
  }

  Vertex split_edge(Halfedge h, int opposite_corner, std::array<double, 3> weights)
  {
    const Face f = m_mesh.face(h);
    const double rest = 1. - weights[opposite_corner];
    weights[opposite_corner] = 0.;
    for(double& w : weights)
      w /= rest;
    const Place place = place_on_input(m_surface, m_working, f, weights);
    return split_edge_at(m_working, m_input_metric, h, internal::point_at(m_surface, place), place);
  }

  Vertex split_face(Face f, const Sample& s)
  {
    const Halfedge h = Euler::add_center_vertex(m_mesh.halfedge(f), m_mesh);
    const Vertex v = m_mesh.target(h);
    put_vertex(m_working, m_input_metric, v, s.point, s.place);
    for(Halfedge i : m_mesh.halfedges_around_target(h))
      m_working.input_face[m_mesh.face(i)] = s.place.face;
    return v;
  }

  const Mesh& m_surface;
  Working_surface& m_working;
  Mesh& m_mesh;
  const Metric m_input_metric;
  const double m_squared_snap;
  std::vector<char> m_is_sample, m_is_on_line;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INSERT_SAMPLES_H
