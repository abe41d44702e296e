// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_CLOCK_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_CLOCK_H

#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <time.h>
#include <functional>
#include <string>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Processor seconds of the calling thread, or where the system does not tell those, of the whole program
inline double thread_seconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  std::timespec time;
  if(clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
#endif
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Tells the visitor of the stages, asks it whether to go on, and takes the time: that of the processor, which does not
// depend on what else the machine does; with several threads that would be the sum of theirs, and what counts is what
// passes.
class Stage_clock
{
public:
  template <class Visitor>
  Stage_clock(Visitor& visitor, Summary& summary, const bool is_parallel)
    : m_visit_stage([&visitor](const std::string& name) { visitor.stage(name); }),
      m_visit_progress([&visitor](const double done) { return static_cast<bool>(visitor.progress(done)); }),
      m_summary(summary), m_is_parallel(is_parallel), m_start(now())
  {
    m_summary.seconds.reserve(16); // the last stage ends after the output has changed, when nothing may fail any more
  }

  // The stages from here on are done once more: their time counts for the one that is on, and the visitor is only asked
  // whether to go on.
  void repeat(const bool does_repeat) { m_does_repeat = does_repeat; }
  bool is_stopped() const { return m_is_stopped; }

  // Begins a stage, at which this part of the whole work is done, and ends the one before.
  void stage(const std::string& name, double done)
  {
    if(!m_does_repeat)
    {
      stop();
      m_name = name;
      m_visit_stage(name);
    }
    if(!go_on(done))
      give_up();
  }

  bool go_on(double done)
  {
    m_done = (std::max)(m_done, done);
    m_is_stopped = true; // also if it throws
    m_is_stopped = !m_visit_progress(m_done);
    return !m_is_stopped;
  }

  [[noreturn]] void give_up() const
  {
    throw Remeshing_error("geodesic remeshing: stopped by the visitor in stage " + m_name);
  }

  void stop()
  {
    const double time = now();
    if(!m_name.empty())
      m_summary.seconds.emplace_back(m_name, time - m_start);
    m_start = time;
  }

private:
  double now() const
  {
    if(!m_is_parallel)
      return thread_seconds();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  const std::function<void(const std::string&)> m_visit_stage; // whatever the visitor's type: else all stages would
  const std::function<bool(double)> m_visit_progress;          // be compiled again for each
  Summary& m_summary;
  const bool m_is_parallel;
  std::string m_name;
  double m_start;
  double m_done = 0.; // the largest that the visitor has been told
  bool m_does_repeat = false;
  bool m_is_stopped = false;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_CLOCK_H
