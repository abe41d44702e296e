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

#include <ctime>
#include <string>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Tells the visitor of the stages, asks it whether to go on, and takes the time.
template <class Visitor>
class Stage_clock
{
public:
  Stage_clock(Visitor& visitor, Summary& summary) : m_visitor(visitor), m_summary(summary), m_start(std::clock())
  {
    m_summary.seconds.reserve(
        16); // the last stage is entered after the output has changed, when nothing may fail any more
  }

  // Begins a stage, at which this part of the whole work is done, and ends the one before.
  void stage(const std::string& name, double done)
  {
    stop();
    m_name = name;
    m_visitor.stage(name);
    if(!go_on(done))
      give_up();
  }

  bool go_on(double done) { return m_visitor.progress(done); }

  [[noreturn]] void give_up() const
  {
    throw Remeshing_error("geodesic remeshing: stopped by the visitor in stage " + m_name);
  }

  void stop()
  {
    const std::clock_t now = std::clock();
    if(!m_name.empty())
      m_summary.seconds.emplace_back(m_name, static_cast<double>(now - m_start) / CLOCKS_PER_SEC);
    m_start = now;
  }

private:
  Visitor& m_visitor;
  Summary& m_summary;
  std::string m_name;
  std::clock_t m_start;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_STAGE_CLOCK_H
