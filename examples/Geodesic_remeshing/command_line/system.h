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

// What the standard library does not know of the operating system.

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#else
#include <unistd.h>
#endif

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

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

// callable from a handler of signals
inline void remove_file(const char* name)
{
#ifdef _WIN32
  _unlink(name);
#else
  unlink(name);
#endif
}

inline std::vector<int> signals_that_end()
{
#ifdef _WIN32
  return {SIGINT, SIGTERM};
#else
  return {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
#endif
}

inline void ignore_limit_of_file_size()
{
#ifndef _WIN32
  std::signal(SIGXFSZ, SIG_IGN);
#endif
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SYSTEM_H
