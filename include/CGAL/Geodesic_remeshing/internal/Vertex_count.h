// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_COUNT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_COUNT_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Brings the number of vertices to the one asked for, by collapses and splits where they cost least regularity: at a
// 5-7 pair they cost none (the pair moves over by one row), in a regular part they make new irregular vertices. Among
// equals the shortest edges go, and the widest rings are divided. The vertices of lines have their own spacing: their
// number changes only where they are too near or too far from each other, or if nothing else is left.
class Vertex_count
{
public:
  using Index = Lean_triangulation::Index;

  // No change leaves an angle smaller than `least_angle`, unless nothing else is left: then it may be 10.
  Vertex_count(Remeshed_surface& remeshed, const double edge_length, const double least_angle = 10.)
    : remeshed_(remeshed), table_(remeshed.connectivity()), squared_edge_length_(edge_length * edge_length)
    , least_angle_(least_angle) {}

  // Returns whether the number was reached.
  bool reach(std::size_t number_of_vertices);
  // The same, at the cost of angles if nothing else is left
  bool reach_at_any_cost(std::size_t number_of_vertices);

private:
  // The collapse of h, or, where `other` is given, the split of the source of both between them, or that of h itself.
  struct Change
  {
    double cost; Index h, other;
    bool operator<(const Change& c) const { return std::tie(cost, h, other) < std::tie(c.cost, c.h, c.other); }
  };

  void find_collapses();
  void find_splits();
  void keep_cheapest(std::size_t number);
  std::size_t apply(std::size_t number);
  bool collapse(Index h);
  bool split(Index h, Index other);
  bool split_edge(Index h);
  void find_edge_splits();
  double worst_around(const std::array<Index, 4>& vertices) const;
  bool settle(const std::array<Index, 4>& changed, double before, bool is_line = false);
  double size_cost(Index v, Index w) const;
  double cost_of_lines(Index h) const;
  std::array<Index, 4> corners(Index h) const;
  bool is_touched(const Change& change) const;

  Remeshed_surface& remeshed_;
  Lean_triangulation& table_;
  double squared_edge_length_;
  double least_angle_;                  // that a change may leave
  double least_angle_on_lines_ = 30.;   // that a collapse along a line may leave; lowered only if nothing else is left
  std::vector<Change> changes_;
  std::vector<char> touched_;     // vertices whose valence or place has changed since the costs were found
};

inline bool Vertex_count::reach(const std::size_t number_of_vertices)
{
  while(table_.number_of_vertices() != number_of_vertices) {
    const std::size_t n = table_.number_of_vertices();
    const std::size_t number = n < number_of_vertices ? number_of_vertices - n : n - number_of_vertices;
    changes_.clear();
    if(n < number_of_vertices) {
      remeshed_.reserve_free(static_cast<Index>(number));
      find_splits();
      find_edge_splits();
    }
    else
      find_collapses();
    touched_.assign(table_.vertex_slots(), false);
    keep_cheapest(number);
    if(apply(number) > 0)
      continue;
    if(least_angle_ > 10.)
      least_angle_ -= 10.;
    else if(least_angle_on_lines_ > 10.)
      least_angle_on_lines_ -= 10.;
    else
      return false;
  }
  return true;
}

inline bool Vertex_count::reach_at_any_cost(const std::size_t number_of_vertices)
{
  for(const double angle : {10., 5., 2., 1.}) {
    least_angle_ = angle;
    if(reach(number_of_vertices))
      return true;
  }
  return false;
}

// The length of an edge weighs as much as one step of the energy (2) when it is off by the whole edge length.
inline double Vertex_count::size_cost(const Index v, const Index w) const
{
  const Remeshed_surface::Spot &a = remeshed_.spot(v), &b = remeshed_.spot(w);
  return 2. * squared_distance(a.point, b.point) / (squared_edge_length_ * CGAL::square(.5 * (a.size + b.size)));
}

