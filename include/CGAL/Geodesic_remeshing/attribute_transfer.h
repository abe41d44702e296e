// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_ATTRIBUTE_TRANSFER_H
#define CGAL_GEODESIC_REMESHING_ATTRIBUTE_TRANSFER_H

#include <CGAL/Geodesic_remeshing/internal/interpolate.h>
#include <CGAL/Geodesic_remeshing/internal/locate_corners.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {

/*!
 * \ingroup PkgGeodesicRemeshingAttributesRef
 *
 * \brief carries a property of the vertices of the input of a remeshing over to those of its output.
 *
 * Floating-point numbers, points, vectors, colors and arrays of floating-point numbers are interpolated over the input
 * face in which the vertex lies; of anything else, as labels and integers, a vertex gets the value of the corner that
 * it is nearest to, by its barycentric coordinates.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam OutputMesh a model of `VertexListGraph`
 * @tparam VertexLocationMap a model of `ReadablePropertyMap` with `boost::graph_traits<OutputMesh>::%vertex_descriptor`
 * as key type and `std::pair<boost::graph_traits<TriangleMesh>::%face_descriptor, std::array<double, 3>>` as value
 * type: what `geodesic_remeshing()` fills when it is passed as `vertex_location_map`
 * @tparam InputMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key
 * type
 * @tparam OutputMap a model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key
 * type and the value type of `InputMap`
 *
 * @param tmesh the input of the remeshing, unchanged since
 * @param input_map the property of its vertices
 * @param remeshed the output of the remeshing
 * @param location_map where the vertices of the output lie on the input
 * @param output_map filled with the property of the vertices of the output
 *
 * \cgalBigO{m} for `m` vertices of the output.
 */
template <class TriangleMesh, class InputMap, class OutputMesh, class VertexLocationMap, class OutputMap>
void transfer_vertex_property(const TriangleMesh& tmesh, const InputMap& input_map, const OutputMesh& remeshed,
                              const VertexLocationMap& location_map, OutputMap output_map)
{
  using Value = typename boost::property_traits<OutputMap>::value_type;
  std::vector<Value> values; // all before the first is written: interpolating may fail
  for(auto v : vertices(remeshed))
  {
    const auto location = get(location_map, v);
    const auto h = halfedge(location.first, tmesh);
    values.push_back(internal::interpolate<Value>(get(input_map, source(h, tmesh)), get(input_map, target(h, tmesh)),
                                                  get(input_map, target(next(h, tmesh), tmesh)),
                                                  internal::in_doubles(location.second)));
  }
  auto value = values.begin();
  for(auto v : vertices(remeshed))
    put(output_map, v, Value(*value++));
}

/*!
 * \ingroup PkgGeodesicRemeshingAttributesRef
 *
 * \brief carries a property of the faces of the input of a remeshing over to those of its output.
 *
 * A face gets the value of the input face in which its center lies, as found by walking there from one of its vertices
 * on the input surface. Where the borders between values are to be kept, remesh with them as `face_patch_map`.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam OutputMesh a model of `FaceListGraph`
 * @tparam VertexLocationMap as for `transfer_vertex_property()`
 * @tparam InputMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor` as key
 * type
 * @tparam OutputMap a model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%face_descriptor` as key
 * type
 *
 * @param tmesh the input of the remeshing, unchanged since
 * @param input_map the property of its faces
 * @param remeshed the output of the remeshing
 * @param location_map where the vertices of the output lie on the input
 * @param output_map filled with the property of the faces of the output
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
 * @throws std::invalid_argument if `tmesh` is empty, has a face that is not a triangle, an edge without faces, a vertex
 * where fans of faces touch or a coordinate that is not finite; `output_map` is then left as it was
 *
 * \cgalBigO{n + m} for `n` and `m` faces.
 */
template <class TriangleMesh, class InputMap, class OutputMesh, class VertexLocationMap, class OutputMap,
          class NamedParameters = parameters::Default_named_parameters>
void transfer_face_property(const TriangleMesh& tmesh, const InputMap& input_map, const OutputMesh& remeshed,
                            const VertexLocationMap& location_map, OutputMap output_map,
                            const NamedParameters& np = parameters::default_values())
{
  const internal::Corner_locator<TriangleMesh> locator(tmesh, np);
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> origins;
  for(auto f : faces(remeshed))
  {
    std::array<internal::Place, 3> corners = locator.corners(f, remeshed, location_map);
    origins.push_back(locator.face_of(locator.towards_centre(corners, 0, 1.).face));
  }
  auto origin = origins.begin();
  for(auto f : faces(remeshed))
    put(output_map, f, get(input_map, *origin++));
}

/*!
 * \ingroup PkgGeodesicRemeshingAttributesRef
 *
 * \brief carries a property of the corners of the input's faces, as texture coordinates, over to those of
 * the output's faces.
 *
 * A property of corners may jump at edges: the seams of a texture. For the corner of an output face, the input face
 * beside the vertex that is meant is the one in which the output face begins; so a seam stays sharp if its edges were
 * constrained when remeshing.
 *
 * @tparam TriangleMesh a model of `FaceListGraph`
 * @tparam OutputMesh a model of `FaceListGraph`
 * @tparam VertexLocationMap as for `transfer_vertex_property()`
 * @tparam InputMap a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as
 * key type: the property of the corner at the target of a halfedge in the face of that halfedge
 * @tparam OutputMap a model of `WritablePropertyMap` with `boost::graph_traits<OutputMesh>::%halfedge_descriptor` as
 * key type
 *
 * @param tmesh the input of the remeshing, unchanged since
 * @param input_map the property of its corners
 * @param remeshed the output of the remeshing
 * @param location_map where the vertices of the output lie on the input
 * @param output_map filled with the property of the corners of the output; halfedges of the boundary have none
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
 * @throws std::invalid_argument if `tmesh` is empty, has a face that is not a triangle, an edge without faces, a vertex
 * where fans of faces touch or a coordinate that is not finite; `output_map` is then left as it was
 *
 * \cgalBigO{n + m} for `n` and `m` faces.
 */
template <class TriangleMesh, class InputMap, class OutputMesh, class VertexLocationMap, class OutputMap,
          class NamedParameters = parameters::Default_named_parameters>
void transfer_corner_property(const TriangleMesh& tmesh, const InputMap& input_map, const OutputMesh& remeshed,
                              const VertexLocationMap& location_map, OutputMap output_map,
                              const NamedParameters& np = parameters::default_values())
{
  using Value = typename boost::property_traits<OutputMap>::value_type;
  const internal::Corner_locator<TriangleMesh> locator(tmesh, np);
  std::vector<Value> values;
  for(auto f : faces(remeshed))
  {
    const std::array<internal::Place, 3> corners = locator.corners(f, remeshed, location_map);
    auto h = halfedge(f, remeshed);
    for(int i = 0; i < 3; ++i, h = next(h, remeshed)) // corner i is the source of h
    {
      const internal::Place place = locator.beside(corners, i);
      const auto g = halfedge(locator.face_of(place.face), tmesh);
      values.push_back(internal::interpolate<Value>(get(input_map, prev(g, tmesh)), get(input_map, g),
                                                    get(input_map, next(g, tmesh)), place.coordinates));
    }
  }
  auto value = values.begin();
  for(auto f : faces(remeshed))
  {
    auto h = halfedge(f, remeshed);
    for(int i = 0; i < 3; ++i, h = next(h, remeshed))
      put(output_map, prev(h, remeshed), Value(*value++));
  }
}

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_ATTRIBUTE_TRANSFER_H
