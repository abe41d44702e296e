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

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

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
// the surface's normal there. Vertices move by walking only; so they are on the surface at any time.
class Remeshed_surface
{
public:
  using Index = Lean_triangulation::Index;

  struct Spot { Point point; Place place; Vector normal; };

  Remeshed_surface(const Surface_walker& walker, const Mesh& mesh, const Mesh::Property_map<Vertex, Place>& place,
                   const Mesh::Property_map<Vertex, bool>& pinned);

  const Surface_walker& walker() const { return walker_; }
  Lean_triangulation& connectivity() { return connectivity_; }
  const Lean_triangulation& connectivity() const { return connectivity_; }

  // A vertex that has to stay where it is.
  bool is_fixed(const Index v) const { return pinned_[v] || connectivity_.is_border(v); }

  const Spot& spot(const Index v) const { return spots_[v]; }
  void put(const Index v, const Spot& spot)
  {
    if(is_recording_)
      journal_.push_back({v, spots_[v]});
    spots_[v] = spot;
  }
  Spot spot_after(Index v, const Vector& displacement) const;
  Spot spot_at_vertex(Index x) const;           // of the input
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
  double ring_badness(Index v) const;
  Vector way_to_center_of_neighbors(Index v) const;

  // How far the valence is from the regular one. Its square summed over the vertices is the energy that flips, collapses
  // and splits lower; what one of them would add to it needs no trial. Two of valence 5 have less of it than one of
  // valence 4; where the irregular vertices cannot vanish, flips merge them if their number counts rather than the squares.
  int excess(const Index v) const
  {
    return static_cast<int>(connectivity_.valence(v)) - (connectivity_.is_border(v) ? 4 : 6);
  }
  void let_numbers_count(const bool value) { do_numbers_count_ = value; }
  int energy_of_flip(Index h) const;
  int energy_of_collapse(Index h) const;

  void write_back(Mesh& mesh, Mesh::Property_map<Vertex, Place> place,
                  Mesh::Property_map<Vertex, bool> pinned) const;

private:
  int energy(int excess) const;
  void write_faces(Mesh& mesh, const std::vector<Vertex>& vertex) const;

  const Surface_walker& walker_;
  Lean_triangulation connectivity_;
  std::vector<Spot> spots_;
  std::vector<char> pinned_;
  std::vector<Index> pinned_here_;
  std::vector<std::pair<Index, Spot>> journal_;
  bool is_recording_ = false, do_numbers_count_ = false;
};

inline Remeshed_surface::Remeshed_surface(const Surface_walker& walker, const Mesh& mesh,
                                          const Mesh::Property_map<Vertex, Place>& place,
                                          const Mesh::Property_map<Vertex, bool>& pinned)
  : walker_(walker), connectivity_(mesh)
{
  spots_.reserve(mesh.number_of_vertices());
  pinned_.reserve(mesh.number_of_vertices());
  for(const Vertex v : mesh.vertices()) {
    // A pinned vertex is a tip, where the normal of one face says nothing.
    spots_.push_back({walker.point(place[v]), place[v], pinned[v] ? Vector(0., 0., 0.) : walker.normal(place[v].face)});
    pinned_.push_back(pinned[v]);
  }
}

inline Remeshed_surface::Spot Remeshed_surface::spot_after(const Index v, const Vector& displacement) const
{
  const Place place = walker_.walk(spots_[v].place, displacement);
  return {walker_.point(place), place, walker_.normal(place.face)};
}

// Such a vertex is sought out as a tip, where the normal of one face says nothing.
inline Remeshed_surface::Spot Remeshed_surface::spot_at_vertex(const Index x) const
{
  const Index h = walker_.triangulation().halfedge(x);
  Place place{Face(Lean_triangulation::face(h)), {{0., 0., 0.}}};
  place.coordinates[h & 3] = 1.;
  return {walker_.point(place), place, Vector(0., 0., 0.)};
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
  // Against the mean normal: at a crease a single one may point anywhere.
  if(normal * (s.normal + t.normal + r.normal) < 0.)
    return turned_badness;
  // The smallest angle is opposite the shortest edge; the scalar product there is (sum of squares)/2 - shortest square.
  const double x = a.squared_length(), y = b.squared_length(), z = c.squared_length();
  const double product = (x + y + z) / 2. - (std::min)({x, y, z});
  const double area = normal.squared_length();
  return product * product < worst_badness * area ? product * product / area : worst_badness;
}

inline double Remeshed_surface::ring_badness(const Index v) const
{
  double sum = 0.;
  connectivity_.for_each_outgoing(v, [&](const Index h) {
    sum = add_badness(sum, badness(v, connectivity_.target(h), connectivity_.apex(h)));
  });
  return sum;
}

inline Vector Remeshed_surface::way_to_center_of_neighbors(const Index v) const
{
  const Point& p = spots_[v].point;
  Vector sum(0., 0., 0.);
  connectivity_.for_each_neighbor(v, [&](const Index w) { sum = sum + (spots_[w].point - p); });
  return sum / static_cast<double>(connectivity_.valence(v));
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
  const int a = excess(connectivity_.source(h)), b = excess(connectivity_.target(h));
  const int c = excess(connectivity_.apex(h)), d = excess(connectivity_.apex(o));
  return energy(a - 1) - energy(a) + energy(b - 1) - energy(b) + energy(c + 1) - energy(c) + energy(d + 1) - energy(d);
}

inline int Remeshed_surface::energy_of_collapse(const Index h) const
{
  const Index o = connectivity_.opposite(h);
  const int a = excess(connectivity_.source(h)), b = excess(connectivity_.target(h));
  const int c = excess(connectivity_.apex(h)), d = excess(connectivity_.apex(o));
  return (a + b + 2) * (a + b + 2) - a * a - b * b + 2 - 2 * c - 2 * d;
}

inline void Remeshed_surface::write_back(Mesh& mesh, Mesh::Property_map<Vertex, Place> place,
                                         Mesh::Property_map<Vertex, bool> pinned) const
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
  write_faces(mesh, vertex);
}

// Sets the links one by one: `add_face()` would have to find out what is known here.
inline void Remeshed_surface::write_faces(Mesh& mesh, const std::vector<Vertex>& vertex) const
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
