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
#include <CGAL/Geodesic_remeshing/internal/distance_to_ring.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Removes irregular vertices. Most of them are pairs of a vertex of valence 5 and one of valence 7, the dislocations of a
// triangular lattice: flips that leave the energy as it is let such a pair glide, and where it meets its opposite both
// vanish. So from each irregular vertex sequences of flips that never raise the energy are searched, depth first and the
// lowest energy first, until one lowers it. A lone pair has two such flips, one of which takes back the last one:
// the search is nearly linear in its depth. What is found is kept if the vertices around can be relaxed to good triangles
// that are still where the vertices were: else a few flips would cut off a horn that all steps before have kept.
class Defect_moves
{
public:
  using Index = Lean_triangulation::Index;

  // `tolerance` is how far, in the unit of the relative sizes, a vertex may be left off the triangles that take its place. With an
  // effort above 1 the searches are that much longer, and may raise the energy on their way.
  Defect_moves(Remeshed_surface& remeshed, const double tolerance, const std::size_t effort = 1)
    : remeshed_(remeshed), table_(remeshed.connectivity()), stamp_(table_.vertex_slots(), 0)
    , changed_(table_.vertex_slots(), 0), valence_(table_.vertex_slots(), 0), refusal_(table_.vertex_slots())
    , tolerance_(tolerance), effort_(effort), barrier_(effort > 1 ? 6 : 0) {}

  // One search from each irregular vertex; returns by how much the energy has fallen. Where nothing has been flipped since
  // a search found nothing, none is made again.
  int sweep(std::size_t depth);

private:
  struct Candidate
  {
    int energy; Index h;
    bool operator<(const Candidate& c) const { return energy < c.energy || (energy == c.energy && h < c.h); }
  };
  // The most flips looked at in one node of the search: more than four vertices of valence 7 offer.
  struct Candidates { std::array<Candidate, 32> list; std::size_t size = 0; };
  using Corners = std::array<Index, 4>;
  // A search that found nothing: when, how deep, and the vertices whose edges it looked at.
  struct Refusal { std::size_t time = 0, depth = 0, begin = 0, end = 0; };

  bool search(const Corners& around, std::size_t depth, int energy, Index made);
  void collect(Index v, int most, Index made, Candidates& candidates) const;
  void add(Index h, int most, Index made, Candidates& candidates) const;
  bool settle();
  bool covers(const Point& p, Index v) const;
  void gather_zone();
  void note_flips();
  void note_change(Index v);
  void note_visits(const Corners& corners);
  bool is_refused(Index v, std::size_t depth) const;

  Remeshed_surface& remeshed_;
  Lean_triangulation& table_;
  std::vector<Corners> path_;           // the vertices of each flip made
  std::vector<Index> zone_;             // what is relaxed: first the vertices of the flips, then their neighbours
  std::size_t core_ = 0;                // number of the former
  std::vector<std::size_t> stamp_;
  std::size_t time_ = 0;
  std::vector<std::size_t> changed_;    // when edges at a vertex or near it were flipped last
  std::vector<Index> valence_;          // at the end of the last sweep
  std::vector<Refusal> refusal_;
  std::vector<Index> visited_;
  std::size_t nodes_left_ = 0, settlements_left_ = 0;
  int found_ = 0;
  double tolerance_;
  std::size_t effort_;
  int barrier_;                         // the most by which the energy may be above that of the start: one step of an excess
  std::vector<Point> places_;           // those of the zone before it was relaxed
};

inline int Defect_moves::sweep(const std::size_t depth)
{
  int total = 0;
  note_flips();
  for(Index v = 0; v < table_.vertex_slots(); ++v) {
    if(table_.is_removed(v) || !remeshed_.energy().is_irregular(v) || is_refused(v, depth))
      continue;
    // Bounds the work where many irregular vertices lie together and the sequences are no longer few.
    nodes_left_ = 40 * effort_ * depth;
    settlements_left_ = 4 * effort_;
    path_.clear();
    const std::size_t begin = visited_.size();
    ++time_;
    remeshed_.record();
    if(search({{v, v, v, v}}, depth, 0, Lean_triangulation::none)) {
      total -= found_;
      for(const Corners& corners : path_)
        for(const Index w : corners)
          note_change(w);
    }
    else
      refusal_[v] = {time_, depth, begin, visited_.size()};
    remeshed_.forget();
  }
  for(Index v = 0; v < table_.vertex_slots(); ++v)
    valence_[v] = table_.valence(v);
  return total;
}

// What was flipped since the last sweep shows in the valences, but for rare cycles of flips.
inline void Defect_moves::note_flips()
{
  ++time_;
  for(Index v = 0; v < table_.vertex_slots(); ++v)
    if(!table_.is_removed(v) && valence_[v] != table_.valence(v))
      note_change(v);
}

