// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEFECT_MOVES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEFECT_MOVES_H

#include <CGAL/Geodesic_remeshing/internal/Intersection_search.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Search_effort.h>
#include <CGAL/Geodesic_remeshing/internal/Search_refusals.h>
#include <CGAL/Geodesic_remeshing/internal/distance_to_ring.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Removes irregular vertices. Most of them are pairs of a vertex of valence 5 and one of valence 7, the dislocations of
// a triangular lattice: flips that leave the energy as it is let such a pair glide, and where it meets its opposite
// both vanish. So from each irregular vertex sequences of flips that never raise the energy are searched, depth first
// and the lowest energy first, until one lowers it. A lone pair has two such flips, one of which takes back the last
// one: the search is nearly linear in its depth. What is found is kept if the vertices around can be relaxed to good
// triangles that are still where the vertices were: else a few flips would cut off a horn that all steps before have
// kept.
class Defect_moves
{
public:
  using Index = Lean_triangulation::Index;

  // `tolerance` is how far, in the unit of the relative sizes, a vertex may be left off the triangles that take its
  // place.
  Defect_moves(Remeshed_surface& remeshed, const double tolerance, const Search_effort& effort)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_refusals(m_table), m_stamp(m_table.vertex_slots(), 0),
      m_tolerance(tolerance), m_effort(effort)
  {}

  // One search from each irregular vertex; returns by how much the energy has fallen. Where nothing has been flipped
  // since a search found nothing, none is made again.
  int sweep(std::size_t depth);

private:
  struct Candidate
  {
    int energy;
    Index h;
    bool operator<(const Candidate& c) const { return energy < c.energy || (energy == c.energy && h < c.h); }
  };
  // The most flips looked at in one node of the search: more than four vertices of valence 7 offer.
  struct Candidates
  {
    std::array<Candidate, 32> list;
    std::size_t size = 0;
  };
  using Corners = Search_refusals::Corners;

  bool search(Corners around, std::size_t depth, int energy, Index made);
  void collect(Index v, int most, Index made, Candidates& candidates) const;
  void add(Index h, int most, Index made, Candidates& candidates) const;
  bool settle();
  bool covers(const Point& p, Index v) const;
  void gather_zone();

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  std::vector<Corners> m_path; // the vertices of each flip made
  std::vector<Index> m_zone;   // what is relaxed: first the vertices of the flips, then their neighbours
  std::size_t m_core = 0;      // number of the former
  Search_refusals m_refusals;
  std::vector<std::size_t> m_stamp; // of the vertices: the last zone that each was in
  std::size_t m_time = 0;
  std::size_t m_nodes_left = 0, m_settlements_left = 0;
  int m_found = 0;
  double m_tolerance;
  Search_effort m_effort;
  std::vector<Point> m_places; // those of the zone before it was relaxed
};

inline int Defect_moves::sweep(const std::size_t depth)
{
  int total = 0;
  m_refusals.begin_sweep();
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
  {
    if(m_table.is_removed(v) || !m_remeshed.energy().is_irregular(v) || m_refusals.is_refused(v, depth))
      continue;
    // Bounds the work where many irregular vertices lie together and the sequences are no longer few.
    m_nodes_left = m_effort.nodes * depth;
    m_settlements_left = m_effort.settlements;
    m_path.clear();
    m_refusals.begin_search();
    m_remeshed.record();
    if(search({{v, v, v, v}}, depth, 0, Lean_triangulation::none))
    {
      total -= m_found;
      m_refusals.note_success(m_path);
    }
    else
      m_refusals.note_failure(v, depth);
    m_remeshed.forget();
  }
  m_refusals.end_sweep();
  return total;
}

inline void Defect_moves::add(const Index h, const int most, const Index made, Candidates& candidates) const
{
  if(m_table.is_constrained(h) || candidates.size == candidates.list.size())
    return;
  const Index one = (std::min)(h, m_table.opposite(h));
  const int energy = m_remeshed.energy().of_flip(one);
  if(energy > most || one == made)
    return;
  for(std::size_t i = 0; i < candidates.size; ++i)
    if(candidates.list[i].h == one)
      return;
  candidates.list[candidates.size++] = {energy, one};
}

