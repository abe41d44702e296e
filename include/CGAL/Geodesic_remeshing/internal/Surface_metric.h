// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_METRIC_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_METRIC_H

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/Points_of_graph.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;
using CGAL::parameters::is_default_parameter;

// What the named parameters say of a mesh: its indices, and how long its edges are. Checked in every build, as bad
// input would else show only in the result.
template <typename TriangleMesh, typename NamedParameters>
class Surface_metric
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Unit_weight_map = Constant_property_map<typename Graph_traits::vertex_descriptor, double>;
  using Vertex_weight_map = typename CGAL::internal_np::Lookup_named_param_def<internal_np::vertex_weight_map_t,
                                                                               NamedParameters, Unit_weight_map>::type;

public:
  using Mesh_type = TriangleMesh;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Vertex_index_map = typename GetInitializedVertexIndexMap<TriangleMesh, NamedParameters>::const_type;
  using Face_index_map = typename GetInitializedFaceIndexMap<TriangleMesh, NamedParameters>::const_type;

  Surface_metric(const char* function, const TriangleMesh& tmesh, const NamedParameters& np)
    : function(function), mesh(tmesh), vertex_index(get_initialized_vertex_index_map(tmesh, np)),
      face_index(get_initialized_face_index_map(tmesh, np)), m_points(tmesh, np), m_weights(choose_weights(np))
  {
    check();
  }

  // An edge is as long as it is in space, times the mean of the weights at its ends (section 3 of the paper).
  double length(halfedge_descriptor h) const
  {
    const auto u = source(h, mesh);
    const auto v = target(h, mesh);
    return std::sqrt(CGAL::squared_distance(m_points(u), m_points(v))) * 0.5 * (weight(u) + weight(v));
  }

  internal::Vertex index(vertex_descriptor v) const
  {
    return internal::Vertex(static_cast<internal::Vertex::size_type>(get(vertex_index, v)));
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::invalid_argument(std::string(function) + ": " + what);
  }

  const char* const function;
  const TriangleMesh& mesh;
  const Vertex_index_map vertex_index;
  const Face_index_map face_index;

private:
  static Vertex_weight_map choose_weights(const NamedParameters& np)
  {
    if constexpr(is_default_parameter<NamedParameters, internal_np::vertex_weight_map_t>::value)
      return Vertex_weight_map(1.);
    else
      return get_parameter(np, internal_np::vertex_weight_map);
  }

  double weight(vertex_descriptor v) const { return CGAL::to_double(get(m_weights, v)); }

  void check() const
  {
    for(const auto v : vertices(mesh))
    {
      const Point p = m_points(v);
      if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
        fail("the coordinates of vertex " + std::to_string(get(vertex_index, v)) + " are not finite");
      if(!(weight(v) > 0.) || !std::isfinite(weight(v)))
        fail("the weight of vertex " + std::to_string(get(vertex_index, v)) + " is not a positive number");
    }
    for(const auto f : faces(mesh))
      if(!is_triangle(halfedge(f, mesh), mesh))
        fail("face " + std::to_string(get(face_index, f)) + " is not a triangle");
    double longest = 0.;
    for(const auto e : edges(mesh))
      longest = (std::max)(longest, length(halfedge(e, mesh)));
    if(!is_scale_computable(longest) && longest > 0.)
      fail("the edges are too short or too long to compute with");
  }

  Points_of_graph<TriangleMesh, NamedParameters> m_points;
  Vertex_weight_map m_weights;
};

template <typename TriangleMesh, typename NamedParameters>
Intrinsic_triangulation triangulate_intrinsically(const Surface_metric<TriangleMesh, NamedParameters>& metric,
                                                  const std::vector<std::size_t>& frozen_faces = {})
{
  return Intrinsic_triangulation(
      metric.mesh, metric.vertex_index, metric.face_index, [&](auto h) { return metric.length(h); }, frozen_faces);
}

// Infinity where the front has not been, and beyond the maximum; sources may lie farther.
template <typename Metric, typename VertexDistanceMap>
void write_distances(const Metric& metric, const Fast_marching& marching, double maximum_distance,
                     VertexDistanceMap vertex_distance_map)
{
  using Distance = typename boost::property_traits<VertexDistanceMap>::value_type;
  for(const auto v : vertices(metric.mesh))
  {
    const double distance = marching.distance(metric.index(v));
    put(vertex_distance_map, v, static_cast<Distance>(distance <= maximum_distance ? distance : infinity));
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SURFACE_METRIC_H
