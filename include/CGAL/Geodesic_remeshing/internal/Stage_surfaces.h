// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_SURFACES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_SURFACES_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/cut_along_lines.h>
#include <CGAL/Geodesic_remeshing/internal/line_edges.h>
#include <CGAL/Geodesic_remeshing/internal/make_working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The surfaces that the stages work on: the working surface, and what cutting it along the lines inside it makes of it.
// Where no edge of a dense input is too long, the working surface is that input as it is. The stages with the largest
// structures of their own only look at its mesh, so that until they are done the input serves, and no copy takes room
// beside them.
class Stage_surfaces
{
public:
  // The input has to outlive this; its lines are marked in it.
  void refine(Mesh& surface, const Constraints& constraints, const double maximum_edge_length)
  {
    m_surface = &surface;
    mark_lines(surface, constraints);
    m_is_copied = has_long_edges(surface, maximum_edge_length);
    if(m_is_copied)
      make_working_surface(surface, constraints, maximum_edge_length, m_working);
  }

  const Mesh& whole() const { return m_is_copied ? m_working.mesh : *m_surface; }

  // `is_corner` is continued for the new vertices. The pieces are a copy where a line is inside the surface; in any
  // case for who needs them after the strips, which use the working surface up.
  void cut(std::vector<char>& is_corner, const bool is_copy_wanted)
  {
    is_corner.resize(whole().number_of_vertices(), 0);
    m_is_cut = is_copy_wanted || has_lines_inside(whole());
    if(!m_is_cut)
      return;
    if(m_is_copied)
      copy_working_surface(m_working, m_cut);
    else
      copy_surface(*m_surface, m_cut);
    cut_along_lines(m_cut, is_corner);
  }

  const Mesh& mesh_of_pieces() const { return m_is_cut ? m_cut.mesh : whole(); }

  // From here on there is a working surface in any case, to be used up.
  Working_surface& working()
  {
    if(!m_is_copied)
      copy_surface(*m_surface, m_working);
    m_is_copied = true;
    return m_working;
  }

  const Working_surface& pieces() const { return m_is_cut ? m_cut : m_working; }

  void release_pieces() { m_cut.mesh = Mesh(); }

private:
  const Mesh* m_surface = nullptr;
  Working_surface m_working, m_cut;
  bool m_is_copied = false; // the working surface is a mesh of its own
  bool m_is_cut = false;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_SURFACES_H
