// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_IMPROVE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_IMPROVE_H

#include <CGAL/Geodesic_remeshing/internal/Angle_relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/Conflict_refinement.h>
#include <CGAL/Geodesic_remeshing/internal/Conflict_search.h>
#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Deviation_descent.h>
#include <CGAL/Geodesic_remeshing/internal/Deviation_relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/Intersection_repair.h>
#include <CGAL/Geodesic_remeshing/internal/Line_fit.h>
#include <CGAL/Geodesic_remeshing/internal/Nearest_vertices.h>
#include <CGAL/Geodesic_remeshing/internal/Polish.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/Tip_recovery.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_count.h>
#include <CGAL/Geodesic_remeshing/internal/quadric_relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/relaxation.h>
#include <CGAL/Geodesic_remeshing/internal/remove_defects.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/internal/write_back.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

struct Improvement_parameters
{
  std::size_t number_of_vertices;
  double edge_length;
  std::size_t number_of_iterations = 3;
  bool use_defect_moves = true;
  double nearness = 0.; // what it is worth to be near to the surface, see GeodesicRemeshingSizingField
  Block_size block_size = Block_size();
};

// Rounds of flips and steps. After the first, when the energies mean something, and before the others, which mend what
// it does, the number of vertices is set.
template <class Progress>
bool make_regular(Remeshed_surface& remeshed, const Improvement_parameters& parameters, const Progress& go_on)
{
  for(std::size_t i = 0; i < parameters.number_of_iterations; ++i)
  {
    flip_to_regular_valences(remeshed);
    relax(remeshed);
    if(i == 0)
      Vertex_count(remeshed, parameters.edge_length).reach(parameters.number_of_vertices);
    if(!go_on(static_cast<double>(i + 1) / parameters.number_of_iterations))
      return false;
  }
  return true;
}

// Returns the quadrics, which serve for the steps to come. They may be those from before vertices were sent: where
// these are now they stay.
inline std::vector<Quadric> recover_tips(Remeshed_surface& remeshed, const double tolerance)
{
  const Nearest_vertices nearest(remeshed);
  Tip_recovery(remeshed).run(nearest, tolerance);
  std::vector<Quadric> planes = quadrics(remeshed, nearest);
  relax_with_quadrics(remeshed, planes);
  return planes;
}

// Takes out or divides what flips and steps cannot mend, and puts as many vertices in or takes them out elsewhere;
// last, only moves and flips. Returns whether anything was to be done.
inline bool mend_angles(Remeshed_surface& remeshed, const Improvement_parameters& parameters)
{
  std::size_t before = (std::numeric_limits<std::size_t>::max)();
  for(int round = 0; round < 3; ++round)
  {
    Polish polish(remeshed);
    const std::size_t number = polish.run(badness_of_angle(remeshed.has_lines() ? 30. : 34.), true);
    if(number == 0)
      return round > 0;
    Vertex_count(remeshed, parameters.edge_length, remeshed.has_lines() ? 10. : 30.)
        .reach(parameters.number_of_vertices);
    flip_to_regular_valences(remeshed);
    relax(remeshed);
    if(!polish.is_worth_going_on(number, before))
      break;
    before = number;
  }
  return true;
}

// Again and again, because what parts one pair may bring another together; then at the cost of tips, last of angles.
// What that cost is mended where it brings no pair back. A surface that intersects itself leaves as many pairs as
// before, whatever is done. Returns whether none is known to be left.
inline bool part_intersections(Remeshed_surface& remeshed)
{
  constexpr std::size_t many = 100;
  const std::array<double, 5> angles = {{36., 30., 30., 25., 20.}};
  std::size_t before = (std::numeric_limits<std::size_t>::max)();
  Intersection_repair repair(remeshed);
  for(std::size_t i = 0; i < angles.size(); ++i)
  {
    const std::size_t number = repair.run(badness_of_angle(angles[i]), i > 0);
    if(number == 0)
    {
      if(i > 0)
        Polish(remeshed).run_apart(badness_of_angle(40.));
      return true;
    }
    if(number > many && number > before - before / 20)
      return false;
    before = number;
  }
  return false;
}

