// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_RUN_STAGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_RUN_STAGES_H

#include <CGAL/Geodesic_remeshing/internal/Conflict_sizing.h>
#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Face_division.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/Line_densities.h>
#include <CGAL/Geodesic_remeshing/internal/Stage_surfaces.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_budget.h>
#include <CGAL/Geodesic_remeshing/internal/badness.h>
#include <CGAL/Geodesic_remeshing/internal/fit_surface.h>
#include <CGAL/Geodesic_remeshing/internal/improve.h>
#include <CGAL/Geodesic_remeshing/internal/sample_surface.h>
#include <CGAL/Geodesic_remeshing/internal/size_field.h>
#include <CGAL/Geodesic_remeshing/internal/stages.h>
#include <CGAL/Geodesic_remeshing/internal/triangulate_strips.h>
#include <CGAL/Geodesic_remeshing/internal/unpack_parameters.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// What the stages work on
struct Stages_work
{
  Mesh& surface; // its metric is set for each run
  const Constraints& constraints;
  const Options& options;
  bool wants_regions; // found out at the end
};

// What they make
struct Stages_run
{
  std::size_t number_of_vertices = 0;
  double edge_length = 0.;
  Stage_surfaces surfaces;
  Segmentation segmentation;
  Placed_mesh remeshed;
  Conflict_places conflicts; // that are left
  std::size_t number_of_regions = 0, number_of_curves = 0, number_of_strips = 0;
};

// From the goal to the improved mesh
template <class Clock>
void run_stages(const Stages_work& work, const Any_target& target, const Goal& goal, Clock& clock, Stage_results* kept,
                Stages_run& run)
{
  Mesh& surface = work.surface;
  const Constraints& constraints = work.constraints;
  const Options& options = work.options;

  clock.stage("refinement", .05);
  Stage_surfaces& surfaces = run.surfaces;
  check_resolution(surface, goal.mean_edge_length);
  surfaces.refine(surface, constraints, longest_working_edge * goal.mean_edge_length);
  std::vector<Line_piece> lines = trace_marked_lines(surfaces.whole(), constraints);
  Line_densities(surfaces.whole(), goal.mean_edge_length, lines).run(.5 * static_cast<double>(goal.number_of_vertices));
  const Vertex_budget budget = make_budget(target, surfaces.whole(), goal.number_of_vertices, lines, constraints);
  const std::size_t n = run.number_of_vertices = budget.number_of_vertices;
  const double edge_length = run.edge_length = budget.edge_length;
  const double curve_distance =
      std::sqrt(.75) * budget.curve_edge_length; // the height of an equilateral triangle (paper, section 4)

  std::vector<char> is_corner = constraints.is_corner;
  surfaces.cut(is_corner, work.wants_regions);
  const Mesh& mesh = surfaces.mesh_of_pieces();

  clock.stage("distances", .1);
  auto triangulation = std::make_unique<const Intrinsic_triangulation>(mesh, options.concurrency);
  auto marching_memory = std::make_unique<Fast_marching>(*triangulation);
  Fast_marching& marching = *marching_memory;
  Fronts_and_components fronts = march_from_roots_and_lines(mesh, is_corner, marching);
  std::vector<double> distance = distances_in(marching, mesh);
  keep_working_surface(mesh, distance, kept);

  clock.stage("regions", .2);
  Segmentation& segmentation = run.segmentation;
  segmentation = segment(mesh, marching, distance, fronts, curve_distance, options.use_segmentation);
  keep_regions(mesh, segmentation, kept);
  run.number_of_regions = segmentation.regions.size();
  Line_samples on_lines;
  if(!lines.empty())
    on_lines.distance = distances_from_lines(mesh, marching, 2. * edge_length);
  release(marching_memory, triangulation); // the largest of what the stages make
  release(distance, fronts.component_of, fronts.closed, fronts.open);

  clock.stage("curves", .3);
  Level_curves curves = Curve_tracer(mesh, segmentation).trace();
  keep_curves(mesh, curves, kept);
  run.number_of_curves = curves.curves.size();

  clock.stage("samples", .35);
  Working_surface& working = surfaces.working();
  on_lines.samples = Line_sampler(surface, working).run(constraints, lines, budget.spacing_on_lines);
  std::vector<Sample> samples;
  parallel_invoke(
      options.concurrency,
      [&] {
        samples = sample_surface(surface, surfaces.pieces(), segmentation, curves, on_lines, fronts.roots,
                                 budget.curve_edge_length, n, options.concurrency);
      },
      [&] { run.number_of_strips = find_strips(mesh, curves).second; });
  keep_samples(samples, kept);
  release(curves, on_lines);
  if(!work.wants_regions)
  {
    release(segmentation);
    surfaces.release_pieces();
  }

  clock.stage("strips", .45);
  Placed_mesh& remeshed = run.remeshed;
  triangulate_strips(surface, working, std::move(samples), edge_length, remeshed, options.concurrency);
  keep_strips(remeshed.mesh, kept);

  clock.stage("improvement", .55);
  bool goes_on = true;
  const double end_of_improvement = options.do_project ? .95 : .75;
  run.conflicts = improve(surface, remeshed.mesh, remeshed.place, remeshed.pinned, remeshed.constrained, constraints,
                          options.improvement(n, edge_length), [&](double done) {
                            return goes_on = goes_on && clock.go_on(.55 + (end_of_improvement - .55) * done);
                          });
  if(!goes_on)
    clock.give_up();
  check_count(remeshed.mesh, n);
}

