// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CORNERS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CORNERS_H

#include <CGAL/Geodesic_remeshing/internal/Point_grid.h>
#include <CGAL/Geodesic_remeshing/internal/angle_at.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Finds the vertices at which lines turn so sharply that no row of samples could follow. That is a matter of scale:
// the border of a scanned face turns at every vertex, and is smooth for long triangles. So a line turns where the
// chords on both sides, half an edge length long, do; where its own edges turn too, less of that is enough. And a
// line of few long edges, as machine parts have them, keeps their ends where there is room for samples between: it
// would lose more than a curve.
class Corner_finder
{
public:
  Corner_finder(const Mesh& mesh, double edge_length)
    : m_mesh(mesh), m_metric(mesh), m_reach(.5 * edge_length), m_long_edge(1.5 * edge_length)
  {}

  // The corners strictly inside a piece, or on a ring
  std::vector<Vertex> run(const Line_piece& piece)
  {
    measure(piece);
    m_candidates.clear();
    for(std::size_t i = m_is_ring ? 0 : 1; i + 1 < m_points.size(); ++i)
      consider(i);
    std::sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.turn > b.turn || (!(b.turn > a.turn) && a.index < b.index);
    });
    std::vector<Vertex> corners;
    m_taken.clear();
    if(!m_is_ring)
      m_taken = {0., m_position.back()};
    for(const Candidate& c : m_candidates)
      if(is_far_from_taken(m_position[c.index]))
      {
        m_taken.insert(m_position[c.index]);
        corners.push_back(m_mesh.source(piece.halfedges[c.index]));
      }
    return corners;
  }

private:
  static constexpr double degree = CGAL_PI / 180.;
  static constexpr double sharp = 60. * degree, least = 30. * degree, of_polygon = 10. * degree, straight = 5. * degree;

  struct Candidate
  {
    double turn;
    std::size_t index;
  };

  void measure(const Line_piece& piece)
  {
    m_is_ring = piece.is_ring;
    m_points.assign(1, m_mesh.point(m_mesh.source(piece.halfedges.front())));
    m_position.assign(1, 0.);
    for(Halfedge h : piece.halfedges)
    {
      m_points.push_back(m_mesh.point(m_mesh.target(h)));
      m_position.push_back(m_position.back() + m_metric.length(h));
    }
  }

  void consider(std::size_t i)
  {
    const double own = turn_at(i, 0.), wide = turn_at(i, m_reach);
    if((wide >= least && ((std::max)(own, wide) >= sharp || (own >= least && is_single(i)))) ||
       (own >= of_polygon && is_straight_beside(i, true) && is_straight_beside(i, false)))
      m_candidates.push_back(Candidate{wide, i});
  }

  // The angle between the chords from a reach before a point to it and from it to a reach beyond; with no reach, its
  // edges'
  double turn_at(std::size_t i, double reach) const
  {
    const Vector before = m_points[i] - (reach > 0. ? point_at(m_position[i] - reach) : neighbour(i, false));
    const Vector after = (reach > 0. ? point_at(m_position[i] + reach) : neighbour(i, true)) - m_points[i];
    return std::atan2(std::sqrt(cross_product(before, after).squared_length()), before * after);
  }

  // As far as a long edge reaches, or the piece
  bool is_straight_beside(std::size_t i, bool forward) const
  {
    const std::size_t n = m_points.size() - 1;
    for(std::size_t k = 1; k <= n; ++k)
    {
      if(!m_is_ring && (forward ? i + k >= n : k >= i))
        return true;
      const std::size_t j = (forward ? i + k : i + n - k) % n;
      const double way = std::abs(m_position[j] - m_position[i]), length = m_position.back();
      if((forward == (j > i) ? way : length - way) >= m_long_edge)
        return true;
      if(m_points[j] != m_points[i] && turn_at(j, 0.) >= straight) // but not that of a point that is there twice
        return false;
    }
    return true;
  }

  // Whether the line turns nowhere near half as sharply, as where two smooth lines meet
  bool is_single(std::size_t i) const
  {
    const double radius = 1.5 * m_reach, limit = .5 * turn_at(i, 0.), length = m_position.back();
    const std::size_t n = m_points.size() - 1;
    for(const bool forward : {true, false})
      for(std::size_t k = 1; k < n && (m_is_ring || (forward ? i + k < n : k < i)); ++k)
      {
        const std::size_t j = (forward ? i + k : i + n - k) % n;
        const double way = std::abs(m_position[j] - m_position[i]);
        if(!((forward == (j > i) ? way : length - way) < radius))
          break;
        if(m_points[j] != m_points[i] && turn_at(j, 0.) > limit)
          return false;
      }
    return true;
  }

  // The next point that is another one
  Point neighbour(std::size_t i, bool forward) const
  {
    const std::size_t n = m_points.size() - 1;
    for(std::size_t k = 1; k <= n; ++k)
    {
      const std::size_t j = forward ? i + k : i + n - k;
      if(!m_is_ring && (forward ? j > n : j < n))
        break;
      const Point& p = m_points[forward && j == n ? n : j % n];
      if(p != m_points[i])
        return p;
    }
    return m_points[i];
  }

  Point point_at(double s) const
  {
    const double length = m_position.back();
    if(m_is_ring)
      s -= std::floor(s / length) * length;
    if(!(s > 0.))
      return m_points.front();
    if(!(s < length))
      return m_points.back();
    const std::size_t j = std::upper_bound(m_position.begin(), m_position.end(), s) - m_position.begin();
    const double t = (s - m_position[j - 1]) / (m_position[j] - m_position[j - 1]);
    return m_points[j - 1] + t * (m_points[j] - m_points[j - 1]);
  }

  bool is_far_from_taken(double s) const
  {
    if(m_taken.empty())
      return true;
    const auto next = m_taken.lower_bound(s);
    const double length = m_is_ring ? m_position.back() : infinity; // of the way around
    const double ahead = next != m_taken.end() ? *next - s : *m_taken.begin() + length - s;
    const double behind = next != m_taken.begin() ? s - *std::prev(next) : s + length - *m_taken.rbegin();
    return !(ahead < m_reach) && !(behind < m_reach);
  }

  const Mesh& m_mesh;
  const Metric m_metric;
  const double m_reach, m_long_edge;
  bool m_is_ring = false;
  std::vector<Point> m_points;
  std::vector<double> m_position;
  std::set<double> m_taken; // positions of corners
  std::vector<Candidate> m_candidates;
};

