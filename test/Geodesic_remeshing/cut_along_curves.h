// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_CUT_ALONG_CURVES_H
#define GEODESIC_REMESHING_TEST_CUT_ALONG_CURVES_H

#include <CGAL/Geodesic_remeshing/internal/Face_division.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace support {

using namespace CGAL::Geodesic_remeshing::internal;

// The surface cut along all curves, with the strip of each face in "f:strip".
inline Mesh cut_along_curves(const Mesh& mesh, const Level_curves& curves, const std::vector<std::uint32_t>& strips)
{
  Mesh result;
  auto strip = result.add_property_map<Face, std::uint32_t>("f:strip").first;
  for(Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  for(Edge e : mesh.edges())
    for(std::size_t c = curves.crossing_begin[e.idx()]; c < curves.crossing_begin[e.idx() + 1]; ++c)
      result.add_vertex(point_at(mesh, Curve_point{mesh.halfedge(e), curves.crossings[c].position}));
  const auto vertex = [&](const std::size_t crossing) {
    return Vertex(static_cast<Mesh::size_type>(mesh.number_of_vertices() + crossing));
  };
  const auto add_polygon = [&](const std::vector<Vertex>& polygon, const std::size_t interval) {
    for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
      strip[result.add_face(polygon[0], polygon[i], polygon[i + 1])] = strips[interval];
  };
  for(Face f : mesh.faces())
  {
    const Face_division division(mesh, curves, f);
    std::vector<Vertex> middle;
    for(int i = 0; i < 3; ++i)
    {
      std::vector<Vertex> last = {division.corner(i)}; // where the piece begins: at the corner or at an arc
      for(std::ptrdiff_t j = 0; j < division.arcs(i); ++j)
      {
        std::vector<Vertex> piece = last;
        const Vertex outgoing = vertex(division.outgoing(i, j)), incoming = vertex(division.incoming(i, j));
        piece.insert(piece.end(), {outgoing, incoming});
        add_polygon(piece, division.outgoing_interval(i, j));
        last = {incoming, outgoing};
      }
      middle.insert(middle.end(), last.begin(), last.end());
    }
    add_polygon(middle, division.outgoing_interval(0, division.arcs(0)));
  }
  return result;
}

} // namespace support

#endif // GEODESIC_REMESHING_TEST_CUT_ALONG_CURVES_H
