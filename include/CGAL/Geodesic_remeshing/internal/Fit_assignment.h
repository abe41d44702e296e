// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ASSIGNMENT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ASSIGNMENT_H

#include <CGAL/Geodesic_remeshing/internal/Downhill_search.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/fit_samples.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

struct Point_of_remeshed
{
  const Remeshed_surface* remeshed;
  const Point& operator()(const Lean_triangulation::Index v) const { return remeshed->spot(v).point; }
};

// Which face of the triangulation each sample of the input is nearest to. The triangulation as a whole is never searched: a search
// starts at the vertex that is nearest over the surface, later where the sample was; so two sheets that nearly touch do not take
// each other's samples, and after a step only the samples around it are searched for.
class Fit_assignment
{
public:
  using Index = Lean_triangulation::Index;
  using Search = Downhill_search<Point_of_remeshed>;
  using Foot = Search::Foot;
  static constexpr Index none = Lean_triangulation::none;

  // What is kept of a foot
  struct Assigned { Index face; double squared_distance, penalty; };

  Fit_assignment(const Remeshed_surface& remeshed, std::vector<Fit_sample> samples, double penalty);

  Index number_of_samples() const { return static_cast<Index>(samples_.size()); }
  const Fit_sample& sample(const Index i) const { return samples_[i]; }
  const Assigned& assigned(const Index i) const { return assigned_[i]; }
  bool is_assigned(const Index i) const { return assigned_[i].face != none; }   // not on a component without vertices
  Foot foot(const Index i) const { return search_.foot_in(assigned_[i].face, samples_[i].point, samples_[i].normal); }
  Foot search(const Index i) const { return search_.run(assigned_[i].face, samples_[i].point, samples_[i].normal); }
  static Assigned summary(const Foot& foot) { return {foot.face, foot.nearest.squared_distance, foot.penalty()}; }

  template <class Visit> void for_each_sample_of(const Index f, const Visit& visit) const
  {
    for(Index i = first_[f]; i != none; i = links_[i].next)
      visit(i);
  }

  void assign(Index i, const Assigned& assigned);
  void search_all();
  void move_samples(Index from, Index to);     // of a face that is about to disappear to where their searches are to start
  void grow() { first_.resize(table_.face_slots(), none); }

  // A trial, as those of `Remeshed_surface`
  void record() { is_recording_ = true; }
  std::size_t mark() const { return journal_.size(); }
  void undo_to(std::size_t mark);
  void forget() { journal_.clear(); is_recording_ = false; }

private:
  struct Link { Index next, previous; };

  Foot first_foot(const Fit_sample& sample, const Nearest_vertices& nearest) const;
  void unlink(Index i);

  const Remeshed_surface& remeshed_;
  const Lean_triangulation& table_;
  const Search search_;
  std::vector<Fit_sample> samples_;
  std::vector<Assigned> assigned_;
  std::vector<Link> links_;                                   // of the samples of a face
  std::vector<Index> first_;                                  // of a face
  std::vector<std::pair<Index, Assigned>> journal_;
  bool is_recording_ = false;
};

inline Fit_assignment::Fit_assignment(const Remeshed_surface& remeshed, std::vector<Fit_sample> samples,
                                      const double penalty)
  : remeshed_(remeshed), table_(remeshed.connectivity()), search_(table_, {&remeshed}, penalty)
  , samples_(std::move(samples)), assigned_(samples_.size(), Assigned{none, 0., 0.})
  , links_(samples_.size(), Link{none, none}), first_(table_.face_slots(), none)
{
  const Nearest_vertices nearest(remeshed);
  for(Index i = 0; i < samples_.size(); ++i) {
    const Foot foot = first_foot(samples_[i], nearest);
    if(foot.face != none)
      assign(i, summary(foot));
  }
}

inline Fit_assignment::Foot Fit_assignment::first_foot(const Fit_sample& sample, const Nearest_vertices& nearest) const
{
  const Lean_triangulation& input = remeshed_.walker().triangulation();
  Index vertex = none;
  double least = infinity;
  for(Index h = 4 * sample.face; h < 4 * sample.face + 3; ++h) {
    const Index v = nearest.vertex[input.source(h)];
    const double distance = v == none ? infinity : CGAL::squared_distance(sample.point, remeshed_.spot(v).point);
    if(distance < least) {
      least = distance;
      vertex = v;
    }
  }
  Foot best{none, {}, infinity};
  if(vertex == none)
    return best;
  table_.for_each_outgoing(vertex, [&](const Index h) {
    const Foot foot = search_.foot_in(Lean_triangulation::face(h), sample.point, sample.normal);
    if(foot.judged_distance < best.judged_distance)
      best = foot;
  });
  return search_.run(best.face, sample.point, sample.normal);
}

inline void Fit_assignment::unlink(const Index i)
{
  const Link& link = links_[i];
  (link.previous == none ? first_[assigned_[i].face] : links_[link.previous].next) = link.next;
  if(link.next != none)
    links_[link.next].previous = link.previous;
}

inline void Fit_assignment::assign(const Index i, const Assigned& assigned)
{
  if(is_recording_)
    journal_.push_back({i, assigned_[i]});
  if(assigned_[i].face != assigned.face) {
    if(assigned_[i].face != none)
      unlink(i);
    Index& first = first_[assigned.face];
    links_[i] = {first, none};
    if(first != none)
      links_[first].previous = i;
    first = i;
  }
  assigned_[i] = assigned;
}

inline void Fit_assignment::search_all()
{
  for(Index i = 0; i < samples_.size(); ++i)
    if(is_assigned(i))
      assign(i, summary(search(i)));
}

inline void Fit_assignment::move_samples(const Index from, const Index to)
{
  while(first_[from] != none) {
    const Assigned& old = assigned_[first_[from]];
    assign(first_[from], {to, old.squared_distance, old.penalty});
  }
}

inline void Fit_assignment::undo_to(const std::size_t mark)
{
  const bool was_recording = is_recording_;
  is_recording_ = false;
  for(; journal_.size() > mark; journal_.pop_back())
    assign(journal_.back().first, journal_.back().second);
  is_recording_ = was_recording;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ASSIGNMENT_H
