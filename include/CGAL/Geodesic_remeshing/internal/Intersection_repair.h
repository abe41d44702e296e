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
#include <limits>
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

  explicit Intersection_repair(Remeshed_surface& remeshed)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_failures(m_table.vertex_slots(), 0)
  {}

  // Returns the number of intersections found before; `mendable` is the worst triangle that a change may make. Vertices
  // that hold a tip give way only if they are let go. Only the first run searches everywhere: nothing but runs may
  // change the surface between them.
  std::size_t run(double mendable, bool do_let_go = false);

private:
  using Pair = Intersection_search::Pair;

  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

  void mend(const Pair& faces, const std::vector<Index>& corners);
  std::vector<Index> corners_of(const Pair& faces) const;
  void move_apart(Index v);
  void flip_apart(Index h);
  void gather(const Pair& faces);
  std::vector<Pair> find_pairs() const;
  void put(Index v, const Remeshed_surface::Spot& spot);
  void update_box(Index f);
  std::size_t intersections(Index f, std::size_t limit) const;
  std::size_t intersections_of_ring(Index v, std::size_t limit) const;
  void list_intersections(Index v);
  bool are_all_left() const;

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  std::vector<Index> m_zone;             // the faces around the pair
  std::vector<Face_box> m_boxes;         // of them
  std::vector<Pair> m_known;             // faces at the vertex that is moved, and those of the zone that they intersect
  std::vector<Index> m_changed;          // vertices at which something may have changed in the last run
  std::vector<unsigned char> m_failures; // times that moving a vertex did not help in this run
  double m_mendable = 0.;
  bool m_is_first = true;
};

inline void Intersection_repair::gather(const Pair& faces)
{
  m_zone.clear();
  for(const Index f : {faces.first, faces.second})
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      m_table.for_each_neighbor(m_table.source(h), [&](const Index v) {
        m_table.for_each_outgoing(v, [&](const Index g) { m_zone.push_back(Lean_triangulation::face(g)); });
      });
  std::sort(m_zone.begin(), m_zone.end());
  m_zone.erase(std::unique(m_zone.begin(), m_zone.end()), m_zone.end());
  m_boxes.clear();
  for(const Index f : m_zone)
    m_boxes.push_back(box_of(m_remeshed, f));
}

inline void Intersection_repair::update_box(const Index f)
{
  m_boxes[std::lower_bound(m_zone.begin(), m_zone.end(), f) - m_zone.begin()] = box_of(m_remeshed, f);
}

inline void Intersection_repair::put(const Index v, const Remeshed_surface::Spot& spot)
{
  m_remeshed.put(v, spot);
  m_table.for_each_outgoing(v, [&](const Index h) { update_box(Lean_triangulation::face(h)); });
}

// With the faces of the zone; no more are counted than a limit.
inline std::size_t Intersection_repair::intersections(const Index f, const std::size_t limit) const
{
  const Face_box box = box_of(m_remeshed, f);
  std::size_t number = 0;
  for(std::size_t i = 0; i < m_zone.size() && number < limit; ++i)
    number += f != m_zone[i] && do_overlap(box, m_boxes[i]) && do_faces_intersect(m_remeshed, f, m_zone[i]);
  return number;
}

inline std::size_t Intersection_repair::intersections_of_ring(const Index v, const std::size_t limit) const
{
  std::size_t number = 0;
  m_table.for_each_outgoing(
      v, [&](const Index h) { number += intersections(Lean_triangulation::face(h), limit - number); });
  return number;
}

inline void Intersection_repair::list_intersections(const Index v)
{
  m_known.clear();
  m_table.for_each_outgoing(v, [&](const Index h) {
    const Index f = Lean_triangulation::face(h);
    const Face_box box = box_of(m_remeshed, f);
    for(std::size_t i = 0; i < m_zone.size(); ++i)
      if(f != m_zone[i] && do_overlap(box, m_boxes[i]) && do_faces_intersect(m_remeshed, f, m_zone[i]))
        m_known.emplace_back(f, m_zone[i]);
  });
}

