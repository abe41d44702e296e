// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTIONS_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTIONS_H

#include "generate.h"
#include "help.h"
#include "repair.h"

#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace command_line {

// exit status 1
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct Options
{
  std::string input; // "-": standard input
  std::string output;
  std::string input_format; // empty: the ending of the name tells
  std::string output_format;
  std::optional<std::size_t> vertices; // exactly one of these three is set
  std::optional<std::size_t> faces;
  std::optional<double> edge_length;
  unsigned int iterations = 3;
  bool use_segmentation = true;
  std::optional<std::size_t> threads; // none: as many as there are processors
  double feature_angle = 0.;          // degrees; zero: features are not sought
  bool fit = false;
  bool protect = false; // lines keep their vertices and edges
  Repair_options repair;
  bool transfer = false;
  bool check = false;
  bool quiet = false;
  std::optional<double> contrast; // a sizing by curvature
  std::string sizing;             // the file of a sizing; empty: none
  double gaussian_weight = .5;
  double mean_weight = .5;
  CGAL::Geodesic_remeshing::Sizing_limits limits;
  std::string report; // empty: none
  std::string html;
  std::string regions;
  std::string curves;
};

namespace internal {

inline po::variables_map parse(int argc, const char* const* argv)
{
  po::options_description all;
  for(const auto& group : option_groups())
    all.add(group.options);
  all.add_options()("input", po::value<std::string>())("output", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("input", 1).add("output", 1);

  // An option must be spelt out: what is a prefix of one name today may be one of two tomorrow.
  namespace style = po::command_line_style;
  po::variables_map values;
  try
  {
    po::store(po::command_line_parser(argc, argv)
                  .options(all)
                  .positional(positional)
                  .style(style::unix_style & ~style::allow_guessing)
                  .run(),
              values);
    po::notify(values);
  }
  catch(const po::error& error)
  {
    throw Usage_error(error.what());
  }
  return values;
}

// Read as a signed number, because the standard library takes "-1" for a huge unsigned one.
inline std::optional<std::size_t> count(const po::variables_map& values, const std::string& name, long long smallest)
{
  if(values.count(name) == 0)
    return std::nullopt;
  const long long value = values[name].as<long long>();
  if(value < smallest)
    throw Usage_error("--" + name + " must be at least " + std::to_string(smallest));
  return static_cast<std::size_t>(value);
}

inline std::string file_name(const po::variables_map& values, const std::string& name)
{
  if(values.count(name) == 0)
    return {};
  const std::string value = values[name].as<std::string>();
  if(value.empty())
    throw Usage_error("the file name of " + name + " is empty");
  return value;
}

// A number in [low, high], or in (low, high) if the ends are not allowed
inline void read_number(const po::variables_map& values, const std::string& name, double low, double high,
                        bool with_ends, double& result)
{
  if(values.count(name) == 0)
    return;
  const double value = values[name].as<double>();
  if(!std::isfinite(value) || value < low || value > high || (!with_ends && !(value > low && value < high)))
    throw Usage_error("--" + name +
                      (high < std::numeric_limits<double>::infinity()
                           ? (with_ends ? " must be from 0 to " : " must be above 0 and below ") +
                                 std::to_string(static_cast<int>(high))
                           : std::string(with_ends ? " must not be negative" : " must be a positive number")));
  result = value;
}

inline void read_repair(const po::variables_map& values, Repair_options& repair)
{
  repair.do_repair = !values["no-repair"].as<bool>();
  read_number(values, "stitch", 0., std::numeric_limits<double>::infinity(), false, repair.stitch_tolerance);
  read_number(values, "drop-parts", 0., 100., false, repair.drop_parts);
  repair.fill_holes = count(values, "fill-holes", 3).value_or(0);
  for(const char* name : {"stitch", "drop-parts", "fill-holes"})
    if(values.count(name) != 0 && !repair.do_repair)
      throw Usage_error(std::string("--") + name + " and --no-repair exclude each other");
}

inline void read_sizing(const po::variables_map& values, Options& options)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double contrast = 0.;
  read_number(values, "contrast", 0., 2., true, contrast);
  if(values.count("contrast") != 0)
    options.contrast = contrast;
  options.sizing = file_name(values, "sizing");
  if(options.contrast && !options.sizing.empty())
    throw Usage_error("--contrast and --sizing exclude each other");
  for(const char* name : {"gaussian-weight", "mean-weight"})
    if(values.count(name) != 0 && !options.contrast)
      throw Usage_error(std::string("--") + name + " needs --contrast");
  for(const char* name : {"gradation", "min-length", "max-length"})
    if(values.count(name) != 0 && !options.contrast && options.sizing.empty())
      throw Usage_error(std::string("--") + name + " needs --contrast or --sizing");
  read_number(values, "gaussian-weight", 0., infinity, true, options.gaussian_weight);
  read_number(values, "mean-weight", 0., infinity, true, options.mean_weight);
  if(!(options.gaussian_weight + options.mean_weight > 0.))
    throw Usage_error("one of --gaussian-weight and --mean-weight must be positive");
  read_number(values, "gradation", 0., infinity, false, options.limits.gradation);
  read_number(values, "min-length", 0., infinity, false, options.limits.minimum_length);
  read_number(values, "max-length", 0., infinity, false, options.limits.maximum_length);
  if(options.limits.minimum_length > options.limits.maximum_length)
    throw Usage_error("--min-length must not be above --max-length");
}

inline void read_target(const po::variables_map& values, Options& options)
{
  if(values.count("vertices") + values.count("faces") + values.count("edge-length") != 1)
    throw Usage_error("exactly one of --vertices, --faces and --edge-length is needed");
  options.vertices = count(values, "vertices", 4);
  options.faces = count(values, "faces", 4);
  if(values.count("edge-length") != 0)
  {
    options.edge_length = values["edge-length"].as<double>();
    if(!std::isfinite(*options.edge_length) || *options.edge_length <= 0.)
      throw Usage_error("--edge-length must be a positive number");
  }
}

} // namespace internal