// Of an edge between lines: what is added to the cost of its collapse, which leaves a longer edge on the line.
inline double Vertex_count::cost_of_lines(const Index h) const
{
  constexpr double last_resort = 1000., longest = 2. * 1.3 * 1.3;
  double length = 0.;
  remeshed_.for_each_neighbor_on_line(table_.target(h), [&](const Index w) {
    length = (std::max)(length, size_cost(table_.source(h), w));
  });
  return length > longest ? last_resort : 0.;
}

// Of the two faces of an edge; at the boundary, where there is one, the source takes the place of the fourth.
inline std::array<Vertex_count::Index, 4> Vertex_count::corners(const Index h) const
{
  const Index o = table_.opposite(h), a = table_.source(h);
  return {{a, table_.target(h), table_.apex(h), o == Lean_triangulation::none ? a : table_.apex(o)}};
}

inline void Vertex_count::find_collapses()
{
  for(Index f = 0; f < table_.face_slots(); ++f) {
    for(Index h = 4 * f; h < 4 * f + 3 && !table_.is_removed_face(f); ++h) {
      const Index v = table_.source(h), w = table_.target(h);
      const bool is_line = table_.is_constrained(h);
      if(is_line ? !remeshed_.is_fixed(w) : remeshed_.is_free(w))
        changes_.push_back({remeshed_.energy().of_collapse(h) + size_cost(v, w) + (is_line ? cost_of_lines(h) : 0.), h,
                            Lean_triangulation::none});
    }
  }
}

// Of each vertex the cheapest split into halves.
inline void Vertex_count::find_splits()
{
  for(Index v = 0; v < table_.vertex_slots(); ++v) {
    if(table_.is_removed(v) || remeshed_.is_on_line(v))
      continue;
    const int valence = static_cast<int>(table_.valence(v)), half = valence / 2;
    Change best{infinity, Lean_triangulation::none, Lean_triangulation::none};
    double size = 0.;
    Index across = table_.halfedge(v);
    for(int i = 0; i < half; ++i)
      across = table_.rotate(across);
    table_.for_each_outgoing(v, [&](const Index h) {
      const double cost = 2. * (remeshed_.energy().excess_at(Lean_triangulation::next(h)) +
                                remeshed_.energy().excess_at(Lean_triangulation::next(across)));
      best = (std::min)(best, Change{cost, h, across});
      size += size_cost(v, table_.target(h));
      across = table_.rotate(across);
    });
    const int one = half + 2 - 6, two = valence - half + 2 - 6, excess = valence - 6;
    best.cost += one * one + two * two - excess * excess + 2 - size / valence;
    changes_.push_back(best);
  }
}

inline void Vertex_count::find_edge_splits()
{
  constexpr double last_resort = 1000., shortest = 2. * 1.5 * 1.5;
  for(Index h = 0; h < 4 * table_.face_slots(); ++h) {
    if((h & 3) == 3 || table_.is_removed_face(Lean_triangulation::face(h)) || table_.opposite(h) < h)
      continue;
    const Index v = table_.source(h), w = table_.target(h);
    if(!remeshed_.is_on_line(v) || !remeshed_.is_on_line(w)
       || (remeshed_.keeps_lines() && table_.is_constrained(h)))
      continue;
    const double size = size_cost(v, w), last = table_.is_constrained(h) ? last_resort : .5 * last_resort;
    changes_.push_back({remeshed_.energy().of_edge_split(h) - size + (size < shortest ? last : 0.), h, h});
  }
}

// Neighbours of a change made have to wait for the next pass; so some more than wanted are looked at.
inline void Vertex_count::keep_cheapest(const std::size_t number)
{
  const std::size_t kept = (std::min)(changes_.size(), 8 * number + 16);
  std::nth_element(changes_.begin(), changes_.begin() + kept, changes_.end());
  changes_.resize(kept);
  std::sort(changes_.begin(), changes_.end());
}

