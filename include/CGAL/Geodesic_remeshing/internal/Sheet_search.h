// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SHEET_SEARCH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SHEET_SEARCH_H

#include <CGAL/Geodesic_remeshing/internal/squared_distance_to_segment.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Are two points that are near in space near on the surface, too, or on two sheets of it? A search over the faces in a
// ball around the first tells, whatever directions the sheets face.
class Sheet_search
{
public:
  explicit Sheet_search(const Mesh& mesh) : m_mesh(mesh), m_seen(mesh.number_of_faces(), 0) {}

  // Does a way from face to face lead there, over edges within the ball only?
  bool connects(Face from, Face to, const Point& centre, double radius)
  {
    ++m_search;
    m_seen[from] = m_search;
    for(m_stack.assign(1, from); !m_stack.empty();)
    {
      const Face f = m_stack.back();
      m_stack.pop_back();
      if(f == to)
        return true;
      for(Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f)))
      {
        const Face g = m_mesh.face(m_mesh.opposite(h));
        if(g == Mesh::null_face() || m_seen[g] == m_search || !reaches(h, centre, radius))
          continue;
        m_seen[g] = m_search;
        m_stack.push_back(g);
      }
    }
    return false;
  }

private:
  bool reaches(Halfedge h, const Point& centre, double radius) const
  {
    return squared_distance_to_segment(centre, m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))) <=
           radius * radius;
  }

  const Mesh& m_mesh;
  std::vector<std::uint32_t> m_seen; // of a face: the last search that came there
  std::uint32_t m_search = 0;
  std::vector<Face> m_stack;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SHEET_SEARCH_H
