// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SEARCH_REFUSALS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SEARCH_REFUSALS_H

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The searches for flips that found nothing, and what has been flipped since: where it is nothing that they looked at,
// none is made again. Most irregular vertices are searched from in sweep after sweep.
class Search_refusals
{
public:
  using Index = Lean_triangulation::Index;
  using Corners = std::array<Index, 4>; // of the two faces at a flip

  explicit Search_refusals(const Lean_triangulation& table)
    : m_table(table), m_changed(table.vertex_slots(), 0), m_seen(table.vertex_slots(), 0),
      m_valence(table.vertex_slots(), 0), m_refusal(table.vertex_slots())
  {
    note_valences();
  }

  void begin_sweep()
  {
    note_flips();
    forget_old_visits();
  }
  void end_sweep() { note_valences(); }

  void begin_search()
  {
    ++m_time;
    m_begin = m_visited.size();
  }
  // The vertices whose edges a search looks at
  void note_visits(const Corners& corners);
  // Ends a search that made these flips.
  void note_success(const std::vector<Corners>& flips);
  // Ends a search from v that found nothing.
  void note_failure(const Index v, const std::size_t depth)
  {
    m_refusal[v] = {m_time, depth, m_begin, m_visited.size()};
  }

  // Whether a search from v would find nothing, as the last one did.
  bool is_refused(Index v, std::size_t depth) const;

private:
  // When, how deep, and which of the vertices visited are its own, each once
  struct Refusal
  {
    std::size_t time = 0, depth = 0, begin = 0, end = 0;
  };

  void note_valences();
  void note_flips();
  void note_change(Index v);
  void forget_old_visits();

  const Lean_triangulation& m_table;
  std::size_t m_time = 0, m_begin = 0;
  std::vector<std::size_t> m_changed; // when edges at a vertex or near it were flipped last
  std::vector<std::size_t> m_seen;    // the search that looked at a vertex last
  std::vector<Index> m_valence;       // at the end of the last sweep
  std::vector<Refusal> m_refusal;     // by vertex
  std::vector<Index> m_visited;
};

inline void Search_refusals::note_visits(const Corners& corners)
{
  for(const Index v : corners)
    if(m_seen[v] != m_time)
    {
      m_seen[v] = m_time;
      m_visited.push_back(v);
    }
}

inline void Search_refusals::note_success(const std::vector<Corners>& flips)
{
  m_visited.resize(m_begin);
  for(const Corners& corners : flips)
    for(const Index v : corners)
      note_change(v);
}

inline bool Search_refusals::is_refused(const Index v, const std::size_t depth) const
{
  const Refusal& refusal = m_refusal[v];
  return refusal.depth >= depth && std::all_of(m_visited.begin() + refusal.begin, m_visited.begin() + refusal.end,
                                               [&](const Index w) { return m_changed[w] <= refusal.time; });
}

inline void Search_refusals::note_valences()
{
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
    m_valence[v] = m_table.valence(v);
}

// What was flipped since the last sweep shows in the valences, but for rare cycles of flips.
inline void Search_refusals::note_flips()
{
  ++m_time;
  for(Index v = 0; v < m_table.vertex_slots(); ++v)
    if(!m_table.is_removed(v) && m_valence[v] != m_table.valence(v))
      note_change(v);
}

// The energy of a flip that a search looks at depends on valences up to two edges away.
inline void Search_refusals::note_change(const Index v)
{
  m_table.for_each_neighbor(
      v, [&](const Index w) { m_table.for_each_neighbor(w, [&](const Index x) { m_changed[x] = m_time; }); });
}

// Those of refusals that later searches from the same vertices have replaced
inline void Search_refusals::forget_old_visits()
{
  std::vector<Index> visited;
  for(Refusal& refusal : m_refusal)
  {
    const std::size_t begin = visited.size();
    visited.insert(visited.end(), m_visited.begin() + refusal.begin, m_visited.begin() + refusal.end);
    refusal.begin = begin;
    refusal.end = visited.size();
  }
  m_visited.swap(visited);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SEARCH_REFUSALS_H