inline bool Intersection_repair::are_all_left() const
{
  return std::all_of(m_known.begin(), m_known.end(),
                     [&](const Pair& faces) { return do_faces_intersect(m_remeshed, faces.first, faces.second); });
}

// Takes the first step along an edge, forth or back, that leaves fewer intersections and good angles, until none are
// left.
inline void Intersection_repair::move_apart(const Index v)
{
  constexpr std::array<double, 6> steps = {{.1, -.1, .25, -.25, .5, -.5}};
  constexpr unsigned char last_failure = 3; // where much intersects a vertex belongs to many pairs
  if(m_remeshed.is_fixed(v) || m_failures[v] == last_failure)
    return;
  list_intersections(v);
  const std::size_t before = m_known.size();
  const double limit = (std::max)(m_mendable, m_remeshed.ring_badness(v));
  for(const double step : steps)
    m_table.for_each_neighbor(v, [&](const Index w) {
      if(m_known.empty())
        return;
      const Remeshed_surface::Spot old = m_remeshed.spot(v);
      put(v, m_remeshed.spot_after(v, step * (m_remeshed.spot(w).point - old.point)));
      // most steps leave what there was, which is quickly seen
      if(m_remeshed.ring_badness(v) <= limit && !are_all_left() &&
         intersections_of_ring(v, m_known.size()) < m_known.size())
        list_intersections(v);
      else
        put(v, old);
    });
  if(m_known.size() == before)
    ++m_failures[v];
}

inline void Intersection_repair::flip_apart(const Index h)
{
  if(!m_table.is_flip_legal(h))
    return;
  const Index o = m_table.opposite(h), f = Lean_triangulation::face(h), g = Lean_triangulation::face(o);
  const Index a = m_table.source(h), b = m_table.target(h), c = m_table.apex(h), d = m_table.apex(o);
  const double before = add_badness(m_remeshed.badness(a, b, c), m_remeshed.badness(b, a, d));
  const double after = add_badness(m_remeshed.badness(a, d, c), m_remeshed.badness(b, c, d));
  if(after > (std::max)(before, m_mendable))
    return;
  m_changed.insert(m_changed.end(), {a, b, c, d});
  const std::size_t number = intersections(f, unlimited) + intersections(g, unlimited);
  m_remeshed.record();
  m_table.flip(h);
  update_box(f);
  update_box(g);
  if(intersections(f, number) + intersections(g, number) >= number)
  {
    m_remeshed.undo_to({0, 0});
    update_box(f);
    update_box(g);
  }
  m_remeshed.forget();
}

inline void Intersection_repair::mend(const Pair& faces, const std::vector<Index>& corners)
{
  gather(faces);
  const auto are_parted = [&] { return !do_faces_intersect(m_remeshed, faces.first, faces.second); };
  for(const Index v : corners)
  {
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
      corners.push_back(m_table.source(h));
  return corners;
}

inline std::vector<Intersection_repair::Pair> Intersection_repair::find_pairs() const
{
  Intersection_search search(m_remeshed);
  if(m_is_first)
    return search.run();
  std::vector<Index> faces;
  for(const Index v : m_changed)
    m_table.for_each_outgoing(v, [&](const Index h) { faces.push_back(Lean_triangulation::face(h)); });
  return search.run(faces);
}

inline std::size_t Intersection_repair::run(const double mendable, const bool do_let_go)
{
  const std::vector<Pair> pairs = find_pairs();
  if(pairs.size() > m_table.number_of_vertices()) // sheets of the input lie on each other, which nothing parts
    return pairs.size();
  m_is_first = false;
  m_changed.clear();
  std::fill(m_failures.begin(), m_failures.end(), static_cast<unsigned char>(0));
  m_mendable = mendable;
  for(const Pair& pair : pairs)
  {
    const std::vector<Index> corners = corners_of(pair);
    m_changed.insert(m_changed.end(), corners.begin(), corners.end());
    if(!do_faces_intersect(m_remeshed, pair.first, pair.second)) // any more
      continue;
    if(do_let_go)
      for(const Index v : corners)
        m_remeshed.let_go(v);
    mend(pair, corners);
  }
  return pairs.size();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_REPAIR_H
