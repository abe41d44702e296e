// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_SOURCES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_SOURCES_H

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Front.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where fronts start: at points of a surface and along polylines of such points. Around a point or a piece of a
// polyline the distances are exact, and so are their directions, for the vertices of the faces that contain it. These
// must stay faces: a front that starts inside a face would not be understood by those into which it had been flipped.
template <typename Metric>
class Surface_sources
{
  using vertex_descriptor = typename Metric::vertex_descriptor;
  using halfedge_descriptor = typename Metric::halfedge_descriptor;

public:
  // A point by the vertices that it is a mean of: one at a vertex, two on an edge. The halfedge leads to the vertex, or
  // is that edge, or one of the face.
  struct Surface_point
  {
    halfedge_descriptor h;
    std::array<vertex_descriptor, 3> vertices;
    std::array<double, 3> weights;
    std::size_t size = 0;

    bool is_vertex() const { return size == 1; }

    double weight(vertex_descriptor v) const
    {
      for(std::size_t i = 0; i < size; ++i)
        if(vertices[i] == v)
          return weights[i];
      return 0.;
    }
  };

  explicit Surface_sources(const Metric& metric) : m_metric(metric) {}

  Surface_point surface_point(vertex_descriptor v) const
  {
    Surface_point result;
    result.h = halfedge(v, m_metric.mesh);
    result.vertices[0] = v;
    result.weights[0] = 1.;
    result.size = 1;
    return result;
  }

  // of a `Face_location` of Polygon Mesh Processing
  template <typename Face, typename FT>
  Surface_point surface_point(const std::pair<Face, std::array<FT, 3>>& location) const
  {
    // coordinates as small as their rounding are those of a point on an edge
    constexpr double least_coordinate = 1e-10;
    constexpr double largest_error = 1e-6;

    Surface_point result;
    double sum = 0., kept = 0.;
    halfedge_descriptor h = prev(halfedge(location.first, m_metric.mesh), m_metric.mesh);
    result.h = h;
    for(const FT& coordinate : location.second)
    {
      const double c = CGAL::to_double(coordinate);
      if(!(c >= -largest_error && c <= 1. + largest_error))
        m_metric.fail("a point of face " + face_name(location.first) + " is not in the face");
      sum += c;
      if(c > least_coordinate)
      {
        result.vertices[result.size] = target(h, m_metric.mesh);
        result.weights[result.size++] = c;
        kept += c;
      }
      else // on the edge opposite to the last such vertex; at a vertex see below
        result.h = prev(h, m_metric.mesh);
      h = next(h, m_metric.mesh);
    }
    if(std::abs(sum - 1.) > largest_error)
      m_metric.fail("the coordinates of a point of face " + face_name(location.first) + " do not add up to one");
    if(result.is_vertex())
      return surface_point(result.vertices[0]);
    for(std::size_t i = 0; i < result.size; ++i)
      result.weights[i] /= kept;
    return result;
  }

  void add_point(const Surface_point& p)
  {
    if(p.is_vertex())
      m_starts.push_back(Start{m_metric.index(p.vertices[0]), 0., Vertex(), Vertex(), 0.});
    else
      add_piece(p, p);
  }

  // The straight piece between two points of one face or edge; false if they have none in common.
  bool add_piece(const Surface_point& p, const Surface_point& q)
  {
    bool is_found = false;
    for_each_face_at(is_in_fewer_faces(p, q) ? p : q, [&](const halfedge_descriptor h) {
      if(!is_border(h, m_metric.mesh) && contains(h, p) && contains(h, q))
      {
        add_piece_in_face(h, p, q);
        is_found = true;
      }
    });
    return is_found;
  }

  const std::vector<std::size_t>& faces() const { return m_faces; }

  void start(Fast_marching& marching) const
  {
    for(const Start& s : m_starts)
      if(s.distance > 0.)
        marching.add_source(s.vertex, s.distance, s.right, s.left, s.angle);
      else
        marching.add_source(s.vertex);
  }

private:
  struct Start
  {
    Vertex vertex;
    double distance;
    Vertex right, left; // the other vertices of the face that the way to the source goes through
    double angle;       // from the edge to `right` to that way
  };

  template <typename Face>
  std::string face_name(Face f) const
  {
    return std::to_string(get(m_metric.face_index, f));
  }

  struct Planar_point
  {
    double x = 0.;
    double y = 0.;

