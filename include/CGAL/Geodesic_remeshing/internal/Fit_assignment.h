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
#include <numeric>
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

// Which face of the triangulation each sample of the input is nearest to. The triangulation as a whole is never
// searched: a search starts at the vertex that is nearest over the surface, later where the sample was; so two sheets
// that nearly touch do not take each other's samples, and after a step only the samples around it are searched for.
class Fit_assignment
{
public:
  using Index = Lean_triangulation::Index;
  using Search = Downhill_search<Point_of_remeshed>;
  using Foot = Search::Foot;
  static constexpr Index none = Lean_triangulation::none;

  // What is kept of a foot
  struct Assigned
  {
    Index face;
    double squared_distance, penalty;
  };

  Fit_assignment(const Remeshed_surface& remeshed, std::vector<Fit_sample> samples, double penalty);

  Index number_of_samples() const { return static_cast<Index>(m_samples.size()); }
  const Fit_sample& sample(const Index i) const { return m_samples[i]; }
  const Assigned& assigned(const Index i) const { return m_assigned[i]; }
  bool is_assigned(const Index i) const { return m_assigned[i].face != none; } // not on a component without vertices
  Foot foot(const Index i) const
  {
    return m_search.foot_in(m_assigned[i].face, m_samples[i].point, m_samples[i].normal);
  }
  Foot search(const Index i) const { return m_search.run(m_assigned[i].face, m_samples[i].point, m_samples[i].normal); }
  static Assigned summary(const Foot& foot) { return {foot.face, foot.nearest.squared_distance, foot.penalty()}; }

  template <class Visit>
  void for_each_sample_of(const Index f, const Visit& visit) const
  {
    for(Index i = m_first[f]; i != none; i = m_links[i].next)
      visit(i);
  }

  void assign(Index i, const Assigned& assigned);
  void search_all();
  void move_samples(Index from, Index to); // of a face that is about to disappear to where their searches are to start
  void grow() { m_first.resize(m_table.face_slots(), none); }

  // A trial, as those of `Remeshed_surface`
  void record() { m_is_recording = true; }
  std::size_t mark() const { return m_journal.size(); }
  void undo_to(std::size_t mark);
  void forget()
  {
    m_journal.clear();
    m_is_recording = false;
  }

private:
  struct Link
  {
    Index next, previous;
  };

  // The vertices of the triangulation by the faces of the input where they are
  struct Vertices_of_faces
  {
    std::vector<Index> first, vertices;
    explicit Vertices_of_faces(const Remeshed_surface& remeshed);
  };

  Foot foot_around(Index v, const Fit_sample& sample) const;
  Foot first_foot(const Fit_sample& sample, const Nearest_vertices& nearest, const Vertices_of_faces& in_faces) const;
  void unlink(Index i);

  const Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const Search m_search;
  std::vector<Fit_sample> m_samples;
  std::vector<Assigned> m_assigned;
  std::vector<Link> m_links;  // of the samples of a face
  std::vector<Index> m_first; // of a face
  std::vector<std::pair<Index, Assigned>> m_journal;
  bool m_is_recording = false;
};

inline Fit_assignment::Fit_assignment(const Remeshed_surface& remeshed, std::vector<Fit_sample> samples,
                                      const double penalty)
  : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_search(m_table, {&remeshed}, penalty),
    m_samples(std::move(samples)), m_assigned(m_samples.size(), Assigned{none, 0., 0.}),
    m_links(m_samples.size(), Link{none, none}), m_first(m_table.face_slots(), none)
{
  const Nearest_vertices nearest(remeshed);
  const Vertices_of_faces in_faces(remeshed);
  for(Index i = 0; i < m_samples.size(); ++i)
  {
    const Foot foot = first_foot(m_samples[i], nearest, in_faces);
    if(foot.face != none)
      assign(i, summary(foot));
  }
}

