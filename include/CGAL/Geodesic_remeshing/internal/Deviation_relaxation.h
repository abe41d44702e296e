// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_RELAXATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_RELAXATION_H

#include <CGAL/Geodesic_remeshing/internal/Deviations.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Steps over the surface that make a sum least: the mean square of the distance of the triangulation from the surface,
// in units of what it was, times a worth, and the mean cotangent of the smallest angles. So what is given up in angles
// goes where it buys the most. For sizings by curvature: no lengths gain as much. Those of the least deviation, known
// from uniform meshes of seven numbers of vertices, are no better than lengths by curvature (on armadillo 10 percent
// below the RMS distance of the uniform mesh, and no more than 13 if they could grow as fast as they like).
class Deviation_relaxation
{
public:
  using Index = Lean_triangulation::Index;

  // `nearest` may be that of some steps ago. No triangle gets worse than `badness` that is not.
  Deviation_relaxation(Remeshed_surface& remeshed, const Nearest_vertices& nearest, const double badness)
    : m_remeshed(remeshed), m_badness(badness), m_deviations(remeshed, nearest)
  {}

  // The larger the worth, the nearer to the surface and the worse the angles. Nothing is done where the deviations are
  // below the least: on a plane they are rounding. A sweep for each length of the steps, in parts of the edges'
  // lengths: each lets neighbors follow one another, and at the same cost of time three sweeps gain more than one with
  // all steps.
  void run(double worth, double least, std::initializer_list<double> parts);

private:
  using Spot = Remeshed_surface::Spot;
  // Those of the input where the middle of an edge of the ring and the center of the triangle beside it were found last
  using Faces = boost::container::small_vector<std::array<Index, 2>, 16>;

  void step(Index v, const Vertex_ring& ring, double part);
  double cost_of_angles(const Vertex_ring& ring, const Spot& spot) const;
  double cost(const Vertex_ring& ring, const Spot& spot, double limit, Faces& faces) const;

  Remeshed_surface& m_remeshed;
  const double m_badness;
  const Deviations m_deviations;
  double m_worth = 0.; // of a squared distance times an area, in cotangents
};

inline double Deviation_relaxation::cost_of_angles(const Vertex_ring& ring, const Spot& spot) const
{
  double sum = 0.;
  Vector a = ring[ring.size() - 1].point - spot.point;
  for(std::size_t i = 0; i < ring.size(); ++i)
  {
    const Vector b = ring[i].point - spot.point;
    sum += std::sqrt(triangle_badness(a.squared_length(), b.squared_length(), (b - a).squared_length(),
                                      cross_product(a, b).squared_length()));
    a = b;
  }
  return sum;
}

// No more than something above the limit where it is above the limit. The deviations are those of the triangles'
// centers and of the middles of the edges, each for the same part of the area. Those of the input's vertices from the
// triangles gained one percent, and would have to be sought beyond the ring.
inline double Deviation_relaxation::cost(const Vertex_ring& ring, const Spot& spot, const double limit,
                                         Faces& faces) const
{
  const std::size_t n = ring.size();
  double sum = cost_of_angles(ring, spot), area = 0.;
  for(std::size_t i = 0; i < n; ++i)
    area += std::sqrt(cross_product(ring[i].point - spot.point, ring[(i + 1) % n].point - spot.point).squared_length());
  const double worth = m_worth * area / static_cast<double>(2 * n);
  for(std::size_t i = 0; i < n && sum <= limit; ++i)
  {
    const Spot &a = ring[i], &b = ring[(i + 1) % n];
    // Beyond that a fold may be another valley of the distance.
    const double large = .1 * CGAL::squared_distance(a.point, spot.point);
    sum += worth * (m_deviations.from_input(CGAL::midpoint(spot.point, a.point), faces[i][0], large, a) +
                    m_deviations.from_input(CGAL::centroid(spot.point, a.point, b.point), faces[i][1], large, a));
  }
  return sum;
}

// Tries ways along the edges, of this part of their lengths.
inline void Deviation_relaxation::step(const Index v, const Vertex_ring& ring, const double part)
{
  const double limit = (std::max)(m_badness, ring.badness());
  const Index face = static_cast<Index>(m_remeshed.spot(v).place.face);
  Faces faces(ring.size(), {{face, face}});
  double best = cost(ring, m_remeshed.spot(v), infinity, faces);
  for(std::size_t i = 0; i < ring.size(); ++i)
  {
    const Spot spot = m_remeshed.spot_after(v, part * (ring[i].point - m_remeshed.spot(v).point));
    if(!(ring.badness(spot, limit) <= limit))
      continue;
    const double c = cost(ring, spot, best, faces);
    if(c < best)
    {
      best = c;
      m_remeshed.put(v, spot);
    }
  }
}

inline void Deviation_relaxation::run(const double worth, const double least, const std::initializer_list<double> parts)
{
  const Lean_triangulation& table = m_remeshed.connectivity();
  std::vector<double> areas(table.face_slots(), 0.), squares(table.face_slots(), 0.);
  parallel_for(m_remeshed.block_size().concurrency, areas.size(), [&](const std::size_t i) {
    const Index f = static_cast<Index>(i);
    if(table.is_removed_face(f))
      return;
    const Point &a = m_remeshed.spot(table.source(4 * f)).point, &b = m_remeshed.spot(table.source(4 * f + 1)).point,
                &c = m_remeshed.spot(table.source(4 * f + 2)).point;
    areas[i] = std::sqrt(cross_product(b - a, c - a).squared_length());
    squares[i] = areas[i] * m_deviations.now({0., false, f});
  });
  const double sum = std::accumulate(squares.begin(), squares.end(), 0.),
               area = std::accumulate(areas.begin(), areas.end(), 0.);
  if(!(sum > area * CGAL::square(least)) || !std::isfinite(sum))
    return;
  const auto number_of_faces = std::count_if(areas.begin(), areas.end(), [](const double x) { return x > 0.; });
  m_worth = worth * static_cast<double>(number_of_faces) / sum; // slots of removed faces count for nothing
  for(const double part : parts)
    for_each_ring(m_remeshed, [&](const Index v, const Vertex_ring& ring) {
      if(!m_remeshed.is_on_line(v))
        step(v, ring, part);
    });
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_RELAXATION_H
