// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

// Remeshes models with features or boundary, their lines kept, with geodesic_remeshing() and isotropic_remeshing();
// both also with the edges of the lines protected, that is left exactly as they are. The last column is how far the
// lines of input and output are from each other.
//
//   line_benchmark [--repeats R] [--output PREFIX] [MODEL=N ...]

#include "comparison.h"

#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using benchmark::Mesh;
using benchmark::Remesher;
using benchmark::Result;
using benchmark::Run;
using Kernel = mesh_quality::Kernel;
using Segments = std::vector<Kernel::Segment_3>;
using Line_map = Mesh::Property_map<Mesh::Edge_index, bool>;

// Of open surfaces, which are scanned ones here, the boundary only: on noise a bound of the angle finds no lines.
double feature_angle(const Mesh& mesh)
{
  return CGAL::is_closed(mesh) ? 60. : 180.;
}

Line_map line_map(Mesh& mesh)
{
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
}

Remesher geodesic(bool protect)
{
  return {protect ? "geodesic_remeshing, protected" : "geodesic_remeshing",
          [protect](const Mesh& input, std::size_t number_of_vertices) -> Run {
            return [&input, number_of_vertices, protect] {
              namespace parameters = CGAL::Geodesic_remeshing::parameters;
              Mesh output;
              CGAL::geodesic_remeshing(
                  input, number_of_vertices, output,
                  parameters::features_angle_bound(feature_angle(input)).protect_constraints(protect),
                  parameters::edge_is_constrained_map(line_map(output)));
              return output;
            };
          }};
}

Mesh isotropic(const Mesh& input, double edge_length, bool protect)
{
  Mesh output = input;
  const Line_map is_line = line_map(output);
  PMP::detect_sharp_edges(output, feature_angle(input), is_line); // those of the boundary are among them
  PMP::isotropic_remeshing(
      faces(output), edge_length, output,
      CGAL::parameters::number_of_iterations(10).edge_is_constrained_map(is_line).protect_constraints(protect));
  output.collect_garbage();
  return output;
}

Remesher isotropic(bool protect)
{
  return {protect ? "isotropic_remeshing, protected" : "isotropic_remeshing",
          [protect](const Mesh& input, std::size_t number_of_vertices) -> Run {
            const double length =
                benchmark::tuned(benchmark::uniform_edge_length(input, number_of_vertices), .5, number_of_vertices,
                                 [&](double value) { return isotropic(input, value, protect); });
            return [&input, length, protect] { return isotropic(input, length, protect); };
          }};
}

Segments lines_of(const Mesh& mesh, const Line_map& is_line)
{
  Segments result;
  for(const auto e : mesh.edges())
    if(is_line[e] || mesh.is_border(e))
      result.emplace_back(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return result;
}

// The farthest of the points that divide each segment into ten
double one_sided_distance(const Segments& from, const Segments& to)
{
  using Primitive = CGAL::AABB_segment_primitive_3<Kernel, Segments::const_iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>> tree(to.begin(), to.end());
  double largest = 0.;
  for(const auto& s : from)
    for(int i = 0; i <= 10; ++i)
      largest = (std::max)(largest, tree.squared_distance(s.source() + .1 * i * s.to_vector()));
  return std::sqrt(largest);
}

// In percent of the diagonal
double distance_of_lines(const Mesh& input, const Mesh& output)
{
  Mesh copy = input;
  const Line_map is_line = line_map(copy);
  PMP::detect_sharp_edges(copy, feature_angle(input), is_line);
  const Segments before = lines_of(copy, is_line);
  const Segments after = lines_of(output, output.property_map<Mesh::Edge_index, bool>("e:line").value());
  const double distance = (std::max)(one_sided_distance(before, after), one_sided_distance(after, before));
  return 100. * distance / mesh_quality::measure_quality(input).diagonal;
}

void write_head(std::ostream& out)
{
  std::vector<std::string> cells = {"model", "method"};
  for(const auto& column : benchmark::columns())
    cells.push_back(column.heading);
  cells.push_back("lines %");
  benchmark::internal::write_row(out, cells);
  out << "|---|---|";
  for(std::size_t i = 2; i < cells.size(); ++i)
    out << "--:|";
  out << "\n";
}

void write_rows(std::ostream& out, const benchmark::Task& task, const std::vector<Remesher>& remeshers,
                const benchmark::Options& options)
{
  const Mesh input = benchmark::read_model(task.model);
  std::vector<Mesh> outputs;
  const std::vector<Result> results = benchmark::measure(task, remeshers, options, &outputs);
  for(std::size_t i = 0; i < results.size(); ++i)
  {
    std::vector<std::string> cells = {results[i].model, results[i].method};
    for(const auto& column : benchmark::columns())
      cells.push_back(benchmark::number(column.value(results[i]), column.digits));
    cells.push_back(benchmark::number(distance_of_lines(input, outputs[i]), 4));
    benchmark::internal::write_row(out, cells);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    const benchmark::Options options = benchmark::read_options(argc, argv,
                                                               {{"fandisk", 3238},
                                                                {"anchor_dense", 1897},
                                                                {"couplingdown", 7364},
                                                                {"joint_refined", 5000},
                                                                {"rotor", 5000},
                                                                {"nefertiti", 3000},
                                                                {"lion-head", 5000},
                                                                {"mannequin-devil", 5000}});
    const std::vector<Remesher> remeshers = {geodesic(false), geodesic(true), isotropic(false), isotropic(true)};
    std::ostringstream table;
    write_head(table);
    for(const benchmark::Task& task : options.tasks)
      write_rows(table, task, remeshers, options);
    std::cout << table.str();
    if(!options.output.empty() && !(std::ofstream(options.output + ".md") << table.str()).flush())
      throw std::runtime_error("cannot write " + options.output + ".md");
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "line_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
