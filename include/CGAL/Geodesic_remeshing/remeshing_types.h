// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_REMESHING_TYPES_H
#define CGAL_GEODESIC_REMESHING_REMESHING_TYPES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * The target of a remeshing given as the length of its edges, in the unit of the coordinates. A type of its own, so
 * that a length is not taken for a number of vertices. Of lengths for which the topology needs more vertices than they
 * make, the edges are shorter.
 */
struct Edge_length
{
  double value; ///< positive and finite
};

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * The target of a remeshing given as its number of faces. A closed triangle mesh has an even number of faces: an odd
 * one is rounded down.
 */
struct Number_of_faces
{
  std::size_t value; ///< positive, at most 1,000,000,000
};

/*!
 * \ingroup PkgGeodesicRemeshingSizingRef
 * The limits of a sizing. They hold for the lengths that the edges aim at; single edges are a little longer or shorter.
 */
struct Sizing_limits
{
  double minimum_length = 0.; ///< no length below this one, in the unit of the coordinates
  double maximum_length = std::numeric_limits<double>::infinity(); ///< none above this one
  /// how much the length may grow over a way on the surface, divided by the length of the way: with a gradation g edges
  /// at neighboring vertices aim at lengths that differ by at most a factor (2 + g) / (2 - g), some 12 percent for
  /// 0.12. Positive; infinite for no limit.
  double gradation = .12;
};

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * What was made, and in what time.
 */
struct Summary
{
  std::size_t number_of_vertices = 0; ///< of the output
  std::size_t number_of_faces = 0;    ///< of the output
  /// what edges aim at: that of an equilateral mesh of this area with the number of vertices that the target stands for
  /// before the boundary, lines and topology are counted; with a sizing that of a uniform mesh of as many vertices
  double edge_length = 0.;
  std::size_t number_of_regions = 0; ///< of the region tree (paper, section 5)
  std::size_t number_of_curves = 0;  ///< equidistant curves
  std::size_t number_of_strips = 0;  ///< pieces that the curves divide the surface into
  /// with `do_project(false)`, the root of the mean square of the distances of points of the input from the output, as
  /// found at about four points a face
  double rms_distance = 0.;
  /// with `do_project(false)`, the largest distance found, in both directions
  double largest_distance = 0.;
  /// processor seconds of each stage, in their order; with `CGAL::Parallel_tag` those that passed
  std::vector<std::pair<std::string, double>> seconds;
};

/*!
 * \ingroup PkgGeodesicRemeshingRegionsRef
 * The three kinds of regions of a region tree (paper, section 5).
 */
enum class Region_kind {
  leaf,     ///< a disc around a maximum of the distance from the root
  interior, ///< an annulus between the fronts of its children and the next meeting of fronts
  root      ///< the disc around the root
};

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * Thrown when the input is fine but what was asked for cannot be made: fewer vertices than the topology needs, edges
 * too short for the coordinates, or the visitor stopped the work. The output is as it was before the call.
 */
class Remeshing_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * A visitor that watches nothing and stops nothing: to derive from.
 * \cgalModels{GeodesicRemeshingVisitor}
 */
struct Default_visitor
{
  /// called when a stage begins: `"input"`, `"sizing"`, `"refinement"`, `"distances"`, `"regions"`, `"curves"`,
  /// `"samples"`, `"strips"`, `"improvement"`, `"fitting"` (with `do_project(false)`), `"output"`
  void stage(const std::string& /* name */) {}
  /// called now and then with the part of the whole work that is done, from 0 to 1
  /// \return `false` to stop the work
  bool progress(double /* done */) { return true; }
};

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * What the stages made on their way, for looking at. Filled when passed as `stage_results(std::ref(results))`.
 */
struct Stage_results
{
  using Point = Exact_predicates_inexact_constructions_kernel::Point_3; ///< a point
  using Mesh = Surface_mesh<Point>;                                     ///< a mesh

  /// the working surface with the distance from the root in its property map `"v:distance"`
  Mesh working_surface;
  /// the working surface cut along the boundaries of the regions, with their ids in its property map `"f:region"`
  Mesh regions;
  /// the equidistant curves, a closed one with its first point again at its end
  std::vector<std::vector<Point>> curves;
  /// the samples on the curves
  std::vector<Point> samples;
  /// the triangulated strips, before the improvement
  Mesh strips;
};

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_REMESHING_TYPES_H
