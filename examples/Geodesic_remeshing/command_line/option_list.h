// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTION_LIST_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTION_LIST_H

#include <boost/program_options.hpp>

#include <string>
#include <vector>

// What there is to choose, once for all: the parser, --help, the man page and the completions of the shells are made
// from this list.
namespace command_line {

namespace po = boost::program_options;

// A group of options under one heading. The name of a value tells the shells what to offer: files if it begins with
// FILE, words if it is a list of them with | between.
struct Option_group
{
  std::string caption;
  po::options_description options;
};

constexpr const char* mesh_formats = "off|obj|ply|stl|ts";
constexpr const char* generated_texts = "man|complete-bash|complete-zsh";

namespace internal {

// clang-format off
inline Option_group target_options()
{
  Option_group group{"Target, exactly one of these", {}};
  group.options.add_options()
    ("vertices", po::value<long long>()->value_name("N"), "exactly N vertices")
    ("faces", po::value<long long>()->value_name("N"), "N faces, of a closed surface an even number")
    ("edge-length", po::value<double>()->value_name("L"), "edges about as long as L");
  return group;
}

inline Option_group sizing_options()
{
  Option_group group{"Sizing", {}};
  group.options.add_options()
    ("contrast", po::value<double>()->value_name("C"), "edges shorter where the surface bends: 0 uniform, 0.5 usual, up to 2")
    ("gaussian-weight", po::value<double>()->value_name("A"), "weight of the Gaussian curvature (0.5); needs --contrast")
    ("mean-weight", po::value<double>()->value_name("B"), "weight of the mean curvature (0.5); needs --contrast")
    ("sizing", po::value<std::string>()->value_name("FILE"), "length of the edges at each vertex of INPUT, up to a common factor: "
     "text with one number a vertex, or PLY with a vertex property \"sizing\"")
    ("gradation", po::value<double>()->value_name("G"), "largest growth of the edges along the surface (0.12)")
    ("min-length", po::value<double>()->value_name("L"), "no edges aim at less than L")
    ("max-length", po::value<double>()->value_name("L"), "no edges aim at more than L");
  return group;
}

inline Option_group input_options()
{
  Option_group group{"Input", {}};
  group.options.add_options()
    ("input-format", po::value<std::string>()->value_name(mesh_formats), "format of INPUT, whatever its name ends with")
    ("feature-angle", po::value<double>()->value_name("DEG"), "keep edges where the surface turns by DEG degrees or more, and corners; 180: not even the long creases of an input of few faces")
    ("protect", po::bool_switch(), "keep the boundary, and features if sought, exactly, with all their vertices and edges")
    ("no-repair", po::bool_switch(), "refuse an INPUT that is no mesh as it is")
    ("stitch", po::value<double>()->value_name("TOLERANCE"), "join vertices of the boundary of INPUT no farther than TOLERANCE from others or from edges of it")
    ("drop-parts", po::value<double>()->value_name("PERCENT"), "leave out parts of INPUT with less than PERCENT of its area, not the largest")
    ("fill-holes", po::value<long long>()->value_name("EDGES"), "close holes of INPUT with at most EDGES edges");
  return group;
}

inline Option_group method_options()
{
  Option_group group{"Method", {}};
  group.options.add_options()
    ("fit", po::bool_switch(), "let the vertices leave the surface, so that OUTPUT as a whole is nearest to INPUT; edges are shorter where it "
     "bends, unless a sizing tells how long")
    ("no-segmentation", po::bool_switch(), "one region: curves around the root all over the surface")
    ("iterations", po::value<long long>()->value_name("K"), "rounds of improvement (3)");
  return group;
}

inline Option_group output_options()
{
  Option_group group{"Output", {}};
  group.options.add_options()
    ("output-format", po::value<std::string>()->value_name(mesh_formats), "format of OUTPUT, whatever its name ends with")
    ("transfer", po::bool_switch(), "carry over what INPUT has beside its mesh: properties of vertices and faces from PLY to "
     "PLY, colors and texture coordinates, their seams kept, from OBJ to OBJ")
    ("check", po::bool_switch(), "check the result against INPUT and tell what holds and what does not; exit status 4 where something does not")
    ("report", po::value<std::string>()->value_name("FILE.json"), "write quality, counts and times")
    ("html", po::value<std::string>()->value_name("FILE.html"), "write a page to look at: both meshes, histograms, tables")
    ("regions", po::value<std::string>()->value_name("FILE.ply"), "write the surface with the region of each face")
    ("curves", po::value<std::string>()->value_name("FILE.obj"), "write the equidistant curves")
    ("quiet,q", po::bool_switch(), "no progress, no table, no hints, nothing about repairs");
  return group;
}

inline Option_group other_options()
{
  Option_group group{"Other", {}};
  group.options.add_options()
    ("threads", po::value<long long>()->value_name("T"), "work with at most T threads (all processors); the result is the same")
    ("help,h", po::bool_switch(), "print this and end")
    ("version", po::bool_switch(), "print the version and end")
    ("generate", po::value<std::string>()->value_name(generated_texts), "print the man page or the completion of a shell, and end");
  return group;
}
// clang-format on

} // namespace internal

inline std::vector<Option_group> option_groups()
{
  return {internal::target_options(), internal::sizing_options(), internal::input_options(),
          internal::method_options(), internal::output_options(), internal::other_options()};
}

inline bool has_value(const po::option_description& option)
{
  return option.semantic()->max_tokens() > 0;
}

inline std::string value_name(const po::option_description& option)
{
  return has_value(option) ? option.semantic()->name() : std::string();
}

// "-q" or nothing
inline std::string short_name(const po::option_description& option)
{
  const std::string name = option.canonical_display_name(po::command_line_style::allow_dash_for_short);
  return name.size() == 2 ? name : std::string();
}

// The words of a list with | between; one word if there is none
inline std::vector<std::string> alternatives(const std::string& list)
{
  std::vector<std::string> words(1);
  for(const char c : list)
    if(c == '|')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_OPTION_LIST_H
