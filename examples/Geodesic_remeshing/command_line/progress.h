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

#include <iostream>
#include <string>

namespace command_line {

// The visitor of the remeshing: a bar on the terminal
class Progress
{
public:
  explicit Progress(bool quiet) : m_shown(!quiet && standard_error_is_a_terminal() && !terminal_is_dumb()) {}
  ~Progress() { erase(); }

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name)
  {
    m_stage = name;
    show();
  }

  bool progress(double done)
  {
    m_done = done;
    show();
    return true;
  }

private:
  void show()
  {
    constexpr int width = 30;
    const int percent = static_cast<int>(100. * m_done);
    if(!m_shown || (percent == m_percent && m_stage == m_shown_stage))
      return;
    m_percent = percent;
    m_shown_stage = m_stage;
    const int full = percent * width / 100;
    const std::string bar = std::string(full, '#') + std::string(width - full, ' ');
    std::cerr << "\r\033[K[" << bar << "] " << percent << " % " << m_stage << std::flush;
  }

  void erase() const
  {
    if(m_shown)
      std::cerr << "\r\033[K" << std::flush;
  }

  bool m_shown;
  double m_done = 0.;
  int m_percent = -1;
  std::string m_stage;
  std::string m_shown_stage;
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_PROGRESS_H
