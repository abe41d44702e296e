// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CUT_ALONG_LINES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CUT_ALONG_LINES_H

#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Cuts the working surface open along the lines inside it. Every line becomes a boundary, so that fronts and curves
// do not know what is beyond (paper, section 6: nothing is triangulated across a feature). Faces and, of the
// vertices, the first of each keep their numbers.
class Line_cutter
{
public:
  Line_cutter(Working_surface& cut, std::vector<char>& is_corner)
    : m_cut(cut), m_mesh(cut.mesh), m_is_corner(is_corner), m_has_density(!Metric(cut.mesh).is_uniform()),
      m_is_used(cut.mesh.number_of_vertices(), 0)
  {}

  void run()
  {
    const std::size_t edges = m_mesh.number_of_edges();
    for(std::size_t i = 0; i < edges; ++i)
    {
      const Edge e(static_cast<Mesh::size_type>(i));
      if(m_cut.is_line[e] && !m_mesh.is_border(e))
        open(m_mesh.halfedge(e, 1));
    }
    for(Halfedge h : m_mesh.halfedges())
      if(m_mesh.is_border(h))
        close_border(h);
  }

private:
  // A new edge takes the place of the old one beside the face of h.
  void open(Halfedge h)
  {
    const Halfedge g = m_mesh.add_edge(m_mesh.source(h), m_mesh.target(h));
    const Face f = m_mesh.face(h);
    m_mesh.set_next(g, m_mesh.next(h));
    m_mesh.set_next(m_mesh.prev(h), g);
    m_mesh.set_face(g, f);
    if(m_mesh.halfedge(f) == h)
      m_mesh.set_halfedge(f, g);
    m_mesh.set_face(h, Mesh::null_face());
    m_cut.is_line[m_mesh.edge(g)] = true;
  }

  // From a halfedge on the border around its target to the one that the border leaves by: what lies between has a
  // vertex of its own.
  void close_border(Halfedge border)
  {
    Vertex v = m_mesh.target(border);
    if(m_is_used[v])
      v = copy_of(v);
    m_is_used[v] = 1;
    m_mesh.set_target(border, v);
    m_mesh.set_halfedge(v, border);
    Halfedge h = m_mesh.opposite(border);
    while(!m_mesh.is_border(h))
    {
      m_mesh.set_target(m_mesh.prev(h), v);
      h = m_mesh.opposite(m_mesh.prev(h));
    }
    m_mesh.set_next(border, h);
  }

  Vertex copy_of(Vertex v)
  {
    const Point point = m_mesh.point(v); // a reference would not outlive the growth of the mesh
    const Vertex copy = m_mesh.add_vertex(point);
    m_cut.place[copy] = m_cut.place[v];
    if(m_has_density)
      m_cut.density[copy] = m_cut.density[v];
    m_is_used.push_back(0);
    m_is_corner.push_back(m_is_corner[v]);
    return copy;
  }

  Working_surface& m_cut;
  Mesh& m_mesh;
  std::vector<char>& m_is_corner;
  const bool m_has_density;
  std::vector<char> m_is_used;
};

// `is_corner` is continued for the new vertices.
inline void cut_along_lines(Working_surface& working, std::vector<char>& is_corner)
{
  Line_cutter(working, is_corner).run();
}

inline bool has_lines_inside(const Mesh& mesh)
{
  const auto is_line = lines_of(mesh);
  return std::any_of(mesh.edges_begin(), mesh.edges_end(), [&](Edge e) { return is_line[e] && !mesh.is_border(e); });
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CUT_ALONG_LINES_H
