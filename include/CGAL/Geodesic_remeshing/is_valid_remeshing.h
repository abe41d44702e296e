// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_IS_VALID_REMESHING_H
#define CGAL_GEODESIC_REMESHING_IS_VALID_REMESHING_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/compare_lines.h>
#include <CGAL/Geodesic_remeshing/internal/compare_surfaces.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/internal/numbers_in_messages.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * What holds of a remeshing, and what does not. Converts to `true` if everything holds.
 */
struct Remeshing_validity
{
  bool is_manifold = false; ///< triangles only, each edge with one or two faces, one fan of faces at each vertex
  bool has_same_components = false;     ///< as many connected components as the input
  bool has_same_genus = false;          ///< the same genus, all components together
  bool has_same_boundary_loops = false; ///< as many boundary loops as the input
  std::size_t number_of_vertices = 0;   ///< of the output
  /// whether that is the number asked for; true if none was named
  bool has_number_of_vertices = false;
  double distance =
      0.; ///< the largest one of an output vertex from the input surface, divided by the diagonal of its box
  bool is_on_surface = false;       ///< the distance is at most the tolerance
  std::size_t degenerate_faces = 0; ///< of the output: with three points on a line
  std::size_t flipped_faces =
      0; ///< of the output: looking against the input surface at their center and at all their corners
  std::size_t self_intersections = 0; ///< pairs of faces of the output that intersect but in what they share
  /// then the output may; only found out if the output does, else `false`
  bool input_intersects_itself = false;
  /// the largest distance of a constrained edge or a boundary edge of the input from the edges of the output, divided
  /// by the diagonal
  double line_distance = 0.;
  /// whether that is at most the tolerance for lines
  bool covers_lines = false;

  /// whether everything holds
  explicit operator bool() const
  {
    return is_manifold && has_same_components && has_same_genus && has_same_boundary_loops && has_number_of_vertices &&
           is_on_surface && degenerate_faces == 0 && flipped_faces == 0 &&
           (self_intersections == 0 || input_intersects_itself) && covers_lines;
  }
};

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * writes one line for each thing checked.
 * @param out the stream
 * @param validity what is written
 * @return `out`
 */
inline std::ostream& operator<<(std::ostream& out, const Remeshing_validity& validity)
{
  const auto line = [&out](const char* what, bool holds, const std::string& figure = {}) {
    out << what << (holds ? "yes" : "NO") << (figure.empty() ? "" : "  (" + figure + ")") << "\n";
  };
  const auto number = [](double x) { return internal::short_number(x); };
  line("manifold              ", validity.is_manifold);
  line("same components       ", validity.has_same_components);
  line("same genus            ", validity.has_same_genus);
  line("same boundary loops   ", validity.has_same_boundary_loops);
  line("number of vertices    ", validity.has_number_of_vertices, std::to_string(validity.number_of_vertices));
  line("on the surface        ", validity.is_on_surface, number(validity.distance) + " of the diagonal");
  line("no degenerate face    ", validity.degenerate_faces == 0, std::to_string(validity.degenerate_faces));
  line("no flipped face       ", validity.flipped_faces == 0, std::to_string(validity.flipped_faces));
  line("no self-intersection  ", validity.self_intersections == 0 || validity.input_intersects_itself,
       std::to_string(validity.self_intersections) + (validity.input_intersects_itself ? ", the input has some" : ""));
  line("lines covered         ", validity.covers_lines, number(validity.line_distance) + " of the diagonal");
  return out;
}

