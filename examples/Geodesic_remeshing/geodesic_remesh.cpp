// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

// Remeshes a file: see --help. The table goes to standard output, the progress and the one line about an error to
// standard error; the exit status tells whose fault it was.

#include "command_line/hints.h"
#include "command_line/html_report.h"
#include "command_line/input.h"
#include "command_line/options.h"
#include "command_line/output.h"
#include "command_line/progress.h"
#include "command_line/report.h"
#include "command_line/sharp_edges.h"
#include "command_line/sizing.h"
#include "command_line/stage_files.h"
#include "command_line/thin_places.h"
#include "command_line/threads.h"
#include "command_line/transfer.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Timer.h>
#include <CGAL/geodesic_remeshing.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace {

namespace GR = CGAL::Geodesic_remeshing;
using command_line::Mesh;
using command_line::Options;
using command_line::Report;
using command_line::Transfer;

enum Exit_status { done = 0, wrong_usage = 1, bad_input = 2, cannot_remesh = 3, not_valid = 4 };

const std::string version = "geodesic_remesh " GEODESIC_REMESHING_VERSION " (CGAL " CGAL_VERSION_STR ")";

// That of the stages: processor seconds, or with several threads those that pass
using Clock = std::conditional_t<std::is_convertible<CGAL::Parallel_if_available_tag, CGAL::Parallel_tag>::value,
                                 CGAL::Real_timer, CGAL::Timer>;

using Edge_marks = Mesh::Property_map<Mesh::Edge_index, bool>;

// One remeshing: the parameters are put together one by one, each only if it is asked for
struct Job
{
  const Mesh& input;
  const Options& options;
  const Transfer& transfer;
  Mesh& output;
  Edge_marks is_line; // of the output
  GR::Stage_results& stages;

  template <class NamedParameters>
  GR::Summary remesh_to_target(const NamedParameters& np) const
  {
    const auto np_out = GR::parameters::vertex_location_map(transfer.locations()).edge_is_constrained_map(is_line);
    if(options.vertices)
      return CGAL::geodesic_remeshing(input, *options.vertices, output, np, np_out);
    if(options.faces)
      return CGAL::geodesic_remeshing(input, GR::Number_of_faces{*options.faces}, output, np, np_out);
    return CGAL::geodesic_remeshing(input, GR::Edge_length{*options.edge_length}, output, np, np_out);
  }

  template <class NamedParameters>
  GR::Summary remesh_and_keep_stages(const NamedParameters& np) const
  {
    if(options.regions.empty() && options.curves.empty() && options.html.empty())
      return remesh_to_target(np);
    return remesh_to_target(np.stage_results(std::ref(stages)));
  }

  template <class NamedParameters>
  GR::Summary remesh_with_features(const NamedParameters& np) const
  {
    if(options.feature_angle > 0.)
      return remesh_and_keep_stages(np.features_angle_bound(options.feature_angle));
    return remesh_and_keep_stages(np);
  }
};

// A sizing field, whether its lengths come from curvatures or from a file
struct Sizing
{
  using vertex_descriptor = Mesh::Vertex_index;
  using FT = double;

  Mesh::Property_map<Mesh::Vertex_index, double> length;
  double worth_of_nearness = 0.;

  double at(const vertex_descriptor v) const { return length[v]; }
  double nearness() const { return worth_of_nearness; }
};

Sizing sizing_by_curvature(Mesh& mesh, const Options& options)
{
  const GR::Curvature_sizing_field<Mesh> field(mesh, GR::parameters::contrast(*options.contrast)
                                                         .gaussian_weight(options.gaussian_weight)
                                                         .mean_weight(options.mean_weight));
  const Sizing sizing{mesh.add_property_map<Mesh::Vertex_index, double>("v:sizing").first, field.nearness()};
  for(const auto v : mesh.vertices())
    sizing.length[v] = field.at(v);
  return sizing;
}

GR::Summary remesh(command_line::Input& input, const Options& options, const Transfer& transfer, Mesh& output,
                   Edge_marks is_line, GR::Stage_results& stages)
{
  command_line::Progress progress(options.quiet);
  const auto np = GR::parameters::use_segmentation(options.use_segmentation)
                      .number_of_iterations(options.iterations)
                      .edge_is_constrained_map(transfer.seams())
                      .protect_constraints(options.protect)
                      .do_project(!options.fit)
                      .concurrency_tag(CGAL::Parallel_if_available_tag())
                      .visitor(std::ref(progress));
  const Job job{input.mesh, options, transfer, output, is_line, stages};
  if(!options.contrast && options.sizing.empty())
    return job.remesh_with_features(np);
  const Sizing sizing = options.contrast
                            ? sizing_by_curvature(input.mesh, options)
                            : Sizing{command_line::read_sizing(options.sizing, input.mesh, input.vertices_in_file)};
  return job.remesh_with_features(np.sizing_field(sizing)
                                      .gradation(options.limits.gradation)
                                      .minimum_length(options.limits.minimum_length)
                                      .maximum_length(options.limits.maximum_length));
}

