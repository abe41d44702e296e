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
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/Valence_energy.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/internal/working_surface.h>

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
public:
  using Index = Lean_triangulation::Index;

  struct Spot { Point point; Place place; Vector normal; double size; };   // the size is relative, see Metric

  Remeshed_surface(const Surface_walker& walker, const Constraints& constraints, const Mesh& mesh,
                   const Mesh::Property_map<Vertex, Place>& place, const Mesh::Property_map<Vertex, bool>& pinned,
                   const Mesh::Property_map<Edge, bool>& constrained);
  Remeshed_surface(const Remeshed_surface&) = delete;
  Remeshed_surface& operator=(const Remeshed_surface&) = delete;

  const Surface_walker& walker() const { return walker_; }
  const Metric& metric() const { return metric_; }         // of the input
  Lean_triangulation& connectivity() { return connectivity_; }
  const Lean_triangulation& connectivity() const { return connectivity_; }
  Valence_energy& energy() { return energy_; }
  const Valence_energy& energy() const { return energy_; }

  // A vertex that has to stay where it is; one that may slide if it is not; one that may go anywhere; one that can be sent
  // elsewhere, if it finds good triangles there.
  bool is_fixed(const Index v) const { return hold_[v] == Hold::corner || hold_[v] == Hold::tip; }
  bool has_lines() const { return has_lines_; }
  const Line_walker& lines() const { return lines_; }
  bool keeps_lines() const { return keeps_lines_; } // all their edges
  bool is_on_line(const Index v) const { return has_lines_ && connectivity_.is_on_line(v); }
  bool is_free(const Index v) const { return hold_[v] == Hold::none && !is_on_line(v); }
  bool can_be_sent(const Index v) const { return !is_fixed(v) && !is_on_line(v); }
  bool may_be_at(const Index v, const Spot& spot) const
  {
    return hold_[v] != Hold::leash ||
           CGAL::squared_distance(spot.point, homes_[v]) <= CGAL::square(leash_length_ * spot.size);
  }

  const Spot& spot(const Index v) const { return spots_[v]; }
  void put(const Index v, const Spot& spot)
  {
    if(is_recording_)
      journal_.push_back({v, spots_[v]});
    spots_[v] = spot;
  }
  Spot spot_after(Index v, const Vector& displacement) const;
  Spot spot_at_vertex(Index x) const;           // of the input
  Spot spot_on_line(const Place& place) const
  {
    return {walker_.point(place), place, walker_.normal_on_line(place), metric_.size(place)};
  }
  bool find_middle(Index h, Spot& middle) const;  // of an edge, on its line if it is on one
  // Tips are pinned, then kept on a leash: a vertex that nothing can move stops the pairs of irregular vertices that glide,
  // one that is free leaves its tip and does not come back. Where nothing else helps they are let go.
  void pin_tip(const Index v) { hold_[v] = Hold::tip; }
  void keep_tips_on_leash(double length);       // times the relative size of the edges
  void let_go(const Index v) { hold_[v] = hold_[v] == Hold::corner ? Hold::corner : Hold::none; }
  void reserve_free(Index number_of_splits);     // room for so many new vertices

  // A trial: from `record()` on changes can be taken back, until `forget()`, which keeps those that were not.
  struct Mark { std::size_t connectivity, spots; };
  void record() { connectivity_.record(); is_recording_ = true; }
  Mark mark() const { return {connectivity_.mark(), journal_.size()}; }
  void undo_to(Mark mark);
  void forget();

  double badness(Index u, Index v, Index w) const;
  double ring_badness(const Index v) const { return ring_badness(v, spots_[v], infinity); }
  // That of the ring if its center were at `spot`, turned where it may not be; no more than something above the limit where it is above the limit.
  double ring_badness(Index v, const Spot& spot, double limit) const;
  Vector way_to_center_of_neighbors(Index v) const;
  template <class Visit> void for_each_neighbor_on_line(const Index v, const Visit& visit) const
  {
    connectivity_.for_each_outgoing(v, [&](const Index h) {
      if(connectivity_.is_constrained(h))
        visit(connectivity_.target(h));
      if(connectivity_.opposite(Lean_triangulation::previous(h)) == Lean_triangulation::none)
        visit(connectivity_.apex(h));
    });
  }

