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

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
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
  std::string input;
  std::string output;
  std::optional<std::size_t> vertices; // exactly one of these three is set
  std::optional<std::size_t> faces;
  std::optional<double> edge_length;
  unsigned int iterations = 3;
  bool use_segmentation = true;
  bool quiet = false;
  std::string report; // empty: none
  std::string regions;
  std::string curves;
};

namespace internal {

namespace po = boost::program_options;

inline po::options_description visible_options()
{
  po::options_description options("Options", 100);
  // clang-format off
  options.add_options()
    ("vertices", po::value<long long>()->value_name("N"), "exactly N vertices")
    ("faces", po::value<long long>()->value_name("N"), "N faces")
    ("edge-length", po::value<double>()->value_name("L"), "edges about as long as L")
    ("no-segmentation", po::bool_switch(), "one region: curves around the root all over the surface")
    ("iterations", po::value<long long>()->value_name("K"), "rounds of improvement (3)")
    ("report", po::value<std::string>()->value_name("FILE.json"), "write quality, counts and times")
    ("regions", po::value<std::string>()->value_name("FILE.ply"), "write the surface with the region of each face")
    ("curves", po::value<std::string>()->value_name("FILE.obj"), "write the equidistant curves")
    ("quiet", po::bool_switch(), "no progress, no table")
    ("help", po::bool_switch(), "print this and end")
    ("version", po::bool_switch(), "print the version and end");
  // clang-format on
  return options;
}

inline po::variables_map parse(int argc, const char* const* argv)
{
  po::options_description all = visible_options();
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

inline void print_help(std::ostream& out)
{
  out << "Usage: geodesic_remesh INPUT OUTPUT (--vertices N | --faces N | --edge-length L) [options]\n\n"
         "Remeshes the closed triangle mesh INPUT and writes the result to OUTPUT. The ending of a file name\n"
         "tells its format: .off, .obj, .ply, .stl, .ts.\n\n"
      << internal::visible_options()
      << "\nExit status: 0 done, 1 wrong usage, 2 INPUT unreadable or unusable, 3 could not remesh or write.\n";
}

// What the arguments ask for, or nothing if they asked for --help or --version, which is answered here.
inline std::optional<Options> read_options(int argc, const char* const* argv, const std::string& version)
{
  const auto values = internal::parse(argc, argv);
  if(values["help"].as<bool>())
  {
    print_help(std::cout);
    return std::nullopt;
  }
  if(values["version"].as<bool>())
  {
    std::cout << version << "\n";
    return std::nullopt;
  }
  Options options;
  options.input = internal::file_name(values, "input");
  options.output = internal::file_name(values, "output");
  if(options.input.empty() || options.output.empty())
    throw Usage_error("INPUT and OUTPUT are needed (see --help)");
  internal::read_target(values, options);
  if(const auto iterations = internal::count(values, "iterations", 0))
    options.iterations = static_cast<unsigned int>((std::min<std::size_t>)(*iterations, 1000000));
  options.use_segmentation = !values["no-segmentation"].as<bool>();
  options.quiet = values["quiet"].as<bool>();
  options.report = internal::file_name(values, "report");
  options.regions = internal::file_name(values, "regions");
  options.curves = internal::file_name(values, "curves");
  return options;
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTIONS_H
