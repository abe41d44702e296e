// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_GENERATE_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_GENERATE_H

#include "help.h"

#include <ostream>
#include <string>

// The texts that are installed beside the program, made from the list of the options: a man page and completions for
// two shells.
namespace command_line {

namespace internal {

// What has a meaning of its own in roff is written another way.
inline std::string roff(const std::string& text)
{
  std::string result;
  for(const char c : text)
    result += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
  return !result.empty() && (result[0] == '.' || result[0] == '\'') ? "\\&" + result : result;
}

inline void print_man_options(std::ostream& out)
{
  for(const auto& group : option_groups())
  {
    out << ".SS " << roff(group.caption) << "\n";
    for(const auto& option : group.options.options())
    {
      const std::string name = short_name(*option).empty() ? std::string() : short_name(*option) + ", ";
      out << ".TP\n\\fB" << roff(name + "--" + option->long_name()) << "\\fR";
      if(has_value(*option))
        out << " \\fI" << roff(value_name(*option)) << "\\fR";
      out << "\n" << roff(option->description()) << "\n";
    }
  }
}

inline void print_man_page(std::ostream& out, const std::string& version)
{
  out << ".TH GEODESIC_REMESH 1 \"\" \"" << roff(version) << "\" \"User Commands\"\n"
      << ".SH NAME\ngeodesic_remesh \\- remeshes a triangle mesh to an exact number of vertices\n"
      << ".SH SYNOPSIS\n.B geodesic_remesh\n.I INPUT OUTPUT\n"
      << "(\\fB\\-\\-vertices\\fR \\fIN\\fR | \\fB\\-\\-faces\\fR \\fIN\\fR | \\fB\\-\\-edge\\-length\\fR \\fIL\\fR)\n"
      << "[\\fIoptions\\fR]\n"
      << ".SH DESCRIPTION\n"
      << roff(description) << "\n"
      << ".PP\nThe files appear as a whole or not at all. An error is one line on standard error.\n"
      << ".SH OPTIONS\n";
  print_man_options(out);
  out << ".SH EXIT STATUS\n";
  for(const auto& [status, meaning] : exit_statuses())
    out << ".TP\n" << status << "\n" << roff(meaning) << "\n";
  out << ".SH ENVIRONMENT\n.TP\nNO_COLOR\nif set and not empty, errors have no color on a terminal\n"
      << ".SH EXAMPLES\n";
  for(const auto& [what, command] : usage_examples())
    out << ".TP\n" << roff(what) << "\n" << roff(command) << "\n";
}

// The words to offer after an option, or what the shell calls for files
inline std::string bash_offer(const po::option_description& option)
{
  const std::string value = value_name(option);
  std::string words;
  if(value.rfind("FILE", 0) == 0)
    return "COMPREPLY=($(compgen -f -- \"$current\"))";
  if(value.find('|') == std::string::npos)
    return "COMPREPLY=()";
  for(const std::string& word : alternatives(value))
    words += (words.empty() ? "" : " ") + word;
  return "COMPREPLY=($(compgen -W '" + words + "' -- \"$current\"))";
}

inline void print_bash_completion(std::ostream& out)
{
  std::string all;
  out << "_geodesic_remesh()\n{\n  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  case $previous in\n";
  for(const auto& group : option_groups())
    for(const auto& option : group.options.options())
    {
      all += (all.empty() ? "--" : " --") + option->long_name();
      if(has_value(*option))
        out << "    --" << option->long_name() << ") " << bash_offer(*option) << "; return ;;\n";
    }
  out << "  esac\n  case $current in\n"
      << "    -*) COMPREPLY=($(compgen -W '" << all << "' -- \"$current\")) ;;\n"
      << "    *) COMPREPLY=($(compgen -f -- \"$current\")) ;;\n  esac\n}\n"
      << "complete -o filenames -F _geodesic_remesh geodesic_remesh\n";
}

// In the words of _arguments: '--name[what it does]:value:what to offer'; two names of which one will do are
// '(-n --name)'{-n,--name}'[what it does]'
inline std::string zsh_argument(const po::option_description& option)
{
  std::string text;
  for(const char c : option.description())
    text += c == '\''                          ? std::string("'\\''")
            : c == '[' || c == ']' || c == ':' ? std::string("\\") + c
                                               : std::string(1, c);
  const std::string name = "--" + option.long_name(), other = short_name(option);
  text =
      (other.empty() ? "'" + name : "'(" + other + " " + name + ")'{" + other + "," + name + "}'") + "[" + text + "]";
  if(!has_value(option))
    return text + "'";
  const std::string value = value_name(option);
  if(value.rfind("FILE", 0) == 0)
    return text + ":file:_files'";
  if(value.find('|') == std::string::npos)
    return text + ":" + value + ": '";
  std::string words;
  for(const std::string& word : alternatives(value))
    words += (words.empty() ? "" : " ") + word;
  return text + ":word:(" + words + ")'";
}

inline void print_zsh_completion(std::ostream& out)
{
  out << "#compdef geodesic_remesh\n_arguments";
  for(const auto& group : option_groups())
    for(const auto& option : group.options.options())
      out << " \\\n  " << zsh_argument(*option);
  out << " \\\n  '1:input:_files' \\\n  '2:output:_files'\n";
}

} // namespace internal

// One of `generated_texts`
inline void generate(const std::string& text, std::ostream& out, const std::string& version)
{
  if(text == "man")
    internal::print_man_page(out, version);
  else if(text == "complete-bash")
    internal::print_bash_completion(out);
  else
    internal::print_zsh_completion(out);
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_GENERATE_H
