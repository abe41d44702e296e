// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_EDGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_EDGES_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Which edges lie on lines is a property of a mesh, which its copies take over.
constexpr const char* line_property = "e:line";

inline Mesh::Property_map<Edge, bool> mark_lines(Mesh& mesh, const Constraints& constraints)
{
  const auto is_line = mesh.add_property_map<Edge, bool>(line_property, false).first;
  for(Edge e : mesh.edges())
    is_line[e] = !constraints.is_line.empty() && constraints.is_line[e.idx()];
  return is_line;
}

// Of a mesh that has it
inline Mesh::Property_map<Edge, bool> lines_of(const Mesh& mesh)
{
  return *mesh.property_map<Edge, bool>(line_property);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_EDGES_H
