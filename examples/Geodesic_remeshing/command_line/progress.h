// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_PROGRESS_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_PROGRESS_H

#include "system.h"

#include <csignal>
#include <iostream>
#include <string>

namespace command_line {

namespace internal {

inline volatile std::sig_atomic_t interrupted = 0;

} // namespace internal

// The visitor of the remeshing: a bar on the terminal, and an orderly end (nothing written, nothing left behind) when the
// user presses Ctrl-C.
class Progress
{
public:
  explicit Progress(bool quiet)
    : shown_(!quiet && standard_error_is_a_terminal())
  {
    std::signal(SIGINT, [](int) { internal::interrupted = 1; });
  }

  ~Progress()
  {
    std::signal(SIGINT, SIG_DFL);
    erase();
  }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name)
  {
    stage_ = name;
    show(0.);
  }

  bool progress(double done)
  {
    show(done);
    return internal::interrupted == 0;
  }

private:
  void show(double done)
  {
    constexpr int width = 30;
    const int full = static_cast<int>(done * width);
    if (!shown_ || (full == full_ && stage_ == shown_stage_))
      return;
    full_ = full;
    shown_stage_ = stage_;
    const std::string bar = std::string(full, '#') + std::string(width - full, ' ');
    std::cerr << "\r\033[K[" << bar << "] " << stage_ << std::flush;
  }

  void erase() const
  {
    if (shown_)
      std::cerr << "\r\033[K" << std::flush;
  }

  bool shown_;
  int full_ = -1;
  std::string stage_;
  std::string shown_stage_;
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_PROGRESS_H
