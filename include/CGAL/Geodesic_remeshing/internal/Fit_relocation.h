// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_RELOCATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_RELOCATION_H

#include <CGAL/Geodesic_remeshing/internal/Fit_assignment.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_probes.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_steps.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_zone.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Takes vertices out where they are needed least and puts as many in where steps alone do not help: at tips and in
// hollows that are narrower than the triangles. A vertex in and one out are one trial, so that their number never
// changes.
class Fit_relocation
{
public:
  using Index = Lean_triangulation::Index;

  Fit_relocation(Remeshed_surface& remeshed, Fit_assignment& assignment, Fit_probes& probes, Fit_steps& steps)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_assignment(assignment), m_probes(probes),
      m_steps(steps), m_zone(remeshed, probes, steps)
  {}

  // For the faces that deviate by more than `deviation`, those first that cost most. Returns the number of vertices
  // relocated.
  std::size_t run(double deviation);

  double largest_deviation();

private:
  struct Item
  {
    double cost;
    Index at;
  };

  double largest_deviation(Index f);
  double cost(Index f);
  void rank();
  bool split(Index h, double& change);
  bool split_an_edge(Index f, double& change);
  bool collapse(Index v, double& change);
  bool collapse_next(double gain);
  bool collapse_a_corner(Index f, double& change);
  bool split_next(double gain, double deviation);

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  Fit_assignment& m_assignment;
  Fit_probes& m_probes;
  Fit_steps& m_steps;
  std::vector<Item> m_faces, m_vertices; // the most costly faces first, the least costly vertices first
  std::size_t m_next_vertex = 0, m_next_face = 0;
  Fit_zone m_zone;
};

inline double Fit_relocation::largest_deviation(const Index f)
{
  double largest = m_probes.largest_squared_distance(f);
  m_assignment.for_each_sample_of(
      f, [&](const Index i) { largest = (std::max)(largest, m_assignment.assigned(i).squared_distance); });
  return std::sqrt(largest);
}

inline double Fit_relocation::largest_deviation()
{
  double largest = 0.;
  for(Index f = 0; f < m_table.face_slots(); ++f)
    if(!m_table.is_removed_face(f))
      largest = (std::max)(largest, largest_deviation(f));
  return largest;
}

inline double Fit_relocation::cost(const Index f)
{
  double sum = m_probes.face_cost(f, m_steps.cost());
  m_assignment.for_each_sample_of(f, [&](const Index i) { sum += m_steps.sample_cost(i); });
  return sum;
}

inline void Fit_relocation::rank()
{
  m_faces.clear();
  m_vertices.clear();
  m_next_vertex = m_next_face = 0;
  std::vector<double> costs(m_table.face_slots(), 0.);
  for(Index f = 0; f < m_table.face_slots(); ++f)
    if(!m_table.is_removed_face(f))
    {
      costs[f] = cost(f);
      m_faces.push_back({costs[f], f});
    }
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
    if(!m_table.is_removed(v) && m_remeshed.is_free(v))
    {
      double sum = 0.;
      m_table.for_each_outgoing(v, [&](const Index h) { sum += costs[Lean_triangulation::face(h)]; });
      m_vertices.push_back({sum, v});
    }
  std::sort(m_faces.begin(), m_faces.end(),
            [](const Item& x, const Item& y) { return std::tie(y.cost, x.at) < std::tie(x.cost, y.at); });
  std::sort(m_vertices.begin(), m_vertices.end(),
            [](const Item& x, const Item& y) { return std::tie(x.cost, x.at) < std::tie(y.cost, y.at); });
}

inline bool Fit_relocation::split(const Index h, double& change)
{
  const Index o = m_table.opposite(h);
  if(o == Lean_triangulation::none || m_table.is_constrained(h) || m_steps.is_edge_frozen(h))
    return false;
  const Index a = m_table.source(h), b = m_table.target(h), f = Lean_triangulation::face(h),
              g = Lean_triangulation::face(o);
  m_zone.mark({a, b, m_table.apex(h), m_table.apex(o)});
  const double before = m_steps.change();
  m_steps.gather(std::array<Index, 2>{{f, g}});
  const Remeshed_surface::Spot spot = m_steps.spot_at(
      CGAL::midpoint(m_remeshed.spot(a).point, m_remeshed.spot(b).point), m_remeshed.spot(a).place.face);
  const Index w = m_table.split_edge(h);
  m_remeshed.put_new(w, spot);
  m_table.for_each_outgoing(w, [&](const Index k) {
    const Index x = Lean_triangulation::face(k);
    if(x != f && x != g)
    {
      m_zone.add_face(x);
      m_probes.forget(x);
    }
  });
  m_steps.search_gathered(infinity);
  m_steps.assign_gathered();
  m_zone.add_vertex(w);
  m_zone.settle();
  change = m_zone.change_since(before);
  return m_zone.is_good();
}

