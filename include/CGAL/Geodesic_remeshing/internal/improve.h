// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_IMPROVE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_IMPROVE_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/internal/vertex_count.h>

#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

struct Improvement_parameters
{
  std::size_t number_of_vertices;
  double edge_length;
  std::size_t number_of_iterations = 3;
  bool use_defect_moves = true;
};

// The last stage, section 6 of the paper and beyond: makes the valences regular, the angles even and the number of
// vertices the one asked for. The pinned vertices stay where they are, the topology stays what it is, every vertex stays on
// the surface. `go_on(progress)`, progress from 0 to 1, stops the work by returning false; then, as at the end, `out` is
// a valid mesh, but its number of vertices may be another one, as it is where the topology does not allow the one asked for.
template <class Progress>
void improve(const Mesh& surface, Mesh& out, Mesh::Property_map<Vertex, Place> place,
             Mesh::Property_map<Vertex, bool> pinned, const Improvement_parameters& parameters, Progress&& go_on)
{
  const Surface_walker walker(surface);
  Remeshed_surface remeshed(walker, out, place, pinned);
  const std::size_t n = parameters.number_of_iterations;
  for(std::size_t i = 0; i < n && go_on(static_cast<double>(i) / n); ++i) {
    flip_to_regular_valences(remeshed);
    relax(remeshed);
    // After the first round, when the energies mean something, and before the others, which mend what it does.
    if(i == 0)
      Vertex_count(remeshed, parameters.edge_length).reach(parameters.number_of_vertices);
  }
  go_on(1.);
  remeshed.write_back(out, place, pinned);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_IMPROVE_H
