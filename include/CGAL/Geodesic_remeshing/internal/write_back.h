// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_WRITE_BACK_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_WRITE_BACK_H

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Sets the links one by one: `add_face()` would have to find out what is known here.
inline void write_faces(const Lean_triangulation& table, const std::vector<Vertex>& vertex, Mesh& mesh,
                        Mesh::Property_map<Edge, bool> constrained)
{
  using Index = Lean_triangulation::Index;
  std::vector<Halfedge> halfedge(4 * table.face_slots());
  const auto for_each_halfedge = [&](const auto& visit) {
    for(Index f = 0; f < table.face_slots(); ++f)
      for(Index h = 4 * f; h < 4 * f + 3 && !table.is_removed_face(f); ++h)
        visit(h);
  };
  for_each_halfedge([&](const Index h) {
    const Index o = table.opposite(h);
    halfedge[h] = o < h ? mesh.opposite(halfedge[o]) : mesh.add_edge(vertex[table.source(h)], vertex[table.target(h)]);
    constrained[mesh.edge(halfedge[h])] = table.is_constrained(h);
  });
  for(Index f = 0; f < table.face_slots(); ++f)
  {
    if(table.is_removed_face(f))
      continue;
    const Face face = mesh.add_face();
    mesh.set_halfedge(face, halfedge[4 * f]);
    for(Index h = 4 * f; h < 4 * f + 3; ++h)
    {
      mesh.set_face(halfedge[h], face);
      mesh.set_next(halfedge[h], halfedge[Lean_triangulation::next(h)]);
      mesh.set_halfedge(vertex[table.target(h)], halfedge[h]);
    }
  }
  // The boundary runs against the halfedges that have no opposite; it is what a vertex of it points to.
  for_each_halfedge([&](const Index h) {
    if(table.opposite(h) != Lean_triangulation::none)
      return;
    Index last = Lean_triangulation::previous(h);
    while(table.opposite(last) != Lean_triangulation::none)
      last = Lean_triangulation::previous(table.opposite(last));
    mesh.set_next(mesh.opposite(halfedge[h]), mesh.opposite(halfedge[last]));
    mesh.set_halfedge(vertex[table.source(h)], mesh.opposite(halfedge[h]));
  });
}

// Replaces the mesh by the triangulation.
inline void write_back(const Remeshed_surface& remeshed, Mesh& mesh, Mesh::Property_map<Vertex, Place> place,
                       Mesh::Property_map<Vertex, bool> pinned, Mesh::Property_map<Edge, bool> constrained)
{
  const Lean_triangulation& table = remeshed.connectivity();
  mesh.clear_without_removing_property_maps();
  std::vector<Vertex> vertex(table.vertex_slots());
  for(Lean_triangulation::Index v = 0; v < table.vertex_slots(); ++v)
  {
    if(table.is_removed(v))
      continue;
    vertex[v] = mesh.add_vertex(remeshed.spot(v).point);
    place[vertex[v]] = remeshed.spot(v).place;
    pinned[vertex[v]] = remeshed.is_fixed(v);
  }
  write_faces(table, vertex, mesh, constrained);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_WRITE_BACK_H
