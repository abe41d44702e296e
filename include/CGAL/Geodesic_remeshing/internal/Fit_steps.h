// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_STEPS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_STEPS_H

#include <CGAL/Geodesic_remeshing/internal/Fit_assignment.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_cost.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_ledger.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_probes.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The badness that steps towards the input may make: that of an angle of 31 degrees, one above what is promised
inline double fit_badness()
{
  static const double badness = badness_of_angle(31.);
  return badness;
}

// The steps that bring a triangulation nearer to the input: each moves a vertex, off the surface where it likes, or
// flips an edge, and is taken back unless the deviations around cost less. Vertices on lines slide along them, corners
// stay.
class Fit_steps : public Fit_ledger
{
public:
  Fit_steps(Remeshed_surface& remeshed, Fit_assignment& assignment, Fit_probes& probes, const double edge_length,
            const std::vector<char>& is_frozen)
    : Fit_ledger(remeshed, assignment), m_probes(probes), m_longest_step(.3 * edge_length), m_is_frozen(is_frozen),
      m_is_held(m_table.vertex_slots(), 0)
  {}

  void move_all();
  void flip_all();
  // To the place that the deviations around and, with the weight `pull`, the center of the neighbors ask for
  bool move(Index v, double pull);
  bool flip(Index h);            // if that costs less and makes no bad angle
  void flip_and_search(Index h); // whatever it costs
  Remeshed_surface::Spot spot_at(const Point& p, Index start) const;
  // Nothing changes at frozen vertices, neither their points nor the faces between them. They are never removed.
  bool is_frozen(const Index v) const { return v < m_is_frozen.size() && m_is_frozen[v]; }
  bool is_edge_frozen(Index h) const;
  void hold(const Index v) // from now on it moves on the surface only
  {
    m_is_held.resize(m_table.vertex_slots(), 0); // relocation may have made slots
    m_is_held[v] = 1;
  }

  // More pull makes better triangles and a larger RMS distance. Of .02, .04, .06 and .08 on seven models the mean of
  // the smallest angles was 48.4, 49.7, 50.4 and 50.9 degrees, the RMS distance .63, .69, .72 and .76 of the best of
  // other remeshers.
  static constexpr double usual_pull = .06;

private:
  bool is_held(const Index v) const { return v < m_is_held.size() && m_is_held[v]; }
  Vector wished_step(Index v, const Vector& normal, const Vector& way, double pull);
  double flip_cost(Index h);
  bool is_flip_possible(Index h) const;

  Fit_probes& m_probes;
  const double m_longest_step;
  const std::vector<char>& m_is_frozen;
  std::vector<char> m_is_held;
};

inline Remeshed_surface::Spot Fit_steps::spot_at(const Point& p, const Index start) const
{
  const Fit_probes::Foot foot = m_probes.nearest(p, start);
  const Place place{Face(foot.face), foot.nearest.coordinates};
  return {p, place, m_remeshed.walker().normal(place.face), m_remeshed.metric().size(place)};
}

inline Vector Fit_steps::wished_step(const Index v, const Vector& normal, const Vector& way, const double pull)
{
  Fit_system system;
  system.add_in_plane(way, normal, pull);
  // Where the deviations say nothing, as where there are none, the vertex stays.
  system.xx += 1e-3 * pull;
  system.yy += 1e-3 * pull;
  system.zz += 1e-3 * pull;
  for(const Index i : m_gathered)
  {
    const Fit_assignment::Foot foot = m_assignment.foot(i);
    const Index h = 4 * foot.face;
    const auto& c = foot.nearest.coordinates;
    system.add(foot.nearest, 1., m_assignment.sample(i).weight * m_cost.weight(foot),
               m_table.source(h) == v       ? c[0]
               : m_table.source(h + 1) == v ? c[1]
                                            : c[2]);
  }
  m_probes.add_ring(v, m_cost, system);
  return system.least();
}