inline Fit_assignment::Vertices_of_faces::Vertices_of_faces(const Remeshed_surface& remeshed)
  : first(remeshed.walker().triangulation().face_slots() + 1, 0)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const auto face_of = [&](const Index v) { return static_cast<Index>(remeshed.spot(v).place.face); };
  for(Index v = 0; v < table.vertex_slots(); ++v)
    if(!table.is_removed(v))
      ++first[face_of(v)];
  std::partial_sum(first.begin(), first.end(), first.begin());
  vertices.resize(first.back());
  for(Index v = table.vertex_slots(); v-- > 0;)
    if(!table.is_removed(v))
      vertices[--first[face_of(v)]] = v;
}

inline Fit_assignment::Foot Fit_assignment::foot_around(const Index v, const Fit_sample& sample) const
{
  Foot best{none, {}, infinity};
  if(v == none)
    return best;
  m_table.for_each_outgoing(v, [&](const Index h) {
    const Foot foot = m_search.foot_in(Lean_triangulation::face(h), sample.point, sample.normal);
    if(foot.judged_distance < best.judged_distance)
      best = foot;
  });
  return m_search.run(best.face, sample.point, sample.normal);
}

// From the vertices near the corners of the input's face, and from one within the face where it is larger than the
// triangles: from a corner far away a search may end on the other side of a thin wall.
inline Fit_assignment::Foot Fit_assignment::first_foot(const Fit_sample& sample, const Nearest_vertices& nearest,
                                                       const Vertices_of_faces& in_faces) const
{
  constexpr Index most = 16; // of those within, evenly from all
  const Lean_triangulation& input = m_remeshed.walker().triangulation();
  const auto nearer_of = [&](const Index v, const Index w) {
    const auto distance = [&](const Index x) {
      return x == none ? infinity : CGAL::squared_distance(sample.point, m_remeshed.spot(x).point);
    };
    return distance(w) < distance(v) ? w : v;
  };
  Index at_corner = none, within = none;
  for(Index h = 4 * sample.face; h < 4 * sample.face + 3; ++h)
    at_corner = nearer_of(at_corner, nearest.vertex[input.source(h)]);
  const Index begin = in_faces.first[sample.face], end = in_faces.first[sample.face + 1];
  for(Index i = begin; i < end; i += (end - begin + most - 1) / most)
    within = nearer_of(within, in_faces.vertices[i]);
  const Foot foot = foot_around(at_corner, sample), other = foot_around(within, sample);
  return other.judged_distance < foot.judged_distance ? other : foot;
}

inline void Fit_assignment::unlink(const Index i)
{
  const Link& link = m_links[i];
  (link.previous == none ? m_first[m_assigned[i].face] : m_links[link.previous].next) = link.next;
  if(link.next != none)
    m_links[link.next].previous = link.previous;
}

inline void Fit_assignment::assign(const Index i, const Assigned& assigned)
{
  if(m_is_recording)
    m_journal.push_back({i, m_assigned[i]});
  if(m_assigned[i].face != assigned.face)
  {
    if(m_assigned[i].face != none)
      unlink(i);
    Index& first = m_first[assigned.face];
    m_links[i] = {first, none};
    if(first != none)
      m_links[first].previous = i;
    first = i;
  }
  m_assigned[i] = assigned;
}

inline void Fit_assignment::search_all()
{
  for(Index i = 0; i < m_samples.size(); ++i)
    if(is_assigned(i))
      assign(i, summary(search(i)));
}

inline void Fit_assignment::move_samples(const Index from, const Index to)
{
  while(m_first[from] != none)
  {
    const Assigned& old = m_assigned[m_first[from]];
    assign(m_first[from], {to, old.squared_distance, old.penalty});
  }
}

inline void Fit_assignment::undo_to(const std::size_t mark)
{
  const bool was_recording = m_is_recording;
  m_is_recording = false;
  for(; m_journal.size() > mark; m_journal.pop_back())
    assign(m_journal.back().first, m_journal.back().second);
  m_is_recording = was_recording;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_ASSIGNMENT_H
