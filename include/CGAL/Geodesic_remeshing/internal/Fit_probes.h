// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_PROBES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_PROBES_H

#include <CGAL/Geodesic_remeshing/internal/Downhill_search.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_cost.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far the triangulation is from the input: at the centers of faces, the middles of edges and the vertices. Without
// them a face that spans a hollow costs nothing, as no sample of the input is near it. Of each is kept where on the
// input it was nearest to last: there the next search starts.
class Fit_probes
{
public:
  using Index = Lean_triangulation::Index;
  using Search = Downhill_search<Point_of_surface>;
  using Foot = Search::Foot;
  static constexpr Index none = Lean_triangulation::none;

  Fit_probes(const Remeshed_surface& remeshed, const double penalty)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()),
      m_search(remeshed.walker().triangulation(), {&remeshed.walker()}, penalty)
  {
    grow();
  }

  void grow()
  {
    m_center.resize(m_table.face_slots(), none);
    m_middle.resize(4 * m_table.face_slots(), none);
  }
  void forget(const Index f) // it is another face now
  {
    m_center[f] = none;
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      m_middle[h] = none;
  }

  Foot at_center(Index f);
  Foot at_middle(Index h);
  Foot at_vertex(const Index v) const { return nearest(point(v), m_remeshed.spot(v).place.face); }
  Foot nearest(const Point& p, const Index start) const { return m_search.run(start, p, Vector(0., 0., 0.)); }

  // What the deviations at a face cost, its share of those on its edges and corners included.
  double face_cost(Index f, const Fit_cost& cost);
  // The same of what a vertex changes when it moves; no more than something above the limit where it is above the
  // limit.
  double ring_cost(Index v, const Fit_cost& cost, double limit);
  void add_ring(Index v, const Fit_cost& cost, Fit_system& system);
  double largest_squared_distance(Index f);

private:
  // Parts of a face's area; that of an edge or a corner from each of the faces there.
  static constexpr double center_share = .4, middle_share = .2, corner_share = .1;

  const Point& point(const Index v) const { return m_remeshed.spot(v).point; }
  Vector normal(const Index f) const
  {
    const Point& p = point(m_table.source(4 * f));
    return cross_product(point(m_table.source(4 * f + 1)) - p, point(m_table.source(4 * f + 2)) - p);
  }
  double area(const Index f) const { return .5 * std::sqrt(normal(f).squared_length()); }
  template <std::size_t n>
  Foot search(Index& start, const std::array<Index, n>& corners, const Point& p, const Vector& normal) const;

  const Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const Search m_search;
  std::vector<Index> m_center, m_middle; // faces of the input
};

// From where it was found last. What is far from there is also sought from where the corners are: beside an edge of the
// input the way may lead into another valley of the distance.
template <std::size_t n>
Fit_probes::Foot Fit_probes::search(Index& start, const std::array<Index, n>& corners, const Point& p,
                                    const Vector& normal) const
{
  constexpr double large = .05; // of the squared length of an edge
  const auto from = [&](const Index f) { return m_search.run(f, p, normal); };
  const auto place = [&](const Index v) { return Index(m_remeshed.spot(v).place.face); };
  Foot best = from(start == none ? place(corners[0]) : start);
  if(best.judged_distance > large * CGAL::squared_distance(point(corners[0]), point(corners[1])))
    for(const Index v : corners)
    {
      const Foot foot = from(place(v));
      if(foot.judged_distance < best.judged_distance)
        best = foot;
    }
  start = best.face;
  return best;
}

inline Fit_probes::Foot Fit_probes::at_center(const Index f)
{
  const Index u = m_table.source(4 * f), v = m_table.source(4 * f + 1), w = m_table.source(4 * f + 2);
  return search(m_center[f], std::array<Index, 3>{{u, v, w}}, CGAL::centroid(point(u), point(v), point(w)), normal(f));
}

inline Fit_probes::Foot Fit_probes::at_middle(const Index h)
{
  const Index o = m_table.opposite(h), v = m_table.source(h), w = m_table.target(h);
  Vector sum = normal(Lean_triangulation::face(h));
  if(o != none)
    sum = sum + normal(Lean_triangulation::face(o));
  return search(m_middle[o == none || h < o ? h : o], std::array<Index, 2>{{v, w}}, CGAL::midpoint(point(v), point(w)),
                sum);
}

inline double Fit_probes::face_cost(const Index f, const Fit_cost& cost)
{
  double sum = center_share * cost(at_center(f));
  for(Index h = 4 * f; h < 4 * f + 3; ++h)
    sum += middle_share * cost(at_middle(h)) + corner_share * cost(at_vertex(m_table.source(h)));
  return area(f) * sum;
}

inline double Fit_probes::ring_cost(const Index v, const Fit_cost& cost, const double limit)
{
  const double at_corner = corner_share * cost(at_vertex(v));
  const Index first = m_table.halfedge(v);
  double sum = 0.;
  Index h = first;
  do
  {
    const Index f = Lean_triangulation::face(h);
    sum += area(f) * (at_corner + center_share * cost(at_center(f)) + 2. * middle_share * cost(at_middle(h)));
    h = m_table.rotate(h);
  } while(h != first && h != none && sum <= limit);
  return sum;
}

inline void Fit_probes::add_ring(const Index v, const Fit_cost& cost, Fit_system& system)
{
  double sum = 0.;
  m_table.for_each_outgoing(v, [&](const Index h) {
    const Index f = Lean_triangulation::face(h);
    const double size = area(f);
    const Foot center = at_center(f), middle = at_middle(h);
    system.add(center.nearest, -1., center_share * size * cost.weight(center), 1. / 3.);
    system.add(middle.nearest, -1., 2. * middle_share * size * cost.weight(middle), 1. / 2.);
    sum += size;
  });
  const Foot here = at_vertex(v);
  system.add(here.nearest, -1., corner_share * sum * cost.weight(here), 1.);
}

inline double Fit_probes::largest_squared_distance(const Index f)
{
  double largest = at_center(f).nearest.squared_distance;
  for(Index h = 4 * f; h < 4 * f + 3; ++h)
    largest = (std::max)(
        {largest, at_middle(h).nearest.squared_distance, at_vertex(m_table.source(h)).nearest.squared_distance});
  return largest;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_PROBES_H
