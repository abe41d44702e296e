// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FAST_MARCHING_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FAST_MARCHING_H

#include <CGAL/Geodesic_remeshing/internal/Front.h>
#include <CGAL/Geodesic_remeshing/internal/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Distances that a front brings from the sources to the vertices, in the order of their arrival (section 3 of the
// paper, after Kimmel and Sethian). Where a face is crossed against that order - obtuse angles, of which the intrinsic
// Delaunay triangulation has left few - a vertex may be reached better after it was settled: it is then queued again,
// so that no unfolding of faces is needed.
class Fast_marching
{
  using Index = Intrinsic_triangulation::Index;
  using Spoke = Intrinsic_triangulation::Spoke;

public:
  explicit Fast_marching(const Intrinsic_triangulation& triangulation)
    : m_triangulation(&triangulation), m_state(triangulation.number_of_vertices())
  {}

  const Intrinsic_triangulation& triangulation() const { return *m_triangulation; }

  // The front starts at `v` with this value, which may be any number.
  void add_source(Vertex v, double distance = 0.) { add_source(v, distance, infinity); }

  // The way back to the source is known, too: it goes through the face of `v`, `right` and `left`, at this angle from
  // the edge to `right`.
  void add_source(Vertex v, double distance, Vertex right, Vertex left, double angle)
  {
    add_source(v, distance, direction_in_face(v, right, left, angle));
  }

  // Marches until the queue is empty. `domain(v)`: may the front enter `v`? `settle(v, distance)` is called in
  // ascending order whenever a vertex is taken from the queue, again if its distance has dropped later. When it returns
  // false the march stops at once, and another call would go on from there.
  template <typename Domain, typename Settle>
  void march(Front_shape shape, const Domain& domain, Settle&& settle)
  {
    if(shape == Front_shape::circular)
      march_shape<Front_shape::circular>(domain, settle, infinity);
    else
      march_shape<Front_shape::planar>(domain, settle, infinity);
  }

  // Marches over everything not farther than `maximum_distance`.
  void march(Front_shape shape, double maximum_distance = infinity)
  {
    const auto everywhere = [](Vertex) { return true; };
    const auto always = [](Vertex, double) { return true; };
    if(shape == Front_shape::circular)
      march_shape<Front_shape::circular>(everywhere, always, maximum_distance);
    else
      march_shape<Front_shape::planar>(everywhere, always, maximum_distance);
  }

  // Infinite where the front has not been.
  double distance(Vertex v) const { return m_state[v.idx()].distance; }

  // All vertices that have a distance, in the order in which they got their first one.
  const std::vector<Vertex>& reached() const { return m_reached; }

  // Forgets sources and distances, at the cost of what was reached.
  void clear()
  {
    for(const Vertex v : m_reached)
      m_state[v.idx()] = State();
    m_reached.clear();
    m_queue.clear();
    m_least = 0.;
  }

private:
  struct State
  {
    double distance = infinity;
    double direction = infinity; // of the way back, counterclockwise from the first spoke; infinite if unknown
    bool is_settled = false;     // left the queue with this distance
    unsigned char number_of_settlings = 0; // as far as they can be counted
  };

  struct Entry
  {
    double distance;
    Index vertex;

    // the heap has its smallest entry on top
    friend bool operator<(const Entry& a, const Entry& b)
    {
      return a.distance > b.distance || (!(a.distance < b.distance) && a.vertex > b.vertex);
    }
  };

  void add_source(Vertex v, double distance, double direction)
  {
    CGAL_precondition(static_cast<std::size_t>(v.idx()) < m_state.size());
    m_least = (std::min)(m_least, distance);
    lower(static_cast<Index>(v.idx()), distance, direction);
  }

  double direction_in_face(Vertex v, Vertex right, Vertex left, double angle) const
  {
    const Spoke* const end = m_triangulation->end(v);
    for(const Spoke* spoke = m_triangulation->begin(v); spoke != end; ++spoke)
      if(spoke->rim >= 0. && spoke[0].neighbor == right.idx() && spoke[1].neighbor == left.idx())
        return spoke->angle + angle;
    return infinity;
  }

  void lower(Index v, double distance, double direction)
  {
    State& state = m_state[v];
    if(!(distance < state.distance))
      return;
    if(!(state.distance < infinity))
      m_reached.push_back(Vertex(v));
    state.distance = distance;
    state.direction = direction;
    state.is_settled = false;
    m_queue.push_back(Entry{distance, v});
    std::push_heap(m_queue.begin(), m_queue.end());
  }

  template <Front_shape shape, typename Domain, typename Settle>
  void march_shape(const Domain& domain, Settle& settle, double maximum_distance);

  template <Front_shape shape, typename Domain>
  void spread_from(Index v, const Domain& domain, double maximum_distance);

  template <Front_shape shape>
  Arrival across_face(Index v, const Spoke& base, const Spoke& side, double rim, double orientation) const;

  bool is_worth(double distance, const Spoke& spoke) const;
  void arrive(const Arrival& arrival, const Spoke& spoke);

  bool may_come_earlier(double distance, double side_v, double side, double base) const;
  static double signed_angle(double angle, double full_angle);

  const Intrinsic_triangulation* m_triangulation;
  std::vector<State> m_state;
  std::vector<Vertex> m_reached;
  std::vector<Entry> m_queue; // a binary heap; an entry whose distance is no longer that of the vertex is dropped
  double m_least = 0.; // of what a distance can be: a source that has a distance stands for one that is that far away
};

