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
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/internal/working_surface.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The badness of a triangle is the squared cotangent of its smallest angle: it grows as the angle shrinks and costs one
// division and no root. That of a triangle turned against the surface is above that of any other.
constexpr double turned_badness = 1e15, worst_badness = 1e12;

inline double badness_of_angle(const double degrees)
{
  return CGAL::square(1. / std::tan(degrees * (CGAL_PI / 180.)));
}

// The worse of two sets of triangles is that with more turned ones, then that with the smaller angle.
inline double add_badness(const double x, const double y)
{
  return y >= turned_badness ? x + y : (std::max)(x, y);
}

// The triangulation under improvement: its connectivity, and for each vertex its place on the surface with the point and
// the surface's normal there. Vertices move by walking only; so they are on the surface at any time. Those on lines slide.
class Remeshed_surface
{
public:
  using Index = Lean_triangulation::Index;

  struct Spot { Point point; Place place; Vector normal; double size; };   // the size is relative, see Metric

  Remeshed_surface(const Surface_walker& walker, const Constraints& constraints, const Mesh& mesh,
                   const Mesh::Property_map<Vertex, Place>& place, const Mesh::Property_map<Vertex, bool>& pinned,
                   const Mesh::Property_map<Edge, bool>& constrained);

  const Surface_walker& walker() const { return walker_; }
  const Metric& metric() const { return metric_; }         // of the input
  Lean_triangulation& connectivity() { return connectivity_; }
  const Lean_triangulation& connectivity() const { return connectivity_; }

  // A vertex that has to stay where it is; one that may slide if it is not; one that may go anywhere.
  bool is_fixed(const Index v) const { return pinned_[v]; }
  bool has_lines() const { return has_lines_; }
  bool is_on_line(const Index v) const { return has_lines_ && connectivity_.is_on_line(v); }
  bool is_free(const Index v) const { return !is_fixed(v) && !is_on_line(v); }

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
    return {walker_.point(place), place, normal_on_line(place), metric_.size(place)};
  }
  bool find_middle(Index h, Spot& middle) const;  // of an edge, on its line if it is on one
  void pin(const Index v)
  {
    pinned_[v] = true;
    pinned_here_.push_back(v);
  }
  void release();                               // the vertices that `pin()` pinned
  void reserve_free(Index number_of_splits);     // room for so many new vertices

  // A trial: from `record()` on changes can be taken back, until `forget()`, which keeps those that were not.
  struct Mark { std::size_t connectivity, spots; };
  void record() { connectivity_.record(); is_recording_ = true; }
  Mark mark() const { return {connectivity_.mark(), journal_.size()}; }
  void undo_to(Mark mark);
  void forget();

  double badness(Index u, Index v, Index w) const;
  double ring_badness(const Index v) const { return ring_badness(v, spots_[v], infinity); }
  // That of the ring if its center were at `spot`; no more than something above the limit where it is above the limit.
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

  // How far the valence is from the regular one. Its square summed over the vertices is the energy that flips, collapses
  // and splits lower; what one of them would add to it needs no trial. Two of valence 5 have less of it than one of
  // valence 4; where the irregular vertices cannot vanish, flips merge them if their number counts rather than the squares.
  // Lines divide the ring of a vertex into sectors, each with a regular number of faces and an excess of its own.
  int excess_at(const Index h) const   // of the sector of face(h) at source(h)
  {
    const Index v = connectivity_.source(h);
    return is_on_line(v) ? excess_in_sector(h) : static_cast<int>(connectivity_.valence(v)) - 6;
  }
  bool is_irregular(Index v) const;
  void let_numbers_count(const bool value) { do_numbers_count_ = value; }
  int energy_of_flip(Index h) const;
  int energy_of_collapse(Index h) const;
  int energy_of_edge_split(Index h) const;

  void write_back(Mesh& mesh, Mesh::Property_map<Vertex, Place> place,
                  Mesh::Property_map<Vertex, bool> pinned, Mesh::Property_map<Edge, bool> constrained) const;

