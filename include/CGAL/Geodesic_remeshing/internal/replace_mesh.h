// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REPLACE_MESH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REPLACE_MESH_H

#include <CGAL/Geodesic_remeshing/internal/Points_of_graph.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The mesh of the caller is replaced as a whole or, whatever is thrown, left as it was: all that can fail comes before
// the first change that cannot be taken back.

// Which elements of the output are copies of which of the internal mesh
template <class OutputMesh>
struct Copied_elements
{
  using Traits = boost::graph_traits<OutputMesh>;
  std::vector<std::pair<Vertex, typename Traits::vertex_descriptor>> vertices;
  std::vector<std::pair<Edge, typename Traits::edge_descriptor>> edges;
  std::vector<std::pair<Face, typename Traits::face_descriptor>> faces;

  explicit Copied_elements(const Mesh& mesh)
  {
    vertices.reserve(mesh.number_of_vertices());
    edges.reserve(mesh.number_of_edges());
    faces.reserve(mesh.number_of_faces());
  }
};

template <class OutputMesh>
struct Old_elements
{
  using Traits = boost::graph_traits<OutputMesh>;
  std::vector<typename Traits::vertex_descriptor> vertices;
  std::vector<typename Traits::edge_descriptor> edges;
  std::vector<typename Traits::face_descriptor> faces;
};

template <class OutputMesh>
void remove(const Old_elements<OutputMesh>& elements, OutputMesh& out)
{
  for(auto e : elements.edges)
    remove_edge(e, out);
  for(auto f : elements.faces)
    remove_face(f, out);
  for(auto v : elements.vertices)
    remove_vertex(v, out);
}

// A `Surface_mesh` is emptied first, so that its indices start from zero, with the memory for what comes at hand. Its
// property maps stay: clear() would remove them, and what removes the elements alone gives the memory back.
template <class P>
Old_elements<Surface_mesh<P>> make_room(const Mesh& mesh, Surface_mesh<P>& out)
{
  using Size = typename Surface_mesh<P>::size_type;
  out.reserve(static_cast<Size>(mesh.number_of_vertices()), static_cast<Size>(mesh.number_of_edges()),
              static_cast<Size>(mesh.number_of_faces()));
  const bool does_recycle = out.does_recycle_garbage();
  out.set_recycle_garbage(true);
  while(out.number_of_removed_vertices() > 0) // nothing may be left in the lists of removed elements
    out.add_vertex();
  while(out.number_of_removed_edges() > 0)
    out.add_edge();
  while(out.number_of_removed_faces() > 0)
    out.add_face();
  out.resize(0, 0, 0);
  out.set_recycle_garbage(does_recycle);
  return {};
}

template <class Graph, class = void>
struct keeps_garbage_for_ever : std::false_type
{};
template <class Graph>
struct keeps_garbage_for_ever<Graph, std::void_t<decltype(std::declval<Graph&>().garbage_collection())>>
  : std::true_type
{};

template <class OutputMesh>
Old_elements<OutputMesh> elements_of(const OutputMesh& mesh)
{
  Old_elements<OutputMesh> result;
  for(auto v : vertices(mesh))
    result.vertices.push_back(v);
  for(auto e : edges(mesh))
    result.edges.push_back(e);
  for(auto f : faces(mesh))
    result.faces.push_back(f);
  return result;
}

// Any other mesh keeps its elements until the new ones are there; but not an OpenMesh, whose descriptors change when
// those removed are swept out: if memory runs out while it is filled, it is left empty.
template <class OutputMesh>
Old_elements<OutputMesh> make_room(const Mesh&, OutputMesh& out)
{
  Old_elements<OutputMesh> elements = elements_of(out);
  if constexpr(keeps_garbage_for_ever<OutputMesh>::value)
  {
    remove(elements, out);
    if(num_vertices(out) > 0)
      out.garbage_collection();
    return {};
  }
  else
    return elements;
}

template <class OutputMesh>
void remove(const Copied_elements<OutputMesh>& elements, OutputMesh& out)
{
  for(const auto& e : elements.edges)
    remove_edge(e.second, out);
  for(const auto& f : elements.faces)
    remove_face(f.second, out);
  for(const auto& v : elements.vertices)
    remove_vertex(v.second, out);
}

template <class OutputMesh>
void add_elements(const Mesh& mesh, OutputMesh& out, Copied_elements<OutputMesh>& copied)
{
  for(Vertex v : mesh.vertices())
    copied.vertices.emplace_back(v, add_vertex(out));
  for(Edge e : mesh.edges())
    copied.edges.emplace_back(e, add_edge(out));
  for(Face f : mesh.faces())
    copied.faces.emplace_back(f, add_face(out));
}

// Connects the new elements as those that they are copies of. The lists have room for the descriptors of all indices.
template <class OutputMesh>
void connect(const Mesh& mesh, const Copied_elements<OutputMesh>& copied, OutputMesh& out,
             std::vector<typename boost::graph_traits<OutputMesh>::vertex_descriptor>& vertex_of,
             std::vector<typename boost::graph_traits<OutputMesh>::halfedge_descriptor>& halfedge_of)
{
  for(const auto& v : copied.vertices)
    vertex_of[v.first] = v.second;
  for(const auto& e : copied.edges)
  {
    halfedge_of[mesh.halfedge(e.first, 0)] = halfedge(e.second, out);
    halfedge_of[mesh.halfedge(e.first, 1)] = opposite(halfedge(e.second, out), out);
  }
  for(Halfedge h : mesh.halfedges())
  {
    set_target(halfedge_of[h], vertex_of[mesh.target(h)], out);
    set_next(halfedge_of[h], halfedge_of[mesh.next(h)], out);
    set_face(halfedge_of[h], boost::graph_traits<OutputMesh>::null_face(), out); // of those on a boundary
  }
  for(const auto& v : copied.vertices)
    set_halfedge(v.second, halfedge_of[mesh.halfedge(v.first)], out);
  for(const auto& f : copied.faces)
  {
    Halfedge h = mesh.halfedge(f.first);
    set_halfedge(f.second, halfedge_of[h], out);
    for(int i = 0; i < 3; ++i, h = mesh.next(h))
      set_face(halfedge_of[h], f.second, out);
  }
}

template <class OutputMesh, class Map, class Geometric_traits>
Copied_elements<OutputMesh> replace_mesh(const Mesh& mesh, OutputMesh& out,
                                         const Converting_point_map<Map, Geometric_traits>& map)
{
  using Traits = boost::graph_traits<OutputMesh>;
  std::vector<std::decay_t<decltype(from_point(map.traits, Point()))>> points;
  points.reserve(mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
    points.push_back(from_point(map.traits, mesh.point(v)));
  std::vector<typename Traits::vertex_descriptor> vertex_of(mesh.num_vertices());
  std::vector<typename Traits::halfedge_descriptor> halfedge_of(mesh.num_halfedges());
  Copied_elements<OutputMesh> copied(mesh);
  const Old_elements<OutputMesh> old = make_room(mesh, out);
  try
  {
    add_elements(mesh, out, copied);
    connect(mesh, copied, out, vertex_of, halfedge_of);
    for(std::size_t i = 0; i < points.size(); ++i)
      put(map.map, copied.vertices[i].second, points[i]);
  }
  catch(...)
  {
    remove(copied, out);
    throw;
  }
  remove(old, out);
  return copied;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REPLACE_MESH_H
