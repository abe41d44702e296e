// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_METRIC_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_METRIC_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How long things are on a mesh with a sizing (paper, section 4). A vertex at which edges are to be h times as long as
// the mean has the density 1/h, and a way counts its length times the density along it. Measured so, all edges of the
// wanted mesh are equally long, and every stage is that for uniform meshes. The density is a property of the mesh; a
// mesh without it is uniform.
class Metric
{
public:
  static constexpr const char* property = "v:density";

  explicit Metric(const Mesh& mesh) : m_mesh(&mesh)
  {
    const auto map = mesh.property_map<Vertex, double>(property);
    m_is_uniform = !map.has_value();
    if(!m_is_uniform)
      m_density = *map;
  }

  bool is_uniform() const { return m_is_uniform; }
  double density(Vertex v) const { return m_is_uniform ? 1. : m_density[v]; }
  double size(Vertex v) const { return m_is_uniform ? 1. : 1. / m_density[v]; }

  // The size changes linearly over a face, so that a bound on its growth along the edges holds between them.
  double size(const Place& place) const
  {
    if(m_is_uniform)
      return 1.;
    const auto v = vertices_of(*m_mesh, place.face);
    const auto& c = place.coordinates;
    return c[0] * size(v[0]) + c[1] * size(v[1]) + c[2] * size(v[2]);
  }

  double squared_length(Vertex v, Vertex w) const
  {
    const double squared = CGAL::squared_distance(m_mesh->point(v), m_mesh->point(w));
    return m_is_uniform ? squared : squared * CGAL::square(.5 * (m_density[v] + m_density[w]));
  }
  double length(Vertex v, Vertex w) const { return std::sqrt(squared_length(v, w)); }
  double length(Edge e) const { return length(m_mesh->vertex(e, 0), m_mesh->vertex(e, 1)); }
  double length(Halfedge h) const { return length(m_mesh->source(h), m_mesh->target(h)); }

private:
  const Mesh* m_mesh;
  Mesh::Property_map<Vertex, double> m_density;
  bool m_is_uniform;
};

// Gives a mesh a density, all ones at first.
inline Mesh::Property_map<Vertex, double> add_density(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, double>(Metric::property, 1.).first;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_METRIC_H
