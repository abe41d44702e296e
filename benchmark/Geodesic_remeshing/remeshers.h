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
#include "result_table.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Polygon_mesh_processing/Adaptive_sizing_field.h>
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

inline Remesher geodesic_remesher_fitted()
{
  return {"geodesic_remeshing, fitted", [](const Mesh& input, std::size_t number_of_vertices) -> Run {
            return [&input, number_of_vertices] {
              Mesh output;
              CGAL::geodesic_remeshing(input, number_of_vertices, output,
                                       CGAL::Geodesic_remeshing::parameters::do_project(false));
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

// isotropic_remeshing() takes a length or a tolerance and not a count: the one for the count is searched first. The
// count goes about with the power -1 / exponent of the value.
template <class Remesh>
double tuned(double value, double exponent, std::size_t number_of_vertices, const Remesh& remesh)
{
  constexpr int largest_number_of_trials = 15;
  constexpr double tolerance = .002;
  const double wanted = static_cast<double>(number_of_vertices);
  double best_value = value;
  double best_error = 1e300;
  for(int trial = 0; trial < largest_number_of_trials && best_error > tolerance; ++trial)
  {
    const double count = static_cast<double>(remesh(value).number_of_vertices());
    const double error = std::abs(count / wanted - 1.);
    if(error < best_error)
    {
      best_error = error;
      best_value = value;
    }
    value *= std::pow(count / wanted, exponent);
  }
  return best_value;
}

// The length of the edges of so many equilateral triangles of the same area
inline double uniform_edge_length(const Mesh& input, std::size_t number_of_vertices)
{
  return std::sqrt(CGAL::Polygon_mesh_processing::area(input) / static_cast<double>(number_of_vertices) * 2. /
                   std::sqrt(3.));
}

inline Remesher isotropic_remesher(unsigned int iterations)
{
  return {"isotropic_remeshing, " + std::to_string(iterations) + " iterations",
          [iterations](const Mesh& input, std::size_t number_of_vertices) -> Run {
            const double length = tuned(uniform_edge_length(input, number_of_vertices), .5, number_of_vertices,
                                        [&](double value) { return isotropic(input, value, iterations); });
            return [&input, length, iterations] { return isotropic(input, length, iterations); };
          }};
}

inline Remesher geodesic_remesher_by_curvature(double contrast)
{
  return {"geodesic_remeshing, contrast " + number(contrast, 1),
          [contrast](const Mesh& input, std::size_t number_of_vertices) -> Run {
            return [&input, number_of_vertices, contrast] {
              namespace parameters = CGAL::Geodesic_remeshing::parameters;
              const CGAL::Geodesic_remeshing::Curvature_sizing_field<Mesh> sizing(input,
                                                                                  parameters::contrast(contrast));
              Mesh output;
              CGAL::geodesic_remeshing(input, number_of_vertices, output, parameters::sizing_field(sizing));
              return output;
            };
          }};
}

// The field wants limits of the lengths: a quarter and four times the length of the uniform mesh. Of the factors 2, 4
// and 10 this is the one whose RMS distance is within 4 % of the least on each of homer, camel, armadillo and fandisk
// at 5,000 vertices.
inline Mesh adaptive(const Mesh& input, double tolerance, double edge_length, unsigned int iterations)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh output = input;
  PMP::Adaptive_sizing_field<Mesh> sizing(tolerance, std::make_pair(edge_length / 4., edge_length * 4.), faces(output),
                                          output);
  PMP::isotropic_remeshing(faces(output), sizing, output, CGAL::parameters::number_of_iterations(iterations));
  output.collect_garbage();
  return output;
}

inline Remesher adaptive_remesher(unsigned int iterations)
{
  return {"isotropic_remeshing, adaptive, " + std::to_string(iterations) + " iterations",
          [iterations](const Mesh& input, std::size_t number_of_vertices) -> Run {
            const double length = uniform_edge_length(input, number_of_vertices);
            const double tolerance = tuned(.05 * length, 1., number_of_vertices,
                                           [&](double value) { return adaptive(input, value, length, iterations); });
            return [&input, tolerance, length, iterations] { return adaptive(input, tolerance, length, iterations); };
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
  remeshers.push_back(geodesic_remesher_fitted());
  return remeshers;
}

} // namespace benchmark

#endif // CGAL_GEODESIC_REMESHING_BENCHMARK_REMESHERS_H
