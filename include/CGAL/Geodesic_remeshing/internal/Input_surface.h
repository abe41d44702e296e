// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INPUT_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INPUT_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/spatial_order.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The mesh of the user as the stages need it: of the internal type, compact, without isolated vertices.
template <class TriangleMesh>
struct Input_surface
{
  Mesh mesh;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> face_of; // by internal index
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertex_of;
  std::vector<Edge> edges_in_order; // in the order of the user's, where that is another one

  Edge copy_of_edge(std::size_t i) const // of the i-th of the user's
  {
    return edges_in_order.empty() ? Edge(static_cast<Mesh::size_type>(i)) : edges_in_order[i];
  }
};

// Index maps of a mesh with removed elements have gaps.
template <class Range, class IndexMap>
std::size_t largest_index(const Range& range, const IndexMap& index)
{
  std::size_t result = 0;
  for(auto d : range)
    result = (std::max)(result, static_cast<std::size_t>(get(index, d)));
  return result;
}

[[noreturn]] inline void reject(const std::string& what)
{
  throw std::invalid_argument("geodesic remeshing: " + what);
}

// Appends the edges and faces of a graph to a mesh that has its vertices already: `copy[index of v]` is the copy of v.
// Takes the connectivity over as it is, which is much faster than adding face by face.
template <class Graph, class VertexIndexMap, class HalfedgeIndexMap>
void copy_connectivity(const Graph& graph, const VertexIndexMap& vertex_index, const HalfedgeIndexMap& halfedge_index,
                       std::size_t number_of_halfedge_indices, const std::vector<Vertex>& copy, Mesh& mesh)
{
  std::vector<Halfedge> copied(number_of_halfedge_indices);
  for(auto e : edges(graph))
  {
    const auto h = halfedge(e, graph);
    const Halfedge g =
        mesh.add_edge(copy[get(vertex_index, source(h, graph))], copy[get(vertex_index, target(h, graph))]);
    copied[get(halfedge_index, h)] = g;
    copied[get(halfedge_index, opposite(h, graph))] = mesh.opposite(g);
  }
  for(auto h : halfedges(graph))
  {
    const Halfedge g = copied[get(halfedge_index, h)];
    mesh.set_next(g, copied[get(halfedge_index, next(h, graph))]);
    if(!mesh.halfedge(mesh.target(g)).is_valid() || is_border(h, graph))
      mesh.set_halfedge(mesh.target(g), g); // of a vertex on a boundary, the halfedge on the boundary
  }
  for(auto f : faces(graph))
  {
    const Face copied_face = mesh.add_face();
    Halfedge g = copied[get(halfedge_index, halfedge(f, graph))];
    mesh.set_halfedge(copied_face, g);
    for(int i = 0; i < 3; ++i, g = mesh.next(g))
      mesh.set_face(g, copied_face);
  }
}

// All faces must be triangles. Marks the vertices that have one.
template <class TriangleMesh, class VertexIndexMap, class NamedParameters>
std::vector<char> check_faces(const TriangleMesh& tmesh, const VertexIndexMap& index, const NamedParameters& np)
{
  std::vector<char> used(largest_index(vertices(tmesh), index) + 1, 0);
  for(auto f : faces(tmesh))
  {
    std::size_t corners = 0;
    for(auto h : halfedges_around_face(halfedge(f, tmesh), tmesh))
    {
      used[get(index, target(h, tmesh))] = 1;
      ++corners;
    }
    if(corners != 3)
      reject("face " + std::to_string(get(get_initialized_face_index_map(tmesh, np), f)) + " has " +
             std::to_string(corners) + " vertices, not three");
  }
  if(faces(tmesh).begin() == faces(tmesh).end())
    reject("the mesh has no face");
  return used;
}

// Nothing leads around an edge of no face, nor need its ends have a copy.
template <class TriangleMesh, class VertexIndexMap>
void check_edges(const TriangleMesh& tmesh, const VertexIndexMap& index)
{
  for(auto e : edges(tmesh))
  {
    const auto h = halfedge(e, tmesh);
    if(is_border(h, tmesh) && is_border(opposite(h, tmesh), tmesh))
      reject("the edge between the vertices " + std::to_string(get(index, source(h, tmesh))) + " and " +
             std::to_string(get(index, target(h, tmesh))) + " has no face");
  }
}

