// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_MESH_QUALITY_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_MESH_QUALITY_H

// How good a triangle mesh is, and how far it is from another one. One and the same code measures what the command-line
// program reports and what the benchmarks compare.

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/centroid.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_invoke.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace mesh_quality {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

struct Quality
{
  std::size_t vertices = 0; // isolated ones are not counted
  std::size_t faces = 0;
  std::size_t components = 0;
  std::size_t genus = 0; // the sum over the components
  std::size_t boundary_loops = 0;
  double min_angle = 180.;       // angles in degrees
  double mean_min_angle = 0.;    // over the faces
  double percent_below_30 = 0.;  // faces with an angle below 30 degrees
  double percent_irregular = 0.; // inner vertices with other than six neighbours
  double diagonal = 0.;          // of the bounding box
};

// Where the small angles are. A face between lines (features, boundary), with all its vertices on them, is small
// because they meet at a small angle or lie nearer to each other than edges are long: it is the model's more than the
// mesh's.
struct Small_angles
{
  std::size_t below_20 = 0;               // faces with an angle below 20 degrees
  std::size_t below_20_between_lines = 0; // those of them that lie between lines
  double min_angle_elsewhere = 180.;      // of the faces that do not
};

// Distances in percent of the diagonal of the reference
struct Distance
{
  double hausdorff_percent = 0.; // the larger of both directions, sampled
  double rms_percent = 0.;       // from the reference to the mesh
  double rms_back_percent = 0.;  // from the mesh to the reference
  double vertices_percent = 0.;  // the farthest vertex of the mesh from the reference
};

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

inline std::array<Point, 3> corners(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {{mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))}};
}

// In degrees, at p
inline double angle(const Point& p, const Point& q, const Point& r)
{
  const double twice_area = std::sqrt(CGAL::cross_product(q - p, r - p).squared_length());
  return std::atan2(twice_area, (q - p) * (r - p)) * 180. / CGAL_PI;
}

inline double smallest_angle(const std::array<Point, 3>& p)
{
  const double twice_area = std::sqrt(CGAL::cross_product(p[1] - p[0], p[2] - p[0]).squared_length());
  double smallest = CGAL_PI;
  for(int i = 0; i < 3; ++i)
    smallest = (std::min)(smallest, std::atan2(twice_area, (p[(i + 1) % 3] - p[i]) * (p[(i + 2) % 3] - p[i])));
  return smallest * 180. / CGAL_PI;
}

// `is_line` tells of an edge whether it lies on a line; those on the boundary do in any case.
template <class IsLine>
Small_angles find_small_angles(const Mesh& mesh, const IsLine& is_line)
{
  std::vector<char> is_on_line(mesh.num_vertices(), 0);
  for(const auto e : mesh.edges())
    if(is_line(e) || mesh.is_border(e))
      is_on_line[mesh.vertex(e, 0).idx()] = is_on_line[mesh.vertex(e, 1).idx()] = 1;
  Small_angles result;
  for(const auto f : mesh.faces())
  {
    const double angle = smallest_angle(corners(mesh, f));
    const auto around = mesh.vertices_around_face(mesh.halfedge(f));
    const bool is_between =
        std::all_of(around.begin(), around.end(), [&](const auto v) { return is_on_line[v.idx()] != 0; });
    result.below_20 += angle < 20.;
    result.below_20_between_lines += angle < 20. && is_between;
    if(!is_between)
      result.min_angle_elsewhere = (std::min)(result.min_angle_elsewhere, angle);
  }
  return result;
}

