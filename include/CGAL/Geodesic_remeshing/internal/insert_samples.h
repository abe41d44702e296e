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
#include <CGAL/Geodesic_remeshing/internal/working_surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Makes samples vertices of the working surface: a vertex nearby becomes the sample, or an edge or a face is split at it.
class Sample_inserter
{
public:
  // Nearer than `snap`, in the metric, to a vertex, a sample takes that vertex over; its own place is kept, only the cells that are to
  // be grown around it begin at the vertex.
  Sample_inserter(const Mesh& surface, Working_surface& working, double snap)
    : m_surface(surface), m_working(working), m_mesh(working.mesh), m_input_metric(surface), m_squared_snap(snap * snap)
  {}

  // The vertices of the samples, in their order; an invalid one where two samples coincide.
  std::vector<Vertex> run(const std::vector<Sample>& samples)
  {
    m_is_sample.assign(m_mesh.number_of_vertices(), 0);
    std::vector<Vertex> result;
    result.reserve(samples.size());
    for(const Sample& s : samples)
    {
      const Vertex v = insert(s);
      result.push_back(v);
      m_is_sample.resize(m_mesh.number_of_vertices(), 0);
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
  // Walks over the faces that the input face has been split into, to the one that holds the place. All of them are known by
  // their corners' coordinates in the input face, so this is plane geometry.
  Face locate(const Sample& s, std::array<double, 3>& weights) const
  {
    Face f = s.face;
    for(int steps = 0; steps < 64; ++steps)
    {
      weights = weights_in(f, s.place);
      const int worst = static_cast<int>(std::min_element(weights.begin(), weights.end()) - weights.begin());
      if(weights[worst] > -1e-9)
        break;
      Halfedge h = m_mesh.halfedge(f); // opposite to corner 2
      for(int i = 2; i != worst; i = (i + 1) % 3)
        h = m_mesh.next(h);
      const Face g = m_mesh.face(m_mesh.opposite(h));
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
    const auto area = [](const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& d)
    { return (b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]); };
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
    if(distance <= squared_snap && !m_is_sample[nearest])
      return nearest;
    if(!(distance > 1e-12 * squared_snap))
      return Vertex();
    const int low = static_cast<int>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    // a split of the face near one of its edges would leave a sliver
    return weights[low] < .1 ? split_edge(f, low, weights) : split_face(f, s);
  }

  Vertex split_edge(Face f, int opposite_corner, std::array<double, 3> weights)
  {
    Halfedge h = m_mesh.halfedge(f);
    for(int i = 2; i != opposite_corner; i = (i + 1) % 3)
      h = m_mesh.next(h);
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
  std::vector<char> m_is_sample;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INSERT_SAMPLES_H