private:
  enum class Hold : char { none, corner, tip, leash };

  bool is_turned(const Spot& u, const Spot& v, const Spot& w, const Vector& normal) const
  {
    // Against the mean normal: at a crease a single one may point anywhere.
    const double side = normal * (u.normal + v.normal + w.normal);
    return side < 0. || (has_lines_ && !(side > 0.) && is_turned_between_lines({{&u, &v, &w}}, normal));
  }
  bool is_turned_between_lines(const std::array<const Spot*, 3>& corners, const Vector& normal) const;

  const Surface_walker& walker_;
  const Metric metric_;
  const Line_walker lines_;
  const bool has_lines_, keeps_lines_;
  Lean_triangulation connectivity_;
  Valence_energy energy_;
  std::vector<Spot> spots_;
  std::vector<Hold> hold_;
  std::vector<Point> homes_;                    // of the vertices on a leash
  double leash_length_ = 0.;
  std::vector<std::pair<Index, Spot>> journal_;
  bool is_recording_ = false;
};

inline Remeshed_surface::Remeshed_surface(const Surface_walker& walker, const Constraints& constraints,
                                          const Mesh& mesh, const Mesh::Property_map<Vertex, Place>& place,
                                          const Mesh::Property_map<Vertex, bool>& pinned,
                                          const Mesh::Property_map<Edge, bool>& constrained)
  : walker_(walker), metric_(walker.surface()), lines_(walker, constraints), has_lines_(!lines_.empty())
  , keeps_lines_(constraints.are_kept)
  , connectivity_(mesh, [&](const Edge e) { return constrained[e]; }), energy_(connectivity_, has_lines_)
{
  spots_.reserve(mesh.number_of_vertices());
  hold_.reserve(mesh.number_of_vertices());
  for(const Vertex v : mesh.vertices()) {
    // A pinned vertex is a tip or a corner, where the normal of one face says nothing.
    const Vector normal = pinned[v] ? Vector(0., 0., 0.)
                        : is_on_line(v) ? walker_.normal_on_line(place[v]) : walker.normal(place[v].face);
    spots_.push_back({walker.point(place[v]), place[v], normal, metric_.size(place[v])});
    hold_.push_back(!pinned[v] ? Hold::none : is_on_line(v) || is_at_corner(walker_.surface(), constraints, place[v]) ? Hold::corner : Hold::tip);
  }
  for(Index v = 0; v < hold_.size(); ++v)
    if(is_fixed(v) && is_on_line(v))
      energy_.add_corner(v, [&](const Index w) { return spots_[w].point; });
}

inline Remeshed_surface::Spot Remeshed_surface::spot_after(const Index v, const Vector& displacement) const
{
  if(is_on_line(v))
    return spot_on_line(lines_.slide(spots_[v].place, displacement));
  const Place place = walker_.walk(spots_[v].place, displacement);
  return {walker_.point(place), place, walker_.normal(place.face), metric_.size(place)};
}

// Such a vertex is sought out as a tip, where the normal of one face says nothing.
inline Remeshed_surface::Spot Remeshed_surface::spot_at_vertex(const Index x) const
{
  const Index h = walker_.triangulation().halfedge(x);
  Place place{Face(Lean_triangulation::face(h)), {{0., 0., 0.}}};
  place.coordinates[h & 3] = 1.;
  return {walker_.point(place), place, Vector(0., 0., 0.), metric_.size(Vertex(x))};
}

inline void Remeshed_surface::keep_tips_on_leash(const double length)
{
  leash_length_ = length;
  homes_.resize(spots_.size());
  for(Index v = 0; v < hold_.size(); ++v)
    if(hold_[v] == Hold::tip) {
      hold_[v] = Hold::leash;
      homes_[v] = spots_[v].point;
    }
}

inline void Remeshed_surface::reserve_free(const Index number_of_splits)
{
  connectivity_.reserve_free(number_of_splits);
  spots_.resize(connectivity_.vertex_slots());
  hold_.resize(connectivity_.vertex_slots(), Hold::none);
  homes_.resize(homes_.empty() ? 0 : connectivity_.vertex_slots());
}

inline void Remeshed_surface::undo_to(const Mark mark)
{
  connectivity_.undo_to(mark.connectivity);
  for(; journal_.size() > mark.spots; journal_.pop_back())
    spots_[journal_.back().first] = journal_.back().second;
}

inline void Remeshed_surface::forget()
{
  connectivity_.forget();
  journal_.clear();
  is_recording_ = false;
}

