// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HELP_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HELP_H

#include "option_list.h"

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What the program tells about itself: --help and --generate
namespace command_line {

namespace internal {

constexpr const char* usage = "geodesic_remesh INPUT OUTPUT (--vertices N | --faces N | --edge-length L) [options]";

constexpr const char* description =
    "Remeshes the triangle mesh INPUT and writes the result to OUTPUT: well-shaped triangles on the same surface, with exactly the "
    "number of vertices asked for. The ending of a file name tells its format: .off, .obj, .ply, .stl, .ts. The name - is standard "
    "input or standard output; OUTPUT then has the format of INPUT unless told otherwise, and the table goes to standard error.";

// what it does, and how to call it
inline const std::vector<std::pair<std::string, std::string>>& usage_examples()
{
  static const std::vector<std::pair<std::string, std::string>> examples = {
      {"5000 vertices", "geodesic_remesh bear.off out.off --vertices 5000"},
      {"smaller triangles where the surface bends", "geodesic_remesh bear.off out.ply --vertices 5000 --contrast 0.5"},
      {"a machine part, its edges kept, with a report",
       "geodesic_remesh part.stl out.obj --edge-length 2 --feature-angle 60 --report part.json"},
      {"texture and all", "geodesic_remesh head.obj out.obj --faces 20000 --transfer"},
      {"between two programs",
       "gunzip -c bear.off.gz | geodesic_remesh - - --input-format off --vertices 5000 --quiet | gzip >out.off.gz"}};
  return examples;
}

inline const std::vector<std::pair<int, std::string>>& exit_statuses()
{
  static const std::vector<std::pair<int, std::string>> statuses = {{0, "done"},
                                                                    {1, "wrong usage"},
                                                                    {2, "INPUT unusable"},
                                                                    {3, "could not remesh or write"},
                                                                    {4, "--check found a fault"}};
  return statuses;
}

// Lines of at most `width` characters, each after the first with `indent` blanks before it
inline std::string wrapped(const std::string& text, std::size_t width, std::size_t indent)
{
  std::istringstream words(text);
  std::string result;
  std::size_t length = 0;
  for(std::string word; words >> word; length += word.size())
  {
    if(length > 0 && length + 1 + word.size() > width)
    {
      result += "\n" + std::string(indent, ' ');
      length = 0;
    }
    if(length > 0)
    {
      result += ' ';
      ++length;
    }
    result += word;
  }
  return result;
}

inline std::string option_and_value(const po::option_description& option, const std::string& between)
{
  std::string text = short_name(option).empty() ? std::string() : short_name(option) + ", ";
  text += "--" + option.long_name();
  return has_value(option) ? text + between + value_name(option) : text;
}

} // namespace internal

inline void print_help(std::ostream& out)
{
  constexpr std::size_t width = 100, column = 26;
  out << "Usage: " << internal::usage << "\n\n" << internal::wrapped(internal::description, width, 0) << "\n";
  for(const auto& group : option_groups())
  {
    out << "\n" << group.caption << ":\n";
    for(const auto& option : group.options.options())
    {
      const std::string name = "  " + internal::option_and_value(*option, " ");
      const bool fits = name.size() + 2 <= column;
      out << name << (fits ? std::string(column - name.size(), ' ') : "\n" + std::string(column, ' '))
          << internal::wrapped(option->description(), width - column, column) << "\n";
    }
  }
  out << "\nExamples:\n";
  for(const auto& [what, command] : internal::usage_examples())
    out << "  # " << what << "\n  " << command << "\n";
  out << "\nExit status:";
  for(const auto& [status, meaning] : internal::exit_statuses())
    out << (status == 0 ? " " : ", ") << status << " " << meaning;
  out << ".\n";
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HELP_H
