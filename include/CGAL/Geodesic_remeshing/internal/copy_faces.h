// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_COPY_FACES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_COPY_FACES_H

#include <CGAL/Geodesic_remeshing/internal/Intrinsic_faces.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Copies the corners of the faces of a graph, the lengths of their sides and which side is beside which.
template <typename Graph, typename VertexIndexMap, typename FaceIndexMap, typename Length_of_halfedge>
void copy_faces(const Graph& graph, VertexIndexMap vertex_index, FaceIndexMap face_index,
                const Length_of_halfedge& length_of_halfedge, Intrinsic_faces& copy)
{
  using Index = Intrinsic_faces::Index;
  for(const auto f : faces(graph))
  {
    const Index i = static_cast<Index>(get(face_index, f));
    auto& triangle = copy.triangle(i);
    auto h = halfedge(f, graph);
    for(Index k = 0; k < 3; ++k, h = next(h, graph))
    {
      triangle.vertex[k] = static_cast<Index>(get(vertex_index, source(h, graph)));
      const auto o = opposite(h, graph);
      const bool seen = !is_border(o, graph) && copy.is_face(static_cast<Index>(get(face_index, face(o, graph))));
      if(!seen || face(o, graph) == f)
      {
        triangle.length[k] = length_of_halfedge(h);
        continue;
      }
      const Index j = static_cast<Index>(get(face_index, face(o, graph)));
      const auto first = halfedge(face(o, graph), graph);
      const Index slot = o == first ? 0 : o == next(first, graph) ? 1 : 2;
      triangle.opposite[k] = 3 * j + slot;
      triangle.length[k] = copy.triangle(j).length[slot];
      copy.triangle(j).opposite[slot] = 3 * i + k;
    }
  }
}

// The same for a `Surface_mesh`, face by face: both sides of an edge are asked for its length, which is the same.
template <typename Length_of_halfedge>
void copy_faces(const Mesh& mesh, const Length_of_halfedge& length_of_halfedge, const Concurrency concurrency,
                Intrinsic_faces& copy)
{
  using Index = Intrinsic_faces::Index;
  parallel_for(concurrency, mesh.num_faces(), [&](const std::size_t i) {
    const Face f(static_cast<Index>(i));
    auto& triangle = copy.triangle(static_cast<Index>(i));
    Halfedge h = mesh.halfedge(f);
    for(Index k = 0; k < 3; ++k, h = mesh.next(h))
    {
      triangle.vertex[k] = mesh.source(h);
      triangle.length[k] = length_of_halfedge(h);
      const Halfedge o = mesh.opposite(h);
      if(mesh.is_border(o))
        continue;
      const Halfedge first = mesh.halfedge(mesh.face(o));
      triangle.opposite[k] = 3 * mesh.face(o) + (o == first ? 0 : o == mesh.next(first) ? 1 : 2);
    }
  });
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_COPY_FACES_H
