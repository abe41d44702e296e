// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_assignment.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_probes.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_relocation.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_steps.h>
#include <CGAL/Geodesic_remeshing/internal/Intersection_repair.h>
#include <CGAL/Geodesic_remeshing/internal/Intersection_search.h>
#include <CGAL/Geodesic_remeshing/internal/Point_grid.h>
#include <CGAL/Geodesic_remeshing/internal/Polish.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/fit_samples.h>
#include <CGAL/Geodesic_remeshing/internal/self_intersections.h>
#include <CGAL/Geodesic_remeshing/internal/triangulate_strips.h>
#include <CGAL/Geodesic_remeshing/internal/write_back.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// From so many times the root mean square on a deviation is a place that needs another vertex. The smaller, the more
// valences are irregular.
constexpr double too_large_deviation = 6.;

// How near a fitted mesh has come, in both directions
struct Fit_result
{
  double root_mean_square = 0., largest = 0.;
};

// Of the vertices that the improvement pinned only the corners may not move: tips are where there is most to fit.
inline void pin_corners(const Mesh& surface, const Constraints& constraints, Placed_mesh& mesh)
{
  for(const Vertex v : mesh.mesh.vertices())
    mesh.pinned[v] = is_at_corner(surface, constraints, mesh.place[v]);
}

// Leaves nothing below the angle promised and nothing that intersects, where that can be had by steps back to the
// surface and along it.
inline void mend_fit(Remeshed_surface& remeshed)
{
  constexpr int rounds = 3;
  const double badness = badness_of_angle(30.5);
  for(int round = 0; round < rounds && Polish(remeshed).run(badness, false) > 0; ++round)
    ;
  Intersection_repair repair(remeshed);
  for(int round = 0; round < rounds && repair.run(badness) > 0; ++round)
    ;
}

// Where two sheets are nearer to each other than the steps are long one may pierce the other. The vertices there go
// back to the surface, where the sheets are apart, and stay on it.
inline void hold_what_intersects(Remeshed_surface& remeshed, Fit_steps& steps)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const double limit = fit_badness();
  for(const Intersection_search::Pair& pair : Intersection_search(remeshed).run())
    for(const Lean_triangulation::Index f : {pair.first, pair.second})
      for(Lean_triangulation::Index h = 4 * f; h < 4 * f + 3; ++h)
      {
        const Lean_triangulation::Index v = table.source(h);
        steps.hold(v);
        if(!remeshed.is_free(v))
          continue;
        const Remeshed_surface::Spot spot = remeshed.spot_after(v, Vector(0., 0., 0.));
        if(Vertex_ring(remeshed, v).badness(spot, limit) <= limit)
          remeshed.put(v, spot);
      }
}

// Rounds of steps: at first by the squares of the deviations, then with more and more weight on the largest.
template <class Progress>
bool run_fit(Remeshed_surface& remeshed, Fit_steps& steps, Fit_relocation& relocation, const Progress& go_on)
{
  // With 20 rounds the distances are 2 percent less.
  constexpr int rounds = 9, plain_rounds = 3;
  // Deviations count as large from so many times the root mean square on. The smaller, the more of the angles is spent
  // on the largest.
  constexpr double large = 4.;
  for(int round = 0; round < rounds; ++round)
  {
    if(round >= plain_rounds)
      steps.cost().set_tolerance(large * steps.root_mean_square());
    if(round % 3 == 2)
      hold_what_intersects(remeshed, steps);
    steps.move_all();
    if(round % 2 == 1)
    {
      steps.flip_all();
      if(round >= plain_rounds)
        relocation.run(too_large_deviation * steps.root_mean_square());
    }
    if(!go_on(double(round + 1) / rounds))
      return false;
  }
  return true;
}

inline std::vector<Lean_triangulation::Index> intersecting_faces(const Remeshed_surface& remeshed)
{
  std::vector<Lean_triangulation::Index> result;
  for(const Intersection_search::Pair& pair : Intersection_search(remeshed).run())
    result.insert(result.end(), {pair.first, pair.second});
  return result;
}

