// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATIONS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATIONS_H

#include <CGAL/Geodesic_remeshing/internal/Downhill_search.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/distance_to_ring.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far a triangulation whose vertices are on the surface is from it: the squared distances of the input's vertices
// from the triangles near them, and those of the triangles' centers and of the edges' middles from the input.
class Deviations
{
public:
  using Index = Lean_triangulation::Index;
  using Spot = Remeshed_surface::Spot;

  // At a vertex of the input or at a face of the triangulation
  struct Deviation
  {
    double squared;
    bool is_of_input;
    Index at;
    bool operator<(const Deviation& d) const
    {
      return std::tie(squared, is_of_input, at) < std::tie(d.squared, d.is_of_input, d.at);
    }
  };

  // `nearest` may be that of some steps ago.
  Deviations(const Remeshed_surface& remeshed, const Nearest_vertices& nearest)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_nearest(nearest),
      m_search(remeshed.walker().triangulation(), {&remeshed.walker()}, 0.)
  {}

  std::vector<Deviation> largest(std::size_t number, double least) const; // about so many
  double now(const Deviation& deviation) const
  {
    return deviation.is_of_input ? of_vertex(deviation.at, 0.) : of_face(deviation.at, 0.);
  }
  Index face_near(const Deviation& deviation) const;

  // Of a point from the input. Sought downhill from where a vertex is; what is beyond the limit from where another one
  // is, too: folds have valleys of their own.
  double from_input(const Point& p, const Spot& start) const
  {
    return m_search.run(static_cast<Index>(start.place.face), p, Vector(0., 0., 0.)).nearest.squared_distance;
  }
  // Sought from the face, which is then the one where it is.
  double from_input(const Point& p, Index& face, const double limit, const Spot& other) const
  {
    const auto foot = m_search.run(face, p, Vector(0., 0., 0.));
    face = foot.face;
    const double squared = foot.nearest.squared_distance;
    return squared > limit ? (std::min)(squared, from_input(p, other)) : squared;
  }
  double from_input(const Point& p, const Spot& start, const double limit, const Spot& other) const
  {
    const double squared = from_input(p, start);
    return squared > limit ? (std::min)(squared, from_input(p, other)) : squared;
  }
  const Point& input_point(const Index x) const { return m_remeshed.walker().surface().point(Vertex(x)); }

private:
  static constexpr Index none = Lean_triangulation::none;

  double of_vertex(Index x, double limit) const;
  double of_face(Index f, double limit) const;
  double of_center(Index f, double limit) const;
  double of_middle(Index h, double limit) const; // of the edge
  const Point& point(const Index v) const { return m_remeshed.spot(v).point; }

  const Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const Nearest_vertices& m_nearest;
  const Downhill_search<Point_of_surface> m_search;
};

// The nearest vertex need not be one of the nearest triangle.
inline double Deviations::of_vertex(const Index x, const double limit) const
{
  const Index v = m_nearest.vertex[x];
  double least = squared_distance_to_ring(m_remeshed, input_point(x), v, limit);
  if(least > limit)
    m_table.for_each_neighbor(v, [&](const Index w) {
      if(least > limit)
        least = (std::min)(least, squared_distance_to_ring(m_remeshed, input_point(x), w, limit));
    });
  return least;
}

inline double Deviations::of_face(const Index f, const double limit) const
{
  double result = of_center(f, limit);
  for(Index h = 4 * f; h < 4 * f + 3; ++h)
    result = (std::max)(result, of_middle(h, limit));
  return result;
}

inline double Deviations::of_center(const Index f, const double limit) const
{
  const Spot &u = m_remeshed.spot(m_table.source(4 * f)), &v = m_remeshed.spot(m_table.source(4 * f + 1)),
             &w = m_remeshed.spot(m_table.source(4 * f + 2));
  const Point center = CGAL::centroid(u.point, v.point, w.point);
  const double result = from_input(center, u, limit, v);
  return result > limit ? (std::min)(result, from_input(center, w)) : result;
}

inline double Deviations::of_middle(const Index h, const double limit) const
{
  const Spot &a = m_remeshed.spot(m_table.source(h)), &b = m_remeshed.spot(m_table.target(h));
  return from_input(CGAL::midpoint(a.point, b.point), a, limit, b);
}

// The vertices of the input are asked for no more than whether they are farther than so many faces are: on a fine input
// most are done with after one triangle.
inline std::vector<Deviations::Deviation> Deviations::largest(const std::size_t number, const double least) const
{
  const Concurrency concurrency = m_remeshed.block_size().concurrency;
  std::vector<double> all(m_table.face_slots(), 0.), of_edge(4 * all.size(), 0.); // at one halfedge of each
  parallel_for(concurrency, all.size(), [&](const std::size_t i) {
    const Index f = static_cast<Index>(i);
    for(Index h = 4 * f; h < 4 * f + 3 && !m_table.is_removed_face(f); ++h)
      if(m_table.opposite(h) > h) // as `none` is
        of_edge[h] = of_middle(h, infinity);
  });
  parallel_for(concurrency, all.size(), [&](const std::size_t i) {
    const Index f = static_cast<Index>(i);
    if(m_table.is_removed_face(f))
      return;
    all[f] = of_center(f, infinity);
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      all[f] = (std::max)(all[f], of_edge[(std::min)(h, m_table.opposite(h))]);
  });
  if(all.size() <= number)
    return {};
  std::vector<double> sorted = all;
  std::nth_element(sorted.begin(), sorted.begin() + number, sorted.end(), std::greater<>());
  const double limit = (std::max)(sorted[number], least);
  std::vector<Deviation> result;
  for(Index f = 0; f < all.size(); ++f)
    if(all[f] > limit)
      result.push_back({all[f], false, f});
  const auto is_far = [&](const Index x) {
    return m_nearest.vertex[x] != none && m_nearest.squared_distance[x] > limit && of_vertex(x, limit) > limit;
  };
  for(const Index x : parallel_list(concurrency, m_nearest.vertex.size(), is_far))
    result.push_back({of_vertex(x, 0.), true, x});
  return result;
}

inline Deviations::Index Deviations::face_near(const Deviation& deviation) const
{
  if(!deviation.is_of_input)
    return deviation.at;
  Index nearest = none;
  double least = infinity;
  const auto look_around = [&](const Index v) {
    m_table.for_each_outgoing(v, [&](const Index h) {
      const double distance = nearest_in_triangle(input_point(deviation.at), point(m_table.source(h)),
                                                  point(m_table.target(h)), point(m_table.apex(h)))
                                  .squared_distance;
      if(distance < least)
      {
        least = distance;
        nearest = Lean_triangulation::face(h);
      }
    });
  };
  look_around(m_nearest.vertex[deviation.at]);
  m_table.for_each_neighbor(m_nearest.vertex[deviation.at], look_around);
  return nearest;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATIONS_H
