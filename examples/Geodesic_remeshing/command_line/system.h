// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SYSTEM_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SYSTEM_H

// The few questions to the operating system that the standard library has no answer to.

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

#include <cstdio>
#include <cstdlib>
#include <string>

namespace command_line {

inline bool standard_error_is_a_terminal()
{
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(2) != 0;
#endif
}

// Neither moves the cursor nor has colors
inline bool terminal_is_dumb()
{
  const char* const terminal = std::getenv("TERM");
  return terminal != nullptr && std::string(terminal) == "dumb";
}

inline bool standard_error_is_a_terminal_with_colors()
{
  const char* const no_color = std::getenv("NO_COLOR"); // any value but an empty one turns them off
  return standard_error_is_a_terminal() && !terminal_is_dumb() && (no_color == nullptr || *no_color == '\0');
}

// Bytes come and go through standard input and standard output as they are.
inline void set_binary(std::FILE* stream)
{
#ifdef _WIN32
  _setmode(_fileno(stream), _O_BINARY);
#else
  (void)stream;
#endif
}

inline std::string process_id()
{
#ifdef _WIN32
  return std::to_string(_getpid());
#else
  return std::to_string(getpid());
#endif
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SYSTEM_H
