// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_WRITE_OUTPUT_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_WRITE_OUTPUT_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Points_of_graph.h>
#include <CGAL/Geodesic_remeshing/internal/faces_beside_lines.h>
#include <CGAL/Geodesic_remeshing/internal/replace_mesh.h>
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Where each vertex of the output lies on the input, in the manner of `Polygon_mesh_processing::Face_location`
template <class Location, class TriangleMesh>
std::vector<Location> locations_of_vertices(const Input_surface<TriangleMesh>& input, const Placed_mesh& remeshed)
{
  std::vector<Location> result;
  result.reserve(remeshed.mesh.number_of_vertices());
  for(Vertex v : remeshed.mesh.vertices())
  {
    const Place& place = remeshed.place[v];
    const auto& c = place.coordinates;
    result.emplace_back(input.face_of[place.face], typename Location::second_type{{c[0], c[1], c[2]}});
  }
  return result;
}

// The patch of each face: an id of the input; or, if it has none, the number of the piece between lines
template <class TriangleMesh, class NamedParametersIn>
auto patches_of_faces(const Input_surface<TriangleMesh>& input, const Placed_mesh& remeshed,
                      const NamedParametersIn& np_in)
{
  std::size_t number;
  const std::vector<std::uint32_t> piece = pieces_between_lines(remeshed, number);
  if constexpr(is_given<NamedParametersIn, internal_np::face_patch_t>)
  {
    const auto patch = CGAL::parameters::get_parameter(np_in, internal_np::face_patch);
    const auto patch_of = [&](Face f) { return get(patch, input.face_of[f]); };
    const std::vector<Face> face_of_piece = faces_of_patches(
        input.mesh, remeshed, piece, number, [&](Face f, Face g) { return patch_of(f) == patch_of(g); });
    std::vector<std::decay_t<decltype(patch_of(Face()))>> result;
    for(std::size_t i : piece)
      result.push_back(patch_of(face_of_piece[i]));
    return result;
  }
  else
    return piece;
}

// Replaces the output by the result and fills the maps that the parameters of the output name: with values made before
// the output changes, because making them can fail, and because the output may be the input. `regions()` gives the
// region of each face, where they are wanted.
template <class TriangleMesh, class OutputMesh, class NamedParametersIn, class NamedParametersOut, class Regions>
void write_output(const Input_surface<TriangleMesh>& input, const Placed_mesh& remeshed, const NamedParametersIn& np_in,
                  OutputMesh& out, const NamedParametersOut& np_out, const Regions& regions)
{
  using CGAL::parameters::get_parameter;
  constexpr bool wants_patches = is_given<NamedParametersOut, internal_np::face_patch_t>;
  constexpr bool wants_locations = is_given<NamedParametersOut, internal_np::vertex_location_map_t>;
  const auto patches = [&] {
    if constexpr(wants_patches)
      return patches_of_faces(input, remeshed, np_in);
    else
      return 0;
  }();
  const auto locations = [&] {
    if constexpr(wants_locations)
      return locations_of_vertices<typename boost::property_traits<
          std::decay_t<decltype(get_parameter(np_out, internal_np::vertex_location_map))>>::value_type>(input,
                                                                                                        remeshed);
    else
      return 0;
  }();
  constexpr bool wants_regions = is_given<NamedParametersOut, internal_np::face_region_map_t>;
  const std::vector<int> region_of = wants_regions ? regions() : std::vector<int>();
  const Copied_elements<OutputMesh> copied = replace_mesh(remeshed.mesh, out, output_points_of(out, np_out));
  if constexpr(wants_locations)
  {
    const auto map = get_parameter(np_out, internal_np::vertex_location_map);
    for(std::size_t i = 0; i < locations.size(); ++i)
      put(map, copied.vertices[i].second, locations[i]);
  }
  if constexpr(is_given<NamedParametersOut, internal_np::edge_is_constrained_t>)
  {
    const auto map = get_parameter(np_out, internal_np::edge_is_constrained);
    for(const auto& e : copied.edges)
      put(map, e.second, remeshed.constrained[e.first]);
  }
  if constexpr(wants_patches)
  {
    const auto map = get_parameter(np_out, internal_np::face_patch);
    using Patch = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
    for(const auto& f : copied.faces)
      put(map, f.second, static_cast<Patch>(patches[f.first]));
  }
  if constexpr(wants_regions)
    for(const auto& f : copied.faces)
      put(get_parameter(np_out, internal_np::face_region_map), f.second, region_of[f.first]);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_WRITE_OUTPUT_H
