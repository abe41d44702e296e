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
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>

#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Which elements of the output are copies of which of the internal mesh
template <class OutputMesh>
struct Copied_elements
{
  using Traits = boost::graph_traits<OutputMesh>;
  std::vector<std::pair<Vertex, typename Traits::vertex_descriptor>> vertices;
  std::vector<std::pair<Halfedge, typename Traits::halfedge_descriptor>> halfedges;
  std::vector<std::pair<Face, typename Traits::face_descriptor>> faces;
};

template <class Graph, class = void>
struct keeps_garbage_for_ever : std::false_type
{};
template <class Graph>
struct keeps_garbage_for_ever<Graph, std::void_t<decltype(std::declval<Graph&>().garbage_collection())>> : std::true_type
{};

// Empties a mesh, but not of the caller's property maps, which clear() would take with it. What CGAL does with an OpenMesh takes
// quadratic time, as its ranges begin by skipping what is removed, and leaves that behind.
template <class OutputMesh>
void remove_elements(OutputMesh& out)
{
  if constexpr(keeps_garbage_for_ever<OutputMesh>::value)
  {
    const auto all = [](const auto& range) { return std::vector(range.begin(), range.end()); };
    for(const auto e : all(edges(out)))
      remove_edge(e, out);
    for(const auto f : all(faces(out)))
      remove_face(f, out);
    for(const auto v : all(vertices(out)))
      remove_vertex(v, out);
    if(num_vertices(out) > 0)
      out.garbage_collection();
  }
  else
    remove_all_elements(out);
}

template <class OutputMesh, class NamedParameters>
Copied_elements<OutputMesh> copy_to_output(const Mesh& mesh, OutputMesh& out, const NamedParameters& np)
{
  Copied_elements<OutputMesh> copied;
  remove_elements(out);
  copy_face_graph(mesh, out,
                  CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(copied.vertices))
                    .halfedge_to_halfedge_output_iterator(std::back_inserter(copied.halfedges))
                    .face_to_face_output_iterator(std::back_inserter(copied.faces)),
                  CGAL::parameters::vertex_point_map(output_points_of(out, np)));
  return copied;
}

// Where each vertex of the output lies on the input, in the manner of `Polygon_mesh_processing::Face_location`
template <class TriangleMesh, class OutputMesh, class Location_map>
void write_locations(const Input_surface<TriangleMesh>& input, const Placed_mesh& remeshed,
                     const Copied_elements<OutputMesh>& copied, Location_map map)
{
  using Location = typename boost::property_traits<Location_map>::value_type;
  for(const auto& v : copied.vertices)
  {
    const Place& place = remeshed.place[v.first];
    const auto& c = place.coordinates;
    put(map, v.second, Location(input.face_of[place.face], typename Location::second_type{{c[0], c[1], c[2]}}));
  }
}

// The patch of each face: an id of the input; or, if it has none, the number of the piece between lines
template <class TriangleMesh, class NamedParametersIn>
auto patches_of_faces(const Input_surface<TriangleMesh>& input, const Placed_mesh& remeshed,
                      const NamedParametersIn& np_in)
{
  std::size_t number;
  const std::vector<std::size_t> piece = pieces_between_lines(remeshed, number);
  if constexpr(is_given<NamedParametersIn, internal_np::face_patch_t>)
  {
    const auto patch = CGAL::parameters::get_parameter(np_in, internal_np::face_patch);
    const auto patch_of = [&](Face f) { return get(patch, input.face_of[f]); };
    const std::vector<Face> face_of_piece =
      faces_of_patches(input.mesh, remeshed, piece, number, [&](Face f, Face g) { return patch_of(f) == patch_of(g); });
    std::vector<std::decay_t<decltype(patch_of(Face()))>> result;
    for(std::size_t i : piece)
      result.push_back(patch_of(face_of_piece[i]));
    return result;
  }
  else
    return piece;
}

// Replaces the output by the result and fills the maps that the parameters of the output name. `regions()` gives the region of each
// face, where they are wanted.
template <class TriangleMesh, class OutputMesh, class NamedParametersIn, class NamedParametersOut, class Regions>
void write_output(const Input_surface<TriangleMesh>& input, const Placed_mesh& remeshed, const NamedParametersIn& np_in,
                  OutputMesh& out, const NamedParametersOut& np_out, const Regions& regions)
{
  using CGAL::parameters::get_parameter;
  constexpr bool wants_patches = is_given<NamedParametersOut, internal_np::face_patch_t>;
  const auto patches = [&]
  {
    if constexpr(wants_patches) // read before the output changes: it may be the input
      return patches_of_faces(input, remeshed, np_in);
    else
      return 0;
  }();
  constexpr bool wants_regions = is_given<NamedParametersOut, internal_np::face_region_map_t>;
  const std::vector<int> region_of = wants_regions ? regions() : std::vector<int>();
  const Copied_elements<OutputMesh> copied = copy_to_output(remeshed.mesh, out, np_out);
  if constexpr(is_given<NamedParametersOut, internal_np::vertex_location_map_t>)
    write_locations(input, remeshed, copied, get_parameter(np_out, internal_np::vertex_location_map));
  if constexpr(is_given<NamedParametersOut, internal_np::edge_is_constrained_t>)
  {
    const auto map = get_parameter(np_out, internal_np::edge_is_constrained);
    for(const auto& h : copied.halfedges)
      put(map, edge(h.second, out), remeshed.constrained[remeshed.mesh.edge(h.first)]);
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
