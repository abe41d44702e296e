// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SIZING_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SIZING_H

#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/curvature.h>
#include <CGAL/Geodesic_remeshing/internal/size_field.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A mesh that is to be near to the surface, and of which nobody has told how long its edges are to be, has short ones
// where the surface bends (paper, section 4): as many vertices as a uniform one has, its RMS distance a sixth to a
// third less.
template <class Target>
Goal set_goal_of_fit(const Target& target, Mesh& surface)
{
  return set_goal(number_of_vertices_for(target, surface), lengths_by_curvature(surface, Curvature_weights()),
                  Sizing_limits(), surface);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SIZING_H