inline double Remeshed_surface::badness(const Index u, const Index v, const Index w) const
{
  const Spot &s = spots_[u], &t = spots_[v], &r = spots_[w];
  const Vector a = t.point - s.point, b = r.point - s.point, c = r.point - t.point;
  const Vector normal = cross_product(a, b);
  if(is_turned(s, t, r, normal))
    return turned_badness;
  return triangle_badness(a.squared_length(), b.squared_length(), c.squared_length(), normal.squared_length());
}

// As `badness()` of each triangle; but what one shares with the next is computed once: of all that is asked here this
// is asked most often.
inline double Remeshed_surface::ring_badness(const Index v, const Spot& spot, const double limit) const
{
  const Index first = connectivity_.halfedge(v);
  const Spot* last = &spots_[connectivity_.target(first)];
  Vector a = last->point - spot.point;
  double x = a.squared_length(), sum = may_be_at(v, spot) ? 0. : turned_badness;
  Index h = first;
  do {
    const Spot* next = &spots_[connectivity_.apex(h)];
    const Vector b = next->point - spot.point, normal = cross_product(a, b);
    const double y = b.squared_length(), z = CGAL::squared_distance(next->point, last->point);
    sum = add_badness(sum, is_turned(spot, *last, *next, normal) ? turned_badness
                                                                 : triangle_badness(x, y, z, normal.squared_length()));
    last = next;
    a = b;
    x = y;
    h = connectivity_.rotate(h);
  } while(h != first && h != Lean_triangulation::none && sum <= limit);
  return sum;
}

inline Vector Remeshed_surface::way_to_center_of_neighbors(const Index v) const
{
  const Spot& spot = spots_[v];
  // In units of the length that the edge is to have, so that all pull alike. Without, a sizing is kept more exactly: to
  // 2 percent in place of 8 where it changes fourfold over a sphere. With, vertices gather where they are wanted: the
  // RMS distance of sizings by curvature is 3 to 5 percent less.
  const auto way_to = [&](const Index w) {
    const Vector way = spots_[w].point - spot.point;
    return metric_.is_uniform() ? way : 2. * spot.size / (spot.size + spots_[w].size) * way;
  };
  Vector sum(0., 0., 0.);
  connectivity_.for_each_neighbor(v, [&](const Index w) { sum = sum + way_to(w); });
  const Vector way = sum / static_cast<double>(connectivity_.valence(v));
  if(!is_on_line(v))
    return way;
  // Evenly between those beside it on the line, to cover bent lines, and in the middle of all, for the angles.
  Vector along(0., 0., 0.);
  for_each_neighbor_on_line(v, [&](const Index w) { along = along + .5 * way_to(w); });
  return .5 * (way + along);
}

// A face between creases is one of a side of each: it is turned if at one of its corners no side looks its way.
inline bool Remeshed_surface::is_turned_between_lines(const std::array<const Spot*, 3>& corners,
                                                      const Vector& normal) const
{
  for(const Spot* spot : corners) {
    bool is_seen = false;
    walker_.for_each_face_at(spot->place, [&](const Face f) { is_seen = is_seen || walker_.normal(f) * normal > 0.; });
    if(!is_seen)
      return true;
  }
  return false;
}

inline bool Remeshed_surface::find_middle(const Index h, Spot& middle) const
{
  Index from = connectivity_.source(h), to = connectivity_.target(h), beside = to;
  if(connectivity_.is_constrained(h)) {
    if(keeps_lines_)
      return false;
    if(is_fixed(from))
      std::swap(from, to);
    for_each_neighbor_on_line(from, [&](const Index w) { beside = w == to ? beside : w; });
    const Place place = lines_.middle(spots_[from].place, spots_[to].place, spots_[beside].place);
    if(place.face.is_valid())
      middle = spot_on_line(place);
    return place.face.is_valid();
  }
  // Into the face, of those beside the line, from which the way leads there.
  const Vector way = .5 * (spots_[to].point - spots_[from].point);
  double least = infinity;
  walker_.for_each_face_at(spots_[from].place, [&](const Face f) {
    const Place place = walker_.walk({f, coordinates_in(walker_.surface(), spots_[from].place, f)}, way);
    const Point point = walker_.point(place);
    const double distance = squared_distance(point, spots_[from].point + way);
    if(distance < least) {
      least = distance;
      middle = {point, place, walker_.normal(place.face), metric_.size(place)};
    }
  });
  return least < infinity;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REMESHED_SURFACE_H