// Marks the vertices of the mesh from which a fit began that are near to faces which it has spoilt.
inline void mark_around(const std::vector<Lean_triangulation::Index>& faces, const Remeshed_surface& fitted,
                        const Remeshed_surface& start, const double edge_length, std::vector<char>& is_marked)
{
  // With 1 and 2 edge lengths more is frozen than need be: Hausdorff distances of dino and camel are a quarter to a
  // half larger.
  const double radius = .5 * edge_length;
  Point_grid grid(radius, 3 * faces.size());
  for(const Lean_triangulation::Index f : faces)
    for(Lean_triangulation::Index h = 4 * f; h < 4 * f + 3; ++h)
    {
      const Remeshed_surface::Spot& spot = fitted.spot(fitted.connectivity().source(h));
      grid.insert(spot.point, spot.size, f);
    }
  is_marked.resize(start.connectivity().vertex_slots(), 0);
  for(Lean_triangulation::Index v = 0; v < start.connectivity().vertex_slots(); ++v)
  {
    const Remeshed_surface::Spot& spot = start.spot(v);
    grid.near(spot.point, spot.size, radius * spot.size,
              [&](std::uint32_t, const Point&, double) { is_marked[v] = 1; });
  }
}

// Brings a remeshed surface as near to the input as its number of vertices and angles of 30 degrees allow. Its vertices
// leave the surface for it, and keep the places that they are nearest to. `go_on(progress)` stops the work by returning
// false. Where the result intersects itself more than the mesh that came, all is done again, with those parts on the
// surface, then without them. Not if the input and the mesh that came do so: what is near to such an input intersects
// itself as well.
template <class Progress>
Fit_result fit_surface(const Mesh& surface, const Constraints& constraints, const double edge_length, Placed_mesh& out,
                       const Progress& go_on)
{
  constexpr double samples_per_face = 4.; // with 6 and 10 the distances are the same within 1 percent
  constexpr int attempts = 3;
  pin_corners(surface, constraints, out);
  const Surface_walker walker(surface, constraints);
  const Remeshed_surface start(walker, constraints, out.mesh, out.place, out.pinned, out.constrained);
  const double area = std::sqrt(3.) / 4. * CGAL::square(edge_length) / samples_per_face;
  const std::vector<Fit_sample> samples = make_fit_samples(walker, start.metric(), area);
  const std::size_t intersections_at_start = intersecting_faces(start).size();
  std::vector<char> is_marked;
  const std::vector<char> none;
  for(int attempt = 1;; ++attempt)
  {
    Remeshed_surface remeshed(walker, constraints, out.mesh, out.place, out.pinned, out.constrained);
    Fit_assignment assignment(remeshed, samples, CGAL::square(.2 * edge_length));
    Fit_probes probes(remeshed, CGAL::square(.5 * edge_length));
    Fit_steps steps(remeshed, assignment, probes, edge_length, attempt == attempts ? is_marked : none);
    for(Lean_triangulation::Index v = 0; v < is_marked.size(); ++v)
      if(is_marked[v])
        steps.hold(v);
    Fit_relocation relocation(remeshed, assignment, probes, steps);
    const bool is_done = run_fit(remeshed, steps, relocation,
                                 [&](const double progress) { return go_on((attempt - 1 + progress) / attempts); });
    if(!is_done)
      return {};
    mend_fit(remeshed);
    // What was mended at the cost of the distance
    assignment.search_all();
    steps.move_all();
    relocation.run(too_large_deviation * steps.root_mean_square());
    steps.move_all();
    mend_fit(remeshed);
    assignment.search_all();
    const std::vector<Lean_triangulation::Index> intersections = intersecting_faces(remeshed);
    if(attempt == attempts || intersections.size() <= intersections_at_start ||
       (intersections_at_start > 0 && !self_intersections(surface.faces(), surface).empty()))
    {
      const Fit_result result{steps.root_mean_square(), relocation.largest_deviation()};
      write_back(remeshed, out.mesh, out.place, out.pinned, out.constrained);
      return result;
    }
    mark_around(intersections, remeshed, start, edge_length, is_marked);
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIT_SURFACE_H
