// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_TRIANGULATE_STRIPS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_TRIANGULATE_STRIPS_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/contract_cells.h>
#include <CGAL/Geodesic_remeshing/internal/delaunay_flips.h>
#include <CGAL/Geodesic_remeshing/internal/insert_samples.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/spatial_order.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A mesh whose vertices lie on the input surface
struct Placed_mesh
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Place> place;
  Mesh::Property_map<Vertex, bool> pinned;
  Mesh::Property_map<Edge, bool> constrained; // the edges on lines
  Mesh::Property_map<Vertex, double> density; // only where the surface has one, see Metric; as the strips need it

  Placed_mesh()
    : place(mesh.add_property_map<Vertex, Place>("v:place").first),
      pinned(mesh.add_property_map<Vertex, bool>("v:pinned", false).first),
      constrained(mesh.add_property_map<Edge, bool>("e:constrained", false).first)
  {}
  Placed_mesh(const Placed_mesh&) = delete;
  Placed_mesh& operator=(const Placed_mesh&) = delete;
};

// The vertices that are left of the working surface in the order in which the mesh has them: that of the samples, which
// runs along the curves, and vertices that had to stay last. What does not fit into a cache is put into an order in
// space.
inline std::vector<Vertex> order_of_dual(const Working_surface& working, const std::vector<Vertex>& samples,
                                         const Concurrency concurrency)
{
  std::vector<Vertex> order;
  order.reserve(working.mesh.number_of_vertices());
  std::vector<char> is_sample(working.mesh.num_vertices(), 0);
  for(Vertex v : samples)
    if(v.is_valid())
    {
      order.push_back(v);
      is_sample[v] = 1;
    }
  for(Vertex v : working.mesh.vertices())
    if(!is_sample[v])
      order.push_back(v);
  if(is_large(order.size()))
    return spatial_order(working.mesh, order, concurrency);
  return order;
}

// Copies what is left of the working surface, with its vertices in this order, and uses it up.
inline void copy_dual(Working_surface& working, const std::vector<Vertex>& order, const Concurrency concurrency,
                      Placed_mesh& result)
{
  const Mesh& dual = working.mesh;
  Numbering number;
  if(is_large(order.size()))
    number = copy_in_order(dual, order, result.mesh, concurrency);
  else
  {
    number.vertex.resize(dual.num_vertices());
    for(Vertex v : order)
      number.vertex[v] = result.mesh.add_vertex(dual.point(v));
    const auto index = CGAL::get(boost::vertex_index, dual);
    copy_connectivity(dual, index, CGAL::get(boost::halfedge_index, dual), dual.num_halfedges(), number.vertex,
                      result.mesh);
    number.edge.resize(dual.num_edges());
    Mesh::size_type edges = 0; // the copy has them in the same order
    for(Edge e : dual.edges())
      number.edge[e] = Edge(edges++);
  }
  const bool has_density = !Metric(dual).is_uniform();
  if(has_density)
    result.density = add_density(result.mesh);
  for(Vertex v : order)
  {
    const Vertex w = number.vertex[v];
    result.place[w] = working.place[v];
    if(has_density)
      result.density[w] = working.density[v];
  }
  for(Edge e : dual.edges())
    result.constrained[number.edge[e]] = working.is_line[e];
  working.mesh = Mesh(); // its memory serves the improvement
}

// Triangulates the strips between the curves (paper, section 6): Voronoi cells of the samples, their dual, Delaunay.
// All strips at once, since nothing in it depends on what a strip looks like. The working surface is used up.
inline void triangulate_strips(const Mesh& surface, Working_surface& working, std::vector<Sample> samples,
                               double edge_length, Placed_mesh& result, const Concurrency concurrency = Concurrency())
{
  // A cell that begins .15 e from its sample is the same cell, and costs no sliver
  const std::vector<Vertex> vertices = Sample_inserter(surface, working, .15 * edge_length).run(samples);
  std::vector<char> is_pinned(working.mesh.num_vertices(), 0);
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(vertices[i].is_valid())
      is_pinned[vertices[i]] = samples[i].is_pinned;
  samples = std::vector<Sample>(); // 100 bytes each
  Cell_contractor(working.mesh, vertices, working.is_line).run();
  const std::vector<Vertex> order = order_of_dual(working, vertices, concurrency);
  copy_dual(working, order, concurrency, result);
  for(Vertex v : result.mesh.vertices())
    result.pinned[v] = is_pinned[order[v]] != 0;
  Delaunay_flipper(result.mesh, result.constrained).run();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TRIANGULATE_STRIPS_H