private:
  static double badness(double x, double y, double z, double area);
  int energy(int excess) const;
  int energy_of_half_collapse(Index h) const;
  int excess_in_sector(Index h) const;
  void count_regular_faces(Index v);
  Vector normal_on_line(const Place& place) const;
  bool is_turned(const Spot& u, const Spot& v, const Spot& w, const Vector& normal) const
  {
    // Against the mean normal: at a crease a single one may point anywhere.
    const double side = normal * (u.normal + v.normal + w.normal);
    return side < 0. || (has_lines_ && !(side > 0.) && is_turned_between_lines({{&u, &v, &w}}, normal));
  }
  bool is_turned_between_lines(const std::array<const Spot*, 3>& corners, const Vector& normal) const;
  void write_faces(Mesh& mesh, const std::vector<Vertex>& vertex, Mesh::Property_map<Edge, bool> constrained) const;

  const Surface_walker& walker_;
  const Metric metric_;
  const Line_walker lines_;
  const bool has_lines_;
  Lean_triangulation connectivity_;
  std::vector<Spot> spots_;
  std::vector<char> pinned_;
  std::vector<Index> pinned_here_;
  std::vector<Index> first_sector_;            // of a vertex: the first of its entries in `regular_faces_`, or `none`
  std::vector<int> regular_faces_;             // a sector, counterclockwise from the vertex' first halfedge
  std::vector<std::pair<Index, Spot>> journal_;
  bool is_recording_ = false, do_numbers_count_ = false;
};

