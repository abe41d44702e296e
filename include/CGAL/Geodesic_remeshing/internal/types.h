// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_TYPES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_TYPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// All stages work on one mesh type, whatever the mesh of the user is: a `Surface_mesh` of double coordinates with
// exact predicates. The front door copies in and out.
using Kernel = Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Fourth powers of lengths, which the predicates compare, must neither vanish nor overflow.
inline bool is_scale_computable(const double length)
{
  return length > 1e-70 && length < 1e70;
}

// A point of a surface: a face and the barycentric coordinates of source(h), target(h) and target(next(h)), where
// h = halfedge(face), all three non-negative, adding up to one. The same convention as PMP's `Face_location`.
struct Place
{
  Face face;
  std::array<double, 3> coordinates = {{1., 0., 0.}};
};

inline std::array<Vertex, 3> vertices_of(const Mesh& mesh, Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}};
}

inline Face face_at(const Mesh& mesh, Vertex v)
{
  const Halfedge h = mesh.halfedge(v);
  return mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h);
}

inline Point point_at(const Mesh& mesh, const Place& place)
{
  const auto v = vertices_of(mesh, place.face);
  const auto& p = mesh.point(v[0]);
  const auto& q = mesh.point(v[1]);
  const auto& r = mesh.point(v[2]);
  const auto& c = place.coordinates;
  return Point(c[0] * p.x() + c[1] * q.x() + c[2] * r.x(), c[0] * p.y() + c[1] * q.y() + c[2] * r.y(),
               c[0] * p.z() + c[1] * q.z() + c[2] * r.z());
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TYPES_H
