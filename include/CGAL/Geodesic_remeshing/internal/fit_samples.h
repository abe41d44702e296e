// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SAMPLES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SAMPLES_H

#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A point of the input that the fitted mesh shall come near to, with the normal and the face there, and the area it
// stands for.
struct Fit_sample
{
  Point point;
  Vector normal;
  Lean_triangulation::Index face;
  double weight;
};

// Points spread evenly over the faces of the input, one for each `area` in the metric, and its vertices: a surface of
// flat faces is farthest from another one at a vertex of one of the two, or nearly so. Within a face the places are
// those of the sequence of the generalised golden ratio, so that they are even and the same in each run.
inline std::vector<Fit_sample> make_fit_samples(const Surface_walker& walker, const Metric& metric, const double area)
{
  constexpr double golden = .7548776662466927, golden_squared = .5698402909980532;
  const Mesh& surface = walker.surface();
  const Lean_triangulation& table = walker.triangulation();
  std::vector<Fit_sample> samples;
  std::vector<double> area_of_vertex(table.vertex_slots(), 0.);
  std::vector<Vector> normal_of_vertex(table.vertex_slots(), Vector(0., 0., 0.));
  std::vector<Lean_triangulation::Index> face_of_vertex(table.vertex_slots(), Lean_triangulation::none);
  double due = .5, u = .5, v = .5;
  for(Lean_triangulation::Index f = 0; f < table.face_slots(); ++f)
  {
    const auto point = [&](const Lean_triangulation::Index i) -> const Point& {
      return surface.point(Vertex(table.source(4 * f + i)));
    };
    const Vector a = point(1) - point(0), b = point(2) - point(0);
    const double area_of_face = .5 * std::sqrt(cross_product(a, b).squared_length());
    const double share = area * CGAL::square(metric.size(Place{Face(f), {{1. / 3., 1. / 3., 1. / 3.}}}));
    for(due += area_of_face / share; due >= 1.; due -= 1.)
    {
      u = std::fmod(u + golden, 1.);
      v = std::fmod(v + golden_squared, 1.);
      const bool is_beyond = u + v > 1.;
      const double s = is_beyond ? 1. - u : u, t = is_beyond ? 1. - v : v;
      samples.push_back({point(0) + s * a + t * b, walker.normal(Face(f)), f, share});
    }
    for(Lean_triangulation::Index i = 0; i < 3; ++i)
    {
      const Lean_triangulation::Index x = table.source(4 * f + i);
      area_of_vertex[x] += area_of_face / 3.;
      normal_of_vertex[x] = normal_of_vertex[x] + area_of_face * walker.normal(Face(f));
      face_of_vertex[x] = f;
    }
  }
  for(Lean_triangulation::Index x = 0; x < table.vertex_slots(); ++x)
    if(face_of_vertex[x] != Lean_triangulation::none)
      samples.push_back({surface.point(Vertex(x)), normal_of_vertex[x], face_of_vertex[x],
                         (std::min)(area_of_vertex[x], area * CGAL::square(metric.size(Vertex(x))))});
  return samples;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SAMPLES_H
