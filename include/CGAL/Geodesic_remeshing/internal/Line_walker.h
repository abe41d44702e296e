// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_WALKER_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_WALKER_H

#include <CGAL/Geodesic_remeshing/internal/Surface_lines.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Slides along the lines of a surface. A place on a line keeps its zero coordinate, so that straight lines stay covered
// exactly.
class Line_walker : public Surface_lines
{
public:
  using Surface_lines::Surface_lines;

  // Along the projection of `displacement` to the line, for the projection's length; at most half the way to an end,
  // where other vertices are. What is at an end stays.
  Place slide(const Place& from, const Vector& displacement) const;

  // The middle of the way along a line from one place to another, which has no face if there is none. Of the two ways
  // around a closed line that which `beside` is not on. Where `from` is an end `to` must be one too: then the shortest
  // line between them.
  Place middle(const Place& from, const Place& to, const Place& beside) const;

  // The part of a line around a place that is not an end, from one neighbour to the other: `at` is between `low` and
  // `high`, in lengths along the line, which on a closed one go on beyond where it begins. No piece if there is none.
  struct Stretch
  {
    Index piece;
    double low, at, high;
  };
  Stretch stretch(const Place& place, const Place& one, const Place& other) const;
  // The vertices of the line strictly between two such positions, or the positions of these
  template <class Visit>
  void for_each_point(const Index near, const double low, const double high, const Visit& visit) const
  {
    for_each_vertex(near, low, high, [&](const Index x, double) { visit(point(x)); });
  }
  template <class Visit>
  void for_each_position(const Index near, const double low, const double high, const Visit& visit) const
  {
    for_each_vertex(near, low, high, [&](Index, const double at) { visit(at); });
  }

private:
  double way_along(Index piece, const Vector& displacement) const;
  Index shortest_line(Index x, Index y) const;
  template <class Visit>
  void for_each_vertex(Index near, double low, double high, const Visit& visit) const;
};

inline double Line_walker::way_along(const Index piece, const Vector& displacement) const
{
  const Piece& p = m_pieces[piece];
  return p.length > 0. ? displacement * (point(end(p)) - point(start(p))) / p.length : 0.;
}

inline Place Line_walker::slide(const Place& from, const Vector& displacement) const
{
  Index piece = piece_at(from);
  if(piece == none)
    return from;
  const Index x = vertex_at(from);
  double way = 0.;
  if(x == none)
    way = way_along(piece, displacement);
  else if(!is_end(x))
  {
    // Where the line bends, along that of its two edges which leads more the way of the displacement.
    double farthest = 0.;
    for(const Index h : m_incident[x])
    {
      const double along = way_along(m_piece_of[h], displacement);
      const double away = start(m_pieces[m_piece_of[h]]) == x ? along : -along;
      if(away > farthest)
      {
        farthest = away;
        piece = m_piece_of[h];
        way = along;
      }
    }
  }
  const Line& line = m_lines[m_pieces[piece].line];
  if(!(std::abs(way) > 0.) || !(line.length > 0.))
    return from;
  const double at = position(from, piece);
  if(is_end(start(m_pieces[line.first])))
  {
    if(!(at + way > 0.))
      way = -.5 * at;
    if(!(at + way < line.length))
      way = .5 * (line.length - at);
  }
  return place_at(piece, at + way);
}

inline Line_walker::Index Line_walker::shortest_line(const Index x, const Index y) const
{
  Index best = none;
  const auto look = [&](const Index h) {
    if(!m_table.is_constrained(h))
      return;
    const Index number = m_pieces[m_piece_of[h]].line;
    const Line& line = m_lines[number];
    const Index first = start(m_pieces[line.first]), last = end(m_pieces[line.last - 1]);
    if(((first == x && last == y) || (first == y && last == x)) && (best == none || line.length < m_lines[best].length))
      best = number;
  };
  m_table.for_each_outgoing(x, [&](const Index h) {
    look(h);
    look(Lean_triangulation::previous(h));
  });
  return best;
}

inline Place Line_walker::middle(const Place& from, const Place& to, const Place& beside) const
{
  const Index x = vertex_at(from), y = vertex_at(to);
  if(x != none && is_end(x))
  {
    const Index number = y == none ? none : shortest_line(x, y);
    return number == none ? Place() : place_at(m_lines[number].first, .5 * m_lines[number].length);
  }
  const Index piece = piece_at(from), other = piece_at(to);
  if(piece == none || other == none || ((y == none || !is_end(y)) && m_pieces[piece].line != m_pieces[other].line))
    return Place();
  const Line& line = m_lines[m_pieces[piece].line];
  const double at = position(from, piece);
  double way = position_on(to, line) - at;
  if(line.is_loop)
  {
    const auto forward = [&](const double d) { return d < 0. ? d + line.length : d; };
    const double side = forward(position_on(beside, line) - at);
    way = forward(way) < side ? forward(way) : forward(way) - line.length;
  }
  return place_at(piece, at + .5 * way);
}

inline Line_walker::Stretch Line_walker::stretch(const Place& place, const Place& one, const Place& other) const
{
  const Index piece = piece_at(place), x = vertex_at(place);
  if(piece == none || (x != none && is_end(x)))
    return {none, 0., 0., 0.};
  const Line& line = m_lines[m_pieces[piece].line];
  const double at = position(place, piece);
  double low = position_on(one, line), high = position_on(other, line);
  if(line.is_loop)
  {
    const auto forward = [&](const double d) { return d < 0. ? d + line.length : d; };
    low = forward(low - at);
    high = forward(high - at);
    if(high < low)
      std::swap(low, high);
    const bool has_end = is_end(start(m_pieces[line.first])); // beyond which nothing is, nor by rounding
    return {piece, (std::max)(at + high - line.length, has_end ? 0. : -infinity), at,
            (std::min)(at + low, has_end ? line.length : infinity)};
  }
  if(high < low)
    std::swap(low, high);
  return {piece, low, at, high};
}

template <class Visit>
void Line_walker::for_each_vertex(const Index near, const double low, const double high, const Visit& visit) const
{
  const Line& line = m_lines[m_pieces[near].line];
  const auto visit_if_between = [&](const Index i, const double turn) {
    const double at = m_pieces[i].begin + turn;
    if(at > low && at < high)
      visit(start(m_pieces[i]), at);
    return at;
  };
  double turn = 0.;
  for(Index i = near; visit_if_between(i, turn) > low;)
  {
    if(i == line.first && !line.is_loop)
      break;
    turn -= i == line.first ? line.length : 0.;
    i = i == line.first ? line.last - 1 : i - 1;
  }
  turn = 0.;
  for(Index i = near;;)
  {
    if(i + 1 == line.last && !line.is_loop)
      break;
    turn += i + 1 == line.last ? line.length : 0.;
    i = i + 1 == line.last ? line.first : i + 1;
    if(!(visit_if_between(i, turn) < high))
      break;
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_WALKER_H
