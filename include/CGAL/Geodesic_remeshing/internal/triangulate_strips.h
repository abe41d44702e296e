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
#include <CGAL/Geodesic_remeshing/internal/spatial_order.h>

#include <algorithm>
#include <utility>
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

// Renumbers a mesh by the faces of the input that its vertices are on.
inline void sort_by_place(Placed_mesh& placed)
{
  std::vector<Vertex> order(placed.mesh.vertices().begin(), placed.mesh.vertices().end());
  std::sort(order.begin(), order.end(), [&](Vertex v, Vertex w) {
    return std::make_pair(placed.place[v].face, v) < std::make_pair(placed.place[w].face, w);
  });
  const auto density = placed.mesh.property_map<Vertex, double>(Metric::property);
  Placed_mesh sorted;
  if(density.has_value())
    sorted.density = add_density(sorted.mesh);
  const Numbering number = copy_in_order(placed.mesh, order, sorted.mesh);
  for(Vertex v : order)
  {
    const Vertex w = number.vertex[v];
    sorted.place[w] = placed.place[v];
    sorted.pinned[w] = placed.pinned[v];
    if(density.has_value())
      sorted.density[w] = (*density)[v];
  }
  for(Edge e : placed.mesh.edges())
    sorted.constrained[number.edge[e]] = placed.constrained[e];
  placed.mesh = std::move(sorted.mesh);
  placed.place = *placed.mesh.property_map<Vertex, Place>("v:place");
  placed.pinned = *placed.mesh.property_map<Vertex, bool>("v:pinned");
  placed.constrained = *placed.mesh.property_map<Edge, bool>("e:constrained");
  if(density.has_value())
    placed.density = *placed.mesh.property_map<Vertex, double>(Metric::property);
}

// Triangulates the strips between the curves (paper, section 6): Voronoi cells of the samples, their dual, Delaunay.
// All strips at once, since nothing in it depends on what a strip looks like. The working surface is used up.
inline void triangulate_strips(const Mesh& surface, Working_surface& working, std::vector<Sample> samples,
                               double edge_length, Placed_mesh& result)
{
  // A cell that begins .15 e from its sample is the same cell, and costs no sliver
  std::vector<Vertex> vertices = Sample_inserter(surface, working, .15 * edge_length).run(samples);
  Cell_contractor(working.mesh, vertices, working.is_line).run();

  const Metric metric(surface);
  if(!metric.is_uniform())
    result.density = add_density(result.mesh);
  // In the order of the samples, which runs along the curves; vertices that had to stay come last. What does not fit
  // into a cache is put in that of the places on the input, which is coherent in space.
  const Mesh& dual = working.mesh;
  std::vector<Vertex> copy(dual.num_vertices());
  const auto add = [&](Vertex v, bool is_pinned) {
    copy[v] = result.mesh.add_vertex(dual.point(v));
    result.place[copy[v]] = working.place[v];
    result.pinned[copy[v]] = is_pinned;
    if(!metric.is_uniform())
      result.density[copy[v]] = working.density[v];
  };
  for(std::size_t i = 0; i < samples.size(); ++i)
    if(vertices[i].is_valid())
      add(vertices[i], samples[i].is_pinned);
  for(Vertex v : dual.vertices())
    if(!copy[v].is_valid())
      add(v, false);
  samples = std::vector<Sample>(); // 100 bytes each
  const auto index = CGAL::get(boost::vertex_index, dual);
  copy_connectivity(dual, index, CGAL::get(boost::halfedge_index, dual), dual.num_halfedges(), copy, result.mesh);
  std::size_t number = 0; // the copy has the edges in the same order
  for(Edge e : dual.edges())
    result.constrained[Edge(static_cast<Mesh::size_type>(number++))] = working.is_line[e];
  working.mesh = Mesh(); // its memory serves the improvement
  if(is_large(result.mesh.number_of_vertices()))
    sort_by_place(result);
  Delaunay_flipper(result.mesh, result.constrained).run();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TRIANGULATE_STRIPS_H
