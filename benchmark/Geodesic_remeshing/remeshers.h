// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_BENCHMARK_REMESHERS_H
#define CGAL_GEODESIC_REMESHING_BENCHMARK_REMESHERS_H

// The remeshers that are compared, each made ready to give about the wanted number of vertices before it is timed.

#include "mesh_quality.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/geodesic_remeshing.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 1, 0)
#include <CGAL/Polygon_mesh_processing/approximated_centroidal_Voronoi_diagram_remeshing.h>
#endif

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace benchmark {

using mesh_quality::Mesh;

// Does what is to be timed: gives the remeshed mesh.
using Run = std::function<Mesh()>;

struct Remesher
{
  std::string name;
  // What need not be timed (tuning) happens here.
  std::function<Run(const Mesh& input, std::size_t number_of_vertices)> prepare;
};

inline Remesher geodesic_remesher()
{
  return {"geodesic_remeshing", [](const Mesh& input, std::size_t number_of_vertices) -> Run {
            return [&input, number_of_vertices] {
              Mesh output;
              CGAL::geodesic_remeshing(input, number_of_vertices, output);
              return output;
            };
          }};
}

inline Mesh isotropic(const Mesh& input, double edge_length, unsigned int iterations)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh output = input;
  PMP::isotropic_remeshing(faces(output), edge_length, output, CGAL::parameters::number_of_iterations(iterations));
  output.collect_garbage();
  return output;
}

// isotropic_remeshing() takes an edge length and not a count: the length for the count is searched first, starting from
// that of equilateral triangles of the same area. The count goes with the inverse square of the length.
inline double isotropic_edge_length(const Mesh& input, std::size_t number_of_vertices, unsigned int iterations)
{
  constexpr int largest_number_of_trials = 10;
  constexpr double tolerance = .002;
  const double wanted = static_cast<double>(number_of_vertices);
  double length = std::sqrt(CGAL::Polygon_mesh_processing::area(input) / wanted * 2. / std::sqrt(3.));
  double best_length = length;
  double best_error = 1e300;
  for(int trial = 0; trial < largest_number_of_trials && best_error > tolerance; ++trial)
  {
    const double count = static_cast<double>(isotropic(input, length, iterations).number_of_vertices());
    const double error = std::abs(count / wanted - 1.);
    if(error < best_error)
    {
      best_error = error;
      best_length = length;
    }
    length *= std::sqrt(count / wanted);
  }
  return best_length;
}

inline Remesher isotropic_remesher(unsigned int iterations)
{
  return {"isotropic_remeshing, " + std::to_string(iterations) + " iterations",
          [iterations](const Mesh& input, std::size_t number_of_vertices) -> Run {
            const double length = isotropic_edge_length(input, number_of_vertices, iterations);
            return [&input, length, iterations] { return isotropic(input, length, iterations); };
          }};
}

#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 1, 0)
inline Remesher acvd_remesher()
{
  return {"ACVD", [](const Mesh& input, std::size_t number_of_vertices) -> Run {
            return [&input, number_of_vertices] {
              Mesh output = input;
              CGAL::Polygon_mesh_processing::approximated_centroidal_Voronoi_diagram_remeshing(
                  output, number_of_vertices, CGAL::parameters::random_seed(0));
              output.collect_garbage();
              return output;
            };
          }};
}
#endif

inline std::vector<Remesher> all_remeshers()
{
  std::vector<Remesher> remeshers = {geodesic_remesher(), isotropic_remesher(3), isotropic_remesher(10)};
#if CGAL_VERSION_NR >= CGAL_VERSION_NUMBER(6, 1, 0)
  remeshers.push_back(acvd_remesher());
#endif
  return remeshers;
}

} // namespace benchmark

#endif // CGAL_GEODESIC_REMESHING_BENCHMARK_REMESHERS_H
