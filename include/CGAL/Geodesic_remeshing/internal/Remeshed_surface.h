// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REMESHED_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REMESHED_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/Line_walker.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/Nested_blocks.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/Valence_energy.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The triangulation under improvement: its connectivity, and for each vertex its place on the surface with the point
// and the surface's normal there. Vertices move by walking only; so they are on the surface at any time. Those on lines
// slide.
class Remeshed_surface
{
  enum class Hold : char { none, corner, tip, leash };

public:
  using Index = Lean_triangulation::Index;

  struct Spot
  {
    Point point;
    Place place;
    Vector normal;
    double size;
  }; // the size is relative, see Metric

  Remeshed_surface(const Surface_walker& walker, const Constraints& constraints, const Mesh& mesh,
                   const Mesh::Property_map<Vertex, Place>& place, const Mesh::Property_map<Vertex, bool>& pinned,
                   const Mesh::Property_map<Edge, bool>& constrained, Block_size block_size = Block_size());
  Remeshed_surface(const Remeshed_surface&) = delete;
  Remeshed_surface& operator=(const Remeshed_surface&) = delete;

  Block_size block_size() const { return m_block_size; } // for the steps that go over the whole of it
  const Surface_walker& walker() const { return m_walker; }
  const Metric& metric() const { return m_metric; } // of the input
  Lean_triangulation& connectivity() { return m_connectivity; }
  const Lean_triangulation& connectivity() const { return m_connectivity; }
  Valence_energy& energy() { return m_energy; }
  const Valence_energy& energy() const { return m_energy; }

  // A vertex that has to stay where it is; one that may slide if it is not; one that may go anywhere; one that can be
  // sent elsewhere, if it finds good triangles there.
  bool is_fixed(const Index v) const { return m_hold[v] == Hold::corner || m_hold[v] == Hold::tip; }
  bool has_lines() const { return m_has_lines; }
  bool has_features() const { return m_has_features; } // sharp edges, as machine parts have them
  const Line_walker& lines() const { return m_lines; }
  bool keeps_lines() const { return m_keeps_lines; } // all their edges
  bool is_on_line(const Index v) const { return m_has_lines && m_connectivity.is_on_line(v); }
  bool is_free(const Index v) const { return m_hold[v] == Hold::none && !is_on_line(v); }
  bool can_be_sent(const Index v) const { return !is_fixed(v) && !is_on_line(v); }
  bool may_be_at(const Index v, const Spot& spot) const
  {
    return m_hold[v] != Hold::leash ||
           CGAL::squared_distance(spot.point, m_homes[v]) <= CGAL::square(m_leash_length * spot.size);
  }

  const Spot& spot(const Index v) const { return m_spots[v]; }
  void put(const Index v, const Spot& spot)
  {
    if(m_is_recording)
      m_journal.push_back({v, m_spots[v], m_hold[v]});
    m_spots[v] = spot;
  }
  // A new vertex, perhaps in the slot of one that was held
  void put_new(const Index v, const Spot& spot)
  {
    put(v, spot);
    m_hold[v] = Hold::none;
  }
  Spot spot_after(Index v, const Vector& displacement) const;
  Spot spot_at_vertex(Index x) const; // of the input
  Spot spot_on_line(const Place& place) const
  {
    return {m_walker.point(place), place, m_walker.normal_on_line(place), m_metric.size(place)};
  }
  // Tips are pinned, then kept on a leash: a vertex that nothing can move stops the pairs of irregular vertices that
  // glide, one that is free leaves its tip and does not come back. Where nothing else helps they are let go.
  void pin_tip(const Index v) { m_hold[v] = Hold::tip; }
  void keep_tips_on_leash(double length); // times the relative size of the edges
  void let_go(const Index v) { m_hold[v] = m_hold[v] == Hold::corner ? Hold::corner : Hold::none; }
  void reserve_free(Index number_of_splits); // room for so many new vertices

  // A trial: from `record()` on changes can be taken back, until `forget()`, which keeps those that were not.
  struct Mark
  {
    std::size_t connectivity, spots;
  };
  void record()
  {
    m_connectivity.record();
    m_is_recording = true;
  }
  Mark mark() const { return {m_connectivity.mark(), m_journal.size()}; }
  void undo_to(Mark mark);
  void forget();
  // All that changes, for trials of many steps that use records themselves.
  struct State
  {
    Lean_triangulation connectivity;
    std::vector<Spot> spots;
    std::vector<Hold> hold;
    std::vector<Point> homes;
  };
  State state() const { return {m_connectivity, m_spots, m_hold, m_homes}; }
  void restore(const State& state)
  {
    m_connectivity = state.connectivity;
    m_spots = state.spots;
    m_hold = state.hold;
    m_homes = state.homes;
  }

  double badness(Index u, Index v, Index w) const;
  double ring_badness(Index v) const;
  // Whether a triangle with this normal is turned against the mean normal of the surface at its corners: at a crease a
  // single one may point anywhere.
  bool is_turned(const Spot& u, const Spot& v, const Spot& w, const Vector& normal) const
  {
    const double side = normal * (u.normal + v.normal + w.normal);
    return side < 0. || (m_has_lines && !(side > 0.) && is_turned_between_lines({{&u, &v, &w}}, normal));
  }
  template <class Visit>
  void for_each_neighbor_on_line(const Index v, const Visit& visit) const
  {
    m_connectivity.for_each_outgoing(v, [&](const Index h) {
      if(m_connectivity.is_constrained(h))
        visit(m_connectivity.target(h));
      if(m_connectivity.opposite(Lean_triangulation::previous(h)) == Lean_triangulation::none)
        visit(m_connectivity.apex(h));
    });
  }

private:
  struct Change // what was there before
  {
    Index vertex;
    Spot spot;
    Hold hold;
  };

