// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

// Remeshes a file: see --help. The table goes to standard output, the progress and the one line about an error to standard
// error; the exit status tells whose fault it was.

#include "command_line/input.h"
#include "command_line/options.h"
#include "command_line/output.h"
#include "command_line/progress.h"
#include "command_line/report.h"
#include "command_line/sizing.h"
#include "command_line/stage_files.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>
#include <CGAL/Timer.h>
#include <CGAL/geodesic_remeshing.h>
#include <CGAL/version.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

namespace {

namespace GR = CGAL::Geodesic_remeshing;
using command_line::Mesh;
using command_line::Options;
using command_line::Report;

enum Exit_status { done = 0, wrong_usage = 1, bad_input = 2, cannot_remesh = 3 };

const std::string version = "geodesic_remesh " GEODESIC_REMESHING_VERSION " (CGAL " CGAL_VERSION_STR ")";

template <class NamedParameters>
GR::Summary remesh_to_target(const Mesh& input, const Options& options, Mesh& output, const NamedParameters& np)
{
  if(options.vertices)
    return CGAL::geodesic_remeshing(input, *options.vertices, output, np);
  if(options.faces)
    return CGAL::geodesic_remeshing(input, GR::Number_of_faces{*options.faces}, output, np);
  return CGAL::geodesic_remeshing(input, GR::Edge_length{*options.edge_length}, output, np);
}

template <class NamedParameters>
GR::Summary remesh_and_keep_stages(const Mesh& input, const Options& options, Mesh& output, GR::Stage_results& stages,
                                   const NamedParameters& np)
{
  if(options.regions.empty() && options.curves.empty())
    return remesh_to_target(input, options, output, np);
  return remesh_to_target(input, options, output, np.stage_results(std::ref(stages)));
}

GR::Summary remesh(command_line::Input& input, const Options& options, Mesh& output, GR::Stage_results& stages)
{
  const auto sizing = options.sizing.empty()
                          ? Mesh::Property_map<Mesh::Vertex_index, double>()
                          : command_line::read_sizing(options.sizing, input.mesh, input.vertices_in_file);
  command_line::Progress progress(options.quiet);
  const auto np = GR::parameters::use_segmentation(options.use_segmentation)
                      .number_of_iterations(options.iterations)
                      .visitor(std::ref(progress));
  const auto remesh_with = [&](const auto& parameters) {
    if(options.feature_angle > 0.)
      return remesh_and_keep_stages(input.mesh, options, output, stages, parameters.features_angle_bound(options.feature_angle));
    return remesh_and_keep_stages(input.mesh, options, output, stages, parameters);
  };
  const auto remesh_by = [&](const auto& field) {
    return remesh_with(np.sizing_field(std::cref(field))
                           .gradation(options.limits.gradation)
                           .minimum_length(options.limits.minimum_length)
                           .maximum_length(options.limits.maximum_length));
  };
  if(options.contrast)
    return remesh_by(GR::Curvature_sizing_field<Mesh>(input.mesh, GR::parameters::contrast(*options.contrast)
                                                                      .gaussian_weight(options.gaussian_weight)
                                                                      .mean_weight(options.mean_weight)));
  if(!options.sizing.empty())
    return remesh_by(sizing);
  return remesh_with(np);
}

GR::Remeshing_validity check(const Mesh& input, const Mesh& output, const Options& options)
{
  const auto np = GR::parameters::default_values();
  return options.vertices ? GR::is_valid_remeshing(input, output, GR::parameters::expected_number_of_vertices(*options.vertices))
                          : GR::is_valid_remeshing(input, output, np);
}

void run(const Options& options)
{
  const auto write_output = command_line::mesh_writer(options.output);
  command_line::Input input = command_line::read_mesh(options.input, options.do_repair);
  command_line::Output_files files;
  if(!options.quiet)
    for(const std::string& repair : input.repairs)
      std::cout << "repaired the input: " << repair << "\n";
  files.announce(options.output);
  for(const std::string& name : {options.report, options.regions, options.curves})
    if(!name.empty())
      files.announce(name);

  Mesh output;
  GR::Stage_results stages;
  Report report;
  CGAL::Timer timer;
  timer.start();
  report.summary = remesh(input, options, output, stages);
  report.seconds = timer.time();

  files.write(options.output, [&](std::ostream& out) { write_output(out, output); });
  files.write(options.regions, [&](std::ostream& out) { command_line::write_regions(out, stages); });
  files.write(options.curves, [&](std::ostream& out) { command_line::write_curves(out, stages); });
  const bool is_measured = !options.quiet || !options.report.empty();
  if(is_measured)
  {
    report.input = mesh_quality::measure_quality(input.mesh);
    report.output = mesh_quality::measure_quality(output);
    report.distance = mesh_quality::measure_distance(input.mesh, output, 100000);
  }
  if(options.check)
    report.validity = check(input.mesh, output, options);
  files.write(options.report, [&](std::ostream& out) { command_line::write_json(out, report); });
  files.put_into_place();
  if(!options.quiet)
    command_line::write_table(std::cout, report);
}

int complain(const std::string& message, Exit_status status)
{
  std::cerr << "geodesic_remesh: " << message << "\n";
  return status;
}

} // namespace

int main(int argc, char* argv[])
{
  // what CGAL would write before it throws is in the exception as well, and ours is to be the only line
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  try
  {
    if(const auto options = command_line::read_options(argc, argv, version))
      run(*options);
    return done;
  }
  catch(const command_line::Usage_error& error)
  {
    return complain(error.what(), wrong_usage);
  }
  catch(const command_line::Input_error& error)
  {
    return complain(error.what(), bad_input);
  }
  catch(const std::invalid_argument& error)
  {
    return complain(error.what(), bad_input);
  }
  catch(const std::bad_alloc&)
  {
    return complain("out of memory", cannot_remesh);
  }
  catch(const std::exception& error)
  {
    std::string message = error.what();
    std::replace(message.begin(), message.end(), '\n', ' ');
    return complain(message, cannot_remesh);
  }
}
