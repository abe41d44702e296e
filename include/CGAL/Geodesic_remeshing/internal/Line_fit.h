// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_FIT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_FIT_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/squared_distance_to_segment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Vertices at even distances are as near to a smooth line as any; along one with bends or noise they are nearer to it
// where it turns. So each slides to where the edges on both sides leave the line least: to a vertex of the line, where
// an edge of that ends, or in between; and its neighbours make room, so that the angles of the triangles allow it.
class Line_fit
{
public:
  using Index = Lean_triangulation::Index;

  // Triangles may become as bad as this or as the worst around, and worse where the vertices are at uneven distances.
  Line_fit(Remeshed_surface& remeshed, const double edge_length, const double badness)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_edge_length(edge_length), m_badness(badness)
  {}

  void run()
  {
    constexpr int sweeps = 10;
    if(!m_remeshed.has_lines() || m_remeshed.keeps_lines())
      return;
    std::vector<Index> sliding;
    for(Index v = 0; v < m_table.vertex_slots(); ++v)
      if(!m_table.is_removed(v) && m_remeshed.is_on_line(v) && !m_remeshed.is_fixed(v))
        sliding.push_back(v);
    for(int sweep = 0; sweep < sweeps; ++sweep)
    {
      bool has_moved = false;
      for(const Index v : sliding)
        has_moved = slide(v) || slide_with_neighbor(v) || has_moved;
      if(!has_moved)
        break;
    }
  }

private:
  using Stretch = Line_walker::Stretch;

  static constexpr double tolerance = .01; // of the length of an edge: nearer to a line is near enough

  // How far the line is from the chord between two positions on it: the largest squared distance of its vertices
  double deviation(const Stretch& s, const double low, const double high) const
  {
    const Point from = point_at(s, low), to = point_at(s, high);
    double largest = 0.;
    m_remeshed.lines().for_each_point(s.piece, low, high, [&](const Point& p) {
      largest = (std::max)(largest, squared_distance_to_segment(p, from, to));
    });
    return largest;
  }

  Point point_at(const Stretch& s, const double at) const
  {
    return m_remeshed.walker().point(m_remeshed.lines().place_at(s.piece, at));
  }

  // Squared again, so that it is the larger of the two that counts most.
  double deviation_beside(const Stretch& s, const double at) const
  {
    return CGAL::square(deviation(s, s.low, at)) + CGAL::square(deviation(s, at, s.high));
  }

  // Towards the best of some places, as far as the triangles allow. Nothing moves for a gain of less than a twentieth.
  bool slide(const Index v)
  {
    constexpr double least_gain = .8; // of fourth powers
    const Stretch s = stretch_beside(v);
    if(s.piece == Line_walker::none)
      return false;
    const double before = deviation_beside(s, s.at);
    if(!(before > std::pow(tolerance * m_edge_length * m_remeshed.spot(v).size, 4.)))
      return false;
    double least = least_gain * before, best = s.at;
    bool is_found = false;
    for_each_candidate(s, [&](const double at) {
      const double d = deviation_beside(s, at);
      if(d < least)
      {
        least = d;
        best = at;
        is_found = true;
      }
    });
    for(double part = 1.; part > .2 && is_found; part *= .5)
    {
      const double at = s.at + part * (best - s.at);
      if((part > .9 || deviation_beside(s, at) < least_gain * before) && try_moves({{{v, at}, {v, at}}}, s))
        return true;
    }
    return false;
  }

  // The vertices of the line, or where they are many some of them, and places between; none near to the neighbours
  template <class Visit>
  void for_each_candidate(const Stretch& s, const Visit& visit) const
  {
    constexpr double least_part = .3;
    constexpr int places = 16;
    constexpr std::size_t many = 32;
    const double low = s.low + least_part * (s.high - s.low), high = s.high - least_part * (s.high - s.low);
    std::size_t number = 0, i_of_vertex = 0;
    m_remeshed.lines().for_each_position(s.piece, low, high, [&](double) { ++number; });
    m_remeshed.lines().for_each_position(s.piece, low, high, [&](const double at) {
      if(i_of_vertex++ % (number / many + 1) == 0)
        visit(at);
    });
    if(number > many)
      visit(farthest_vertex(s, low, high, s.at));
    for(int i = 0; i <= places; ++i)
      visit(low + (high - low) * i / places);
  }

