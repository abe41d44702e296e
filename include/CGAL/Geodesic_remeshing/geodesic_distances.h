// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_GEODESIC_DISTANCES_H
#define CGAL_GEODESIC_REMESHING_GEODESIC_DISTANCES_H

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_metric.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_sources.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geodesic_remeshing {

#ifndef DOXYGEN_RUNNING
namespace internal {

// a vertex or a `Face_location`, as against a range of them
template <typename Graph, typename T>
struct is_surface_point
  : std::integral_constant<bool, std::is_convertible<T, typename boost::graph_traits<Graph>::vertex_descriptor>::value>
{};

template <typename Graph, typename Face, typename Coordinates>
struct is_surface_point<Graph, std::pair<Face, Coordinates>> : std::true_type
{};

template <typename Metric, typename NamedParameters, typename VertexDistanceMap>
void march_from(const Surface_sources<Metric>& sources, const Metric& metric, Front_shape shape,
                VertexDistanceMap vertex_distance_map, const NamedParameters& np)
{
  check_parameters<NamedParameters,
                   Parameters_of_mesh::And<internal_np::vertex_weight_map_t, internal_np::maximum_distance_t>>();
  const double maximum_distance = choose_parameter(get_parameter(np, CGAL::internal_np::maximum_distance), infinity);
  if(!(maximum_distance >= 0.))
    metric.fail("the maximum distance must be a number and not negative");
  const Intrinsic_triangulation triangulation = triangulate_intrinsically(metric, sources.faces());
  Fast_marching marching(triangulation);
  sources.start(marching);
  marching.march(shape, maximum_distance);
  write_distances(metric, marching, maximum_distance, vertex_distance_map);
}

} // namespace internal
#endif

/*!
 * \ingroup PkgGeodesicRemeshingDistanceRef
 *
 * \brief computes for each vertex its distance on the surface from the closest of some sources.
 *
 * The distance of two points is the length of a shortest path on the surface. It is approximated by fast marching on
 * triangles (Kimmel and Sethian, <em>Computing geodesic paths on manifolds</em>; Sifri, Sheffer and Gotsman,
 * <em>Geodesic-based surface remeshing</em>, section 3), in these respects improved: the front marches on the intrinsic
 * Delaunay triangulation of the surface, so that obtuse and thin faces do not matter; a vertex that is reached better
 * later is taken up again; and the bend of the front is taken from the directions of its paths. In the faces that
 * contain a source the distances are exact, and so they are wherever the surface is flat and no other front interferes,
 * up to rounding and rare obtuse angles.
 *
 * Complexity: \cgalBigO{n \log n} in the number of vertices, once to set up and once to march; \cgalBigO{n} in memory.
 * There is no `concurrency_tag`: a front settles one vertex after the other. The function keeps no state, so that
 * several threads can call it at the same time, for other sources of the same mesh too.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeGraph`
 * @tparam VertexDistanceMap a model of `WritablePropertyMap` with
 * `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a floating-point type as value type
 * @tparam Sources `boost::graph_traits<TriangleMesh>::%vertex_descriptor`, or
 * `CGAL::Polygon_mesh_processing::Face_location`, or a range of either
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the surface, with or without boundary
 * @param vertex_distance_map receives the distances, in the unit of the coordinates; infinity at vertices that no path
 * leads to or that are too far
 * @param sources a vertex, a point in a face, or a range of vertices or of points
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
 *     \cgalParamDescription{how much harder than usual the surface is to pass around each vertex: an edge counts as
 *                           long as it is times the mean of the weights at its ends; positive and finite}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{1 at every vertex}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_distance}
 *     \cgalParamDescription{how far to go; farther vertices get infinity, and cost no time; not negative}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
 *                           `Compute_z_3`}
 *     \cgalParamType{a class model of `Kernel`, or any with these functors}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @throws std::invalid_argument if a face is not a triangle, a closed fan of faces touches others at its vertex, a
 * coordinate is not finite, a weight not positive and finite, the longest edge, times its weight, outside of 1e-70 to
 * 1e70, the maximum distance negative or not a number, or if the barycentric coordinates of a source are negative or do
 * not add up to one; the message says what is wrong where, and `vertex_distance_map` is left as it was
 *
 * @sa `geodesic_distances_from_curve()`
 * @sa `geodesic_diameter()`
 */
template <typename TriangleMesh, typename VertexDistanceMap, typename Sources,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void geodesic_distances(const TriangleMesh& tmesh, VertexDistanceMap vertex_distance_map, const Sources& sources,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using Metric = internal::Surface_metric<TriangleMesh, NamedParameters>;
  const Metric metric("geodesic_distances()", tmesh, np);
  internal::Surface_sources<Metric> starts(metric);
  if constexpr(internal::is_surface_point<TriangleMesh, Sources>::value)
    starts.add_point(starts.surface_point(sources));
  else
    for(const auto& source : sources)
      starts.add_point(starts.surface_point(source));
  internal::march_from(starts, metric, internal::Front_shape::circular, vertex_distance_map, np);
}

/*!
 * \ingroup PkgGeodesicRemeshingDistanceRef
 *
 * \brief computes for each vertex its distance on the surface from a curve.
 *
 * The curve is a polyline on the surface: each of its points and the next one lie in one face, on one edge or at one
 * vertex of it, and are joined by the straight piece between them. It is closed if the last point is the first one
 * again. In the faces along the curve the distances are exact; beyond, see `geodesic_distances()`, whose fronts start
 * as circles around points, while the front of a curve starts parallel to it.
 *
 * Complexity: \cgalBigO{n \log n} in the number of vertices, \cgalBigO{n} in memory.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeGraph`
 * @tparam VertexDistanceMap a model of `WritablePropertyMap` with
 * `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a floating-point type as value type
 * @tparam Curve a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor` or of
 * `CGAL::Polygon_mesh_processing::Face_location`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the surface, with or without boundary
 * @param vertex_distance_map receives the distances, in the unit of the coordinates; infinity at vertices that no path
 * leads to or that are too far
 * @param curve the points of the curve in their order
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
 *     \cgalParamDescription{how much harder than usual the surface is to pass around each vertex: an edge counts as
 *                           long as it is times the mean of the weights at its ends; positive and finite}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type}
 *     \cgalParamDefault{1 at every vertex}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_distance}
 *     \cgalParamDescription{how far to go; farther vertices get infinity, and cost no time; not negative}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
 *                           `Compute_z_3`}
 *     \cgalParamType{a class model of `Kernel`, or any with these functors}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @throws std::invalid_argument as `geodesic_distances()` does, and if consecutive points of the curve have no face in
 * common
 *
 * @sa `geodesic_distances()`
 */
template <typename TriangleMesh, typename VertexDistanceMap, typename Curve,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
void geodesic_distances_from_curve(const TriangleMesh& tmesh, VertexDistanceMap vertex_distance_map, const Curve& curve,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using Metric = internal::Surface_metric<TriangleMesh, NamedParameters>;
  const Metric metric("geodesic_distances_from_curve()", tmesh, np);
  internal::Surface_sources<Metric> starts(metric);
  std::size_t number_of_points = 0;
  typename internal::Surface_sources<Metric>::Surface_point last;
  for(const auto& point : curve)
  {
    const auto current = starts.surface_point(point);
    if(number_of_points == 0)
      starts.add_point(current);
    else if(!starts.add_piece(last, current))
      metric.fail("points " + std::to_string(number_of_points - 1) + " and " + std::to_string(number_of_points) +
                  " of the curve have no face in common");
    last = current;
    ++number_of_points;
  }
  internal::march_from(starts, metric, internal::Front_shape::planar, vertex_distance_map, np);
}

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_GEODESIC_DISTANCES_H
