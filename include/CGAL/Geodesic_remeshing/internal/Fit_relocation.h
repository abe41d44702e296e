// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_RELOCATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_RELOCATION_H

#include <CGAL/Geodesic_remeshing/internal/Fit_assignment.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_probes.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_steps.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Takes vertices out where they are needed least and puts as many in where steps alone do not help: at tips and in hollows that are
// narrower than the triangles. A vertex in and one out are one trial, so that their number never changes.
class Fit_relocation
{
public:
  using Index = Lean_triangulation::Index;

  Fit_relocation(Remeshed_surface& remeshed, Fit_assignment& assignment, Fit_probes& probes, Fit_steps& steps)
    : remeshed_(remeshed), table_(remeshed.connectivity()), assignment_(assignment), probes_(probes), steps_(steps) {}

  // For the faces that deviate by more than `deviation`, those first that cost most. Returns the number of vertices relocated.
  std::size_t run(double deviation);

  double largest_deviation();

private:
  struct Item { double cost; Index at; };
  // What a change touches
  struct Zone { std::vector<Index> vertices, faces; double cost, badness; };

  double largest_deviation(Index f);
  double cost(Index f);
  void rank();
  void mark_zone(std::initializer_list<Index> centers);
  double change_of_zone(double change_before);
  bool is_zone_good() const { return zone_badness() <= zone_.badness; }
  double zone_cost();
  double zone_badness() const;
  void settle();
  void regularize(Index v);
  bool split(Index h, double& change);
  bool split_an_edge(Index f, double& change);
  bool collapse(Index v, double& change);
  bool collapse_next(double gain);

  Remeshed_surface& remeshed_;
  Lean_triangulation& table_;
  Fit_assignment& assignment_;
  Fit_probes& probes_;
  Fit_steps& steps_;
  std::vector<Item> faces_, vertices_;           // the most costly faces first, the least costly vertices first
  std::size_t next_vertex_ = 0;
  Zone zone_;
  std::vector<Index> spokes_;
};

inline double Fit_relocation::largest_deviation(const Index f)
{
  double largest = probes_.largest_squared_distance(f);
  assignment_.for_each_sample_of(f, [&](const Index i) {
    largest = (std::max)(largest, assignment_.assigned(i).squared_distance);
  });
  return std::sqrt(largest);
}

inline double Fit_relocation::largest_deviation()
{
  double largest = 0.;
  for(Index f = 0; f < table_.face_slots(); ++f)
    if(!table_.is_removed_face(f))
      largest = (std::max)(largest, largest_deviation(f));
  return largest;
}

inline double Fit_relocation::cost(const Index f)
{
  double sum = probes_.face_cost(f, steps_.cost());
  assignment_.for_each_sample_of(f, [&](const Index i) { sum += steps_.sample_cost(i); });
  return sum;
}

inline void Fit_relocation::rank()
{
  faces_.clear();
  vertices_.clear();
  next_vertex_ = 0;
  std::vector<double> costs(table_.face_slots(), 0.);
  for(Index f = 0; f < table_.face_slots(); ++f)
    if(!table_.is_removed_face(f)) {
      costs[f] = cost(f);
      faces_.push_back({costs[f], f});
    }
  for(Index v = 0; v < table_.vertex_slots(); ++v)
    if(!table_.is_removed(v) && remeshed_.is_free(v)) {
      double sum = 0.;
      table_.for_each_outgoing(v, [&](const Index h) { sum += costs[Lean_triangulation::face(h)]; });
      vertices_.push_back({sum, v});
    }
  std::sort(faces_.begin(), faces_.end(), [](const Item& x, const Item& y) {
    return std::tie(y.cost, x.at) < std::tie(x.cost, y.at);
  });
  std::sort(vertices_.begin(), vertices_.end(), [](const Item& x, const Item& y) {
    return std::tie(x.cost, x.at) < std::tie(y.cost, y.at);
  });
}

inline double Fit_relocation::zone_cost()
{
  double sum = 0.;
  for(const Index f : zone_.faces)
    if(!table_.is_removed_face(f))
      sum += probes_.face_cost(f, steps_.cost());
  return sum;
}

inline double Fit_relocation::zone_badness() const
{
  double worst = 0.;
  for(const Index f : zone_.faces)
    if(!table_.is_removed_face(f))
      worst = add_badness(worst, remeshed_.badness(table_.source(4 * f), table_.source(4 * f + 1), table_.source(4 * f + 2)));
  return worst;
}

// Some vertices, their neighbors and the faces around all of them
inline void Fit_relocation::mark_zone(const std::initializer_list<Index> centers)
{
  const auto make_unique = [](std::vector<Index>& x) {
    std::sort(x.begin(), x.end());
    x.erase(std::unique(x.begin(), x.end()), x.end());
  };
  zone_.vertices.assign(centers);
  for(const Index v : centers)
    table_.for_each_neighbor(v, [&](const Index w) { zone_.vertices.push_back(w); });
  make_unique(zone_.vertices);
  zone_.faces.clear();
  for(const Index v : zone_.vertices)
    table_.for_each_outgoing(v, [&](const Index h) { zone_.faces.push_back(Lean_triangulation::face(h)); });
  make_unique(zone_.faces);
  zone_.cost = zone_cost();
  zone_.badness = (std::max)(fit_badness(), zone_badness());
}

inline double Fit_relocation::change_of_zone(const double change_before)
{
  return steps_.change() - change_before + zone_cost() - zone_.cost;
}

