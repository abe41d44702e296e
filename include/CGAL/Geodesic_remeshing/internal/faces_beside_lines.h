// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FACES_BESIDE_LINES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FACES_BESIDE_LINES_H

#include <CGAL/Geodesic_remeshing/internal/Component_numbers.h>
#include <CGAL/Geodesic_remeshing/internal/triangulate_strips.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The pieces that the constrained edges divide a mesh into, numbered in the order of their first faces
inline std::vector<std::uint32_t> pieces_between_lines(const Placed_mesh& remeshed, std::size_t& number)
{
  const Mesh& mesh = remeshed.mesh;
  Component_numbers pieces(mesh.number_of_faces());
  for(Edge e : mesh.edges())
    if(!mesh.is_border(e) && !remeshed.constrained[e])
      pieces.join(mesh.face(mesh.halfedge(e, 0)), mesh.face(mesh.halfedge(e, 1)));
  return pieces.take(number);
}

// Finds a face of the input that a face of the output lies upon: the one to which the way from a corner's place to
// the face's centre points most.
class Face_beneath
{
public:
  Face_beneath(const Mesh& surface, const Placed_mesh& remeshed) : m_surface(surface), m_remeshed(remeshed) {}

  // The input face at a corner of the face, and how well the ways agree: the cosine of the angle between them
  std::pair<Face, double> at_corner(Face f, Vertex corner) const
  {
    const auto v = vertices_of(m_remeshed.mesh, f);
    const Mesh& mesh = m_remeshed.mesh;
    const Point& p = mesh.point(corner);
    const Vector way = centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])) - p;
    const Place& place = m_remeshed.place[corner];
    std::pair<Face, double> best(place.face, -2.);
    const auto consider = [&](Face g, const Vector& into) {
      const double lengths = std::sqrt(into.squared_length() * way.squared_length());
      const double cosine = lengths > 0. ? into * way / lengths : -1.;
      if(cosine > best.second)
        best = std::make_pair(g, cosine);
    };
    std::array<Halfedge, 3> side; // side[i] begins at corner i
    side[0] = m_surface.halfedge(place.face);
    side[1] = m_surface.next(side[0]);
    side[2] = m_surface.next(side[1]);
    const auto& c = place.coordinates;
    const int zeros = !(c[0] > 0.) + !(c[1] > 0.) + !(c[2] > 0.);
    if(zeros == 0)
      return std::make_pair(place.face, 1.);
    for(int i = 0; i < 3; ++i)
      if(zeros == 1 ? !(c[i] > 0.) : c[i] > 0.)
      {
        if(zeros == 1) // on the side opposite to corner i
          for(Halfedge h : {side[(i + 1) % 3], m_surface.opposite(side[(i + 1) % 3])})
            consider_across(h, p, consider);
        else
          for(Halfedge h : m_surface.halfedges_around_target(m_surface.prev(side[i])))
            if(!m_surface.is_border(h))
              consider(m_surface.face(h), middle(h) - p);
      }
    return best;
  }

private:
  // Of the side that is opposite to the target of h
  Point middle(Halfedge h) const
  {
    return CGAL::midpoint(m_surface.point(m_surface.source(h)), m_surface.point(m_surface.target(m_surface.next(h))));
  }

  template <class Consider>
  void consider_across(Halfedge h, const Point& p, const Consider& consider) const
  {
    if(m_surface.is_border(h))
      return;
    const Point& a = m_surface.point(m_surface.source(h));
    const Vector along(a, m_surface.point(m_surface.target(h)));
    const Vector up(p, m_surface.point(m_surface.target(m_surface.next(h))));
    const double length = along.squared_length();
    consider(m_surface.face(h), length > 0. ? up - (up * along / length) * along : up);
  }

  const Mesh& m_surface;
  const Placed_mesh& m_remeshed;
};

// For each piece between lines, a face of the input that has its patch. Inside a piece any place tells; where all its
// vertices lie on lines its faces vote. `is_same_patch` compares two input faces.
template <class IsSamePatch>
std::vector<Face> faces_of_patches(const Mesh& surface, const Placed_mesh& remeshed,
                                   const std::vector<std::uint32_t>& piece, std::size_t number,
                                   const IsSamePatch& is_same_patch)
{
  const Face_beneath beneath(surface, remeshed);
  std::vector<std::vector<std::pair<Face, double>>> votes(number);
  for(Face f : remeshed.mesh.faces())
    for(Vertex v : vertices_of(remeshed.mesh, f))
    {
      const std::pair<Face, double> vote = beneath.at_corner(f, v);
      auto& of_piece = votes[piece[f]];
      std::size_t i = 0;
      while(i < of_piece.size() && !is_same_patch(of_piece[i].first, vote.first))
        ++i;
      if(i == of_piece.size())
        of_piece.emplace_back(vote.first, 0.);
      of_piece[i].second += vote.second;
    }
  std::vector<Face> result;
  for(const auto& of_piece : votes)
    result.push_back(std::max_element(of_piece.begin(), of_piece.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first);
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FACES_BESIDE_LINES_H
