// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_REFINEMENT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_REFINEMENT_H

#include <CGAL/Geodesic_remeshing/internal/Conflict_search.h>
#include <CGAL/Geodesic_remeshing/internal/Conflict_sizing.h>
#include <CGAL/Geodesic_remeshing/internal/Intersection_repair.h>
#include <CGAL/Geodesic_remeshing/internal/Polish.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_count.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/find_middle.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What is in conflict; but no faces where that is the input's doing, or so much of the mesh that it is not a few places
// that need more vertices.
inline Conflicts conflicts_worth_mending(const Remeshed_surface& remeshed, const std::size_t number_of_vertices)
{
  Conflicts conflicts = find_conflicts(remeshed);
  if(conflicts.number > most_conflicts(number_of_vertices) ||
     is_input_in_conflict(remeshed.walker().surface(), places_of(remeshed, conflicts).places))
    conflicts.faces.clear();
  return conflicts;
}

// Where a triangle is too large for what is near to it, it cuts through another sheet wherever its corners are, or
// turns over in a fold: the surface needs smaller ones there. Those in conflict are divided until they are not, and as
// many vertices are taken away elsewhere. That is kept if fewer conflicts are left, which matters more than angles;
// else all of it is taken back, as where the input intersects itself.
class Conflict_refinement
{
public:
  using Index = Lean_triangulation::Index;

  Conflict_refinement(Remeshed_surface& remeshed, const double edge_length)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_edge_length(edge_length)
  {}

  // Returns what is left, without faces if it is not worth mending.
  Conflicts run(std::size_t number_of_vertices);

private:
  void polish_turned_faces(std::size_t number_of_vertices);
  void refine(const Conflicts& conflicts, std::size_t most_vertices);
  void divide(const std::vector<Index>& faces);
  bool divide_longest_edge(Index f);
  void repair();
  bool reach(std::size_t number_of_vertices);

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  double m_edge_length;
  std::vector<Index> m_zone; // the new vertices
};

inline bool Conflict_refinement::divide_longest_edge(const Index f)
{
  const auto length = [&](const Index h) {
    return squared_distance(m_remeshed.spot(m_table.source(h)).point, m_remeshed.spot(m_table.target(h)).point);
  };
  Index longest = 4 * f;
  for(Index h = 4 * f + 1; h < 4 * f + 3; ++h)
    if(length(h) > length(longest))
      longest = h;
  Remeshed_surface::Spot middle;
  if(!find_middle(m_remeshed, longest, middle))
    return false;
  const Index w = m_table.split_edge(longest);
  m_remeshed.put_new(w, middle);
  m_zone.push_back(w);
  return true;
}

inline void Conflict_refinement::divide(const std::vector<Index>& faces)
{
  m_remeshed.reserve_free(static_cast<Index>(faces.size()));
  for(const Index f : faces)
    divide_longest_edge(f);
}

// With whatever angles that takes: most of these can be bettered.
inline void Conflict_refinement::repair()
{
  Intersection_repair repair(m_remeshed);
  for(const double angle : {30., 25., 20., 10., 5.})
    if(repair.run(badness_of_angle(angle), true) == 0)
      break;
}

// Without taking away what has just been put in
inline bool Conflict_refinement::reach(const std::size_t number_of_vertices)
{
  std::vector<Index> pinned;
  for(const Index v : m_zone)
    if(!m_table.is_removed(v) && !m_remeshed.is_fixed(v))
    {
      pinned.push_back(v);
      m_remeshed.pin_tip(v);
    }
  const bool is_reached = Vertex_count(m_remeshed, m_edge_length, 30.).reach(number_of_vertices);
  for(const Index v : pinned)
    m_remeshed.let_go(v);
  return is_reached;
}

// Where sheets are apart from each other this converges; where the input intersects itself smaller triangles intersect
// more often. Leaves the best there was.
inline void Conflict_refinement::refine(const Conflicts& conflicts, const std::size_t most_vertices)
{
  constexpr int patience = 3;
  std::vector<Index> faces = conflicts.faces;
  std::size_t least = conflicts.number;
  Remeshed_surface::State best = m_remeshed.state();
  std::vector<Index> zone_of_best;
  for(int in_vain = 0; in_vain < patience && least > 0 && m_table.number_of_vertices() < most_vertices; ++in_vain)
  {
    divide(faces);
    Polish(m_remeshed).run(2. * worst_badness, true); // those that are turned
    repair();
    const Conflicts left = find_conflicts(m_remeshed);
    faces = left.faces;
    if(left.number < least)
    {
      in_vain = -1;
      least = left.number;
      best = m_remeshed.state();
      zone_of_best = m_zone;
    }
  }
  m_remeshed.restore(best);
  m_zone = std::move(zone_of_best); // later ones name vertices that are not there any more
}

// Turned faces beside each other, or where sheets intersect, the input's own too, need a polish that leaves as many
// intersections as there are. To part these as well, before faces are divided, made smallest angles of 24 to 37 degrees
// 10 to 22 on boeing, elephant, femur and turbine with 300 vertices.
inline void Conflict_refinement::polish_turned_faces(const std::size_t number_of_vertices)
{
  if(m_table.number_of_vertices() != number_of_vertices || find_turned_faces(m_remeshed).empty())
    return;
  const std::size_t before = find_conflicts(m_remeshed).number;
  const Remeshed_surface::State state = m_remeshed.state();
  for(int round = 0; round < 3; ++round)
    if(Polish(m_remeshed, false, true).run(2. * worst_badness, false) == 0)
      break;
  if(find_conflicts(m_remeshed).number >= before)
    m_remeshed.restore(state);
}

inline Conflicts Conflict_refinement::run(const std::size_t number_of_vertices)
{
  polish_turned_faces(number_of_vertices);
  const Conflicts conflicts = conflicts_worth_mending(m_remeshed, number_of_vertices);
  if(conflicts.faces.empty() || m_table.number_of_vertices() != number_of_vertices)
    return conflicts;
  const double worst_before = worst_badness_of(m_remeshed), poor = badness_of_angle(15.);
  const Remeshed_surface::State state = m_remeshed.state();
  refine(conflicts, number_of_vertices + number_of_vertices / 4);
  if(reach(number_of_vertices))
  {
    Polish(m_remeshed).run(badness_of_angle(30.), false);
    repair();
    const Conflicts left = find_conflicts(m_remeshed);
    if(left.number < conflicts.number && worst_badness_of(m_remeshed) <= (std::max)(worst_before, poor))
      return left;
  }
  m_remeshed.restore(state);
  return conflicts;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_REFINEMENT_H
