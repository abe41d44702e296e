// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_OPEN_SEPARATING_TRIANGLES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_OPEN_SEPARATING_TRIANGLES_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// An edge can be contracted if its ends have no common neighbours but those in its faces. Flips the edges from the
// source of h to the others, where no line and no edge that is there already is in the way.
template <class IsLine>
void open_separating_triangles(Mesh& mesh, Halfedge h, const IsLine& is_line)
{
  const Vertex v = mesh.source(h), into = mesh.target(h);
  std::vector<Halfedge> crossing;
  for(Halfedge g : mesh.halfedges_around_target(mesh.opposite(h)))
  {
    const Vertex x = mesh.source(g);
    const bool is_in_face = (!mesh.is_border(h) && mesh.target(mesh.next(h)) == x) ||
                            (!mesh.is_border(mesh.opposite(h)) && mesh.target(mesh.next(mesh.opposite(h))) == x);
    if(x != into && !is_in_face && mesh.halfedge(x, into).is_valid() && !is_line(mesh.edge(g)) &&
       !mesh.is_border(mesh.edge(g)))
      crossing.push_back(g);
  }
  for(Halfedge g : crossing)
    if(mesh.degree(v) > 3 &&
       !mesh.halfedge(mesh.target(mesh.next(g)), mesh.target(mesh.next(mesh.opposite(g)))).is_valid())
      Euler::flip_edge(g, mesh);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_OPEN_SEPARATING_TRIANGLES_H
