// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EQUIDISTANT_CURVES_H
#define CGAL_GEODESIC_REMESHING_EQUIDISTANT_CURVES_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingRegionsRef
 * A curve on which a function on a surface has one value: an ordered polyline over points of edges.
 * @tparam TriangleMesh the type of the mesh
 * @tparam Point its point type
 */
template <class TriangleMesh, class Point>
struct Equidistant_curve
{
  double value;              ///< of the function on the curve
  bool is_closed;            ///< a loop, whose last point is joined to its first; else an arc from boundary to boundary
  std::vector<Point> points; ///< in order, with the smaller values on the left hand side
  /// of each point the halfedge it lies on, and where: 0 at the source, 1 at the target
  std::vector<std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>> places;
};

namespace internal {

// One region, whose field is the function and whose curves are at the values
inline Segmentation levels_of_function(std::vector<double> function, const std::vector<double>& values)
{
  Segmentation result;
  result.number_of_junctions = 2;
  Region region;
  region.values = values;
  region.number_of_levels = static_cast<int>(values.size());
  region.bottom = 1;
  result.regions.push_back(region);
  result.region.assign(function.size(), 0);
  result.field_region = result.region;
  for(double d : function)
    result.level.push_back(1 + static_cast<int>(std::lower_bound(values.begin(), values.end(), d) - values.begin()));
  result.field = std::move(function);
  return result;
}

template <class TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_of_input(const TriangleMesh& tmesh, const Input_surface<TriangleMesh>& input, Halfedge h)
{
  const bool is_border = input.mesh.is_border(h);
  const Halfedge inner = is_border ? input.mesh.opposite(h) : h;
  auto g = halfedge(input.face_of[input.mesh.face(inner)], tmesh);
  while(target(g, tmesh) != input.vertex_of[input.mesh.target(inner)])
    g = next(g, tmesh);
  return is_border ? opposite(g, tmesh) : g;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicRemeshingRegionsRef
 *
 * \brief traces the curves on which a piecewise linear function, such as a geodesic distance, has
 * given values (section 3 of the paper).
 *
 * All values are traced in one pass. A vertex whose value is exactly that of a curve counts as lower, so that each
 * triangle is crossed twice or not at all: every curve is a loop, or an arc from boundary to boundary, whatever
 * plateaus the function has.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam VertexValueMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
 * as key type and a number type as value type
 * @tparam OutputIterator a model of `OutputIterator` that accepts `Equidistant_curve<TriangleMesh, Point>`
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh a triangle mesh, with or without boundary
 * @param vertex_value_map the values of the function, for example filled by `geodesic_distances()`
 * @param values the values to trace, in ascending order
 * @param curves takes the curves, in the order of their values
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
 *                           `Compute_z_3` and `Construct_point_3`}
 *     \cgalParamType{a class model of `Kernel`, or any with these functors}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
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
 * \cgalNamedParamsEnd
 *
 * @throws std::invalid_argument if the mesh is empty, has a face that is not a triangle, an edge without faces or a
 * vertex where fans of faces touch, if a coordinate or a value of the function is not finite, or if the values are not
 * numbers in ascending order
 * @return `curves` after the last curve
 *
 * \cgalBigO{n \log m + k} for `n` vertices, `m` values and `k` points of curves.
 */
template <class TriangleMesh, class VertexValueMap, class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator equidistant_curves(const TriangleMesh& tmesh, VertexValueMap vertex_value_map,
                                  const std::vector<double>& values, OutputIterator curves,
                                  const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  check_parameters<NamedParameters, Parameters_of_mesh>();
  const auto traits = geom_traits_of<TriangleMesh>(np);
  using User_point = std::decay_t<decltype(from_point(traits, Point()))>;
  if(std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }) ||
     !std::is_sorted(values.begin(), values.end()))
    reject("the values of the curves must be numbers in ascending order");
  Input_surface<TriangleMesh> input;
  copy_input(tmesh, np, input);
  const auto index = vertex_indices_of(tmesh, np);
  std::vector<double> function;
  for(auto v : input.vertex_of)
  {
    function.push_back(CGAL::to_double(get(vertex_value_map, v)));
    if(!std::isfinite(function.back()))
      reject("the value at vertex " + std::to_string(get(index, v)) + " is not finite");
  }
  const Segmentation levels = levels_of_function(std::move(function), values);
  const Level_curves traced = Curve_tracer(input.mesh, levels).trace();
  std::vector<Equidistant_curve<TriangleMesh, User_point>> results; // all or none go out
  for(const Level_curve& curve : traced.curves)
  {
    Equidistant_curve<TriangleMesh, User_point> result{values[curve.level - 1], curve.is_closed, {}, {}};
    for(std::size_t i = curve.begin; i < curve.end; ++i)
    {
      result.points.push_back(from_point(traits, point_at(input.mesh, traced.points[i])));
      result.places.emplace_back(halfedge_of_input(tmesh, input, traced.points[i].halfedge), traced.points[i].position);
    }
    results.push_back(std::move(result));
  }
  return std::move(results.begin(), results.end(), curves);
}

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_EQUIDISTANT_CURVES_H