// Tips and defects hinder each other: a pinned tip stops the pairs that glide, and the steps between their sweeps
// shorten the tips. So the tips are sought first, when a lost one is still near, and hold what is around them while the
// first sweeps mend it; sought again, as the last sweeps start from what is around them but move them too; and in the
// end only those are sent back that were lost by much.
template <class Progress>
bool recover_tips_and_remove_defects(Remeshed_surface& remeshed, const Improvement_parameters& parameters,
                                     const Progress& go_on)
{
  // Below the first a deviation is that of any triangle on a curved surface; at .15 the tips sent did more harm than
  // good.
  const double tolerance = .35 * parameters.edge_length, last_tolerance = .45 * parameters.edge_length;
  const double leash = .3 * parameters.edge_length;
  const Search_effort effort = search_effort(remeshed, parameters.number_of_vertices);
  std::vector<Quadric> planes = recover_tips(remeshed, tolerance);
  if(mend_angles(remeshed, parameters))
    planes = quadrics(remeshed, Nearest_vertices(remeshed)); // the vertices are others now
  if(parameters.use_defect_moves)
  {
    if(!remove_defects(remeshed, Defect_moves(remeshed, leash, effort), Sweeps::first, planes,
                       [&](const double progress) { return go_on(.5 * progress); }))
      return false;
    planes = recover_tips(remeshed, tolerance);
    remeshed.keep_tips_on_leash(leash);
    remeshed.energy().let_numbers_count(true);
    if(!remove_defects(remeshed, Defect_moves(remeshed, leash, effort), Sweeps::last, planes,
                       [&](const double progress) { return go_on(.5 + .5 * progress); }))
      return false;
  }
  // The quadric steps between the last sweeps have followed the surface at the cost of angles. There they get a step of
  // their own: a fifth of a degree in the mean, for one percent of the RMS distance.
  if(is_moderate(remeshed, parameters.number_of_vertices))
    relax(remeshed);
  recover_tips(remeshed, last_tolerance);
  remeshed.keep_tips_on_leash(leash);
  return true;
}

// Where far more vertices are needed than asked for, at handles and thin places, no later stage takes them away either.
inline bool is_out_of_reach(Remeshed_surface& remeshed, const Improvement_parameters& parameters)
{
  const std::size_t wanted = parameters.number_of_vertices;
  return remeshed.connectivity().number_of_vertices() > wanted + wanted / 20 + 4 &&
         !Vertex_count(remeshed, parameters.edge_length).reach_at_any_cost(wanted);
}

// On a small mesh many angles are below 40 degrees, and flips for all of them would cost a third of what the searches
// gained. On one of moderate size they cost a tenth; nearly all of that is kept if first whatever leaves the valences
// as they are is done. There the aim is a degree higher, since what mends a triangle may bend the next.
inline void polish(Remeshed_surface& remeshed, const std::size_t number_of_vertices)
{
  const auto polish = [&](const double angle, const bool keep_regular) {
    constexpr int rounds = 3;
    std::size_t before = (std::numeric_limits<std::size_t>::max)(), number = 0;
    for(int i = 0; i < rounds; ++i, before = number)
    {
      Polish polish(remeshed, keep_regular);
      number = polish.run(badness_of_angle(angle), false);
      if(!polish.is_worth_going_on(number, before))
        break;
    }
  };
  if(is_moderate(remeshed, number_of_vertices))
    polish(41., true);
  polish(is_moderate(remeshed, number_of_vertices) ? 41. : 40., is_small(remeshed, number_of_vertices));
}

// Means of six to nine models: the mean smallest angle .5 degrees larger at 10,000 vertices, .9 at 5,000 and 1.2 at
// 1,000, the RMS distance 1 to 2 percent less. A third sweep at 10,000 would gain .1 degrees. Sweeps that ask for the
// deviations, as those of sizings, gain no more and take twice the time.
inline void relax_angles(Remeshed_surface& remeshed, const std::vector<Quadric>& planes,
                         const std::size_t number_of_vertices, const bool on_lines = false)
{
  const double good = badness_of_angle(40.);
  if(number_of_vertices < 10000)
    for(const double part : {.15, .07})
      relax_angles(remeshed, planes, good, part, on_lines);
  for(const double part : {.1, .05})
    relax_angles(remeshed, planes, good, part, on_lines);
}