namespace internal {

inline void measure_angles(const Mesh& mesh, Quality& quality)
{
  std::size_t below_30 = 0;
  for(const auto f : mesh.faces())
  {
    const double angle = smallest_angle(corners(mesh, f));
    quality.min_angle = (std::min)(quality.min_angle, angle);
    quality.mean_min_angle += angle;
    below_30 += angle < 30.;
  }
  quality.mean_min_angle /= static_cast<double>(mesh.number_of_faces());
  quality.percent_below_30 = 100. * static_cast<double>(below_30) / static_cast<double>(mesh.number_of_faces());
}

inline void measure_valences(const Mesh& mesh, Quality& quality)
{
  std::size_t inner = 0;
  std::size_t irregular = 0;
  for(const auto v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
      continue;
    ++quality.vertices;
    if(mesh.is_border(v))
      continue;
    ++inner;
    irregular += mesh.degree(v) != 6;
  }
  quality.percent_irregular = inner == 0 ? 0. : 100. * static_cast<double>(irregular) / static_cast<double>(inner);
}

inline std::size_t number_of_boundary_loops(const Mesh& mesh)
{
  std::vector<bool> seen(mesh.num_halfedges(), false);
  std::size_t loops = 0;
  for(const auto start : mesh.halfedges())
  {
    if(!mesh.is_border(start) || seen[start.idx()])
      continue;
    ++loops;
    for(auto h = start; !seen[h.idx()]; h = mesh.next(h))
      seen[h.idx()] = true;
  }
  return loops;
}

inline void measure_topology(const Mesh& mesh, Quality& quality)
{
  std::vector<std::size_t> ids(mesh.num_faces());
  const auto face_ids = boost::make_function_property_map<Mesh::Face_index>(
      [&ids](Mesh::Face_index f) -> std::size_t& { return ids[f.idx()]; });
  quality.components = CGAL::Polygon_mesh_processing::connected_components(mesh, face_ids);
  quality.boundary_loops = number_of_boundary_loops(mesh);
  // V - E + F = 2 components - 2 genus - loops
  const std::size_t twice_genus = 2 * quality.components + mesh.number_of_edges() - quality.boundary_loops -
                                  quality.vertices - mesh.number_of_faces();
  quality.genus = twice_genus / 2;
}

} // namespace internal

inline Quality measure_quality(const Mesh& mesh)
{
  Quality quality;
  quality.faces = mesh.number_of_faces();
  quality.diagonal = diagonal(mesh);
  internal::measure_angles(mesh, quality);
  internal::measure_valences(mesh, quality);
  internal::measure_topology(mesh, quality);
  return quality;
}

// The points of a surface that are nearest to given ones
class Closest_point
{
  // With its triangle, which building the tree and searching in it ask for again and again
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh, CGAL::Default, CGAL::Tag_true, CGAL::Tag_true>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;

public:
  explicit Closest_point(const Mesh& mesh)
  {
    // A face without area adds nothing to the surface, and has no plane to project on.
    std::vector<Mesh::Face_index> faces;
    faces.reserve(mesh.number_of_faces());
    for(const auto f : mesh.faces())
    {
      const auto p = corners(mesh, f);
      if(!CGAL::collinear(p[0], p[1], p[2]))
        faces.push_back(f);
    }
    m_tree.rebuild(faces.begin(), faces.end(), mesh);
    m_tree.build();
    if(!faces.empty())
      m_last = {corners(mesh, faces.front())[0], faces.front()};
  }

  // Queries are fast when each is near the one before: the answer to that one bounds the search.
  double distance(const Point& query)
  {
    if(m_tree.empty())
      return 0.;
    m_last = m_tree.closest_point_and_primitive(query, m_last);
    return std::sqrt(CGAL::squared_distance(query, m_last.first));
  }

  // Not of an empty mesh
  Mesh::Face_index face(const Point& query)
  {
    m_last = m_tree.closest_point_and_primitive(query, m_last);
    return m_last.second;
  }

private:
  Tree m_tree;
  Tree::Point_and_primitive_id m_last;
};

struct One_sided_distance
{
  double maximum = 0.;
  double root_mean_square = 0.;
};

// In an order in which each is near the one before, whatever that of the mesh is: it makes the queries several times as
// fast.
template <typename Index, typename Point_of_index>
void sort_in_space(std::vector<Index>& indices, const Point_of_index& point_of)
{
  using Item = std::pair<Point, Index>;
  std::vector<Item> items;
  items.reserve(indices.size());
  for(const Index i : indices)
    items.emplace_back(point_of(i), i);
  const CGAL::First_of_pair_property_map<Item> points;
  CGAL::spatial_sort(items.begin(), items.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, std::decay_t<decltype(points)>>(points));
  std::transform(items.begin(), items.end(), indices.begin(), [](const Item& item) { return item.second; });
}

