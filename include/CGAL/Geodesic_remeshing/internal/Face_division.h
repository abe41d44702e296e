// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FACE_DIVISION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FACE_DIVISION_H

#include <CGAL/Geodesic_remeshing/internal/Component_numbers.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How curves divide the faces. Within a face every piece of a curve cuts off one corner, so the numbers of crossings on
// the three edges tell all: pieces around corner i, innermost first, then the piece in the middle ("normal curves").
//
// An edge with k crossings has k + 1 intervals; the pieces of a face join intervals of its edges.
class Face_division
{
public:
  Face_division(const Mesh& mesh, const Level_curves& curves, Face f) : m_mesh(mesh), m_curves(curves)
  {
    Halfedge h = mesh.halfedge(f);
    for(int i = 0; i < 3; ++i, h = mesh.next(h))
      m_halfedge[i] = h;
    for(int i = 0; i < 3; ++i)
      m_arcs[i] = (crossings(i) + crossings(i + 2) - crossings(i + 1)) / 2;
  }

  Halfedge halfedge(int i) const { return m_halfedge[i % 3]; } // from corner i to corner i + 1
  Vertex corner(int i) const { return m_mesh.source(halfedge(i)); }
  std::ptrdiff_t arcs(int corner) const { return m_arcs[corner % 3]; }

  // Whether pieces around corners can join all crossings; not where curves go different ways along two edges, around a
  // handle smaller than the face
  bool is_possible() const
  {
    return (crossings(0) + crossings(1) + crossings(2)) % 2 == 0 &&
           std::all_of(m_arcs.begin(), m_arcs.end(), [](const std::ptrdiff_t number) { return number >= 0; });
  }

  std::ptrdiff_t crossings(int i) const
  {
    const std::size_t e = m_mesh.edge(halfedge(i)).idx();
    return m_curves.crossing_begin[e + 1] - m_curves.crossing_begin[e];
  }

  // The j-th crossing from corner i on its outgoing edge, or on its incoming one
  std::size_t outgoing(int i, std::ptrdiff_t j) const { return crossing(i, j, true); }
  std::size_t incoming(int i, std::ptrdiff_t j) const { return crossing(i + 2, j, false); }

  // The j-th interval from corner i on its outgoing edge, or on its incoming one, numbered over all edges
  std::size_t outgoing_interval(int i, std::ptrdiff_t j) const { return interval(i, j, true); }
  std::size_t incoming_interval(int i, std::ptrdiff_t j) const { return interval(i + 2, j, false); }

private:
  bool counts_forward(int i, bool from_source) const
  {
    return (m_mesh.halfedge(m_mesh.edge(halfedge(i)), 0) == halfedge(i)) == from_source;
  }

  std::size_t crossing(int i, std::ptrdiff_t j, bool from_source) const
  {
    const std::size_t e = m_mesh.edge(halfedge(i)).idx();
    return counts_forward(i, from_source) ? m_curves.crossing_begin[e] + j : m_curves.crossing_begin[e + 1] - 1 - j;
  }

  std::size_t interval(int i, std::ptrdiff_t j, bool from_source) const
  {
    const std::size_t e = m_mesh.edge(halfedge(i)).idx();
    return counts_forward(i, from_source) ? m_curves.crossing_begin[e] + e + j : m_curves.crossing_begin[e + 1] + e - j;
  }

  const Mesh& m_mesh;
  const Level_curves& m_curves;
  std::array<Halfedge, 3> m_halfedge;
  std::array<std::ptrdiff_t, 3> m_arcs;
};

// The strips: what the curves divide the surface into. The strip of each interval, and their number.
inline std::pair<std::vector<std::uint32_t>, std::size_t> find_strips(const Mesh& mesh, const Level_curves& curves)
{
  Component_numbers strips(curves.crossings.size() + mesh.number_of_edges());
  for(Face f : mesh.faces())
  {
    const Face_division division(mesh, curves, f);
    const bool is_possible = division.is_possible();
    for(int i = 0; i < 3; ++i)
    {
      strips.join(division.outgoing_interval(i, 0), division.incoming_interval(i, 0));
      if(!is_possible)
        continue;
      for(std::ptrdiff_t j = 1; j <= division.arcs(i); ++j)
        strips.join(division.outgoing_interval(i, j), division.incoming_interval(i, j));
      strips.join(division.outgoing_interval(i, division.arcs(i)), division.outgoing_interval(0, division.arcs(0)));
    }
  }
  std::size_t number;
  std::vector<std::uint32_t> strip = strips.take(number);
  return {std::move(strip), number};
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FACE_DIVISION_H