// Returns the conflicts that are left, without faces where another attempt is not worth it: if they are too many, or
// the input's own.
template <class Progress>
Conflicts improve(Remeshed_surface& remeshed, const Improvement_parameters& parameters, const Progress& go_on)
{
  const double share = parameters.use_defect_moves ? .3 : .9;
  if(!make_regular(remeshed, parameters, [&](const double progress) { return go_on(share * progress); }) ||
     is_out_of_reach(remeshed, parameters))
    return {};
  if(!recover_tips_and_remove_defects(remeshed, parameters,
                                      [&](const double progress) { return go_on(share + (.9 - share) * progress); }))
    return {};
  // Once more, on the cells as they are now: nearer to hollows.
  const Nearest_vertices nearest(remeshed);
  const std::vector<Quadric> planes = quadrics(remeshed, nearest);
  relax_with_quadrics(remeshed, planes);
  Line_fit(remeshed, parameters.edge_length, tolerated_badness()).run();
  polish(remeshed, parameters.number_of_vertices);
  // The polish moves what is on lines as well.
  Line_fit(remeshed, parameters.edge_length, badness_of_angle(40.)).run();
  // On homer, elephant, armadillo, fandisk and dino with a sizing of contrast .5 and 5,000 vertices worths of .25, .4,
  // .55, .7 and 1 made the RMS distance 15, 20, 23, 25 and 27 percent less, and the mean angle .9 and .4 degrees more,
  // the same, .4 and 1.1 degrees less. The descent at the largest deviations comes after, as these
  // steps do not ask for the input's vertices.
  // Where there are lines a sweep of them for uniform meshes too, with angles worth more: on fandisk and anchor_dense
  // the sweeps for angles make the RMS distance a seventh more. So these then move only what lies in a plane, where the
  // other does nothing if no part of the surface is curved.
  const bool is_uniform = remeshed.metric().is_uniform();
  Deviation_relaxation deviation_relaxation(remeshed, nearest, badness_of_angle(40.));
  if(parameters.nearness > 0.)
    deviation_relaxation.run(.7 * parameters.nearness, 1e-6 * parameters.edge_length, {.15, .08, .04});
  else if(is_uniform && !remeshed.has_lines())
    relax_angles(remeshed, planes, parameters.number_of_vertices);
  else if(is_uniform)
  {
    if(parameters.number_of_vertices < 10000)
      deviation_relaxation.run(.1, 1e-6 * parameters.edge_length, {.06});
    relax_angles(remeshed, planes, parameters.number_of_vertices);
  }
  // A hundredth of the vertices: with twice as many the Hausdorff distance is nearly the same, and the mean angle .2
  // degrees less. With a sizing, which may have seen to the deviations and has spent angles, half as many. A sphere of
  // a thousand vertices deviates by a fiftieth of an edge.
  Deviation_descent(remeshed, nearest, badness_of_angle(40.))
      .run(parameters.number_of_vertices / (is_uniform ? 100 : 200), .02 * parameters.edge_length);
  // What lies in a plane again, now along straight lines, too: not before, where other angles would lead the descent
  // elsewhere. With features, on a hundred models of 500 and of 5,000 vertices, the mean angle is .3 and .1 degrees
  // larger.
  if(is_uniform && remeshed.has_lines())
    relax_angles(remeshed, planes, parameters.number_of_vertices, true);
  Conflicts conflicts;
  if(!part_intersections(remeshed) || !find_turned_faces(remeshed).empty())
    conflicts = Conflict_refinement(remeshed, parameters.edge_length).run(parameters.number_of_vertices);
  if(remeshed.connectivity().number_of_vertices() != parameters.number_of_vertices)
  {
    Vertex_count(remeshed, parameters.edge_length).reach_at_any_cost(parameters.number_of_vertices);
    conflicts = conflicts_worth_mending(remeshed, parameters.number_of_vertices);
  }
  go_on(1.);
  return conflicts;
}

// The last stage, section 6 of the paper and beyond: makes the valences regular, the angles even and the number of
// vertices the one asked for. Of the pinned vertices corners stay where they are and the others near, the topology
// stays what it is, every vertex stays on the surface, and every edge that is `constrained` on its line: a vertex with
// such edges that is not pinned slides along them. Of the `constraints` the corners tell where lines end.
// `go_on(progress)`, progress from 0 to 1, stops the work by returning false; then, as at the end, `out` is a valid
// mesh, but its number of vertices may be another one, as it is where the topology does not allow the one asked for.
// Without iterations only the number of vertices is set, to show what the stages before made. Returns where faces that
// intersect or are turned over are left, if another attempt is worth it.
template <class Progress>
Conflict_places improve(const Mesh& surface, Mesh& out, Mesh::Property_map<Vertex, Place> place,
                        Mesh::Property_map<Vertex, bool> pinned, Mesh::Property_map<Edge, bool> constrained,
                        const Constraints& constraints, const Improvement_parameters& parameters, Progress&& go_on)
{
  const Surface_walker walker(surface, constraints, parameters.block_size.concurrency);
  Remeshed_surface remeshed(walker, constraints, out, place, pinned, constrained, parameters.block_size);
  Conflicts conflicts;
  if(parameters.number_of_iterations == 0)
    Vertex_count(remeshed, parameters.edge_length).reach(parameters.number_of_vertices);
  else
    conflicts = improve(remeshed, parameters, go_on);
  write_back(remeshed, out, place, pinned, constrained);
  return places_of(remeshed, conflicts);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_IMPROVE_H
