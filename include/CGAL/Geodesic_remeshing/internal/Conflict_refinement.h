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

#include <CGAL/Geodesic_remeshing/internal/Intersection_repair.h>
#include <CGAL/Geodesic_remeshing/internal/Intersection_search.h>
#include <CGAL/Geodesic_remeshing/internal/Polish.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_count.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where a triangle is too large for what is near to it, and cuts through another sheet wherever its corners are, the
// surface needs smaller ones: those that intersect are divided until they do not, and as many vertices are taken away
// elsewhere. All of it is taken back if intersections are left, as where the input intersects itself.
class Conflict_refinement
{
public:
  using Index = Lean_triangulation::Index;

  Conflict_refinement(Remeshed_surface& remeshed, const double edge_length)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_edge_length(edge_length)
  {}

  void run(std::size_t number_of_vertices);

private:
  using Pair = Intersection_search::Pair;

  std::vector<Pair> find_pairs() const { return Intersection_search(m_remeshed).run(); }
  bool refine(std::size_t number_of_vertices);
  void divide(const std::vector<Pair>& pairs);
  bool divide_longest_edge(Index f);
  void settle();
  void repair();
  bool reach(std::size_t number_of_vertices);
  double worst() const;

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  double m_edge_length;
  std::vector<Index> m_zone; // the new vertices and their neighbors
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
  if(!m_remeshed.find_middle(longest, middle))
    return false;
  const Index w = m_table.split_edge(longest);
  m_remeshed.put(w, middle);
  m_zone.push_back(w);
  return true;
}

inline void Conflict_refinement::divide(const std::vector<Pair>& pairs)
{
  std::vector<Index> faces;
  for(const Pair& pair : pairs)
    faces.insert(faces.end(), {pair.first, pair.second});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  m_remeshed.reserve_free(static_cast<Index>(faces.size()));
  for(const Index f : faces)
    divide_longest_edge(f);
}

// Flips and steps around what is new
inline void Conflict_refinement::settle()
{
  const std::size_t number = m_zone.size();
  for(std::size_t i = 0; i < number; ++i)
    m_table.for_each_neighbor(m_zone[i], [&](const Index w) { m_zone.push_back(w); });
  std::sort(m_zone.begin(), m_zone.end());
  m_zone.erase(std::unique(m_zone.begin(), m_zone.end()), m_zone.end());
  for(int round = 0; round < 2; ++round)
  {
    for(Index h = 0; h < 4 * m_table.face_slots(); ++h)
      if((h & 3) != 3 && !m_table.is_removed_face(Lean_triangulation::face(h)) && !m_table.is_constrained(h) &&
         h < m_table.opposite(h) && std::binary_search(m_zone.begin(), m_zone.end(), m_table.source(h)) &&
         is_flip_better(m_remeshed, h))
        m_table.flip(h);
    for(const Index v : m_zone)
      if(!m_remeshed.is_fixed(v))
        relax_vertex(m_remeshed, v);
  }
}

inline void Conflict_refinement::repair()
{
  Intersection_repair repair(m_remeshed);
  for(const double angle : {30., 25., 20.})
    if(repair.run(badness_of_angle(angle), true) == 0)
      break;
}

// Without taking away what has just been put in
inline bool Conflict_refinement::reach(const std::size_t number_of_vertices)
{
  std::vector<Index> pinned;
  for(const Index v : m_zone)
    if(!m_remeshed.is_fixed(v))
    {
      pinned.push_back(v);
      m_remeshed.pin_tip(v);
    }
  const bool is_reached = Vertex_count(m_remeshed, m_edge_length, 30.).reach(number_of_vertices);
  for(const Index v : pinned)
    m_remeshed.let_go(v);
  return is_reached;
}

inline double Conflict_refinement::worst() const
{
  double result = 0.;
  for(Index f = 0; f < m_table.face_slots(); ++f)
    if(!m_table.is_removed_face(f))
      result = add_badness(
          result, m_remeshed.badness(m_table.source(4 * f), m_table.source(4 * f + 1), m_table.source(4 * f + 2)));
  return result;
}

// Where sheets are apart from each other this converges; where the input intersects itself smaller triangles intersect
// more often. Returns whether no intersections are left.
inline bool Conflict_refinement::refine(const std::size_t number_of_vertices)
{
  constexpr int patience = 2;
  const std::size_t room = number_of_vertices + number_of_vertices / 4;
  std::vector<Pair> pairs = find_pairs();
  std::size_t least = pairs.size();
  for(int in_vain = 0; in_vain < patience && !pairs.empty() && m_table.number_of_vertices() < room; ++in_vain)
  {
    divide(pairs);
    settle();
    repair();
    pairs = find_pairs();
    if(pairs.size() < least)
    {
      in_vain = -1;
      least = pairs.size();
    }
  }
  return pairs.empty();
}

inline void Conflict_refinement::run(const std::size_t number_of_vertices)
{
  // More pairs than these are those of an input that intersects itself, where all would be tried in vain.
  const std::size_t most = 20 + number_of_vertices / 200, before = find_pairs().size();
  if(before == 0 || before > most || m_table.number_of_vertices() != number_of_vertices)
    return;
  const double worst_before = worst(), poor = badness_of_angle(15.);
  const Remeshed_surface::State state = m_remeshed.state();
  bool is_better = refine(number_of_vertices) && reach(number_of_vertices);
  if(is_better)
  {
    Polish(m_remeshed).run(badness_of_angle(30.), false);
    repair();
    is_better = find_pairs().empty() && worst() <= (std::max)(worst_before, poor);
  }
  if(!is_better)
    m_remeshed.restore(state);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CONFLICT_REFINEMENT_H
