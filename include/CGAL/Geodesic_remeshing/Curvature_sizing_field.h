// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_CURVATURE_SIZING_FIELD_H
#define CGAL_GEODESIC_REMESHING_CURVATURE_SIZING_FIELD_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/curvature.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/internal/size_field.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingSizingRef
 *
 * \brief A sizing field by curvature: short edges where the surface bends, long ones where it is flat (paper, section
 * 4).
 *
 * The curvature of a vertex is a combination of the Gaussian curvature \f$K\f$ and the mean curvature \f$H\f$ with the
 * weights \f$a\f$ and \f$b\f$ of the user, \f$\kappa = a \sqrt{|K|} + b |H|\f$, in which both have the unit of an
 * inverse length. The length at the vertex is proportional to \f$(\min(\kappa / \bar\kappa, 4) + 0.3)^{-0.8 c}\f$ with
 * the mean \f$\bar\kappa\f$ over the surface and the contrast \f$c\f$: with 0 the sizing is uniform, with 0.5 the RMS
 * distance from the surface is about the least, with more the deviation of the most bent parts falls further. A mesh by
 * this sizing is to be near to the surface, so its vertices also go, by parts of an edge, to where it is.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 *
 * \cgalModels{GeodesicRemeshingSizingField}
 *
 * @sa `CGAL::geodesic_remeshing()`
 * @sa `CGAL::Polygon_mesh_processing::interpolated_corrected_curvatures()`
 */
template <class TriangleMesh>
class Curvature_sizing_field
{
public:
  /// the type of the mesh
  using Triangle_mesh = TriangleMesh;
  /// vertex descriptor
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// number type
  using FT = double;

  /*!
   * computes the curvatures of all vertices.
   *
   * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
   *
   * @param tmesh a triangle mesh, with or without boundary
   * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
   *
   * \cgalNamedParamsBegin
   *   \cgalParamNBegin{contrast}
   *     \cgalParamDescription{how much the lengths differ, from 0 (not at all) to 2}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0.5`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gaussian_weight}
   *     \cgalParamDescription{the weight of the Gaussian curvature, not negative}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0.5`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{mean_weight}
   *     \cgalParamDescription{the weight of the mean curvature, not negative; the two weights must not both be zero}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0.5`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{ball_radius}
   *     \cgalParamDescription{the radius of the ball around a vertex over which the curvatures are averaged, in the
   *                           unit of the coordinates; positive and finite}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{the faces around the vertex and its neighbors}
   *     \cgalParamExtra{Of use on noisy surfaces; the time grows with the number of faces in a ball.}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{gradation}
   *     \cgalParamDescription{the largest growth of the length along the surface, see `Sizing_limits`}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{that of `Sizing_limits`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{minimum_length}
   *     \cgalParamDescription{the smallest length, see `Sizing_limits`}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{`0`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{maximum_length}
   *     \cgalParamDescription{the largest length, see `Sizing_limits`}
   *     \cgalParamType{`double`}
   *     \cgalParamDefault{infinity}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{vertex_point_map}
   *     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value
   *                    type}
   *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{geom_traits}
   *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
   *                           `Compute_z_3`}
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
   *                    `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `std::size_t` as
   *                    value type}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   *   \cgalParamNBegin{face_index_map}
   *     \cgalParamDescription{a property map associating to each face of `tmesh` a unique index, from zero without
   *                           large gaps}
   *     \cgalParamType{a class model of `ReadablePropertyMap` with
   *                    `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `std::size_t` as value
   *                    type}
   *     \cgalParamDefault{an automatically indexed internal map}
   *   \cgalParamNEnd
   * \cgalNamedParamsEnd
   *
   * @throws std::invalid_argument if the mesh is empty, has a face that is not a triangle, an edge without faces, a
   * vertex where fans of faces touch or a coordinate that is not finite, or if a parameter is out of its range
   *
   * \cgalBigO{n} for `n` vertices without `ball_radius`.
   */
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Curvature_sizing_field(const TriangleMesh& tmesh, const NamedParameters& np = parameters::default_values())
    : m_length(get(CGAL::dynamic_vertex_property_t<double>(), tmesh))
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    internal::check_parameters<
        NamedParameters, internal::Parameters_of_mesh::And<internal_np::contrast_t, internal_np::gaussian_weight_t,
                                                           internal_np::mean_weight_t, internal_np::ball_radius_t,
                                                           internal_np::gradation_t, internal_np::minimum_length_t,
                                                           internal_np::maximum_length_t>>();
    internal::Curvature_weights weights;
    weights.contrast = choose_parameter(get_parameter(np, internal_np::contrast), weights.contrast);
    weights.gaussian = choose_parameter(get_parameter(np, internal_np::gaussian_weight), weights.gaussian);
    weights.mean = choose_parameter(get_parameter(np, internal_np::mean_weight), weights.mean);
    if constexpr(internal::is_given<NamedParameters, internal_np::ball_radius_t>)
      weights.ball_radius = CGAL::to_double(get_parameter(np, internal_np::ball_radius));
    m_limits.gradation = choose_parameter(get_parameter(np, internal_np::gradation), m_limits.gradation);
    m_limits.minimum_length = choose_parameter(get_parameter(np, internal_np::minimum_length), m_limits.minimum_length);
    m_limits.maximum_length = choose_parameter(get_parameter(np, internal_np::maximum_length), m_limits.maximum_length);
    internal::check_limits(m_limits);
    m_nearness = (std::min)(2. * weights.contrast, 1.);

    for(auto v : vertices(tmesh))
      put(m_length, v, 1.); // isolated vertices
    internal::Input_surface<TriangleMesh> input;
    internal::copy_input(tmesh, np, input);
    const std::vector<double> lengths = internal::lengths_by_curvature(input.mesh, weights);
    for(std::size_t i = 0; i < lengths.size(); ++i)
      put(m_length, input.vertex_of[i], lengths[i]);
  }

  /// \return the length of the edges at `v`, relative to their mean length
  /// \param v a vertex of the mesh given to the constructor
  double at(vertex_descriptor v) const { return get(m_length, v); }

  /// \return the limits given to the constructor, which `geodesic_remeshing()` keeps to
  const Sizing_limits& limits() const { return m_limits; }

  /// \return what it is worth to be near to the surface, at the cost of angles: 1 from a contrast of 0.5 on, with less
  /// contrast less, with none 0
  double nearness() const { return m_nearness; }

private:
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<double>>::const_type m_length;
  Sizing_limits m_limits;
  double m_nearness = 0.;
};

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_CURVATURE_SIZING_FIELD_H