// What is asked of the angles of a run's mesh
struct Angles
{
  double worst = 0.;     // badness
  bool are_poor = false; // where limbs are thinner than edges are long
};

inline Angles angles_of(const Mesh& mesh)
{
  static const double poor = badness_of_angle(30.);
  Angles result;
  std::size_t number = 0;
  for(const Face f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    const Vector a = mesh.point(v[1]) - mesh.point(v[0]), b = mesh.point(v[2]) - mesh.point(v[0]);
    const double badness = triangle_badness(a.squared_length(), b.squared_length(), (b - a).squared_length(),
                                            cross_product(a, b).squared_length());
    result.worst = (std::max)(result.worst, badness);
    number += badness > poor;
  }
  result.are_poor = 4 * number > mesh.number_of_faces();
  return result;
}

// Where triangles as large as these are in conflict smaller ones are tried, at the cost of others, until there are no
// conflicts left or that does not help any more: fewer conflicts at the cost of some angles, but not of any. `wishes`
// and `limits` are those of the first run, which is the best so far, and the number of vertices remains its own.
template <class Clock>
void avoid_conflicts(const Stages_work& work, const Any_target& target, const std::vector<double>& wishes,
                     const Sizing_limits& limits, Clock& clock, Stage_results* kept, std::unique_ptr<Stages_run>& best)
{
  static const double poor = badness_of_angle(10.);
  Conflict_places conflicts = best->conflicts;
  Angles angles = angles_of(best->remeshed.mesh);
  const std::size_t n = best->number_of_vertices;
  const int runs = n <= 4000 ? 6 : n <= 20000 ? 3 : 2; // each takes its time
  Conflict_sizing sizing(work.surface, wishes, limits);
  clock.repeat(true);
  for(int i = 0; i < runs && !conflicts.places.empty(); ++i)
  {
    sizing.shorten(conflicts.places);
    auto run = std::make_unique<Stages_run>();
    Stage_results stages;
    try
    {
      const Goal goal = set_goal(target, sizing.wishes(), sizing.limits(), work.surface);
      run_stages(work, target, goal, clock, kept == nullptr ? kept : &stages, *run);
    }
    catch(const Remeshing_error&) // so small they cannot be
    {
      if(clock.is_stopped())
        throw;
      break;
    }
    conflicts = run->conflicts;
    const Angles others = angles_of(run->remeshed.mesh);
    if(conflicts.number >= best->conflicts.number || others.worst > (std::max)(angles.worst, poor))
    {
      if(angles.are_poor)
        break;
      continue;
    }
    angles = others;
    best = std::move(run);
    if(kept != nullptr)
      *kept = std::move(stages);
  }
  clock.repeat(false);
}

// The stage after them, if vertices may leave the surface
template <class Clock>
void fit(const Stages_work& work, Clock& clock, Stages_run& run, Summary& summary)
{
  clock.stage("fitting", .75);
  bool goes_on = true;
  const Fit_result fit =
      fit_surface(work.surface, work.constraints, run.edge_length, run.remeshed,
                  [&](const double done) { return goes_on = goes_on && clock.go_on(.75 + .2 * done); });
  if(!goes_on)
    clock.give_up();
  summary.rms_distance = fit.root_mean_square;
  summary.largest_distance = fit.largest;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_RUN_STAGES_H