// Onto the nearest neighbor that it may become one with.
inline bool Fit_relocation::collapse(const Index v, double& change)
{
  Index h = Lean_triangulation::none;
  double least = infinity;
  bool is_frozen = m_steps.is_frozen(v);
  m_table.for_each_neighbor(v, [&](const Index w) { is_frozen = is_frozen || m_steps.is_frozen(w); });
  if(is_frozen)
    return false;
  m_table.for_each_outgoing(v, [&](const Index k) {
    const double distance = CGAL::squared_distance(m_remeshed.spot(v).point, m_remeshed.spot(m_table.target(k)).point);
    if(distance < least && m_table.is_collapse_legal(m_table.opposite(k)))
    {
      least = distance;
      h = m_table.opposite(k);
    }
  });
  if(h == Lean_triangulation::none)
    return false;
  m_zone.mark({v});
  const double before = m_steps.change();
  const Index o = m_table.opposite(h);
  m_assignment.move_samples(Lean_triangulation::face(h),
                            Lean_triangulation::face(m_table.opposite(Lean_triangulation::next(h))));
  m_assignment.move_samples(Lean_triangulation::face(o),
                            Lean_triangulation::face(m_table.opposite(Lean_triangulation::previous(o))));
  m_steps.gather_ring(v);
  m_table.collapse(h);
  m_steps.search_gathered(infinity);
  m_steps.assign_gathered();
  m_zone.settle();
  change = m_zone.change_since(before);
  return m_zone.is_good();
}

inline bool Fit_relocation::split_an_edge(const Index f, double& change)
{
  std::array<Index, 3> edges = {{4 * f, 4 * f + 1, 4 * f + 2}};
  const auto length = [&](const Index h) {
    return CGAL::squared_distance(m_remeshed.spot(m_table.source(h)).point, m_remeshed.spot(m_table.target(h)).point);
  };
  std::sort(edges.begin(), edges.end(), [&](const Index x, const Index y) {
    return std::make_pair(-length(x), x) < std::make_pair(-length(y), y);
  });
  const Fit_steps::Mark mark = m_steps.mark();
  for(const Index h : edges)
  {
    if(split(h, change) && change < 0.)
      return true;
    m_steps.undo_to(mark);
  }
  return false;
}

// Takes out the first of the next few vertices that costs less than was gained.
inline bool Fit_relocation::collapse_next(const double gain)
{
  constexpr int trials = 4;
  const Fit_steps::Mark mark = m_steps.mark();
  for(int trial = 0; trial < trials; ++trial)
  {
    while(m_next_vertex < m_vertices.size() && m_table.is_removed(m_vertices[m_next_vertex].at))
      ++m_next_vertex;
    if(m_next_vertex == m_vertices.size())
      return false;
    double loss;
    if(collapse(m_vertices[m_next_vertex++].at, loss) && loss < gain)
      return true;
    m_steps.undo_to(mark);
  }
  return false;
}

inline bool Fit_relocation::collapse_a_corner(const Index f, double& change)
{
  const std::array<Index, 3> corners = {{m_table.source(4 * f), m_table.source(4 * f + 1), m_table.source(4 * f + 2)}};
  const Fit_steps::Mark mark = m_steps.mark();
  for(const Index v : corners)
  {
    if(m_remeshed.is_free(v) && collapse(v, change) && change < 0.)
      return true;
    m_steps.undo_to(mark);
  }
  return false;
}

// Puts a vertex in at one of the next few faces that do not deviate so much.
inline bool Fit_relocation::split_next(const double gain, const double deviation)
{
  constexpr int trials = 4;
  const Fit_steps::Mark mark = m_steps.mark();
  for(int trial = 0; trial < trials && m_next_face < m_faces.size(); ++m_next_face)
  {
    const Index f = m_faces[m_next_face].at;
    if(m_table.is_removed_face(f) || largest_deviation(f) > deviation)
      continue;
    ++trial;
    double loss;
    if(split_an_edge(f, loss) && loss < gain)
    {
      ++m_next_face;
      return true;
    }
    m_steps.undo_to(mark);
  }
  return false;
}

inline std::size_t Fit_relocation::run(const double deviation)
{
  rank();
  m_remeshed.reserve_free(1);
  m_assignment.grow();
  m_probes.grow();
  std::size_t number = 0;
  for(const Item& item : m_faces)
  {
    // What was done for a face may have served its neighbors too.
    if(m_table.is_removed_face(item.at) || largest_deviation(item.at) < deviation || cost(item.at) < .5 * item.cost)
      continue;
    m_steps.begin_trial();
    const Fit_steps::Mark start = m_steps.mark();
    double change;
    bool is_done = split_an_edge(item.at, change) && collapse_next(-change);
    if(!is_done)
    {
      // Where vertices crowd, at the rim of a thin sheet or in a narrow fillet, their angles keep them from where they
      // should be.
      m_steps.undo_to(start);
      is_done = collapse_a_corner(item.at, change) && split_next(-change, deviation);
    }
    if(is_done)
      ++number;
    else
      m_steps.undo_to(start);
    m_steps.end_trial();
  }
  m_assignment.search_all();
  return number;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_RELOCATION_H