// How far a vertex of a fitted mesh may be from the surface, as a part of the diagonal: more is no fit but a fault.
constexpr double fitted_tolerance = .05;

GR::Remeshing_validity check(const Mesh& input, const Mesh& output, const Options& options)
{
  const auto with_number = [&](const auto& np) {
    return options.vertices ? GR::is_valid_remeshing(input, output, np.expected_number_of_vertices(*options.vertices))
                            : GR::is_valid_remeshing(input, output, np);
  };
  const auto np = GR::parameters::concurrency_tag(CGAL::Parallel_if_available_tag());
  return options.fit ? with_number(np.surface_tolerance(fitted_tolerance)) : with_number(np);
}

std::string output_format_of(const Options& options, const command_line::Input_file& input)
{
  if(!options.output_format.empty())
    return options.output_format;
  return options.output == "-" ? input.format() : command_line::format_of(options.output);
}

std::string name_in_title(const std::string& path)
{
  return path.substr(path.find_last_of("/\\") + 1);
}

void announce_all(command_line::Output_files& files, const Options& options)
{
  for(const std::string& name : {options.output, options.report, options.html, options.regions, options.curves})
    if(!name.empty())
      files.announce(name);
}

void measure(Report& report, const Mesh& input, const Mesh& output, const Edge_marks is_line, const Options& options)
{
  if(!options.quiet || !options.report.empty() || !options.html.empty())
  {
    report.input = mesh_quality::measure_quality(input);
    report.output = mesh_quality::measure_quality(output);
    report.small_angles = mesh_quality::find_small_angles(output, [&](const Mesh::Edge_index e) { return is_line[e]; });
    report.distance = mesh_quality::measure_distance<CGAL::Parallel_if_available_tag>(input, output, 100000);
  }
  if(options.check)
    report.validity = check(input, output, options);
}

void tell_hint(const std::string& hint)
{
  if(!hint.empty())
    std::cerr << "geodesic_remesh: hint: " << hint << "\n";
}

Exit_status run(const Options& options)
{
  const command_line::Thread_limit thread_limit(options.threads);
  const command_line::Input_file file(options.input, options.input_format);
  const std::string output_format = output_format_of(options, file);
  const auto write_output = command_line::mesh_writer(options.output, output_format);
  if(options.transfer && !Transfer::is_possible(file.format(), output_format))
    throw command_line::Usage_error("--transfer goes from .ply to .ply and from .obj to .obj");
  command_line::Input input = command_line::read_mesh(file, options.repair);
  command_line::Output_files files;
  announce_all(files, options);
  std::ostream& messages = files.use_standard_output() ? std::cerr : std::cout;
  if(!options.quiet)
    for(const std::string& repair : input.repairs)
      messages << "repaired the input: " << repair << "\n";

  if(!options.quiet)
    tell_hint(command_line::hints(input.mesh, options));

  Mesh output;
  const Edge_marks is_line = output.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
  Transfer transfer(options.transfer, file, input, output);
  GR::Stage_results stages;
  Report report;
  Clock timer;
  timer.start();
  report.summary = remesh(input, options, transfer, output, is_line, stages);
  report.is_fitted = options.fit;
  report.seconds = timer.time();
  transfer.run();
  if(!options.quiet)
  {
    const double length = report.summary.edge_length;
    tell_hint(options.feature_angle > 0. ? command_line::hint_at_many_lines(output, is_line)
                                         : command_line::hint_at_sharp_edges(input.mesh, length, output, is_line));
    if(options.protect)
      tell_hint(command_line::hint_at_short_kept_edges(length, output, is_line));
    tell_hint(command_line::Thin_places(input.mesh, output).hint(options, length));
  }

  files.write(options.output,
              [&](std::ostream& out) { transfer.is_from_obj() ? transfer.write_obj(out) : write_output(out, output); });
  files.write(options.regions, [&](std::ostream& out) { command_line::write_regions(out, stages); });
  files.write(options.curves, [&](std::ostream& out) { command_line::write_curves(out, stages); });
  measure(report, input.mesh, output, is_line, options);
  files.write(options.report, [&](std::ostream& out) { command_line::write_json(out, report); });
  files.write(options.html, [&](std::ostream& out) {
    command_line::write_html(out, name_in_title(file.name()), report, input.mesh, output, stages);
  });
  files.put_into_place();
  if(!options.quiet)
    command_line::write_table(messages, report);
  if(!std::cout.flush())
    throw command_line::Output_error("standard output cannot be written");
  return report.validity && !*report.validity ? not_valid : done;
}

int complain(const std::string& message, Exit_status status)
{
  const bool has_colors = command_line::standard_error_is_a_terminal_with_colors();
  std::cerr << (has_colors ? "\033[1;31mgeodesic_remesh:\033[0m " : "geodesic_remesh: ") << message << "\n";
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
      return run(*options);
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
