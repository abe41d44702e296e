// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_LEDGER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_LEDGER_H

#include <CGAL/Geodesic_remeshing/internal/Fit_assignment.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_cost.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What the deviations of the samples of the input cost: those of a few faces, before and after a step, and the change
// of all since a trial began.
class Fit_ledger
{
public:
  using Index = Lean_triangulation::Index;
  using Assigned = Fit_assignment::Assigned;

  Fit_ledger(Remeshed_surface& remeshed, Fit_assignment& assignment)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_assignment(assignment)
  {}

  Fit_cost& cost() { return m_cost; }
  double root_mean_square() const;

  // The samples of some faces, for which `search_gathered()` searches where they are now.
  template <class Faces>
  void gather(const Faces& faces);
  void gather_ring(Index v);
  double search_gathered(double limit); // their cost, no more than something above the limit
  void assign_gathered();
  double sample_cost(const Index i) const { return sample_cost(i, m_assignment.assigned(i)); }

  // A trial of many steps; `change()` is that of the cost of all samples since its begin.
  struct Mark
  {
    Remeshed_surface::Mark surface;
    std::size_t samples;
    double change;
  };
  void begin_trial();
  Mark mark() const { return {m_remeshed.mark(), m_assignment.mark(), m_change}; }
  double change() const { return m_change; }
  void undo_to(const Mark& mark);
  void end_trial();

protected:
  double sample_cost(const Index i, const Assigned& assigned) const
  {
    return m_assignment.sample(i).weight * (m_cost.of(assigned.squared_distance) + assigned.penalty);
  }
  double gathered_cost() const;

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  Fit_assignment& m_assignment;
  Fit_cost m_cost;
  double m_change = 0.;
  bool m_is_trial = false;
  std::vector<Index> m_gathered;
  std::vector<Assigned> m_found; // where the gathered samples are now
};

inline void Fit_ledger::begin_trial()
{
  m_remeshed.record();
  m_assignment.record();
  m_is_trial = true;
  m_change = 0.;
}

inline void Fit_ledger::undo_to(const Mark& mark)
{
  m_remeshed.undo_to(mark.surface);
  m_assignment.undo_to(mark.samples);
  m_change = mark.change;
}

inline void Fit_ledger::end_trial()
{
  m_remeshed.forget();
  m_assignment.forget();
  m_is_trial = false;
}

inline double Fit_ledger::root_mean_square() const
{
  double sum = 0., weight = 0.;
  for(Index i = 0; i < m_assignment.number_of_samples(); ++i)
    if(m_assignment.is_assigned(i))
    {
      sum += m_assignment.sample(i).weight * m_assignment.assigned(i).squared_distance;
      weight += m_assignment.sample(i).weight;
    }
  return weight > 0. ? std::sqrt(sum / weight) : 0.;
}

template <class Faces>
void Fit_ledger::gather(const Faces& faces)
{
  m_gathered.clear();
  for(const Index f : faces)
    m_assignment.for_each_sample_of(f, [&](const Index i) { m_gathered.push_back(i); });
}

inline void Fit_ledger::gather_ring(const Index v)
{
  m_gathered.clear();
  m_table.for_each_outgoing(v, [&](const Index h) {
    m_assignment.for_each_sample_of(Lean_triangulation::face(h), [&](const Index i) { m_gathered.push_back(i); });
  });
}

inline double Fit_ledger::gathered_cost() const
{
  double sum = 0.;
  for(const Index i : m_gathered)
    sum += sample_cost(i);
  return sum;
}

inline double Fit_ledger::search_gathered(const double limit)
{
  double sum = 0.;
  m_found.clear();
  for(std::size_t k = 0; k < m_gathered.size() && sum <= limit; ++k)
  {
    m_found.push_back(Fit_assignment::summary(m_assignment.search(m_gathered[k])));
    sum += sample_cost(m_gathered[k], m_found.back());
  }
  return sum;
}

inline void Fit_ledger::assign_gathered()
{
  for(std::size_t k = 0; k < m_gathered.size(); ++k)
  {
    m_change += sample_cost(m_gathered[k], m_found[k]) - sample_cost(m_gathered[k]);
    m_assignment.assign(m_gathered[k], m_found[k]);
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_LEDGER_H