inline bool Fit_steps::move(const Index v, const double pull)
{
  if(is_frozen(v))
    return false;
  const Remeshed_surface::Spot old = m_remeshed.spot(v);
  Vector sum(0., 0., 0.);
  m_table.for_each_outgoing(v, [&](const Index h) {
    sum = sum + cross_product(m_remeshed.spot(m_table.target(h)).point - old.point,
                              m_remeshed.spot(m_table.apex(h)).point - old.point);
  });
  const double size = std::sqrt(sum.squared_length()), weight = pull * size / 6.; // a third of the area around
  if(!(size > 0.))
    return false;
  gather_ring(v);
  const Vertex_ring ring(m_remeshed, v);
  const Vector normal = sum / size, way = ring.way_to_center();
  Vector step = wished_step(v, normal, way, weight);
  const double length = std::sqrt(step.squared_length()), longest = m_longest_step * old.size;
  if(!(length > 1e-3 * longest))
    return false;
  if(length > longest)
    step = longest / length * step;
  const auto pulling = [&](const Vector& rest) {
    return weight * (rest.squared_length() - CGAL::square(rest * normal));
  };
  const double before = gathered_cost() + pulling(way) + m_probes.ring_cost(v, m_cost, infinity);
  const double limit = (std::max)(fit_badness(), ring.badness());
  for(int trial = 0; trial < 4; ++trial, step = .4 * step)
  {
    const Remeshed_surface::Spot spot = m_remeshed.is_on_line(v) || is_held(v)
                                            ? m_remeshed.spot_after(v, step)
                                            : spot_at(old.point + step, old.place.face);
    if(ring.badness(spot, limit) > limit)
      continue;
    m_remeshed.put(v, spot);
    double rest = before - pulling(way - (spot.point - old.point));
    rest -= m_probes.ring_cost(v, m_cost, rest);
    if(rest > 0. && search_gathered(rest) < rest)
    {
      assign_gathered();
      return true;
    }
    m_remeshed.put(v, old);
  }
  return false;
}

inline bool Fit_steps::is_flip_possible(const Index h) const
{
  const Index o = m_table.opposite(h);
  if(o == Lean_triangulation::none || !m_table.is_flip_legal(h) || is_edge_frozen(h))
    return false;
  const Index a = m_table.source(h), b = m_table.target(h), c = m_table.apex(h), d = m_table.apex(o);
  const double after = add_badness(m_remeshed.badness(a, d, c), m_remeshed.badness(b, c, d));
  return after <= fit_badness() || after <= add_badness(m_remeshed.badness(a, b, c), m_remeshed.badness(b, a, d));
}

// One of the vertices of the faces beside an edge is
inline bool Fit_steps::is_edge_frozen(const Index h) const
{
  const Index o = m_table.opposite(h);
  return is_frozen(m_table.source(h)) || is_frozen(m_table.target(h)) || is_frozen(m_table.apex(h)) ||
         (o != Lean_triangulation::none && is_frozen(m_table.apex(o)));
}

inline double Fit_steps::flip_cost(const Index h)
{
  return m_probes.face_cost(Lean_triangulation::face(h), m_cost) +
         m_probes.face_cost(Lean_triangulation::face(m_table.opposite(h)), m_cost);
}

inline void Fit_steps::flip_and_search(const Index h)
{
  gather(std::array<Index, 2>{{Lean_triangulation::face(h), Lean_triangulation::face(m_table.opposite(h))}});
  m_table.flip(h);
  search_gathered(infinity);
  assign_gathered();
}

inline bool Fit_steps::flip(const Index h)
{
  if(!is_flip_possible(h))
    return false;
  gather(std::array<Index, 2>{{Lean_triangulation::face(h), Lean_triangulation::face(m_table.opposite(h))}});
  constexpr double gain_of_energy = .05;
  double rest = gathered_cost() + flip_cost(h);
  // What makes valences less regular must gain by it: without, twice as many vertices are irregular for 2 percent of
  // the distance.
  rest -= gain_of_energy * m_remeshed.energy().of_flip(h) * rest;
  m_remeshed.record();
  const Remeshed_surface::Mark mark = m_remeshed.mark();
  const Index k = m_table.flip(h);
  rest -= flip_cost(k);
  const bool is_better = rest > 0. && search_gathered(rest) < rest;
  if(is_better)
    assign_gathered();
  else
    m_remeshed.undo_to(mark);
  if(!m_is_trial)
    m_remeshed.forget();
  return is_better;
}

inline void Fit_steps::move_all()
{
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
    if(!m_table.is_removed(v) && !m_remeshed.is_fixed(v))
      move(v, usual_pull);
  m_assignment.search_all();
}

inline void Fit_steps::flip_all()
{
  for(Index h = 0; h < 4 * m_table.face_slots(); ++h)
    if((h & 3) != 3 && !m_table.is_removed_face(Lean_triangulation::face(h)) && h < m_table.opposite(h))
      flip(h);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_STEPS_H
