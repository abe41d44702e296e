// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INTERRUPTION_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INTERRUPTION_H

#include "system.h"

#include <array>
#include <csignal>
#include <cstddef>
#include <list>
#include <stdexcept>
#include <string>

namespace command_line {

namespace internal {

// What a handler of signals may look at: neither containers nor locks
inline std::array<const char* volatile, 16> temporary_files{};
inline volatile std::sig_atomic_t number_of_temporary_files = 0;

extern "C" inline void remove_temporary_files_and_end(int signal)
{
  for(int i = 0; i < number_of_temporary_files; ++i)
    remove_file(temporary_files[static_cast<std::size_t>(i)]);
  std::signal(signal, SIG_DFL);
  std::raise(signal); // whoever waits for the program is to see how it ended
}

} // namespace internal

// While it lives, a signal that ends the program (Ctrl-C, `kill`, the terminal closed) takes the temporary files with
// it. Signals that whoever started the program chose to ignore stay ignored.
class Interruption
{
public:
  Interruption()
  {
    for(const int signal : signals_that_end())
      if(std::signal(signal, internal::remove_temporary_files_and_end) == SIG_IGN)
        std::signal(signal, SIG_IGN);
    ignore_limit_of_file_size(); // writing fails then, which is told
  }

  ~Interruption()
  {
    for(const int signal : signals_that_end())
      if(std::signal(signal, SIG_DFL) == SIG_IGN)
        std::signal(signal, SIG_IGN);
    internal::number_of_temporary_files = 0;
  }

  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  void add(const std::string& file)
  {
    const auto number = static_cast<std::size_t>(internal::number_of_temporary_files);
    if(number == internal::temporary_files.size())
      throw std::length_error("too many files");
    m_files.push_back(file);
    internal::temporary_files[number] = m_files.back().c_str();
    internal::number_of_temporary_files = static_cast<std::sig_atomic_t>(number + 1);
  }

  // What follows must not end half way, and takes no time.
  void ignore_from_now_on() const
  {
    for(const int signal : signals_that_end())
      std::signal(signal, SIG_IGN);
  }

private:
  std::list<std::string> m_files; // the handler has their addresses
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_INTERRUPTION_H
