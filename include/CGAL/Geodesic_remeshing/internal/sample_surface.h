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

// The spacing with which these curves get so many samples. The number falls with the spacing, in steps.
inline double spacing_for(const std::vector<double>& lengths, double edge_length, double number)
{
  double low = .7 * edge_length, high = 1.4 * edge_length; // outside, it would only make long triangles
  for(int i = 0; i < 30; ++i)
  {
    const double middle = .5 * (low + high);
    double sum = 0.;
    for(double length : lengths)
      sum += Curve_sampler::number_on_loop(length, middle, edge_length);
    (sum > number ? low : high) = middle;
  }
  return .5 * (low + high);
}

// Samples the curves so that there are as many samples as the mesh is to have vertices, as nearly as can be: by the
// spacing along the curves, since their distance from each other is given. What is left is for the improvement to mend;
// it is a few vertices in a thousand.
inline std::vector<Sample> sample_surface(const Mesh& surface, const Working_surface& working,
                                          const Segmentation& segmentation, const Level_curves& curves,
                                          const Line_samples& lines, const std::vector<Vertex>& roots,
                                          double edge_length, std::size_t number,
                                          const Concurrency concurrency = Concurrency())
{
  const std::vector<double> lengths = lengths_of_curves(working.mesh, curves);
  const double wanted = static_cast<double>(number);
  double refused = 0.; // less those on peaks
  std::vector<Sample> best;
  for(int attempt = 0; attempt < 4; ++attempt)
  {
    Curve_sampler sampler(surface, working, segmentation, curves, lines, edge_length, number, concurrency);
    const double off_curves = static_cast<double>(sampler.sample_off_curves(roots));
    std::vector<Sample> samples =
        sampler.sample_curves(spacing_for(lengths, edge_length, wanted - off_curves + refused));
    const double excess = static_cast<double>(samples.size()) - wanted;
    if(best.empty() || std::abs(excess) < std::abs(static_cast<double>(best.size()) - wanted))
      best.swap(samples);
    if(std::abs(excess) < .001 * wanted)
      break;
    refused -= excess;
  }
  return best;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SAMPLE_SURFACE_H