inline Remeshed_surface::Remeshed_surface(const Surface_walker& walker, const Constraints& constraints, const Mesh& mesh,
                                          const Mesh::Property_map<Vertex, Place>& place,
                                          const Mesh::Property_map<Vertex, bool>& pinned,
                                          const Mesh::Property_map<Edge, bool>& constrained)
  : walker_(walker), metric_(walker.surface()), lines_(walker, constraints), has_lines_(!lines_.empty())
  , connectivity_(mesh, [&](const Edge e) { return constrained[e]; })
{
  spots_.reserve(mesh.number_of_vertices());
  pinned_.reserve(mesh.number_of_vertices());
  for(const Vertex v : mesh.vertices()) {
    // A pinned vertex is a tip or a corner, where the normal of one face says nothing.
    const Vector normal = pinned[v] ? Vector(0., 0., 0.)
                        : is_on_line(v) ? normal_on_line(place[v]) : walker.normal(place[v].face);
    spots_.push_back({walker.point(place[v]), place[v], normal, metric_.size(place[v])});
    pinned_.push_back(pinned[v]);
  }
  if(has_lines_)
    first_sector_.assign(mesh.number_of_vertices(), Lean_triangulation::none);
  for(Index v = 0; v < first_sector_.size(); ++v)
    if(pinned_[v] && is_on_line(v))
      count_regular_faces(v);
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

inline void Remeshed_surface::release()
{
  for(const Index v : pinned_here_)
    pinned_[v] = false;
  pinned_here_.clear();
}

inline void Remeshed_surface::reserve_free(const Index number_of_splits)
{
  connectivity_.reserve_free(number_of_splits);
  spots_.resize(connectivity_.vertex_slots());
  pinned_.resize(connectivity_.vertex_slots(), false);
  if(has_lines_)
    first_sector_.resize(connectivity_.vertex_slots(), Lean_triangulation::none);
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

// Of a triangle by the squares of its edges and of twice its area.
inline double Remeshed_surface::badness(const double x, const double y, const double z, const double area)
{
  // The smallest angle is opposite the shortest edge; the scalar product there is (sum of squares)/2 - shortest square.
  const double product = (x + y + z) / 2. - (std::min)((std::min)(x, y), z);
  return product * product < worst_badness * area ? product * product / area : worst_badness;
}

inline double Remeshed_surface::badness(const Index u, const Index v, const Index w) const
{
  const Spot &s = spots_[u], &t = spots_[v], &r = spots_[w];
  const Vector a = t.point - s.point, b = r.point - s.point, c = r.point - t.point;
  const Vector normal = cross_product(a, b);
  if(is_turned(s, t, r, normal))
    return turned_badness;
  return badness(a.squared_length(), b.squared_length(), c.squared_length(), normal.squared_length());
}

// As `badness()` of each triangle; but what one shares with the next is computed once: of all that is asked here this is
// asked most often.
inline double Remeshed_surface::ring_badness(const Index v, const Spot& spot, const double limit) const
{
  const Index first = connectivity_.halfedge(v);
  const Spot* last = &spots_[connectivity_.target(first)];
  Vector a = last->point - spot.point;
  double x = a.squared_length(), sum = 0.;
  Index h = first;
  do {
    const Spot* next = &spots_[connectivity_.apex(h)];
    const Vector b = next->point - spot.point, normal = cross_product(a, b);
    const double y = b.squared_length(), z = CGAL::squared_distance(next->point, last->point);
    sum = add_badness(sum, is_turned(spot, *last, *next, normal) ? turned_badness
                                                                 : badness(x, y, z, normal.squared_length()));
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
  // In units of the length that the edge is to have, so that all pull alike. Without, a sizing is kept more exactly: to 2 percent in
  // place of 8 where it changes fourfold over a sphere. With, vertices gather where they are wanted: the RMS distance of
  // sizings by curvature is 3 to 5 percent less.
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

inline int Remeshed_surface::energy(const int excess) const
{
  // A vertex of valence 4 counts less than two of valence 5, one of valence 8 as much as two of valence 7.
  constexpr std::array<int, 5> counting = {{7, 4, 0, 4, 8}};
  return do_numbers_count_ && std::abs(excess) <= 2 ? counting[excess + 2] : 3 * excess * excess;
}

inline int Remeshed_surface::energy_of_flip(const Index h) const
{
  const Index o = connectivity_.opposite(h);
  const int a = excess_at(h), b = excess_at(o);
  const int c = excess_at(Lean_triangulation::previous(h)), d = excess_at(Lean_triangulation::previous(o));
  return energy(a - 1) - energy(a) + energy(b - 1) - energy(b) + energy(c + 1) - energy(c) + energy(d + 1) - energy(d);
}

inline int Remeshed_surface::energy_of_collapse(const Index h) const
{
  const Index o = connectivity_.opposite(h);
  if(connectivity_.is_constrained(h))
    return energy_of_half_collapse(h) + (o == Lean_triangulation::none ? 0 : energy_of_half_collapse(o));
  const int a = excess_at(h), b = excess_at(o);
  const int c = excess_at(Lean_triangulation::previous(h)), d = excess_at(Lean_triangulation::previous(o));
  return (a + b + 2) * (a + b + 2) - a * a - b * b + 2 - 2 * c - 2 * d;
}

// That of one side of a line
inline int Remeshed_surface::energy_of_half_collapse(const Index h) const
{
  const int a = excess_at(h), b = excess_at(Lean_triangulation::next(h)), c = excess_at(Lean_triangulation::previous(h));
  return (a + b + 1) * (a + b + 1) - a * a - b * b + 1 - 2 * c;
}

// A new vertex on a line has two faces on each side where three are regular; another has four where six are.
inline int Remeshed_surface::energy_of_edge_split(const Index h) const
{
  const Index o = connectivity_.opposite(h);
  const int c = 1 + 2 * excess_at(Lean_triangulation::previous(h));
  const int d = o == Lean_triangulation::none ? 0 : 1 + 2 * excess_at(Lean_triangulation::previous(o));
  return c + d + (!connectivity_.is_constrained(h) ? 4 : o == Lean_triangulation::none ? 1 : 2);
}

inline int Remeshed_surface::excess_in_sector(const Index h) const
{
  const Index v = connectivity_.source(h), first = connectivity_.halfedge(v);
  Index sector = 0;
  int faces = 0;
  bool is_found = false;
  Index g = first;
  do {
    if(connectivity_.is_constrained(g) && g != first) {
      if(is_found)
        break;
      ++sector;
      faces = 0;
    }
    ++faces;
    is_found = is_found || g == h;
    g = connectivity_.rotate(g);
  } while(g != first && g != Lean_triangulation::none);
  return faces - (first_sector_[v] == Lean_triangulation::none ? 3 : regular_faces_[first_sector_[v] + sector]);
}

inline bool Remeshed_surface::is_irregular(const Index v) const
{
  bool result = false;
  if(!is_on_line(v))
    return excess_at(connectivity_.halfedge(v)) != 0;
  connectivity_.for_each_outgoing(v, [&](const Index h) { result = result || excess_in_sector(h) != 0; });
  return result;
}

// At a corner as many faces are regular in a sector as make its angle's parts nearest to 60 degrees.
inline void Remeshed_surface::count_regular_faces(const Index v)
{
  const Index first = connectivity_.halfedge(v);
  first_sector_[v] = static_cast<Index>(regular_faces_.size());
  std::vector<double> angles;
  connectivity_.for_each_outgoing(v, [&](const Index h) {
    if(h == first || connectivity_.is_constrained(h))
      angles.push_back(0.);
    const Vector a = spots_[connectivity_.target(h)].point - spots_[v].point;
    const Vector b = spots_[connectivity_.apex(h)].point - spots_[v].point;
    angles.back() += std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  });
  // Right angles are common and as good in one part as in two; two it is, whatever the rounding.
  for(const double angle : angles)
    regular_faces_.push_back((std::max)(1, static_cast<int>(angle * 3. / CGAL_PI + .51)));
}

// None where the faces that meet there look different ways.
inline Vector Remeshed_surface::normal_on_line(const Place& place) const
{
  constexpr double least_cosine = .7;
  Vector sum(0., 0., 0.);
  walker_.for_each_face_at(place, [&](const Face f) { sum = sum + walker_.normal(f); });
  const double length = std::sqrt(sum.squared_length());
  bool is_smooth = length > 0.;
  walker_.for_each_face_at(place, [&](const Face f) {
    is_smooth = is_smooth && walker_.normal(f) * sum >= least_cosine * length;
  });
  return is_smooth ? sum / length : Vector(0., 0., 0.);
}

// A face between creases is one of a side of each: it is turned if at one of its corners no side looks its way.
inline bool Remeshed_surface::is_turned_between_lines(const std::array<const Spot*, 3>& corners, const Vector& normal) const
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

inline void Remeshed_surface::write_back(Mesh& mesh, Mesh::Property_map<Vertex, Place> place,
                                         Mesh::Property_map<Vertex, bool> pinned,
                                         Mesh::Property_map<Edge, bool> constrained) const
{
  mesh.clear_without_removing_property_maps();
  std::vector<Vertex> vertex(connectivity_.vertex_slots());
  for(Index v = 0; v < connectivity_.vertex_slots(); ++v) {
    if(connectivity_.is_removed(v))
      continue;
    vertex[v] = mesh.add_vertex(point_at(walker_.surface(), spots_[v].place));
    place[vertex[v]] = spots_[v].place;
    pinned[vertex[v]] = pinned_[v];
  }
  write_faces(mesh, vertex, constrained);
}

// Sets the links one by one: `add_face()` would have to find out what is known here.
inline void Remeshed_surface::write_faces(Mesh& mesh, const std::vector<Vertex>& vertex,
                                          Mesh::Property_map<Edge, bool> constrained) const
{
  const Lean_triangulation& table = connectivity_;
  std::vector<Halfedge> halfedge(4 * table.face_slots());
  const auto for_each_halfedge = [&](const auto& visit) {
    for(Index f = 0; f < table.face_slots(); ++f)
      for(Index h = 4 * f; h < 4 * f + 3 && !table.is_removed_face(f); ++h)
        visit(h);
  };
  for_each_halfedge([&](const Index h) {
    const Index o = table.opposite(h);
    halfedge[h] = o < h ? mesh.opposite(halfedge[o]) : mesh.add_edge(vertex[table.source(h)], vertex[table.target(h)]);
    constrained[mesh.edge(halfedge[h])] = table.is_constrained(h);
  });
  for(Index f = 0; f < table.face_slots(); ++f) {
    if(table.is_removed_face(f))
      continue;
    const Face face = mesh.add_face();
    mesh.set_halfedge(face, halfedge[4 * f]);
    for(Index h = 4 * f; h < 4 * f + 3; ++h) {
      mesh.set_face(halfedge[h], face);
      mesh.set_next(halfedge[h], halfedge[Lean_triangulation::next(h)]);
      mesh.set_halfedge(vertex[table.target(h)], halfedge[h]);
    }
  }
  // The boundary runs against the halfedges that have no opposite; it is what a vertex of it points to.
  for_each_halfedge([&](const Index h) {
    if(table.opposite(h) != Lean_triangulation::none)
      return;
    Index last = Lean_triangulation::previous(h);
    while(table.opposite(last) != Lean_triangulation::none)
      last = Lean_triangulation::previous(table.opposite(last));
    mesh.set_next(mesh.opposite(halfedge[h]), mesh.opposite(halfedge[last]));
    mesh.set_halfedge(vertex[table.source(h)], mesh.opposite(halfedge[h]));
  });
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REMESHED_SURFACE_H