  bool is_turned_between_lines(const std::array<const Spot*, 3>& corners, const Vector& normal) const;

  const Block_size m_block_size;
  const Surface_walker& m_walker;
  const Metric m_metric;
  const Line_walker m_lines;
  const bool m_has_lines, m_has_features, m_keeps_lines;
  Lean_triangulation m_connectivity;
  Valence_energy m_energy;
  std::vector<Spot> m_spots;
  std::vector<Hold> m_hold;
  std::vector<Point> m_homes; // of the vertices on a leash
  double m_leash_length = 0.;
  std::vector<Change> m_journal;
  bool m_is_recording = false;
};

inline Remeshed_surface::Remeshed_surface(const Surface_walker& walker, const Constraints& constraints,
                                          const Mesh& mesh, const Mesh::Property_map<Vertex, Place>& place,
                                          const Mesh::Property_map<Vertex, bool>& pinned,
                                          const Mesh::Property_map<Edge, bool>& constrained,
                                          const Block_size block_size)
  : m_block_size(block_size), m_walker(walker), m_metric(walker.surface()), m_lines(walker, constraints),
    m_has_lines(!m_lines.empty()), m_has_features(constraints.has_features), m_keeps_lines(constraints.are_kept),
    m_connectivity(mesh, [&](const Edge e) { return constrained[e]; }), m_energy(m_connectivity, m_has_lines)
{
  m_spots.resize(mesh.number_of_vertices());
  m_hold.resize(mesh.number_of_vertices());
  parallel_for(block_size.concurrency, m_spots.size(), [&](const std::size_t i) {
    const Vertex v(static_cast<Index>(i));
    // A pinned vertex is a tip or a corner, where the normal of one face says nothing.
    const Vector normal = pinned[v]       ? Vector(0., 0., 0.)
                          : is_on_line(v) ? m_walker.normal_on_line(place[v])
                                          : walker.normal(place[v].face);
    m_spots[i] = {walker.point(place[v]), place[v], normal, m_metric.size(place[v])};
    m_hold[i] = !pinned[v]                                                                 ? Hold::none
                : is_on_line(v) || is_at_corner(m_walker.surface(), constraints, place[v]) ? Hold::corner
                                                                                           : Hold::tip;
  });
  for(Index v = 0; v < m_hold.size(); ++v)
    if(is_fixed(v) && is_on_line(v))
      m_energy.add_corner(v, [&](const Index w) { return m_spots[w].point; });
}

inline Remeshed_surface::Spot Remeshed_surface::spot_after(const Index v, const Vector& displacement) const
{
  if(is_on_line(v))
    return spot_on_line(m_lines.slide(m_spots[v].place, displacement));
  const Place place = m_walker.walk(m_spots[v].place, displacement);
  return {m_walker.point(place), place, m_walker.normal(place.face), m_metric.size(place)};
}

// Such a vertex is sought out as a tip, where the normal of one face says nothing.
inline Remeshed_surface::Spot Remeshed_surface::spot_at_vertex(const Index x) const
{
  const Index h = m_walker.triangulation().halfedge(x);
  Place place{Face(Lean_triangulation::face(h)), {{0., 0., 0.}}};
  place.coordinates[h & 3] = 1.;
  return {m_walker.point(place), place, Vector(0., 0., 0.), m_metric.size(Vertex(x))};
}

inline void Remeshed_surface::keep_tips_on_leash(const double length)
{
  m_leash_length = length;
  m_homes.resize(m_spots.size());
  for(Index v = 0; v < m_hold.size(); ++v)
    if(m_hold[v] == Hold::tip)
    {
      m_hold[v] = Hold::leash;
      m_homes[v] = m_spots[v].point;
    }
}

inline void Remeshed_surface::reserve_free(const Index number_of_splits)
{
  m_connectivity.reserve_free(number_of_splits);
  m_spots.resize(m_connectivity.vertex_slots());
  m_hold.resize(m_connectivity.vertex_slots(), Hold::none);
  m_homes.resize(m_homes.empty() ? 0 : m_connectivity.vertex_slots());
}

inline void Remeshed_surface::undo_to(const Mark mark)
{
  m_connectivity.undo_to(mark.connectivity);
  for(; m_journal.size() > mark.spots; m_journal.pop_back())
  {
    const Change& change = m_journal.back();
    m_spots[change.vertex] = change.spot;
    m_hold[change.vertex] = change.hold;
  }
}

inline void Remeshed_surface::forget()
{
  m_connectivity.forget();
  m_journal.clear();
  m_is_recording = false;
}

inline double Remeshed_surface::badness(const Index u, const Index v, const Index w) const
{
  const Spot &s = m_spots[u], &t = m_spots[v], &r = m_spots[w];
  const Vector a = t.point - s.point, b = r.point - s.point, c = r.point - t.point;
  const Vector normal = cross_product(a, b);
  if(is_turned(s, t, r, normal))
    return turned_badness;
  return triangle_badness(a.squared_length(), b.squared_length(), c.squared_length(), normal.squared_length());
}

// A face between creases is one of a side of each: it is turned if at one of its corners no side looks its way.
inline bool Remeshed_surface::is_turned_between_lines(const std::array<const Spot*, 3>& corners,
                                                      const Vector& normal) const
{
  for(const Spot* spot : corners)
  {
    bool is_seen = false;
    m_walker.for_each_face_at(spot->place,
                              [&](const Face f) { is_seen = is_seen || m_walker.normal(f) * normal > 0.; });
    if(!is_seen)
      return true;
  }
  return false;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#include <CGAL/Geodesic_remeshing/internal/Vertex_ring.h>

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REMESHED_SURFACE_H