inline void Fit_relocation::regularize(const Index v)
{
  spokes_.clear();
  table_.for_each_outgoing(v, [&](const Index h) { spokes_.push_back(h); });
  for(const Index h : spokes_)
    // a flip before may have made another edge of it
    if(table_.source(h) == v && !table_.is_constrained(h) && !steps_.is_edge_frozen(h)
       && is_flip_better(remeshed_, h))
      steps_.flip_and_search(h);
}

// First for the valences and the angles, which the change has spoilt, then for the deviations.
inline void Fit_relocation::settle()
{
  constexpr double strong_pull = .5;
  const auto move_each = [&](const double pull) {
    for(const Index v : zone_.vertices)
      if(!table_.is_removed(v) && !remeshed_.is_fixed(v))
        steps_.move(v, pull);
  };
  for(int round = 0; round < 2; ++round) {
    for(const Index v : zone_.vertices)
      if(!table_.is_removed(v))
        regularize(v);
    move_each(strong_pull);
  }
  for(const Index f : zone_.faces)
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
      if(!table_.is_removed_face(f))
        steps_.flip(h);
  for(int round = 0; round < 2; ++round)
    move_each(Fit_steps::usual_pull);
}

inline bool Fit_relocation::split(const Index h, double& change)
{
  const Index o = table_.opposite(h);
  if(o == Lean_triangulation::none || table_.is_constrained(h) || steps_.is_edge_frozen(h))
    return false;
  const Index a = table_.source(h), b = table_.target(h), f = Lean_triangulation::face(h), g = Lean_triangulation::face(o);
  mark_zone({a, b, table_.apex(h), table_.apex(o)});
  const double before = steps_.change();
  steps_.gather(std::array<Index, 2>{{f, g}});
  const Remeshed_surface::Spot spot =
    steps_.spot_at(CGAL::midpoint(remeshed_.spot(a).point, remeshed_.spot(b).point), remeshed_.spot(a).place.face);
  const Index w = table_.split_edge(h);
  remeshed_.put(w, spot);
  table_.for_each_outgoing(w, [&](const Index k) {
    const Index x = Lean_triangulation::face(k);
    if(x != f && x != g) {
      zone_.faces.push_back(x);
      probes_.forget(x);
    }
  });
  steps_.search_gathered(infinity);
  steps_.assign_gathered();
  zone_.vertices.push_back(w);
  settle();
  change = change_of_zone(before);
  return is_zone_good();
}

// Onto the nearest neighbor that it may become one with.
inline bool Fit_relocation::collapse(const Index v, double& change)
{
  Index h = Lean_triangulation::none;
  double least = infinity;
  bool is_frozen = steps_.is_frozen(v);
  table_.for_each_neighbor(v, [&](const Index w) { is_frozen = is_frozen || steps_.is_frozen(w); });
  if(is_frozen)
    return false;
  table_.for_each_outgoing(v, [&](const Index k) {
    const double distance = CGAL::squared_distance(remeshed_.spot(v).point, remeshed_.spot(table_.target(k)).point);
    if(distance < least && table_.is_collapse_legal(table_.opposite(k))) {
      least = distance;
      h = table_.opposite(k);
    }
  });
  if(h == Lean_triangulation::none)
    return false;
  mark_zone({v});
  const double before = steps_.change();
  const Index o = table_.opposite(h);
  assignment_.move_samples(Lean_triangulation::face(h), Lean_triangulation::face(table_.opposite(Lean_triangulation::next(h))));
  assignment_.move_samples(Lean_triangulation::face(o), Lean_triangulation::face(table_.opposite(Lean_triangulation::previous(o))));
  steps_.gather_ring(v);
  table_.collapse(h);
  steps_.search_gathered(infinity);
  steps_.assign_gathered();
  settle();
  change = change_of_zone(before);
  return is_zone_good();
}

inline bool Fit_relocation::split_an_edge(const Index f, double& change)
{
  std::array<Index, 3> edges = {{4 * f, 4 * f + 1, 4 * f + 2}};
  const auto length = [&](const Index h) {
    return CGAL::squared_distance(remeshed_.spot(table_.source(h)).point, remeshed_.spot(table_.target(h)).point);
  };
  std::sort(edges.begin(), edges.end(), [&](const Index x, const Index y) { return length(x) > length(y); });
  const Fit_steps::Mark mark = steps_.mark();
  for(const Index h : edges) {
    if(split(h, change) && change < 0.)
      return true;
    steps_.undo_to(mark);
  }
  return false;
}

// Takes out the first of the next few vertices that costs less than was gained.
inline bool Fit_relocation::collapse_next(const double gain)
{
  constexpr int trials = 4;
  const Fit_steps::Mark mark = steps_.mark();
  for(int trial = 0; trial < trials; ++trial) {
    while(next_vertex_ < vertices_.size() && table_.is_removed(vertices_[next_vertex_].at))
      ++next_vertex_;
    if(next_vertex_ == vertices_.size())
      return false;
    double loss;
    if(collapse(vertices_[next_vertex_++].at, loss) && loss < gain)
      return true;
    steps_.undo_to(mark);
  }
  return false;
}

inline std::size_t Fit_relocation::run(const double deviation)
{
  rank();
  remeshed_.reserve_free(1);
  assignment_.grow();
  probes_.grow();
  std::size_t number = 0;
  for(const Item& item : faces_) {
    // What was done for a face may have served its neighbors too.
    if(table_.is_removed_face(item.at) || largest_deviation(item.at) < deviation || cost(item.at) < .5 * item.cost)
      continue;
    steps_.begin_trial();
    const Fit_steps::Mark start = steps_.mark();
    double change;
    if(split_an_edge(item.at, change) && collapse_next(-change))
      ++number;
    else
      steps_.undo_to(start);
    steps_.end_trial();
  }
  assignment_.search_all();
  return number;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_RELOCATION_H
