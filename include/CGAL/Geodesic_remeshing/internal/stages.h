// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_STAGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_STAGES_H

#include <CGAL/Geodesic_remeshing/internal/Component_extent.h>
#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>
#include <CGAL/Geodesic_remeshing/internal/Vertex_order.h>
#include <CGAL/Geodesic_remeshing/internal/cut_along_lines.h>
#include <CGAL/Geodesic_remeshing/internal/cut_surface.h>
#include <CGAL/Geodesic_remeshing/internal/find_roots.h>
#include <CGAL/Geodesic_remeshing/internal/line_regions.h>
#include <CGAL/Geodesic_remeshing/internal/make_working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/march_from_lines.h>
#include <CGAL/Geodesic_remeshing/internal/region_sweep.h>
#include <CGAL/Geodesic_remeshing/internal/triangulate_strips.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The small steps between the stages, so that the front door holds nothing but their order.

// Gives back what no later stage reads: on a large mesh each array counts.
template <class... Made>
void release(Made&... made)
{
  ((made = Made()), ...);
}

inline std::vector<double> distances_in(const Fast_marching& marching, const Mesh& mesh)
{
  std::vector<double> result;
  result.reserve(mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
    result.push_back(marching.distance(v));
  return result;
}

// The components of a surface, closed ones apart from those with boundary, and where their fronts start
struct Fronts_and_components
{
  std::vector<std::uint32_t> component_of;
  std::vector<Vertex> closed, open; // vertices
  std::vector<Vertex> roots;        // of the closed components
  std::vector<Vertex> starts;       // on a line of each of the others
};

// Marches from roots in closed components, from lines in those with boundary.
inline Fronts_and_components march_from_roots_and_lines(const Mesh& mesh, const std::vector<char>& is_corner,
                                                        Fast_marching& marching)
{
  Fronts_and_components result;
  std::size_t number;
  result.component_of = components_of(mesh, number);
  std::vector<char> is_open(number, 0);
  for(Edge e : mesh.edges())
    if(mesh.is_border(e))
      is_open[result.component_of[mesh.vertex(e, 0)]] = 1;
  for(Vertex v : mesh.vertices())
    (is_open[result.component_of[v]] ? result.open : result.closed).push_back(v);
  if(!result.closed.empty())
    for(Vertex r : find_roots(mesh, marching.triangulation(), result.component_of, number))
      if(!is_open[result.component_of[r]])
        result.roots.push_back(r);
  for(Vertex r : result.roots)
    marching.add_source(r);
  marching.march(Front_shape::circular);
  if(result.open.empty())
    return result;
  const std::vector<Line_piece> boundary = trace_lines(
      mesh, [&](Edge e) { return mesh.is_border(e); }, [&](Vertex v) { return is_corner[v] && turns_at(mesh, v); });
  result.starts = Line_fronts(mesh, result.component_of, number, boundary).march(marching);
  return result;
}

inline Segmentation segment(const Mesh& mesh, Fast_marching& marching, const std::vector<double>& distance,
                            const Fronts_and_components& fronts, double curve_distance, bool use_segmentation)
{
  Segmentation result;
  if(!fronts.closed.empty())
  {
    const Vertex_order order = order_vertices(mesh, distance, fronts.roots, fronts.closed);
    result = use_segmentation ? segment(mesh, marching, distance, order, curve_distance)
                              : one_region(mesh, distance, order, fronts.roots.front(), curve_distance);
  }
  if(!fronts.open.empty())
  {
    add_line_regions(distance, fronts.starts, fronts.open, fronts.component_of, curve_distance, result);
    const Vertex_order order = order_vertices(mesh, distance, fronts.starts, fronts.open);
    for(Vertex v : Region_sweep(mesh, distance, order, curve_distance).run(nullptr))
      if(is_pointed(mesh, v, curve_distance))
        result.tips.push_back(v);
  }
  return result;
}

// ---- for those who want to look at the stages

inline void keep_working_surface(const Mesh& mesh, const std::vector<double>& distance, Stage_results* results)
{
  if(results == nullptr)
    return;
  results->working_surface = Mesh();
  for(Vertex v : mesh.vertices())
    results->working_surface.add_vertex(mesh.point(v));
  for(Face f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    results->working_surface.add_face(v[0], v[1], v[2]);
  }
  auto map = results->working_surface.add_property_map<Vertex, double>("v:distance", 0.).first;
  for(Vertex v : mesh.vertices())
    map[v] = distance[v];
}

inline void keep_regions(const Mesh& mesh, const Segmentation& segmentation, Stage_results* results)
{
  if(results != nullptr)
    results->regions = cut_along_regions(mesh, segmentation);
}

inline void keep_curves(const Mesh& mesh, const Level_curves& curves, Stage_results* results)
{
  if(results == nullptr)
    return;
  results->curves.clear();
  for(const Level_curve& curve : curves.curves)
  {
    std::vector<Point> polyline;
    for(std::size_t i = curve.begin; i < curve.end; ++i)
      polyline.push_back(point_at(mesh, curves.points[i]));
    if(curve.is_closed)
      polyline.push_back(polyline.front());
    results->curves.push_back(polyline);
  }
}

inline void keep_samples(const std::vector<Sample>& samples, Stage_results* results)
{
  if(results == nullptr)
    return;
  results->samples.clear();
  for(const Sample& s : samples)
    results->samples.push_back(s.point);
}

inline void keep_strips(const Mesh& mesh, Stage_results* results)
{
  if(results != nullptr)
    results->strips = mesh;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_STAGES_H
