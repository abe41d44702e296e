// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_REPAIR_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_REPAIR_H

#include <CGAL/Geodesic_remeshing/internal/Intersection_search.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where two sheets of the surface are nearer to each other than the triangles deviate from it, triangles of the one may
// pierce the other's. Their vertices are moved along their edges until they do not, as far as good triangles allow.
class Intersection_repair
{
public:
  using Index = Lean_triangulation::Index;

  Intersection_repair(Remeshed_surface& remeshed, const double mendable)
    : remeshed_(remeshed), table_(remeshed.connectivity()), mendable_(mendable) {}

  // Returns the number of intersections found before. Vertices that hold a tip give way only if they are let go.
  std::size_t run(bool do_let_go = false);

private:
  using Pair = Intersection_search::Pair;

  void mend(const Pair& faces);
  std::vector<Index> corners_of(const Pair& faces) const;
  void move_apart(Index v);
  void flip_apart(Index h);
  void gather(const Pair& faces);
  Kernel::Triangle_3 triangle(const Index f) const { return triangle_of(remeshed_, f); }
  std::size_t intersections(Index f) const;
  std::size_t intersections_of_ring(Index v) const;

  Remeshed_surface& remeshed_;
  Lean_triangulation& table_;
  std::vector<Index> zone_;                                   // the faces around the pair
  double mendable_;                                           // the worst triangle that a change may make
};

inline void Intersection_repair::gather(const Pair& faces)
{
  zone_.clear();
  for(const Index f : {faces.first, faces.second})
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      table_.for_each_neighbor(table_.source(h), [&](const Index v) {
        table_.for_each_outgoing(v, [&](const Index g) { zone_.push_back(Lean_triangulation::face(g)); });
      });
  std::sort(zone_.begin(), zone_.end());
  zone_.erase(std::unique(zone_.begin(), zone_.end()), zone_.end());
}

// With the faces of the zone.
inline std::size_t Intersection_repair::intersections(const Index f) const
{
  const Bbox_3 box = triangle(f).bbox();
  std::size_t number = 0;
  for(const Index g : zone_)
    number += f != g && do_overlap(box, triangle(g).bbox()) && do_faces_intersect(remeshed_, f, g);
  return number;
}

inline std::size_t Intersection_repair::intersections_of_ring(const Index v) const
{
  std::size_t number = 0;
  table_.for_each_outgoing(v, [&](const Index h) { number += intersections(Lean_triangulation::face(h)); });
  return number;
}

// Takes the first step along an edge, forth or back, that leaves fewer intersections and good angles, until none are left.
inline void Intersection_repair::move_apart(const Index v)
{
  constexpr std::array<double, 6> steps = {{.1, -.1, .25, -.25, .5, -.5}};
  if(remeshed_.is_fixed(v))
    return;
  std::size_t number = intersections_of_ring(v);
  const double limit = (std::max)(mendable_, remeshed_.ring_badness(v));
  for(const double step : steps)
    table_.for_each_neighbor(v, [&](const Index w) {
      if(number == 0)
        return;
      const Remeshed_surface::Spot old = remeshed_.spot(v);
      remeshed_.put(v, remeshed_.spot_after(v, step * (remeshed_.spot(w).point - old.point)));
      const std::size_t left = remeshed_.ring_badness(v) <= limit ? intersections_of_ring(v) : number;
      if(left < number)
        number = left;
      else
        remeshed_.put(v, old);
    });
}

inline void Intersection_repair::flip_apart(const Index h)
{
  if(!table_.is_flip_legal(h))
    return;
  const Index o = table_.opposite(h), f = Lean_triangulation::face(h), g = Lean_triangulation::face(o);
  const Index a = table_.source(h), b = table_.target(h), c = table_.apex(h), d = table_.apex(o);
  const double before = add_badness(remeshed_.badness(a, b, c), remeshed_.badness(b, a, d));
  const double after = add_badness(remeshed_.badness(a, d, c), remeshed_.badness(b, c, d));
  if(after > (std::max)(before, mendable_))
    return;
  const std::size_t number = intersections(f) + intersections(g);
  remeshed_.record();
  table_.flip(h);
  if(intersections(f) + intersections(g) >= number)
    remeshed_.undo_to({0, 0});
  remeshed_.forget();
}

inline void Intersection_repair::mend(const Pair& faces)
{
  gather(faces);
  const std::vector<Index> corners = corners_of(faces);
  const auto are_parted = [&] { return !do_faces_intersect(remeshed_, faces.first, faces.second); };
  for(const Index v : corners) {
    if(are_parted())
      return;
    move_apart(v);
  }
  for(const Index f : {faces.first, faces.second})
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      if(!are_parted())
        flip_apart(h);
}

inline std::vector<Intersection_repair::Index> Intersection_repair::corners_of(const Pair& faces) const
{
  std::vector<Index> corners;
  for(const Index f : {faces.first, faces.second})
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      corners.push_back(table_.source(h));
  return corners;
}

inline std::size_t Intersection_repair::run(const bool do_let_go)
{
  const std::vector<Pair> pairs = Intersection_search(remeshed_).run();
  for(const Pair& pair : pairs) {
    for(const Index v : corners_of(pair))
      if(do_let_go)
        remeshed_.let_go(v);
    mend(pair);
  }
  return pairs.size();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_REPAIR_H
