// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_DESCENT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_DESCENT_H

#include <CGAL/Geodesic_remeshing/internal/Deviation_trial.h>
#include <CGAL/Geodesic_remeshing/internal/Deviations.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Moves vertices over the surface where the triangulation is farthest from it. What decides the Hausdorff distance are
// a few places: ridges and ends of limbs between vertices, hollows that a triangle spans. There the vertices of the
// nearest triangle go where the deviations around them are least, as far as the angles allow it. On a large mesh in
// rounds of several places far from each other, which threads share: one thread makes the same rounds.
class Deviation_descent
{
public:
  using Index = Lean_triangulation::Index;

  // `nearest` may be that of some steps ago. No triangle gets worse than `badness` that is not.
  Deviation_descent(Remeshed_surface& remeshed, const Nearest_vertices& nearest, const double badness)
    : m_table(remeshed.connectivity()), m_block_size(remeshed.block_size()), m_nearest(nearest),
      m_deviations(remeshed, nearest), m_trials([this, &remeshed, &nearest, badness] {
        return Deviation_trial(remeshed, nearest, m_deviations, badness);
      })
  {}

  // Works at the largest deviations, so many times, but not at what is below the least: on a plane that is rounding.
  void run(std::size_t number_of_trials, double least);

private:
  using Deviation = Deviations::Deviation;

  struct Trial
  {
    Deviation trouble;
    Index face; // near it
    bool has_moved;
    double after;
  };

  std::vector<Trial> next_round(std::size_t most);
  void finish(const Trial& trial, double least);
  void mark_near(Index f);
  bool is_near_others(Index v) const { return m_near_at[v] == m_time; }
  bool is_near_others(const Deviation& trouble) const
  {
    return is_near_others(trouble.is_of_input ? m_nearest.vertex[trouble.at] : m_table.source(4 * trouble.at));
  }
  bool is_face_near_others(const Index f) const
  {
    return is_near_others(m_table.source(4 * f)) || is_near_others(m_table.source(4 * f + 1)) ||
           is_near_others(m_table.source(4 * f + 2));
  }
  void put_back(const Deviation& trouble)
  {
    m_heap.push_back(trouble);
    std::push_heap(m_heap.begin(), m_heap.end());
  }
  Deviation take_largest()
  {
    std::pop_heap(m_heap.begin(), m_heap.end());
    const Deviation result = m_heap.back();
    m_heap.pop_back();
    return result;
  }

  const Lean_triangulation& m_table;
  const Block_size m_block_size;
  const Nearest_vertices& m_nearest;
  const Deviations m_deviations;
  Per_thread<Deviation_trial> m_trials;
  std::vector<Deviation> m_heap;
  std::vector<char> m_is_stuck; // of a face
  std::vector<Index> m_near_at; // of a vertex: in which round a trial was near
  Index m_time = 0;
};

// The vertices that another trial must not move: this one looks at those up to two edges from the face's, and what its
// trouble is now says the nearest vertex of the input's vertex, perhaps a neighbor of these, with all up to two edges
// from it.
inline void Deviation_descent::mark_near(const Index f)
{
  const auto mark = [&](const Index v) { m_near_at[v] = m_time; };
  for(Index h = 4 * f; h < 4 * f + 3; ++h)
    m_table.for_each_neighbor(m_table.source(h), [&](const Index v) {
      m_table.for_each_neighbor(v, [&](const Index w) { m_table.for_each_neighbor(w, mark); });
    });
}

// The largest deviations of which none is near another. Where nothing helps all that is nearest to the same face is
// left until a vertex around it has moved.
inline std::vector<Deviation_descent::Trial> Deviation_descent::next_round(const std::size_t most)
{
  constexpr double least_of_round = .5; // of the largest: without a bound trials go where they help little
  std::vector<Trial> result;
  std::vector<Deviation> later;
  ++m_time;
  while(result.size() < most && later.size() < 4 * most && !m_heap.empty())
  {
    Deviation trouble = take_largest();
    if(is_near_others(trouble))
    {
      later.push_back(trouble);
      continue;
    }
    trouble.squared = m_deviations.now(trouble); // may have been bettered with another one
    if(!m_heap.empty() && trouble < m_heap.front())
    {
      put_back(trouble);
      continue;
    }
    if(!result.empty() && trouble.squared < least_of_round * result.front().trouble.squared)
    {
      put_back(trouble);
      break;
    }
    const Index f = m_deviations.face_near(trouble);
    if(f == Lean_triangulation::none || m_is_stuck[f]) // none if the distances overflow
      continue;
    if(is_face_near_others(f))
    {
      later.push_back(trouble);
      continue;
    }
    result.push_back({trouble, f, false, 0.});
    mark_near(f);
  }
  for(const Deviation& trouble : later)
    put_back(trouble);
  return result;
}

// A trouble that is bettered may still be the largest.
inline void Deviation_descent::finish(const Trial& trial, const double least)
{
  m_is_stuck[trial.face] = !trial.has_moved;
  for(Index h = 4 * trial.face; h < 4 * trial.face + 3 && trial.has_moved; ++h)
    m_table.for_each_outgoing(m_table.source(h), [&](const Index k) { m_is_stuck[Lean_triangulation::face(k)] = 0; });
  if(trial.after < .9 * trial.trouble.squared && trial.after > CGAL::square(least))
    put_back({trial.after, trial.trouble.is_of_input, trial.trouble.at});
}

// Some of those on the list are bettered with others: it has to be longer than there are trials.
inline void Deviation_descent::run(const std::size_t number_of_trials, const double least)
{
  if(number_of_trials == 0)
    return;
  m_heap = m_deviations.largest(4 * number_of_trials, CGAL::square(least));
  std::make_heap(m_heap.begin(), m_heap.end());
  m_is_stuck.assign(m_table.face_slots(), 0);
  m_near_at.assign(m_table.vertex_slots(), 0);
  constexpr std::size_t rounds = 32; // and some more; in fewer the largest deviations would have too few turns
  const std::size_t most = m_block_size.bits == Block_size::one_block ? 1 : number_of_trials / rounds + 1;
  for(std::size_t left = number_of_trials; left > 0;)
  {
    std::vector<Trial> round = next_round((std::min)(most, left));
    if(round.empty())
      break;
    const auto make = [&](const std::size_t i) {
      Trial& trial = round[i];
      trial.has_moved = m_trials.local().run(trial.face, trial.trouble.squared);
      trial.after = m_deviations.now(trial.trouble);
    };
    parallel_for(m_block_size.concurrency, round.size(), make, 1);
    for(const Trial& trial : round)
      finish(trial, least);
    left -= round.size();
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_DEVIATION_DESCENT_H