// The energy of a flip that a search looks at depends on valences up to two edges away.
inline void Defect_moves::note_change(const Index v)
{
  table_.for_each_neighbor(v, [&](const Index w) {
    table_.for_each_neighbor(w, [&](const Index x) { changed_[x] = time_; });
  });
}

inline void Defect_moves::note_visits(const Corners& corners)
{
  visited_.insert(visited_.end(), corners.begin(), corners.end());
}

inline bool Defect_moves::is_refused(const Index v, const std::size_t depth) const
{
  const Refusal& refusal = refusal_[v];
  return refusal.depth >= depth &&
         std::all_of(visited_.begin() + refusal.begin, visited_.begin() + refusal.end,
                     [&](const Index w) { return changed_[w] <= refusal.time; });
}

inline void Defect_moves::add(const Index h, const int most, const Index made, Candidates& candidates) const
{
  if(table_.is_constrained(h) || candidates.size == candidates.list.size())
    return;
  const Index one = (std::min)(h, table_.opposite(h));
  const int energy = remeshed_.energy().of_flip(one);
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
  if(!remeshed_.energy().is_irregular(v))
    return;
  table_.for_each_outgoing(v, [&](const Index h) {
    const int excess = remeshed_.energy().excess_at(h);
    if(excess != 0)
      add(excess > 0 ? h : Lean_triangulation::next(h), most, made, candidates);
  });
}

inline bool Defect_moves::search(const Corners& around, const std::size_t depth, const int energy, const Index made)
{
  Candidates candidates;
  note_visits(around);
  for(const Index v : around)
    collect(v, barrier_ - energy, made, candidates);
  std::sort(candidates.list.begin(), candidates.list.begin() + candidates.size);
  for(std::size_t i = 0; i < candidates.size && nodes_left_ > 0; ++i) {
    const Index h = candidates.list[i].h, o = table_.opposite(h);
    const int reached = energy + candidates.list[i].energy;
    if(!table_.is_flip_legal(h))
      continue;
    --nodes_left_;
    const auto start = remeshed_.mark();
    path_.push_back({{table_.source(h), table_.target(h), table_.apex(h), table_.apex(o)}});
    const Index e = table_.flip(h);
    found_ = reached;
    if(reached < 0 ? settle() : depth > 1 && search(path_.back(), depth - 1, reached, (std::min)(e, table_.opposite(e))))
      return true;
    remeshed_.undo_to(start);
    path_.pop_back();
  }
  return false;
}

inline void Defect_moves::gather_zone()
{
  ++time_;
  zone_.clear();
  const auto enter = [&](const Index v) {
    if(stamp_[v] != time_) {
      stamp_[v] = time_;
      zone_.push_back(v);
    }
  };
  for(const Corners& corners : path_)
    for(const Index v : corners)
      enter(v);
  core_ = zone_.size();
  for(std::size_t i = 0; i < core_; ++i)
    table_.for_each_neighbor(zone_[i], enter);
}

// Relaxes the vertices of the flips freely (faces may be turned at first) and then these and their neighbours with
// care. Angles of 30 degrees are good enough, since the rounds to come better them.
inline bool Defect_moves::settle()
{
  static const double good = badness_of_angle(30.);
  if(settlements_left_ == 0)
    return false;
  --settlements_left_;
  gather_zone();
  places_.clear();
  for(const Index v : zone_)
    places_.push_back(remeshed_.spot(v).point);
  for(std::size_t i = 0; i < core_; ++i) {
    const Index v = zone_[i];
    if(remeshed_.is_fixed(v))
      continue;
    const Remeshed_surface::Spot center = remeshed_.spot_after(v, remeshed_.way_to_center_of_neighbors(v));
    if(remeshed_.may_be_at(v, center))
      remeshed_.put(v, center);
  }
  for(int round = 0; round < 3; ++round)
    for(const Index v : zone_)
      if(!remeshed_.is_fixed(v))
        relax_vertex(remeshed_, v);
  for(const Index v : zone_)
    if(remeshed_.ring_badness(v) > good)
      return false;
  for(std::size_t i = 0; i < zone_.size(); ++i)
    if(!covers(places_[i], zone_[i]))
      return false;
  // Where limbs are as thick as edges are long, flips bring their sides together.
  return effort_ == 1 || !has_intersections_near(remeshed_, zone_);
}

// Whether the triangles around v or those beside them are near p, where v was: if not, a tip was cut off, or a hollow filled.
inline bool Defect_moves::covers(const Point& p, const Index v) const
{
  const double limit = CGAL::square(tolerance_ * remeshed_.spot(v).size);
  double distance = CGAL::squared_distance(p, remeshed_.spot(v).point);
  if(distance > limit)
    distance = squared_distance_to_ring(remeshed_, p, v, limit);
  if(distance > limit)
    table_.for_each_neighbor(v, [&](const Index w) {
      if(distance > limit)
        distance = (std::min)(distance, squared_distance_to_ring(remeshed_, p, w, limit));
    });
  return distance <= limit;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEFECT_MOVES_H
