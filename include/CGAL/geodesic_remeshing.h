// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_H
#define CGAL_GEODESIC_REMESHING_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Stage_clock.h>
#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/find_constraints.h>
#include <CGAL/Geodesic_remeshing/internal/fit_sizing.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/internal/regions_of_faces.h>
#include <CGAL/Geodesic_remeshing/internal/run_stages.h>
#include <CGAL/Geodesic_remeshing/internal/size_field.h>
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>
#include <CGAL/Geodesic_remeshing/internal/write_output.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <memory>
#include <type_traits>

namespace CGAL {

/*!
 * \ingroup PkgGeodesicRemeshingRef
 *
 * \brief remeshes a triangulated surface by geodesic distances on it: the output has the same topology, exactly the
 * number of vertices asked for, and well-shaped triangles of even size or of the sizes wished; all its vertices lie on
 * the input surface, unless `do_project(false)` lets them leave it to bring the mesh nearer to it.
 *
 * The algorithm is that of Sifri, Sheffer and Gotsman \cgalCite{cgal:ssg-gbsr-03}: distances from a root vertex
 * are computed by fast marching (section 3 of the paper), the surface is segmented into regions in which fronts advance
 * without meeting (section 5), equidistant curves in the regions are sampled, and the strips between them are
 * triangulated by the dual of geodesic Voronoi cells (section 6). Valences, angles and the number of vertices are then
 * improved with the vertices walking on the input surface.
 *
 * The boundary of the surface, features, constrained edges and the borders of patches are <em>lines</em>: edges of the
 * output cover them. Their vertices start at even distances, nearer to each other where two lines are, and slide along
 * them in the improvement. Where lines end, meet or turn sharply are <em>corners</em>, which are vertices of the
 * output. A line turns sharply at a vertex
 *
 * - where the chords on both sides of it, half an edge length of the output long, turn by 60 degrees;
 * - where they turn by 30, and the two edges there by 60;
 * - where both turn by 30, and the line nowhere more than half as sharply as these edges within three quarters of an
 *   edge length;
 * - where the two edges turn by 10 between two straight stretches, which are one and a half edge lengths long or reach
 *   to the end of the line.
 *
 * Of such vertices nearer to each other than half an edge length the one where the chords turn most is a corner. Curves
 * are those of pieces between lines: their fronts start on the longest straight line around a piece.
 *
 * The same input gives the same output, bit by bit.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam Target an integral type, `Geodesic_remeshing::Number_of_faces` or `Geodesic_remeshing::Edge_length`
 * @tparam OutputMesh a model of `MutableFaceGraph`
 * @tparam NamedParametersIn a sequence of \ref bgl_namedparameters "Named Parameters"
 * @tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the input: a triangle mesh of any genus, with any number of boundary loops and connected components.
 * Degenerate faces, duplicate points and isolated vertices are allowed; the latter are left out.
 * @param target the number of vertices, at most 500,000,000; or the number of faces, `Number_of_faces{n}`; or
 * `Edge_length{l}`, which asks for the number of vertices that equilateral triangles of that edge length would have
 * @param out the output, cleared before it is filled
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
 *   \cgalParamNBegin{sizing_field}
 *     \cgalParamDescription{how long edges are to be at each vertex of `tmesh` (section 4 of the paper). When `target`
 *                           is a number, only the ratios of these lengths matter: all are multiplied by the factor that
 *                           gives the number. With `Edge_length{l}` edges are to be `l` times as long as the field
 *                           tells; `Edge_length{1}` takes it as it is.}
 *     \cgalParamType{a class model of `GeodesicRemeshingSizingField`, such as
 *                    `Geodesic_remeshing::Curvature_sizing_field`; or of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number as value type; or
 *                    of `PMPSizingField`, such as `Polygon_mesh_processing::Adaptive_sizing_field`}
 *     \cgalParamDefault{all edges are to be equally long}
 *     \cgalParamExtra{The field is copied; pass it by `std::cref()` if that is costly. It is asked once for each vertex
 *                     that has a face.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{gradation}
 *     \cgalParamDescription{the largest growth of the length along the surface, positive: see
 *                           `Geodesic_remeshing::Sizing_limits`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{that of the field, if it has limits of its own, else that of
 *                       `Geodesic_remeshing::Sizing_limits`}
 *     \cgalParamExtra{This and the two lengths below are limits on a sizing: without `sizing_field` the call does not
 *                     compile.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{minimum_length}
 *     \cgalParamDescription{the smallest length that edges aim at, in the unit of the coordinates}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{that of the field, else `0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{maximum_length}
 *     \cgalParamDescription{the largest length that edges aim at, in the unit of the coordinates}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{that of the field, else infinity}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{features_angle_bound}
 *     \cgalParamDescription{edges at which the surface turns by at least this angle, in degrees, are lines, as
 *                           `Polygon_mesh_processing::detect_sharp_edges()` finds them; but not short ones: lines with
 *                           one end in the surface shorter than an edge of the output is to be, with both ends there
 *                           shorter than two, and rings shorter than three quarters of one. Then tips of cones,
 *                           vertices at which more than 90 degrees are missing, are corners.}
 *     \cgalParamType{a number, positive; above 180 there are no features, nor creases}
 *     \cgalParamDefault{no features but the long creases of an input of few faces: sharper than 50 degrees, more than
 *                       three edge lengths of the output long, with room for a row of triangles on both sides and
 *                       between them, and with others or the boundary at both ends; none with `protect_constraints`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{a property map that tells which edges of `tmesh` are lines}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{no edge but those on the boundary}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{a property map that tells which vertices of `tmesh` are corners}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with
 *                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
 *     \cgalParamDefault{none but those found}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{a property map with the patch of each face of `tmesh`: edges between two patches are lines}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
 *                    as key type and a value type that can be compared for equality}
 *     \cgalParamDefault{no patches}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{protect_constraints}
 *     \cgalParamDescription{whether lines are kept exactly, with all their vertices and edges: the boundary, features,
 *                           constrained edges, the borders of patches}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *     \cgalParamExtra{Where edges on lines are shorter or longer than those of the output, triangles beside them cannot
 *                     be well-shaped.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{use_segmentation}
 *     \cgalParamDescription{whether the surface is segmented into regions, or the curves are those of the distance from
 *                           the root alone; pieces with boundary are never segmented}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of rounds of the improvement}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`3`}
 *     \cgalParamExtra{With 0 only the number of vertices is mended, so that the result shows the triangulated strips.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{use_defect_moves}
 *     \cgalParamDescription{whether the improvement searches for sequences of flips that remove irregular vertices}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *     \cgalParamExtra{They take about a fifth of the time of the whole from 10,000 vertices on, nearly half at 5,000 and
 *                     two thirds at 2,000. Without them about three times as many vertices are irregular.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{do_project}
 *     \cgalParamDescription{whether the vertices lie on the input surface. With `false` they leave it so that the mesh
 *                           as a whole is as near to the surface as its number of vertices and angles of about 31
 *                           degrees allow, in both directions: its largest distance is about a third and its RMS
 *                         distance half of those of a mesh with its vertices on the surface. Those on lines stay
 *                         on their lines, corners stay where they are.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true`}
 *     \cgalParamExtra{Without a `sizing_field` a mesh that is fitted has shorter edges where the surface bends, by
 *                     `Geodesic_remeshing::Curvature_sizing_field` as it is by default. The triangles are less even for
 *                     it: their smallest angles are 48 to 54 degrees in the mean.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether several threads share the work; the result is the same, bit by bit}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Sequential_tag`}
 *     \cgalParamExtra{`CGAL::Parallel_tag` needs TBB, whose own means, such as `tbb::global_control`, limit the number
 *                     of threads.}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told the stages and the progress, and can stop the work; pass it by `std::ref()`}
 *     \cgalParamType{a class model of `GeodesicRemeshingVisitor`}
 *     \cgalParamDefault{`Geodesic_remeshing::Default_visitor`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{stage_results}
 *     \cgalParamDescription{filled with what the stages made; pass it by `std::ref()`}
 *     \cgalParamType{`Geodesic_remeshing::Stage_results`}
 *     \cgalParamDefault{nothing is kept}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{a property map associating points to the vertices of `out`}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with `boost::graph_traits<OutputMesh>::%vertex_descriptor`
 *                    as key type and `%Point_3` as value type}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, out)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{geom_traits}
 *     \cgalParamDescription{tells the coordinates of the points: its functors `Compute_x_3`, `Compute_y_3`,
 *                           `Compute_z_3` and `Construct_point_3`}
 *     \cgalParamType{a class model of `Kernel`, or any with these functors}
 *     \cgalParamDefault{a \cgal kernel deduced from the point type, using `CGAL::Kernel_traits`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_location_map}
 *     \cgalParamDescription{filled with the place of each vertex of `out` on `tmesh`; with `do_project(false)` with the
 *                           place that the vertex is nearest to}
 *     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%vertex_descriptor`
 *                    as key type and `Polygon_mesh_processing::Face_location<TriangleMesh, FT>` as value type}
 *     \cgalParamDefault{nothing is written}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{edge_is_constrained_map}
 *     \cgalParamDescription{filled with whether an edge of `out` lies on a line}
 *     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%edge_descriptor`
 *                    as key type and `bool` as value type}
 *     \cgalParamDefault{nothing is written}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_patch_map}
 *     \cgalParamDescription{filled with the patch of each face of `out`: that of `tmesh`, or, where `tmesh` has none,
 *                           the number of the piece between lines that the face belongs to}
 *     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%face_descriptor`
 *                    as key type and a value type that the patches of `tmesh`, or numbers, convert to}
 *     \cgalParamDefault{nothing is written}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_region_map}
 *     \cgalParamDescription{filled with the region of the surface (section 5 of the paper) that each face of `out` has
 *                           its center in, from 0 to `Summary::number_of_regions - 1`; not every region need have a
 *                           face}
 *     \cgalParamType{a class model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%face_descriptor`
 *                    as key type and a value type that `int` converts to}
 *     \cgalParamDefault{nothing is written}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * @return what was made, and in what time
 *
 * @throws std::invalid_argument if the input is empty, has a face that is not a triangle, an edge without faces, a
 * vertex where fans of faces touch or a coordinate that is not finite, if the target is not positive or asks for more
 * than 500,000,000 vertices, if `number_of_iterations` is negative or `features_angle_bound` not positive, if the
 * sizing field gives a vertex a length that is not positive and finite or has a `nearness()` below 0 or above 10, if
 * `gradation` or `maximum_length` is not positive, `minimum_length` negative, infinite or above `maximum_length`, or if
 * the surface has no area or edges would be shorter than 1e-70 or longer than 1e70; the message says which vertex or
 * face
 * @throws Geodesic_remeshing::Remeshing_error if the topology, the corners or the lines of the input, or handles, thin
 * places and long thin parts of it, need more vertices, if `minimum_length` and `maximum_length` exclude the number
 * asked for (the message says which numbers they allow), if edges would not be longer than sixteen times the rounding
 * of the largest coordinate, or if the visitor stops the work
 *
 * Whatever is thrown, also by the visitor, by a map or field that is read, or because memory runs out: `out`, its
 * property maps and those of `tmesh` are left as they were, provided that writing to a map does not throw.
 * `stage_results` then has what the stages before made.
 *
 * In practice \cgalBigO{(n + m) \log (n + m)} for an input of `n` vertices, once its long edges have been split, and an
 * output of `m`. Flips to an intrinsic Delaunay triangulation, and vertices that the front meets again, have no such
 * bound in the worst case. Where faces of the output intersect and those of the input do not, the stages are run again,
 * twice to six times at the most.
 *
 * @sa `CGAL::Geodesic_remeshing::Curvature_sizing_field`
 * @sa `CGAL::Polygon_mesh_processing::isotropic_remeshing()`
 */
template <class TriangleMesh, class Target, class OutputMesh,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<!Geodesic_remeshing::internal::is_named_parameters<OutputMesh>::value, int> = 0
#endif
          >
Geodesic_remeshing::Summary geodesic_remeshing(const TriangleMesh& tmesh, const Target& target, OutputMesh& out,
                                               const NamedParametersIn& np_in = parameters::default_values(),
                                               const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace Geodesic_remeshing::internal;
  static_assert(!std::is_const<OutputMesh>::value,
                "geodesic_remeshing: a mesh to be filled or replaced cannot be const");
  check_parameters<NamedParametersIn, Parameters_of_input<NamedParametersOut>>();
  check_parameters<NamedParametersOut, Parameters_of_output>();
  const auto asked = unpack_target(target);
  const auto options = unpack_options(np_in);
  decltype(auto) visitor = visitor_of(np_in);
  Geodesic_remeshing::Stage_results* const kept = stage_results_of(np_in);
  Geodesic_remeshing::Summary summary;
  Stage_clock clock(visitor, summary, options.concurrency.is_parallel());

  clock.stage("input", 0.);
  Input_surface<TriangleMesh> input;
  copy_input(tmesh, np_in, input);
  sort_in_space(input, options.concurrency);
  const Mesh& surface = input.mesh;

  clock.stage("sizing", .03);
  const std::vector<double> wishes = wished_lengths(tmesh, input.vertex_of, np_in);
  const Goal goal = options.do_project || !wishes.empty() ? set_goal(asked, wishes, sizing_limits_of(np_in), input.mesh)
                                                          : set_goal_of_fit(asked, input.mesh);
  check_scale(goal.mean_edge_length);
  check_thinness(surface, goal.mean_edge_length, goal.number_of_vertices);
  const Constraints constraints = find_constraints(tmesh, np_in, input, goal.mean_edge_length);
  release(input.edges_in_order);

  const bool wants_regions = is_given<NamedParametersOut, Geodesic_remeshing::internal_np::face_region_map_t>;
  const Stages_work work{input.mesh, constraints, options, wants_regions};
  auto run = std::make_unique<Stages_run>();
  run_stages(work, asked, goal, clock, kept, *run);
  if(options.do_project && !run->conflicts.places.empty())
    avoid_conflicts(work, target_again(asked, run->number_of_vertices), wishes, sizing_limits_of(np_in), clock, kept,
                    run);
  Placed_mesh& remeshed = run->remeshed;
  summary.number_of_regions = run->number_of_regions;
  summary.number_of_curves = run->number_of_curves;
  summary.number_of_strips = run->number_of_strips;

  if(!options.do_project)
    fit(work, clock, *run, summary);

  clock.stage("output", 1.); // the last question to the visitor: from here on nothing but the output changes
  write_output(input, remeshed, np_in, out, np_out,
               [&] { return regions_of_faces(surface, run->surfaces.pieces(), run->segmentation, remeshed); });
  clock.stop();
  summary.number_of_vertices = remeshed.mesh.number_of_vertices();
  summary.number_of_faces = remeshed.mesh.number_of_faces();
  summary.edge_length = goal.mean_edge_length;
  return summary;
}

/*!
 * \ingroup PkgGeodesicRemeshingRef
 *
 * \brief remeshes a triangulated surface in place.
 *
 * As the other overload, with `tmesh` replaced by the result at the very end. Property maps of `tmesh` other than the
 * points are not carried over; but those given as `edge_is_constrained_map` and `face_patch_map`, if they can be
 * written to, are filled for the result as the other overload fills the ones of its output. Maps over ranges of fixed
 * size, as `boost::make_iterator_property_map()` makes them, are only read: the result may have more elements. Others
 * must have room for those, as the mesh's own property maps and dynamic ones have.
 *
 * @tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
 * @tparam Target as for the other overload
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh the input, and then the output
 * @param target as for the other overload
 * @param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of the input of the other
 * overload, and `face_region_map`
 *
 * @return what was made, and in what time
 *
 * @throws whatever the other overload throws; `tmesh` is then left as it was
 */
template <class TriangleMesh, class Target, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          std::enable_if_t<Geodesic_remeshing::internal::is_named_parameters<NamedParameters>::value, int> = 0
#endif
          >
Geodesic_remeshing::Summary geodesic_remeshing(TriangleMesh& tmesh, const Target& target,
                                               const NamedParameters& np = parameters::default_values())
{
  return geodesic_remeshing(tmesh, target, tmesh, np,
                            Geodesic_remeshing::internal::of_output_in_place<TriangleMesh>(np));
}

} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_H
