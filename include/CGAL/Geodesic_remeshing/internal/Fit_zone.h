// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ZONE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ZONE_H

#include <CGAL/Geodesic_remeshing/internal/Fit_probes.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_steps.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What the removal or insertion of a vertex touches: the faces around some vertices and their neighbors, which settle
// after it, and whether they are better for it.
class Fit_zone
{
public:
  using Index = Lean_triangulation::Index;

  Fit_zone(Remeshed_surface& remeshed, Fit_probes& probes, Fit_steps& steps)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_probes(probes), m_steps(steps)
  {}

  void mark(std::initializer_list<Index> centers); // before the change
  void add_face(const Index f) { m_faces.push_back(f); }
  void add_vertex(const Index v) { m_vertices.push_back(v); }
  void settle();
  double change_since(double change_before);
  bool is_good() const { return current_badness() <= m_badness; }

private:
  double current_cost();
  double current_badness() const;
  void regularize(Index v);

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  Fit_probes& m_probes;
  Fit_steps& m_steps;
  std::vector<Index> m_vertices, m_faces, m_spokes;
  double m_cost = 0., m_badness = 0.;
};

inline double Fit_zone::current_cost()
{
  double sum = 0.;
  for(const Index f : m_faces)
    if(!m_table.is_removed_face(f))
      sum += m_probes.face_cost(f, m_steps.cost());
  return sum;
}

inline double Fit_zone::current_badness() const
{
  double worst = 0.;
  for(const Index f : m_faces)
    if(!m_table.is_removed_face(f))
      worst = add_badness(
          worst, m_remeshed.badness(m_table.source(4 * f), m_table.source(4 * f + 1), m_table.source(4 * f + 2)));
  return worst;
}

// Some vertices, their neighbors and the faces around all of them
inline void Fit_zone::mark(const std::initializer_list<Index> centers)
{
  const auto make_unique = [](std::vector<Index>& x) {
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());
  };
  m_vertices.assign(centers);
  for(const Index v : centers)
    m_table.for_each_neighbor(v, [&](const Index w) { m_vertices.push_back(w); });
  make_unique(m_vertices);
  m_faces.clear();
  for(const Index v : m_vertices)
    m_table.for_each_outgoing(v, [&](const Index h) { m_faces.push_back(Lean_triangulation::face(h)); });
  make_unique(m_faces);
  m_cost = current_cost();
  m_badness = (std::max)(fit_badness(), current_badness());
}

inline double Fit_zone::change_since(const double change_before)
{
  return m_steps.change() - change_before + current_cost() - m_cost;
}

inline void Fit_zone::regularize(const Index v)
{
  m_spokes.clear();
  m_table.for_each_outgoing(v, [&](const Index h) { m_spokes.push_back(h); });
  for(const Index h : m_spokes)
    // a flip before may have made another edge of it
    if(m_table.source(h) == v && !m_table.is_constrained(h) && !m_steps.is_edge_frozen(h) &&
       is_flip_better(m_remeshed, h))
      m_steps.flip_and_search(h);
}

// First for the valences and the angles, which the change has spoilt, then for the deviations.
inline void Fit_zone::settle()
{
  constexpr double strong_pull = .5;
  const auto move_each = [&](const double pull) {
    for(const Index v : m_vertices)
      if(!m_table.is_removed(v) && !m_remeshed.is_fixed(v))
        m_steps.move(v, pull);
  };
  for(int round = 0; round < 2; ++round)
  {
    for(const Index v : m_vertices)
      if(!m_table.is_removed(v))
        regularize(v);
    move_each(strong_pull);
  }
  for(const Index f : m_faces)
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      if(!m_table.is_removed_face(f))
        m_steps.flip(h);
  for(int round = 0; round < 2; ++round)
    move_each(Fit_steps::usual_pull);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ZONE_H
