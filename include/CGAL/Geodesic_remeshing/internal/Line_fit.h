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
// where it turns. So each slides, as far as the angles of its triangles allow, to where the edges on both sides leave
// the line least.
class Line_fit
{
public:
  using Index = Lean_triangulation::Index;

  Line_fit(Remeshed_surface& remeshed, const double edge_length)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_tolerance(.01 * edge_length)
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
        if(slide(v))
        {
          has_moved = true;
          m_table.for_each_neighbor(v, [&](const Index w) {
            if(m_remeshed.is_free(w))
              relax_vertex(m_remeshed, w);
          });
        }
      if(!has_moved)
        break;
    }
  }

private:
  using Stretch = Line_walker::Stretch;

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

  // To the best of some places that leaves angles of 36 degrees, or as they are. Nothing moves for a gain of less than
  // a sixth.
  bool slide(const Index v)
  {
    constexpr std::array<double, 8> steps = {{-.2, .2, -.1, .1, -.05, .05, -.02, .02}};
    constexpr double least_part = .3;
    const Stretch s = stretch_beside(v);
    if(s.piece == Line_walker::none)
      return false;
    const double length = s.high - s.low;
    double least = deviation_beside(s, s.at);
    if(!(least > std::pow(m_tolerance * m_remeshed.spot(v).size, 4.)))
      return false;
    least *= .5;
    const Vertex_ring ring(m_remeshed, v);
    const double limit = (std::max)(tolerated_badness(), ring.badness());
    bool has_moved = false;
    for(const double step : steps)
    {
      const double at = s.at + step * length;
      if(!(at > s.low + least_part * length && at < s.high - least_part * length))
        continue;
      const double d = deviation_beside(s, at);
      const Remeshed_surface::Spot spot = m_remeshed.spot_on_line(m_remeshed.lines().place_at(s.piece, at));
      if(!(d < least) || ring.badness(spot, limit) > limit)
        continue;
      least = d;
      m_remeshed.put(v, spot);
      has_moved = true;
    }
    return has_moved;
  }

  Stretch stretch_beside(const Index v) const
  {
    std::array<Index, 2> beside = {{v, v}};
    std::size_t number = 0;
    m_remeshed.for_each_neighbor_on_line(v, [&](const Index w) {
      if(number < 2)
        beside[number] = w;
      ++number;
    });
    if(number != 2)
      return {Line_walker::none, 0., 0., 0.};
    const auto place = [&](const Index w) -> const Place& { return m_remeshed.spot(w).place; };
    Stretch s = m_remeshed.lines().stretch(place(v), place(beside[0]), place(beside[1]));
    if(!(s.low < s.at && s.at < s.high)) // both ends are the same corner, or coincide
      s.piece = Line_walker::none;
    return s;
  }

  Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const double m_tolerance; // nearer than this to a line is near enough
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_FIT_H
