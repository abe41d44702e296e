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

// Triangulates the strips between the curves (paper, section 6): Voronoi cells of the samples, their dual, Delaunay. All
// strips at once, since nothing in it depends on what a strip looks like. The working surface is used up.
inline void triangulate_strips(const Mesh& surface, Working_surface& working, const std::vector<Sample>& samples,
                               double edge_length, Placed_mesh& result)
{
  // A cell that begins .15 e from its sample is the same cell, and costs no sliver
  const std::vector<Vertex> vertices = Sample_inserter(surface, working, .15 * edge_length).run(samples);
  Cell_contractor(working.mesh, vertices, working.is_line).run();

  const Metric metric(surface);
  if(!metric.is_uniform())
    result.density = add_density(result.mesh);
  // In the order of the samples, which runs along the curves; vertices that had to stay come last.
  const Mesh& dual = working.mesh;
  std::vector<Vertex> copy(dual.num_vertices());
  const auto add = [&](Vertex v, bool is_pinned)
  {
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
  const auto index = CGAL::get(boost::vertex_index, dual);
  copy_connectivity(dual, index, CGAL::get(boost::halfedge_index, dual), dual.num_halfedges(), copy, result.mesh);
  std::size_t number = 0; // the copy has the edges in the same order
  for(Edge e : dual.edges())
    result.constrained[Edge(static_cast<Mesh::size_type>(number++))] = working.is_line[e];
  Delaunay_flipper(result.mesh, result.constrained).run();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_TRIANGULATE_STRIPS_H
