// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_THREADS_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_THREADS_H

#include "options.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <optional>

namespace command_line {

// Holds the number of threads of the program to what was asked for, as long as it lives.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(const std::optional<std::size_t>& number)
  {
    constexpr std::size_t many = 4096;
    if(number)
      m_limit.emplace(tbb::global_control::max_allowed_parallelism, (std::min)(*number, many));
  }

private:
  std::optional<tbb::global_control> m_limit;
#else
  explicit Thread_limit(const std::optional<std::size_t>& number)
  {
    if(number && *number > 1)
      throw Usage_error("--threads: this program was built without TBB and has one thread");
  }
#endif
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_THREADS_H
