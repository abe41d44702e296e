// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_FILE_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_FILE_H

#include "system.h"

#include <CGAL/IO/helpers.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>

namespace command_line {

// The format that the ending of a name tells, in small letters
inline std::string format_of(const std::string& file_name)
{
  return CGAL::IO::internal::get_file_extension(file_name);
}

// A file to read from as often as one likes. Standard input ("-") and pipes are kept in memory for that.
class Input_file
{
public:
  // The ending of the name tells the format if it is empty.
  Input_file(const std::string& name, const std::string& format)
    : m_name(name == "-" ? "standard input" : name), m_format(format.empty() ? format_of(name) : format)
  {
    if(name == "-")
    {
      set_binary(stdin);
      keep(std::cin);
    }
    else if(is_stream(name))
    {
      std::ifstream in(name, std::ios::binary);
      keep(in);
    }
  }

  const std::string& name() const { return m_name; } // for messages
  const std::string& format() const { return m_format; }

  std::unique_ptr<std::istream> open() const
  {
    if(m_contents)
      return std::make_unique<std::istringstream>(*m_contents);
    return std::make_unique<std::ifstream>(m_name, std::ios::binary);
  }

private:
  static bool is_stream(const std::string& name)
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(name, error);
    return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status);
  }

  void keep(std::istream& in)
  {
    m_contents = std::make_shared<std::string>(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }

  std::string m_name;
  std::string m_format;
  std::shared_ptr<const std::string> m_contents;
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INPUT_FILE_H