/*!
 * \ingroup PkgGeodesicRemeshingRef
 *
 * \brief checks, knowing nothing of how it was made, whether a mesh is a valid remeshing of another one.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam OutputMesh a model of `FaceListGraph`
 * @tparam NamedParametersIn a sequence of \ref bgl_namedparameters "Named Parameters"
 * @tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the input of the remeshing
 * @param remeshed its output
 * @param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
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
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{the edges of `tmesh`, beside those of its boundary, that edges of the output must cover}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{no edge}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{expected_number_of_vertices}
 *     \cgalParamDescription{the number of vertices asked for}
 *     \cgalParamType{`std::size_t`}
 *     \cgalParamDefault{any number is right}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{surface_tolerance}
 *     \cgalParamDescription{how far from the surface a vertex may be, as a part of the diagonal of the box of `tmesh`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`1e-9`, or eight units of the last place of the largest coordinate where that is more: far from
 *                       the origin}
 *     \cgalParamExtra{The vertices of a mesh made with `do_project(false)` are off the surface, by less than an edge
 *                     length.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{line_tolerance}
 *     \cgalParamDescription{how far a point of a boundary or of a constrained edge may be from the edges of the output,
 *                           as a part of that diagonal}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.01`, or for a line that bends between two vertices of `remeshed` 2.5 times how far, in the mean,
 *                       it leaves the chords of stretches as long as the edges, where that is more}
 *     \cgalParamExtra{Straight lines are covered to rounding; curved ones to the height of an arc over an edge, and
 *                     noise within an edge to its height.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether several threads share the work; the result is the same}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Sequential_tag`}
 *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB, whose own means, such as `tbb::global_control`, limit the number
 *                     of threads.}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `remeshed`}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<OutputMesh>::%vertex_descriptor`
 *                    as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, remeshed)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
 *                           `Compute_z_3`}
 *     \cgalParamType{a class model of `Kernel`, or any with these functors}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{a property map associating to each vertex of `remeshed` a unique index, from zero without
 *                           large gaps}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<OutputMesh>::%vertex_descriptor`
 *                    as key type and `std::size_t` as value type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{halfedge_index_map}
 *     \cgalParamDescription{a property map associating to each halfedge of `remeshed` a unique index, from zero
 *                           without large gaps}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<OutputMesh>::%halfedge_descriptor` as key type and `std::size_t` as value
 *                    type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_index_map}
 *     \cgalParamDescription{a property map associating to each face of `remeshed` a unique index, from zero without
 *                           large gaps}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<OutputMesh>::%face_descriptor`
 *                    as key type and `std::size_t` as value type}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return what holds and what does not
 *
 * @throws std::invalid_argument if `tmesh` is empty, has a face that is not a triangle, an edge without faces, a vertex
 * where fans of faces touch or a coordinate that is not finite; an output of that kind is not manifold
 *
 * \cgalBigO{(n + m) \log (n + m)} for `n` and `m` faces, but for the pairs that intersect.
 */
template <class TriangleMesh, class OutputMesh, class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Remeshing_validity is_valid_remeshing(const TriangleMesh& tmesh, const OutputMesh& remeshed,
                                      const NamedParametersIn& np_in = parameters::default_values(),
                                      const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  check_parameters<NamedParametersIn,
                   Parameters_of_mesh::And<internal_np::edge_is_constrained_t,
                                           internal_np::expected_number_of_vertices_t, internal_np::surface_tolerance_t,
                                           internal_np::line_tolerance_t, internal_np::concurrency_tag_t>>();
  check_parameters<NamedParametersOut, Parameters_of_mesh>();
  Remeshing_validity result;
  Input_surface<TriangleMesh> input;
  copy_input(tmesh, np_in, input);
  Input_surface<OutputMesh> output;
  try
  {
    copy_input(remeshed, np_out, output);
  }
  catch(const std::invalid_argument&)
  {
    return result; // not even a triangle mesh
  }
  result.number_of_vertices =
      static_cast<std::size_t>(std::distance(vertices(remeshed).begin(), vertices(remeshed).end()));
  result.is_manifold = result.number_of_vertices == output.mesh.number_of_vertices(); // the copy has those with faces
  const Surface_comparison comparison(input.mesh, output.mesh, concurrency_of(np_in));
  result.has_same_components = comparison.input_shape().components == comparison.output_shape().components;
  result.has_same_boundary_loops = comparison.input_shape().boundary_loops == comparison.output_shape().boundary_loops;
  result.has_same_genus = comparison.input_shape().twice_genus() == comparison.output_shape().twice_genus();
  const auto expected = static_cast<std::size_t>(
      choose_parameter(get_parameter(np_in, internal_np::expected_number_of_vertices), result.number_of_vertices));
  result.has_number_of_vertices = expected == result.number_of_vertices;
  result.distance = comparison.distance_of_vertices();
  result.is_on_surface = result.distance <= choose_parameter(get_parameter(np_in, internal_np::surface_tolerance),
                                                             (std::max)(1e-9, comparison.distance_of_rounding()));
  result.degenerate_faces = comparison.number_of_degenerate_faces();
  result.flipped_faces = comparison.number_of_flipped_faces();
  result.self_intersections = number_of_self_intersections<Concurrency_tag_of<NamedParametersIn>>(output.mesh);
  result.input_intersects_itself = result.self_intersections > 0 &&
                                   number_of_self_intersections<Concurrency_tag_of<NamedParametersIn>>(input.mesh) > 0;
  const Line_comparison lines(input.mesh, output.mesh, constrained_edges_of(tmesh, input.mesh, np_in));
  result.line_distance = comparison.relative(lines.distance());
  if constexpr(is_given<NamedParametersIn, internal_np::line_tolerance_t>)
    result.covers_lines = result.line_distance <= get_parameter(np_in, internal_np::line_tolerance);
  else
    result.covers_lines = lines.are_covered(.01 * comparison.diagonal());
  return result;
}

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_IS_VALID_REMESHING_H
