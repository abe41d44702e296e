// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_COMPILED_STAGES_H
#define GEODESIC_REMESHING_TEST_COMPILED_STAGES_H

#include <CGAL/geodesic_remeshing.h>

#include <memory>
#include <vector>

// The stages are compiled once, in compiled_stages.cpp, and not again in each of our programs: that takes a third off
// the time of most compilations. A program of yours that calls CGAL::geodesic_remeshing() in several files can do the
// same.

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

#ifndef GEODESIC_REMESHING_COMPILE_STAGES
#define GEODESIC_REMESHING_COMPILE_STAGES extern
#endif

GEODESIC_REMESHING_COMPILE_STAGES template void run_stages(const Stages_work&, const Any_target&, const Goal&,
                                                           Stage_clock&, Stage_results*, Stages_run&);
GEODESIC_REMESHING_COMPILE_STAGES template void avoid_conflicts(const Stages_work&, const Any_target&,
                                                                const std::vector<double>&, const Sizing_limits&,
                                                                Stage_clock&, Stage_results*,
                                                                std::unique_ptr<Stages_run>&);
GEODESIC_REMESHING_COMPILE_STAGES template void fit(const Stages_work&, Stage_clock&, Stages_run&, Summary&);
GEODESIC_REMESHING_COMPILE_STAGES template Goal set_goal_of_fit(const Any_target&, Mesh&);

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // GEODESIC_REMESHING_TEST_COMPILED_STAGES_H