    friend Planar_point operator+(Planar_point a, Planar_point b) { return {a.x + b.x, a.y + b.y}; }
    friend Planar_point operator-(Planar_point a, Planar_point b) { return {a.x - b.x, a.y - b.y}; }
    friend Planar_point operator*(double s, Planar_point a) { return {s * a.x, s * a.y}; }
    friend double dot(Planar_point a, Planar_point b) { return a.x * b.x + a.y * b.y; }
  };

  struct Piece
  {
    Planar_point p, q;

    Planar_point closest_to(Planar_point point) const
    {
      const Planar_point direction = q - p;
      const double square = dot(direction, direction);
      const double t = square > 0. ? dot(point - p, direction) / square : 0.;
      return p + (std::max)(0., (std::min)(1., t)) * direction;
    }
  };

  // Calls `visit(h)` for a halfedge of each face that a point is in, or of the outside; for none at an isolated vertex.
  template <typename Visit>
  void for_each_face_at(const Surface_point& p, const Visit& visit) const
  {
    if(!p.is_vertex())
    {
      visit(p.h);
      if(p.size == 2)
        visit(opposite(p.h, m_metric.mesh));
    }
    else if(p.h != null_halfedge())
      for(const halfedge_descriptor h : halfedges_around_target(p.h, m_metric.mesh))
        visit(h);
  }

  // Around two vertices at the same time: one may be the apex of a cone of all faces.
  bool is_in_fewer_faces(const Surface_point& p, const Surface_point& q) const
  {
    if(!p.is_vertex() || !q.is_vertex() || p.h == null_halfedge() || q.h == null_halfedge())
      return p.size > q.size || p.h == null_halfedge();
    const auto next_around = [&](const halfedge_descriptor h) {
      return opposite(next(h, m_metric.mesh), m_metric.mesh);
    };
    halfedge_descriptor g = next_around(p.h), h = next_around(q.h);
    for(; g != p.h && h != q.h; g = next_around(g))
      h = next_around(h);
    return g == p.h;
  }

  static halfedge_descriptor null_halfedge()
  {
    return boost::graph_traits<typename Metric::Mesh_type>::null_halfedge();
  }

  bool contains(halfedge_descriptor h, const Surface_point& p) const
  {
    const auto& mesh = m_metric.mesh;
    for(std::size_t i = 0; i < p.size; ++i)
    {
      const vertex_descriptor v = p.vertices[i];
      if(v != source(h, mesh) && v != target(h, mesh) && v != target(next(h, mesh), mesh))
        return false;
    }
    return true;
  }

  halfedge_descriptor longest_of_face(halfedge_descriptor h) const
  {
    const halfedge_descriptor n = next(h, m_metric.mesh), p = prev(h, m_metric.mesh);
    const double of_h = m_metric.length(h), of_n = m_metric.length(n), of_p = m_metric.length(p);
    return of_h >= of_n && of_h >= of_p ? h : of_n >= of_p ? n : p;
  }

  void add_piece_in_face(halfedge_descriptor h, const Surface_point& p, const Surface_point& q)
  {
    const auto& mesh = m_metric.mesh;
    m_faces.push_back(get(m_metric.face_index, face(h, mesh)));
    h = longest_of_face(h);
    const std::array<halfedge_descriptor, 3> sides = {{h, next(h, mesh), prev(h, mesh)}};
    const auto vertex = [&](std::size_t i) { return m_metric.index(source(sides[i % 3], mesh)); };
    std::array<Planar_point, 3> corners; // of the sources of the sides
    if(m_metric.length(h) > 0.)
    {
      const Flat_triangle flat(m_metric.length(h), m_metric.length(sides[2]), m_metric.length(sides[1]));
      corners[1] = {flat.base, 0.};
      corners[2] = {flat.x, flat.y};
    }
    Piece piece;
    for(std::size_t i = 0; i < 3; ++i)
    {
      piece.p = piece.p + p.weight(source(sides[i], mesh)) * corners[i];
      piece.q = piece.q + q.weight(source(sides[i], mesh)) * corners[i];
    }
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Planar_point side = corners[(i + 1) % 3] - corners[i];
      const Planar_point way = piece.closest_to(corners[i]) - corners[i];
      m_starts.push_back(Start{vertex(i), std::sqrt(dot(way, way)), vertex(i + 1), vertex(i + 2),
                               std::atan2(side.x * way.y - side.y * way.x, dot(side, way))});
    }
  }

  const Metric& m_metric;
  std::vector<std::size_t> m_faces;
  std::vector<Start> m_starts;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_SOURCES_H