// The first vertex at which two fans of faces touch, if there is one. Walking around it does not reach all of its
// halfedges, or leads from fan to fan over the boundary of each.
inline Vertex find_touching_fans(const Mesh& mesh)
{
  std::vector<char> reached(mesh.number_of_halfedges(), 0);
  for(Vertex v : mesh.vertices())
  {
    int on_boundary = 0;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      reached[h] = 1;
      on_boundary += mesh.is_border(h);
    }
    if(on_boundary > 1)
      return v;
  }
  for(Halfedge h : mesh.halfedges())
    if(!reached[h])
      return mesh.target(h);
  return Vertex();
}

// Copies the input, in its own order, and rejects what the stages cannot work on: these checks are cheap and
// made in every build, since on such input the loops of the stages need not end.
template <class TriangleMesh, class NamedParameters>
void copy_input(const TriangleMesh& tmesh, const NamedParameters& np, Input_surface<TriangleMesh>& result)
{
  const Points_of_graph<TriangleMesh, NamedParameters> points(tmesh, np);
  const auto index = vertex_indices_of(tmesh, np);
  const std::vector<char> used = check_faces(tmesh, index, np);
  check_edges(tmesh, index);
  Mesh& mesh = result.mesh;
  mesh.reserve(static_cast<Mesh::size_type>(used.size()), static_cast<Mesh::size_type>(edges(tmesh).size()),
               static_cast<Mesh::size_type>(faces(tmesh).size()));
  std::vector<Vertex> copy(used.size());
  for(auto v : vertices(tmesh))
  {
    if(!used[get(index, v)])
      continue;
    const Point p = points(v);
    if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      reject("vertex " + std::to_string(get(index, v)) + " has a coordinate that is not finite");
    copy[get(index, v)] = mesh.add_vertex(p);
    result.vertex_of.push_back(v);
  }
  const auto halfedge_index = get_initialized_halfedge_index_map(tmesh, np);
  copy_connectivity(tmesh, index, halfedge_index, largest_index(halfedges(tmesh), halfedge_index) + 1, copy, mesh);
  result.face_of.assign(faces(tmesh).begin(), faces(tmesh).end());
  const Vertex bad = find_touching_fans(mesh);
  if(bad.is_valid())
    reject("vertex " + std::to_string(get(index, result.vertex_of[bad])) +
           " is not manifold: two fans of faces touch there");
}

// Renumbers the copy of a large input in a spatially coherent order.
template <class TriangleMesh>
void sort_in_space(Input_surface<TriangleMesh>& input, const Concurrency concurrency = Concurrency())
{
  if(!is_large(input.mesh.number_of_vertices()))
    return;
  Mesh sorted;
  const std::vector<Vertex> order = spatial_order(input.mesh, concurrency);
  Numbering number = copy_in_order(input.mesh, order, sorted, concurrency);
  input.mesh = std::move(sorted);
  auto vertex_of = input.vertex_of;
  for(std::size_t i = 0; i < order.size(); ++i)
    input.vertex_of[i] = vertex_of[order[i]];
  auto face_of = input.face_of;
  for(std::size_t i = 0; i < face_of.size(); ++i)
    input.face_of[number.face[i]] = face_of[i];
  input.edges_in_order = std::move(number.edge);
}

inline double area(const Mesh& mesh, Face f)
{
  const auto v = vertices_of(mesh, f);
  return std::sqrt(CGAL::squared_area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])));
}

inline double area(const Mesh& mesh)
{
  double sum = 0.;
  for(Face f : mesh.faces())
    sum += area(mesh, f);
  return sum;
}

inline std::ptrdiff_t euler_characteristic(const Mesh& mesh)
{
  return static_cast<std::ptrdiff_t>(mesh.number_of_vertices()) - static_cast<std::ptrdiff_t>(mesh.number_of_edges()) +
         static_cast<std::ptrdiff_t>(mesh.number_of_faces());
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INPUT_SURFACE_H