  // Two vertices near to each other on both sides of a bend: one of them to where the line bends, and the other one
  // makes room.
  bool slide_with_neighbor(const Index v)
  {
    constexpr double least_gain = .8;
    const Stretch s = stretch_beside(v);
    if(s.piece == Line_walker::none)
      return false;
    for(const Index w : neighbors_on_line(v))
    {
      const Stretch t = m_remeshed.is_fixed(w) ? Stretch{Line_walker::none, 0., 0., 0.} : stretch_beside(w);
      if(t.piece == Line_walker::none)
        continue;
      const Point& p = m_remeshed.spot(w).point;
      const bool is_low = squared_distance(p, point_at(s, s.low)) < squared_distance(p, point_at(s, s.high));
      const double near = is_low ? s.low : s.high, beyond = is_low ? s.high : s.low;
      const double far = is_low ? s.low - (t.at - t.low) : s.high + (t.high - t.at);
      const double bend = farthest_vertex(s, (std::min)(near, s.at), (std::max)(near, s.at), s.at),
                   middle = .5 * (far + bend);
      const double before = deviation_along(s, {{far, near, s.at, beyond}});
      if(before > std::pow(tolerance * m_edge_length * m_remeshed.spot(v).size, 4.) &&
         deviation_along(s, {{far, middle, bend, beyond}}) < least_gain * before &&
         try_moves({{{v, bend}, {w, middle}}}, s))
        return true;
    }
    return false;
  }

  double deviation_along(const Stretch& s, const std::array<double, 4>& at) const
  {
    double sum = 0.;
    for(std::size_t i = 0; i < 3; ++i)
      sum += CGAL::square(deviation(s, (std::min)(at[i], at[i + 1]), (std::max)(at[i], at[i + 1])));
    return sum;
  }

  // The position of the vertex of the line that is farthest from the chord
  double farthest_vertex(const Stretch& s, const double low, const double high, const double if_none) const
  {
    const Point from = point_at(s, low), to = point_at(s, high);
    double largest = 0., result = if_none;
    m_remeshed.lines().for_each_position(s.piece, low, high, [&](const double at) {
      const double d = squared_distance_to_segment(point_at(s, at), from, to);
      if(d > largest)
      {
        largest = d;
        result = at;
      }
    });
    return result;
  }

  // An edge longer than the others cuts off more of a curve than they do.
  bool has_long_edge(const Index v, const Stretch& s) const
  {
    constexpr double long_part = 1.2;
    const Point& p = m_remeshed.spot(v).point;
    return (std::max)(squared_distance(p, point_at(s, s.low)), squared_distance(p, point_at(s, s.high))) >
           CGAL::square(long_part * m_edge_length * m_remeshed.spot(v).size);
  }

  // 33 degrees in place of 36 and 40: on six machine parts curved lines are a seventh nearer.
  double uneven_badness() const { return (std::max)(m_badness, badness_of_angle(33.)); }

  struct Move
  {
    Index vertex;
    double at;
  };

  bool try_moves(const std::array<Move, 2>& moves, const Stretch& s)
  {
    m_around.clear();
    for(const Move& move : moves)
    {
      m_around.push_back(move.vertex);
      m_table.for_each_neighbor(move.vertex, [&](const Index w) { m_around.push_back(w); });
    }
    double limit = has_long_edge(moves[0].vertex, s) ? uneven_badness() : m_badness;
    for(const Index w : m_around)
      limit = (std::max)(limit, Vertex_ring(m_remeshed, w).badness());
    if(!(limit < turned_badness)) // of a triangle that is turned already: others must not become so
      return false;
    m_remeshed.record();
    for(const Move& move : moves)
      m_remeshed.put(move.vertex, m_remeshed.spot_on_line(m_remeshed.lines().place_at(s.piece, move.at)));
    for(int round = 0; round < 2; ++round)
      for(const Index w : m_around)
        if(m_remeshed.is_free(w))
          relax_vertex(m_remeshed, w);
    const bool is_good = std::all_of(m_around.begin(), m_around.end(),
                                     [&](const Index w) { return Vertex_ring(m_remeshed, w).badness() <= limit; });
    if(!is_good)
      m_remeshed.undo_to({0, 0});
    m_remeshed.forget();
    return is_good;
  }

  std::array<Index, 2> neighbors_on_line(const Index v) const
  {
    std::array<Index, 2> beside = {{v, v}};
    std::size_t number = 0;
    m_remeshed.for_each_neighbor_on_line(v, [&](const Index w) {
      if(number < 2)
        beside[number] = w;
      ++number;
    });
    return number == 2 ? beside : std::array<Index, 2>{{v, v}};
  }

  Stretch stretch_beside(const Index v) const
  {
    const std::array<Index, 2> beside = neighbors_on_line(v);
    if(beside[0] == beside[1])
      return {Line_walker::none, 0., 0., 0.};
    const auto place = [&](const Index w) -> const Place& { return m_remeshed.spot(w).place; };
    Stretch s = m_remeshed.lines().stretch(place(v), place(beside[0]), place(beside[1]));
    if(!(s.low < s.at && s.at < s.high)) // both ends are the same corner, or coincide
      s.piece = Line_walker::none;
    return s;
  }

  Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const double m_edge_length;
  const double m_badness;
  std::vector<Index> m_around;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_FIT_H
