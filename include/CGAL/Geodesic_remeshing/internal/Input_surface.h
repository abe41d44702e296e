// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INPUT_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INPUT_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The mesh of the user as the stages need it: of the internal type, compact, without isolated vertices.
template <class TriangleMesh>
struct Input_surface
{
  Mesh mesh;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> face_of;     // by internal index
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertex_of;
};

[[noreturn]] inline void reject(const std::string& what)
{
  throw std::invalid_argument("geodesic remeshing: " + what);
}

// Copies the input, in its own order, and rejects what the stages cannot work on: these checks are cheap and
// made in every build, since on such input the loops of the stages need not end.
template <class TriangleMesh, class VertexPointMap, class VertexIndexMap>
void copy_input(const TriangleMesh& tmesh, const VertexPointMap& points, const VertexIndexMap& index,
                Input_surface<TriangleMesh>& result, bool allow_boundary = false)
{
  Mesh& mesh = result.mesh;
  std::vector<Vertex> copy(vertices(tmesh).size());
  std::size_t faces_seen = 0;
  const auto vertex = [&](typename boost::graph_traits<TriangleMesh>::vertex_descriptor v)
  {
    Vertex& c = copy[get(index, v)];
    if(c.is_valid())
      return c;
    const auto& p = get(points, v);
    const Point q(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    if(!std::isfinite(q.x()) || !std::isfinite(q.y()) || !std::isfinite(q.z()))
      reject("vertex " + std::to_string(get(index, v)) + " has a coordinate that is not finite");
    result.vertex_of.push_back(v);
    return c = mesh.add_vertex(q);
  };
  // in the order of the input's vertices, not in that of its faces: neighbours in memory as the user has them
  std::vector<char> used(copy.size(), 0);
  for(auto f : faces(tmesh))
  {
    std::size_t corners = 0;
    for(auto h : halfedges_around_face(halfedge(f, tmesh), tmesh))
    {
      used[get(index, target(h, tmesh))] = 1;
      ++corners;
      if(!allow_boundary && is_border(opposite(h, tmesh), tmesh))
        reject("face " + std::to_string(faces_seen) + " has an edge on a boundary: surfaces with boundary are not supported yet");
    }
    if(corners != 3)
      reject("face " + std::to_string(faces_seen) + " has " + std::to_string(corners) + " vertices, not three");
    ++faces_seen;
  }
  if(faces_seen == 0)
    reject("the mesh has no face");
  mesh.reserve(static_cast<Mesh::size_type>(copy.size()), static_cast<Mesh::size_type>(3 * faces_seen / 2),
               static_cast<Mesh::size_type>(faces_seen));
  for(auto v : vertices(tmesh))
    if(used[get(index, v)])
      vertex(v);
  for(auto f : faces(tmesh))
  {
    const auto h = halfedge(f, tmesh);
    const Face copied = mesh.add_face(vertex(source(h, tmesh)), vertex(target(h, tmesh)), vertex(target(next(h, tmesh), tmesh)));
    if(copied == Mesh::null_face())
      reject("face " + std::to_string(result.face_of.size()) + " makes the mesh non-manifold");
    result.face_of.push_back(f);
  }
}

inline double area(const Mesh& mesh)
{
  double sum = 0.;
  for(Face f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    sum += std::sqrt(CGAL::squared_area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])));
  }
  return sum;
}

inline std::ptrdiff_t euler_characteristic(const Mesh& mesh)
{
  return static_cast<std::ptrdiff_t>(mesh.number_of_vertices()) - static_cast<std::ptrdiff_t>(mesh.number_of_edges())
       + static_cast<std::ptrdiff_t>(mesh.number_of_faces());
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INPUT_SURFACE_H