template <Front_shape shape, typename Domain, typename Settle>
void Fast_marching::march_shape(const Domain& domain, Settle& settle, double maximum_distance)
{
  while(!m_queue.empty())
  {
    const Entry top = m_queue.front();
    State& state = m_state[top.vertex];
    const bool is_current = !state.is_settled && !(state.distance < top.distance);
    if(is_current && !settle(Vertex(top.vertex), top.distance))
      return;
    std::pop_heap(m_queue.begin(), m_queue.end());
    m_queue.pop_back();
    if(!is_current)
      continue;
    state.is_settled = true;
    state.number_of_settlings += state.number_of_settlings < (std::numeric_limits<unsigned char>::max)() ? 1 : 0;
    spread_from<shape>(top.vertex, domain, maximum_distance);
  }
}

// Brings the front from v, which has just been settled, to its neighbors: along the spokes, and across the faces that
// have another settled vertex. What was settled earlier than v seldom gains.
template <Front_shape shape, typename Domain>
void Fast_marching::spread_from(Index v, const Domain& domain, double maximum_distance)
{
  const State here = m_state[v];
  const double full_angle = m_triangulation->full_angle(v);
  const Spoke* const end = m_triangulation->end(v);
  Arrival across_previous_face;
  for(const Spoke* spoke = m_triangulation->begin(v); spoke != end; ++spoke)
  {
    const State& b = m_state[spoke->neighbor];
    Arrival best = across_previous_face;
    across_previous_face = Arrival();
    if(spoke->rim >= 0.)
    {
      const Spoke* const next = spoke + 1;
      const State& c = m_state[next->neighbor];
      if(c.is_settled &&
         (here.distance < b.distance || may_come_earlier(b.distance, spoke->length, spoke->rim, next->length)))
      {
        const Arrival across_next_face = across_face<shape>(v, *next, *spoke, spoke->rim, -1.);
        if(across_next_face.distance < best.distance)
          best = across_next_face;
      }
      if(b.is_settled &&
         (here.distance < c.distance || may_come_earlier(c.distance, next->length, spoke->rim, spoke->length)))
        across_previous_face = across_face<shape>(v, *spoke, *next, spoke->rim, 1.);
    }
    const double along = here.distance + spoke->length;
    if(along < best.distance && along < b.distance)
    {
      const double angle = signed_angle(spoke->angle - here.direction, full_angle);
      best = arrive_along<shape>({here.distance, angle}, spoke->length);
    }
    if(best.distance <= maximum_distance && is_worth(best.distance, *spoke) && domain(Vertex(spoke->neighbor)))
      arrive(best, *spoke);
  }
}

// Across the face between two spokes of v, both ends of `base` being settled, to the end of `side`. The orientation is
// 1 if that lies to the left of the base, -1 to the right.
template <Front_shape shape>
Arrival Fast_marching::across_face(Index v, const Spoke& base, const Spoke& side, double rim, double orientation) const
{
  const State& a = m_state[v];
  const State& b = m_state[base.neighbor];
  const double angle_a = signed_angle(orientation * (base.angle - a.direction), m_triangulation->full_angle(v));
  const double angle_b = signed_angle(orientation * (b.direction - m_triangulation->reverse(base).angle),
                                      m_triangulation->full_angle(base.neighbor));
  Arrival arrival = arrive_across<shape>({a.distance, angle_a}, {b.distance, angle_b}, base.length, side.length, rim);
  arrival.turn *= orientation;
  return arrival;
}

// May a front through the base come to the apex before it comes to v, an end of the base? Only if the apex is farther
// than v from the middle of the way between them, seen from the source: where the angle at the apex is obtuse, or
// almost so and the source near.
inline bool Fast_marching::may_come_earlier(double distance, double side_v, double side, double base) const
{
  return (distance - m_least) * (side_v * side_v + side * side - base * base) < side_v * side_v * side;
}

// A distance that has served already must drop by a part of it to be worth the trouble, each time by a larger one. What
// is lost is hardly measurable, and the dropping ends, even where fronts in faces without area lower each other in
// turn.
inline bool Fast_marching::is_worth(double distance, const Spoke& spoke) const
{
  constexpr double least_part = 1e-9;
  constexpr int most_doublings = 20;

  const State& state = m_state[spoke.neighbor];
  if(!(distance >= m_least))
    return false;
  if(state.number_of_settlings == 0)
    return distance < state.distance;
  const double part = least_part * double(1 << (std::min)(int(state.number_of_settlings), most_doublings));
  return distance < state.distance - part * (state.distance - m_least);
}

inline void Fast_marching::arrive(const Arrival& arrival, const Spoke& spoke)
{
  double direction = m_triangulation->reverse(spoke).angle + arrival.turn;
  const double full_angle = m_triangulation->full_angle(spoke.neighbor);
  if(direction < infinity && full_angle < infinity)
    direction += direction < 0. ? full_angle : direction >= full_angle ? -full_angle : 0.;
  lower(spoke.neighbor, arrival.distance, direction);
}

// An angle at a vertex is positive or negative by the side that is nearer. Both sides being more than half a turn
// (there are more than two half turns around a saddle vertex), the way turns at the vertex itself: that is half a turn.
inline double Fast_marching::signed_angle(double angle, double full_angle)
{
  if(!(std::abs(angle) < infinity))
    return infinity;
  const double other_side = angle < 0. ? angle + full_angle : angle - full_angle;
  const double left = (std::max)(angle, other_side);
  const double right = (std::min)(angle, other_side);
  return left <= CGAL_PI ? left : right > -CGAL_PI ? right : CGAL_PI;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FAST_MARCHING_H
