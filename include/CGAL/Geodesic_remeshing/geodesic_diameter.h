// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_GEODESIC_DIAMETER_H
#define CGAL_GEODESIC_REMESHING_GEODESIC_DIAMETER_H

#include <CGAL/Geodesic_remeshing/internal/Surface_metric.h>
#include <CGAL/Geodesic_remeshing/internal/farthest_points.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingDistanceRef
 *
 * The result of `geodesic_diameter()`.
 *
 * @tparam TriangleMesh the type of the mesh
 */
template <typename TriangleMesh>
struct Geodesic_diameter
{
  /// vertex descriptor
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// one end
  vertex_descriptor first = boost::graph_traits<TriangleMesh>::null_vertex();
  /// the other end, the farthest vertex from `first`
  vertex_descriptor second = boost::graph_traits<TriangleMesh>::null_vertex();
  /// their geodesic distance
  double distance = 0.;
  /// how often distances were computed
  std::size_t number_of_runs = 0;
};

/*!
 * \ingroup PkgGeodesicRemeshingDistanceRef
 *
 * \brief finds two vertices of a surface that are about as far apart as two of its vertices can be.
 *
 * The distance is the length of a shortest path on the surface. The function goes from a vertex to the one that is
 * farthest from it, and on from there, until the distance does not grow by more than 1e-4 of it. As Sifri, Sheffer and
 * Gotsman (<em>Geodesic-based surface remeshing</em>, section 4) remark, this may stop at a pair that is locally
 * farthest. If the mesh has several connected components, the one with the largest distance counts.
 *
 * Complexity: each of two to six runs takes \cgalBigO{n \log n} time in the number of vertices, \cgalBigO{n} in memory.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeGraph`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the surface, with or without boundary
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map associating to each vertex of `tmesh` a unique index, from zero without
 *                           large gaps}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value
 *                    type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{halfedge_index_map}
 *     \cgalParamDescription{a property map associating to each halfedge of `tmesh` a unique index, from zero without
 *                           large gaps}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `std::size_t` as value
 *                    type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_index_map}
 *     \cgalParamDescription{a property map associating to each face of `tmesh` a unique index, from zero without large
 *                           gaps}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
 *                    as key type and `std::size_t` as value type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_weight_map}
 *     \cgalParamDescription{how much harder than usual the surface is to pass around each vertex, as in
 *                           `geodesic_distances()`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{1 at every vertex}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_distance_map}
 *     \cgalParamDescription{a property map that receives the distances from `first`; infinity in other connected
 *                           components}
 *     \cgalParamType{a class model of `WritablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a value type that
 *                    `double` converts to}
 *     \cgalParamDefault{distances are not written}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
 *                           `Compute_z_3`}
 *     \cgalParamType{a class model of `Kernel`, or any with these functors}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return the two vertices, their distance and the number of runs; without faces, null vertices and 0
 *
 * @throws std::invalid_argument if a face is not a triangle, a closed fan of faces touches others at its vertex, a
 * coordinate is not finite, a weight not positive and finite, or the longest edge, times its weight, outside of 1e-70
 * to 1e70; the message says which vertex or face
 *
 * @sa `geodesic_distances()`
 */
template <typename TriangleMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Geodesic_diameter<TriangleMesh> geodesic_diameter(const TriangleMesh& tmesh,
                                                  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<NamedParameters, internal::Parameters_of_mesh::And<internal_np::vertex_weight_map_t,
                                                                                internal_np::vertex_distance_map_t>>();
  const internal::Surface_metric<TriangleMesh, NamedParameters> metric("geodesic_diameter()", tmesh, np);
  const auto triangulation = internal::triangulate_intrinsically(metric);
  internal::Fast_marching marching(triangulation);
  const internal::Farthest_pair* largest = nullptr;
  const auto pairs = internal::farthest_pairs(marching);
  for(const internal::Farthest_pair& pair : pairs)
    if(largest == nullptr || pair.distance > largest->distance)
      largest = &pair;

  Geodesic_diameter<TriangleMesh> result;
  if(largest != nullptr)
  {
    result.distance = largest->distance;
    result.number_of_runs = largest->number_of_runs;
    for(const auto v : vertices(tmesh))
    {
      if(metric.index(v) == largest->root)
        result.first = v;
      if(metric.index(v) == largest->farthest)
        result.second = v;
    }
  }
  if constexpr(!CGAL::parameters::is_default_parameter<NamedParameters, internal_np::vertex_distance_map_t>::value)
  {
    marching.clear();
    if(largest != nullptr)
      marching.add_source(largest->root);
    marching.march(internal::Front_shape::circular);
    internal::write_distances(metric, marching, internal::infinity,
                              CGAL::parameters::get_parameter(np, internal_np::vertex_distance_map));
  }
  return result;
}

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_GEODESIC_DIAMETER_H
