// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_REGION_SEGMENTATION_H
#define CGAL_GEODESIC_REMESHING_REGION_SEGMENTATION_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/find_constraints.h>
#include <CGAL/Geodesic_remeshing/internal/regions_of_faces.h>
#include <CGAL/Geodesic_remeshing/internal/stages.h>
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingRegionsRef
 * One region of a region tree.
 * @tparam VertexDescriptor the vertex descriptor of the segmented mesh
 */
template <class VertexDescriptor>
struct Region_node
{
  Region_kind kind; ///< leaf, interior or root
  std::vector<std::size_t>
      parents; ///< the regions below: none for a root, two below the saddle where a front splits at a handle, else one
  std::vector<std::size_t> children; ///< the regions above: none for a leaf
  VertexDescriptor center; ///< the maximum of a leaf, the root vertex, or the saddle where the fronts above meet (or
                           ///< the vertex next to it)
  double height; ///< the distance from the top to the bottom: a multiple of the curve distance, but for the root; 0 for
                 ///< a region that degenerates to its top
  std::size_t number_of_curves; ///< the equidistant curves in it, its bottom included
};

/*!
 * \ingroup PkgGeodesicRemeshingRegionsRef
 * The regions of a surface, children before their parents. On a surface of genus 0 they form a tree under the root;
 * each handle adds a region whose front splits and two that meet again.
 */
template <class VertexDescriptor>
using Region_tree = std::vector<Region_node<VertexDescriptor>>;

namespace internal {

// The region that covers most of each input face
inline std::vector<int> regions_of_input_faces(const Mesh& surface, const Working_surface& working,
                                               const Segmentation& segmentation)
{
  std::vector<std::tuple<Face, int, double>> parts; // input face, region, area
  for(Face f : working.mesh.faces())
  {
    const auto v = vertices_of(working.mesh, f);
    parts.emplace_back(
        working.input_face[f], region_of_face(working.mesh, segmentation, f),
        std::sqrt(CGAL::squared_area(working.mesh.point(v[0]), working.mesh.point(v[1]), working.mesh.point(v[2]))));
  }
  std::sort(parts.begin(), parts.end());
  std::vector<int> result(surface.number_of_faces(), 0);
  std::vector<double> largest(surface.number_of_faces(), -1.);
  for(std::size_t i = 0; i < parts.size();)
  {
    const Face f = std::get<0>(parts[i]);
    const int region = std::get<1>(parts[i]);
    double sum = 0.;
    for(; i < parts.size() && std::get<0>(parts[i]) == f && std::get<1>(parts[i]) == region; ++i)
      sum += std::get<2>(parts[i]);
    if(sum > largest[f])
      result[f] = region;
    largest[f] = (std::max)(largest[f], sum);
  }
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgGeodesicRemeshingRegionsRef
 *
 * \brief segments a surface into regions in which a front of constant distance moves without meeting itself or another.
 *
 * This is section 5 of the paper, for surfaces of any genus. Leaves are discs around the maxima of the distance from a
 * root vertex; interior regions are annuli that begin at the "spectacles" where fronts meet and end a whole number of
 * curve distances further on; the root region is the disc around the root. A maximum that rises less than half a curve
 * distance above the saddle beside it is noise and has no region. Every connected component has a tree of its own. One
 * with boundary is a single region, the root, as in `CGAL::geodesic_remeshing()`: its front starts on the straightest
 * long piece of the boundary, on which its center lies. Around handles smaller than the curve distance a region may
 * touch itself or lie in several pieces.
 *
 * The boundaries of the regions run through faces; each face gets the region that covers most of it.
 * `Stage_results::regions` has the surface cut along the boundaries.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam FaceRegionMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as
 * key type and an integral value type
 * @tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
 *
 * @param tmesh a triangle mesh of any genus, with any number of boundary loops and connected components
 * @param curve_distance the distance between curves, to a multiple of which heights are rounded down; for a remeshing
 * it is \f$\sqrt{3/4}\f$ of the edge length. Positive.
 * @param face_region_map filled with the index of the region of each face
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
 * \cgalNamedParamsEnd
 *
 * @return the regions, children before their parents
 * @throws std::invalid_argument if the mesh is empty, has a face that is not a triangle, an edge without faces, a
 * vertex where fans of faces touch or a coordinate that is not finite, if the curve distance is not between 1e-70 and
 * 1e70, or so small that a remeshing with it would have more than 500,000,000 vertices
 * @throws Remeshing_error if edges for the curve distance are not longer than sixteen times the rounding of the largest
 * coordinate
 *
 * \cgalBigO{n \log n} for `n` vertices after long edges have been split.
 */
template <class TriangleMesh, class FaceRegionMap, class NamedParameters = parameters::Default_named_parameters>
Region_tree<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
region_segmentation(const TriangleMesh& tmesh, double curve_distance, FaceRegionMap face_region_map,
                    const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  check_parameters<NamedParameters, Parameters_of_mesh>();
  if(!(curve_distance > 0.) || !std::isfinite(curve_distance))
    reject("the curve distance must be positive and finite");
  if(!is_scale_computable(curve_distance))
    reject("the curve distance is too small or too large to compute with");
  Input_surface<TriangleMesh> input;
  copy_input(tmesh, np, input);
  const double edge_length = curve_distance / std::sqrt(.75);
  check_not_too_many(number_for_length(area(input.mesh), edge_length), "the curve distance is too small: it");
  check_resolution(input.mesh, edge_length);
  const Constraints boundary = find_boundary(input.mesh, edge_length);
  Working_surface working;
  make_working_surface(input.mesh, boundary, longest_working_edge * edge_length, working);
  std::vector<char> is_corner = boundary.is_corner;
  is_corner.resize(working.mesh.number_of_vertices(), 0);
  const Intrinsic_triangulation triangulation(working.mesh);
  Fast_marching marching(triangulation);
  const Fronts_and_components fronts = march_from_roots_and_lines(working.mesh, is_corner, marching);
  const Segmentation segmentation =
      segment(working.mesh, marching, distances_in(marching, working.mesh), fronts, curve_distance, true);

  const std::vector<int> regions = regions_of_input_faces(input.mesh, working, segmentation);
  Region_tree<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> tree;
  for(const Region& region : segmentation.regions)
  {
    // a vertex that splitting an edge has added stands for the nearest one of the input
    const Place& place = working.place[region.centre];
    const auto& c = place.coordinates;
    const Vertex near = vertices_of(input.mesh, place.face)[std::max_element(c.begin(), c.end()) - c.begin()];
    tree.push_back({region.kind, region.parents, region.children, input.vertex_of[near], region.height,
                    static_cast<std::size_t>(region.number_of_levels)});
  }
  for(std::size_t i = 0; i < regions.size(); ++i) // at the end, when nothing can fail any more
    put(face_region_map, input.face_of[i], regions[i]);
  return tree;
}

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_REGION_SEGMENTATION_H
