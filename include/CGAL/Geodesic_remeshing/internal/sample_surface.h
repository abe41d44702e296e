// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Curve_sampler.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Samples the curves so that there are as many samples as the mesh is to have vertices, as nearly as can be: by the spacing
// along the curves, since their distance from each other is given. What is left is for the improvement to mend; it is
// a few vertices in a thousand.
inline std::vector<Sample> sample_surface(const Mesh& surface, const Working_surface& working,
                                          const Segmentation& segmentation, const Level_curves& curves,
                                          const std::vector<Vertex>& roots, double edge_length, std::size_t number)
{
  std::vector<Sample> best;
  double spacing = edge_length;
  const auto miss = [number](const std::vector<Sample>& samples)
  { return std::abs(static_cast<double>(samples.size()) - static_cast<double>(number)); };
  for(int attempt = 0; attempt < 4; ++attempt)
  {
    std::vector<Sample> samples = Curve_sampler(surface, working, segmentation, curves, edge_length, spacing, number).run(roots);
    const double ratio = static_cast<double>(samples.size()) / static_cast<double>(number);
    if(best.empty() || miss(samples) < miss(best))
      best.swap(samples);
    // a spacing far from the edge length would only make long triangles
    spacing = (std::min)((std::max)(spacing * ratio, .7 * edge_length), 1.4 * edge_length);
    if(miss(best) < .002 * static_cast<double>(number))
      break;
  }
  return best;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SURFACE_H