namespace internal {

// One of the words of a list with | between, or nothing
inline std::string one_of(const po::variables_map& values, const std::string& name, const char* list)
{
  if(values.count(name) == 0)
    return {};
  const std::string value = values[name].as<std::string>();
  const auto words = alternatives(list);
  if(std::find(words.begin(), words.end(), value) == words.end())
    throw Usage_error("--" + name + " is one of " + list + ", not \"" + value + "\"");
  return value;
}

inline void read_files(const po::variables_map& values, Options& options)
{
  options.input = file_name(values, "input");
  options.output = file_name(values, "output");
  if(options.input.empty() || options.output.empty())
    throw Usage_error("INPUT and OUTPUT are needed (see --help)");
  options.input_format = one_of(values, "input-format", mesh_formats);
  options.output_format = one_of(values, "output-format", mesh_formats);
  if(options.input == "-" && options.input_format.empty())
    throw Usage_error("reading standard input needs --input-format");
  options.report = file_name(values, "report");
  options.html = file_name(values, "html");
  options.regions = file_name(values, "regions");
  options.curves = file_name(values, "curves");
}

// --help, --version and --generate
inline bool is_answered(const po::variables_map& values, const std::string& version)
{
  const std::string text = one_of(values, "generate", generated_texts);
  if(values["help"].as<bool>())
    print_help(std::cout);
  else if(values["version"].as<bool>())
    std::cout << version << "\n";
  else if(!text.empty())
    generate(text, std::cout, version);
  else
    return false;
  return true;
}

} // namespace internal

// What the arguments ask for, or nothing if they asked for a text about the program, which is printed here.
inline std::optional<Options> read_options(int argc, const char* const* argv, const std::string& version)
{
  const auto values = internal::parse(argc, argv);
  if(internal::is_answered(values, version))
    return std::nullopt;
  Options options;
  internal::read_files(values, options);
  internal::read_target(values, options);
  internal::read_sizing(values, options);
  if(const auto iterations = internal::count(values, "iterations", 0))
    options.iterations = static_cast<unsigned int>((std::min<std::size_t>)(*iterations, 1000000));
  options.threads = internal::count(values, "threads", 1);
  options.use_segmentation = !values["no-segmentation"].as<bool>();
  internal::read_number(values, "feature-angle", 0., 180., true, options.feature_angle);
  if(values.count("feature-angle") != 0 && !(options.feature_angle > 0.))
    throw Usage_error("--feature-angle must be above 0 and at most 180");
  if(options.feature_angle >= 180.)
    options.feature_angle = 181.; // folds that lie flat upon themselves turn by 180
  options.fit = values["fit"].as<bool>();
  options.protect = values["protect"].as<bool>();
  internal::read_repair(values, options.repair);
  options.transfer = values["transfer"].as<bool>();
  options.check = values["check"].as<bool>();
  options.quiet = values["quiet"].as<bool>();
  return options;
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTIONS_H