inline bool Vertex_count::is_touched(const Change& change) const
{
  if(table_.is_removed_face(table_.face(change.h)))
    return true;
  if(change.other != Lean_triangulation::none && change.other != change.h)
    return touched_[table_.source(change.h)] || touched_[table_.target(change.h)] ||
           touched_[table_.target(change.other)];
  const std::array<Index, 4> around = corners(change.h);
  return std::any_of(around.begin(), around.end(), [&](const Index v) { return touched_[v]; });
}

inline std::size_t Vertex_count::apply(const std::size_t number)
{
  std::size_t made = 0;
  for(const Change& change : changes_) {
    if(made == number)
      break;
    if(is_touched(change))
      continue;
    remeshed_.record();
    const auto start = remeshed_.mark();
    if(change.other == Lean_triangulation::none ? collapse(change.h)
       : change.other == change.h ? split_edge(change.h) : split(change.h, change.other))
      ++made;
    else
      remeshed_.undo_to(start);
    remeshed_.forget();
  }
  return made;
}

inline bool Vertex_count::collapse(const Index h)
{
  if(!table_.is_collapse_legal(h))
    return false;
  const std::array<Index, 4> around = corners(h);
  const Index a = around[0], b = around[1];
  const Vector way = remeshed_.spot(b).point - remeshed_.spot(a).point;
  const bool are_alike = remeshed_.is_on_line(a) == remeshed_.is_on_line(b);
  const bool is_line = table_.is_constrained(h);
  const double before = worst_around(around);
  table_.collapse(h);
  if(!remeshed_.is_fixed(a) && are_alike)
    remeshed_.put(a, remeshed_.spot_after(a, .5 * way));
  return settle({{a, a, around[2], around[3]}}, before, is_line);
}

// Divides an edge of a line, or one from line to line, where no vertex is free to be split.
inline bool Vertex_count::split_edge(const Index h)
{
  const std::array<Index, 4> around = corners(h);
  Remeshed_surface::Spot middle;
  if(!remeshed_.find_middle(h, middle))
    return false;
  const double before = worst_around(around);
  const Index w = table_.split_edge(h);
  remeshed_.put(w, middle);
  touched_[around[0]] = touched_[around[1]] = true;
  return settle({{w, w, around[2], around[3]}}, before);
}

// The vertex and the new one part along the line between their halves of the ring.
inline bool Vertex_count::split(const Index h, const Index other)
{
  const Index v = table_.source(h), c = table_.target(h), d = table_.target(other);
  const double before = worst_around({{v, v, c, d}});
  const Index w = table_.split(h, other);
  remeshed_.put(w, remeshed_.spot(v));
  remeshed_.put(w, remeshed_.spot_after(w, .5 * remeshed_.way_to_center_of_neighbors(w)));
  if(!remeshed_.is_fixed(v))
    remeshed_.put(v, remeshed_.spot_after(v, .5 * remeshed_.way_to_center_of_neighbors(v)));
  return settle({{v, w, c, d}}, before);
}

inline double Vertex_count::worst_around(const std::array<Index, 4>& vertices) const
{
  double worst = 0.;
  for(const Index v : vertices)
    worst = (std::max)(worst, remeshed_.ring_badness(v));
  return worst;
}

// Relaxes the vertices whose valence has changed; refuses what leaves a face turned or worse than the rounds to come
// mend: of little help is that to the vertices of lines, which cannot give way. But where it was as bad before, as
// between lines nearer to each other than the edges are long, nothing is lost.
inline bool Vertex_count::settle(const std::array<Index, 4>& changed, const double before, const bool is_line)
{
  const double angle = is_line ? (std::min)(least_angle_on_lines_, least_angle_on_lines_ - 10. + least_angle_) : least_angle_;
  const double mendable = is_line ? badness_of_angle(angle) : (std::max)(badness_of_angle(angle), before);
  for(int round = 0; round < 2; ++round)
    for(const Index v : changed)
      if(!remeshed_.is_fixed(v))
        relax_vertex(remeshed_, v);
  if(worst_around(changed) > mendable)
    return false;
  for(const Index v : changed)
    touched_[v] = true;
  return true;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_COUNT_H