// Where other than two line edges meet, and where a line turns sharply
inline void find_corners(const Mesh& mesh, double edge_length, Constraints& constraints)
{
  const auto is_line = [&](Edge e) { return constraints.is_line[e.idx()] != 0; };
  const std::vector<int> degree = degrees_on_lines(mesh, is_line);
  for(Vertex v : mesh.vertices())
    if(degree[v] != 0 && degree[v] != 2)
      constraints.is_corner[v.idx()] = 1;
  Corner_finder finder(mesh, edge_length);
  for(const Line_piece& piece : trace_lines(mesh, constraints))
    for(Vertex v : finder.run(piece))
      constraints.is_corner[v.idx()] = 1;
}

// The tip of a cone is a feature of its own, where no line leads to it: here an angle of more than 90 degrees is
// missing. Of several near to each other, as where a tip is many vertices at one point, the sharpest is one.
inline void find_cone_tips(const Mesh& mesh, double edge_length, Constraints& constraints)
{
  const std::vector<int> degree = degrees_on_lines(mesh, [&](Edge e) { return constraints.is_line[e.idx()] != 0; });
  std::vector<std::pair<double, Vertex>> tips; // the lower index of equals first
  for(Vertex v : mesh.vertices())
    if(degree[v] == 0)
    {
      const double angle = angle_at(mesh, v);
      if(angle < 1.5 * CGAL_PI)
        tips.emplace_back(angle, v);
    }
  std::sort(tips.begin(), tips.end());
  const Metric metric(mesh);
  Point_grid taken(edge_length, tips.size());
  for(const auto& tip : tips)
  {
    const Vertex v = tip.second;
    bool is_free = true;
    taken.near(mesh.point(v), metric.size(v), .5 * edge_length * metric.size(v),
               [&](std::uint32_t, const Point&, double) { is_free = false; });
    if(!is_free)
      continue;
    taken.insert(mesh.point(v), metric.size(v), v.idx());
    constraints.is_corner[v.idx()] = 1;
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CORNERS_H