// A flip takes a neighbour from two vertices and gives one to two others: of use are the edges of a vertex that has too
// many, and those opposite a vertex that has too few.
inline void Defect_moves::collect(const Index v, const int most, const Index made, Candidates& candidates) const
{
  if(!m_remeshed.energy().is_irregular(v))
    return;
  m_table.for_each_outgoing(v, [&](const Index h) {
    const int excess = m_remeshed.energy().excess_at(h);
    if(excess != 0)
      add(excess > 0 ? h : Lean_triangulation::next(h), most, made, candidates);
  });
}

inline bool Defect_moves::search(const Corners around, const std::size_t depth, const int energy, const Index made)
{
  Candidates candidates;
  m_refusals.note_visits(around);
  for(const Index v : around)
    collect(v, m_effort.barrier - energy, made, candidates);
  std::sort(candidates.list.begin(), candidates.list.begin() + candidates.size);
  for(std::size_t i = 0; i < candidates.size && m_nodes_left > 0; ++i)
  {
    const Index h = candidates.list[i].h, o = m_table.opposite(h);
    const int reached = energy + candidates.list[i].energy;
    if(!m_table.is_flip_legal(h))
      continue;
    --m_nodes_left;
    const auto start = m_remeshed.mark();
    m_path.push_back({{m_table.source(h), m_table.target(h), m_table.apex(h), m_table.apex(o)}});
    const Index e = m_table.flip(h);
    m_found = reached;
    if(reached < 0 ? settle()
                   : depth > 1 && search(m_path.back(), depth - 1, reached, (std::min)(e, m_table.opposite(e))))
      return true;
    m_remeshed.undo_to(start);
    m_path.pop_back();
  }
  return false;
}

inline void Defect_moves::gather_zone()
{
  ++m_time;
  m_zone.clear();
  const auto enter = [&](const Index v) {
    if(m_stamp[v] != m_time)
    {
      m_stamp[v] = m_time;
      m_zone.push_back(v);
    }
  };
  for(const Corners& corners : m_path)
    for(const Index v : corners)
      enter(v);
  m_core = m_zone.size();
  for(std::size_t i = 0; i < m_core; ++i)
    m_table.for_each_neighbor(m_zone[i], enter);
}

// Relaxes the vertices of the flips freely (faces may be turned at first) and then these and their neighbours with
// care. Angles of about 30 degrees are good enough, since the rounds to come better them; what is worse holds others
// back: with 25 or 20 more vertices stay irregular than with 30.
inline bool Defect_moves::settle()
{
  const double good = badness_of_angle(m_effort.least_angle);
  if(m_settlements_left == 0)
    return false;
  --m_settlements_left;
  gather_zone();
  m_places.clear();
  for(const Index v : m_zone)
    m_places.push_back(m_remeshed.spot(v).point);
  for(std::size_t i = 0; i < m_core; ++i)
  {
    const Index v = m_zone[i];
    if(m_remeshed.is_fixed(v))
      continue;
    const Remeshed_surface::Spot center = m_remeshed.spot_after(v, Vertex_ring(m_remeshed, v).way_to_center());
    if(m_remeshed.may_be_at(v, center))
      m_remeshed.put(v, center);
  }
  for(int round = 0; round < 3; ++round)
    for(const Index v : m_zone)
      if(!m_remeshed.is_fixed(v))
        relax_vertex(m_remeshed, v);
  for(const Index v : m_zone)
    if(m_remeshed.ring_badness(v) > good)
      return false;
  for(std::size_t i = 0; i < m_zone.size(); ++i)
    if(!covers(m_places[i], m_zone[i]))
      return false;
  // Where limbs are as thick as edges are long, flips bring their sides together.
  return !m_effort.finds_intersections || !has_intersections_near(m_remeshed, m_zone);
}

// Whether the triangles around v or those beside them are near p, where v was: if not, a tip was cut off, or a hollow
// filled.
inline bool Defect_moves::covers(const Point& p, const Index v) const
{
  const double limit = CGAL::square(m_tolerance * m_remeshed.spot(v).size);
  double distance = CGAL::squared_distance(p, m_remeshed.spot(v).point);
  if(distance > limit)
    distance = squared_distance_to_ring(m_remeshed, p, v, limit);
  if(distance > limit)
    m_table.for_each_neighbor(v, [&](const Index w) {
      if(distance > limit)
        distance = (std::min)(distance, squared_distance_to_ring(m_remeshed, p, w, limit));
    });
  return distance <= limit;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEFECT_MOVES_H