inline double farthest_vertex(const Mesh& from, Closest_point& to, std::size_t largest_number)
{
  const std::size_t stride = 1 + from.number_of_vertices() / largest_number;
  std::vector<Mesh::Vertex_index> vertices;
  std::size_t count = 0;
  for(const auto v : from.vertices())
    if(!from.is_isolated(v) && count++ % stride == 0)
      vertices.push_back(v);
  sort_in_space(vertices, [&](Mesh::Vertex_index v) -> Point { return from.point(v); });
  double farthest = 0.;
  for(const auto v : vertices)
    farthest = (std::max)(farthest, to.distance(from.point(v)));
  return farthest;
}

// Samples at equal steps of area, placed in their faces by a sequence of low discrepancy: no random numbers, so that
// the same meshes give the same figures.
inline std::vector<Point> samples_on(const Mesh& mesh, std::size_t number_of_samples)
{
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  sort_in_space(faces, [&](Mesh::Face_index f) -> Point {
    const auto p = corners(mesh, f);
    return CGAL::centroid(p[0], p[1], p[2]);
  });
  std::vector<double> areas;
  double total_area = 0.;
  for(const auto f : faces)
  {
    const auto p = corners(mesh, f);
    areas.push_back(std::sqrt(CGAL::cross_product(p[1] - p[0], p[2] - p[0]).squared_length()) / 2.);
    total_area += areas.back();
  }
  std::vector<Point> samples;
  samples.reserve(number_of_samples);
  double area_before = 0.;
  std::size_t index = 0;
  for(const auto f : faces)
  {
    const auto p = corners(mesh, f);
    area_before += areas[index++];
    while(samples.size() < number_of_samples && (static_cast<double>(samples.size()) + .5) * total_area <
                                                    area_before * static_cast<double>(number_of_samples))
    {
      // the additive sequence of the plastic number, folded into the triangle
      const auto number = static_cast<double>(samples.size() + 1);
      double u = std::fmod(.7548776662466927 * number, 1.);
      double v = std::fmod(.5698402909980532 * number, 1.);
      if(u + v > 1.)
      {
        u = 1. - u;
        v = 1. - v;
      }
      samples.push_back(p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]));
    }
  }
  return samples;
}

inline One_sided_distance one_sided_distance(const Mesh& from, Closest_point& to, std::size_t number_of_samples)
{
  std::vector<Point> samples = samples_on(from, number_of_samples);
  CGAL::spatial_sort(samples.begin(), samples.end()); // those of one large face are anywhere in it
  One_sided_distance result;
  double sum_of_squares = 0.;
  for(const Point& p : samples)
  {
    const double distance = to.distance(p);
    sum_of_squares += distance * distance;
    result.maximum = (std::max)(result.maximum, distance);
  }
  if(!samples.empty())
    result.root_mean_square = std::sqrt(sum_of_squares / static_cast<double>(samples.size()));
  return result;
}

// With TBB and `CGAL::Parallel_tag` both directions at the same time
template <typename Concurrency_tag = CGAL::Sequential_tag>
Distance measure_distance(const Mesh& reference, const Mesh& mesh, std::size_t number_of_samples = 200000)
{
  const auto measure = [&](const Mesh& from, const Mesh& to, One_sided_distance& distance, double& of_vertices) {
    Closest_point closest_point(to);
    distance = one_sided_distance(from, closest_point, number_of_samples);
    of_vertices = farthest_vertex(from, closest_point, number_of_samples);
  };
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<Concurrency_tag, CGAL::Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  One_sided_distance there, back;
  double vertices_there = 0., vertices_back = 0.;
  const auto measure_there = [&] { measure(reference, mesh, there, vertices_there); };
  const auto measure_back = [&] { measure(mesh, reference, back, vertices_back); };
  if constexpr(std::is_convertible<Concurrency_tag, CGAL::Parallel_tag>::value)
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_invoke(measure_there, measure_back);
#endif
  }
  else
  {
    measure_there();
    measure_back();
  }

  const double to_percent = 100. / diagonal(reference);
  Distance distance;
  distance.hausdorff_percent = to_percent * (std::max)({there.maximum, back.maximum, vertices_there, vertices_back});
  distance.rms_percent = to_percent * there.root_mean_square;
  distance.rms_back_percent = to_percent * back.root_mean_square;
  distance.vertices_percent = to_percent * vertices_back;
  return distance;
}

} // namespace mesh_quality

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_MESH_QUALITY_H
