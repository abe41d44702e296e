// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_COMPARE_SURFACES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_COMPARE_SURFACES_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/self_intersections.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Judges a remeshing by its two meshes alone: nothing here knows how it was made.

struct Shape
{
  std::size_t components = 0, boundary_loops = 0;
  std::ptrdiff_t euler_characteristic = 0;

  std::ptrdiff_t twice_genus() const
  {
    return 2 * static_cast<std::ptrdiff_t>(components) - static_cast<std::ptrdiff_t>(boundary_loops) -
           euler_characteristic;
  }
};

inline Shape shape_of(const Mesh& mesh)
{
  Shape shape;
  std::vector<std::size_t> component(mesh.number_of_faces());
  shape.components = Polygon_mesh_processing::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), CGAL::get(boost::face_index, mesh)));
  std::vector<char> seen(mesh.number_of_halfedges(), 0);
  for(Halfedge start : mesh.halfedges())
  {
    if(!mesh.is_border(start) || seen[start])
      continue;
    ++shape.boundary_loops;
    for(Halfedge h = start; !seen[h]; h = mesh.next(h))
      seen[h] = 1;
  }
  shape.euler_characteristic = euler_characteristic(mesh);
  return shape;
}

template <class Concurrency_tag>
std::size_t number_of_self_intersections(const Mesh& mesh)
{
  return self_intersections<Concurrency_tag>(mesh.faces(), mesh).size();
}

class Surface_comparison
{
public:
  Surface_comparison(const Mesh& input, const Mesh& output, const Concurrency concurrency)
    : m_input(input), m_output(output), m_concurrency(concurrency), m_input_shape(shape_of(input)),
      m_output_shape(shape_of(output))
  {
    const Bbox_3 box = Polygon_mesh_processing::bbox(input);
    m_diagonal = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
    for(const double x : {box.xmin(), box.xmax(), box.ymin(), box.ymax(), box.zmin(), box.zmax()})
      m_largest_coordinate = (std::max)(m_largest_coordinate, std::abs(x));
    // A face of hardly any area has no plane to project on: the tree would tell any distance. It is nowhere far from
    // its edges.
    std::vector<Face> solid;
    std::vector<Edge> edges_of_others;
    for(Face f : input.faces())
      if(is_thin(input, f))
        for(Halfedge h : input.halfedges_around_face(input.halfedge(f)))
          edges_of_others.push_back(input.edge(h));
      else
        solid.push_back(f);
    m_input_faces.rebuild(solid.begin(), solid.end(), input);
    m_edges_of_thin_faces.rebuild(edges_of_others.begin(), edges_of_others.end(), input);
    m_input_faces.build(); // here, and not with the first question, which several threads may ask at the same time
    m_edges_of_thin_faces.build();
  }

  const Shape& input_shape() const { return m_input_shape; }
  const Shape& output_shape() const { return m_output_shape; }

  // What the rounding of its coordinates may take a point off the surface: some units of the last place
  double distance_of_rounding() const
  {
    return relative(8. * std::numeric_limits<double>::epsilon() * m_largest_coordinate);
  }

  double distance_of_vertices() const
  {
    const auto largest_of = [&](const std::size_t begin, const std::size_t end) {
      double largest = 0.;
      for(std::size_t i = begin; i < end; ++i)
        largest = (std::max)(largest, squared_distance_from_input(m_output.point(Vertex(index_type(i)))));
      return largest;
    };
    const double largest = parallel_reduce(
        m_concurrency, m_output.number_of_vertices(), 0., largest_of,
        [](const double x, const double y) { return (std::max)(x, y); }, questions_of_a_block);
    return relative(std::sqrt(largest));
  }

  std::size_t number_of_degenerate_faces() const
  {
    const auto all = m_output.faces();
    return std::count_if(all.begin(), all.end(), [&](Face f) { return is_degenerate(m_output, f); });
  }

  // Against the input where the centre is nearest and at each corner: where two sheets are close together the nearest
  // may be the other one for some of them.
  std::size_t number_of_flipped_faces() const
  {
    const auto number_of = [&](const std::size_t begin, const std::size_t end) {
      std::size_t number = 0;
      for(std::size_t i = begin; i < end; ++i)
        number += is_flipped(Face(index_type(i)));
      return number;
    };
    return parallel_reduce(m_concurrency, m_output.number_of_faces(), std::size_t(0), number_of, std::plus<>(),
                           questions_of_a_block);
  }

  // As a part of the diagonal of the input's box
  double relative(double distance) const { return m_diagonal > 0. ? distance / m_diagonal : distance; }
  double diagonal() const { return m_diagonal; }

private:
  using Primitive = AABB_face_graph_triangle_primitive<Mesh>;
  using Edge_tree = AABB_tree<AABB_traits_3<Kernel, AABB_halfedge_graph_segment_primitive<Mesh>>>;

  // A search in the tree takes microseconds.
  static constexpr std::size_t questions_of_a_block = 256;

  static Mesh::size_type index_type(const std::size_t i) { return static_cast<Mesh::size_type>(i); }

  double squared_distance_from_input(const Point& p) const
  {
    double nearest = infinity;
    if(!m_input_faces.empty())
      nearest = m_input_faces.squared_distance(p);
    if(!m_edges_of_thin_faces.empty())
      nearest = (std::min)(nearest, m_edges_of_thin_faces.squared_distance(p));
    return nearest;
  }

  bool is_flipped(const Face f) const
  {
    const auto v = vertices_of(m_output, f);
    const Vector normal = normal_of(m_output, f);
    bool result = is_against(normal, CGAL::centroid(m_output.point(v[0]), m_output.point(v[1]), m_output.point(v[2])));
    for(Vertex w : v)
      result = result && is_against(normal, m_output.point(w));
    return result;
  }

  static bool is_degenerate(const Mesh& mesh, Face f)
  {
    const auto v = vertices_of(mesh, f);
    return CGAL::collinear(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
  }

  static bool is_thin(const Mesh& mesh, Face f)
  {
    double longest = 0.;
    for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      longest = (std::max)(longest, CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
    return !(normal_of(mesh, f).squared_length() >
             1e-20 * longest * longest); // its height is 1e-10 of its longest edge
  }

  static Vector normal_of(const Mesh& mesh, Face f)
  {
    const auto v = vertices_of(mesh, f);
    return cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0]));
  }

  // Whether all of the input where it is nearest to p looks the other way: at a crease, where features are, that is
  // several faces, of which the search finds any one.
  bool is_against(const Vector& normal, const Point& p) const
  {
    if(m_input_faces.empty())
      return false;
    const auto is_face_against = [&](const Face f) { return normal * normal_of(m_input, f) < 0.; };
    const auto nearest = m_input_faces.closest_point_and_primitive(p);
    if(!is_face_against(nearest.second))
      return false;
    const double near = 1e-9 * m_diagonal; // as vertices are
    const Vector way(near, near, near);
    std::vector<Face> faces;
    m_input_faces.all_intersected_primitives(Kernel::Iso_cuboid_3(nearest.first - way, nearest.first + way),
                                             std::back_inserter(faces));
    return std::all_of(faces.begin(), faces.end(), is_face_against);
  }

  const Mesh& m_input;
  const Mesh& m_output;
  const Concurrency m_concurrency;
  const Shape m_input_shape, m_output_shape;
  double m_diagonal, m_largest_coordinate = 0.;
  AABB_tree<AABB_traits_3<Kernel, Primitive>> m_input_faces;
  Edge_tree m_edges_of_thin_faces;
};

// The marks of the user's edges, by edge of the internal mesh, which has its edges in the same order
template <class TriangleMesh, class NamedParameters>
std::vector<char> constrained_edges_of(const TriangleMesh& tmesh, const Mesh& mesh, const NamedParameters& np)
{
  std::vector<char> result(mesh.number_of_edges(), 0);
  if constexpr(is_given<NamedParameters, internal_np::edge_is_constrained_t>)
  {
    const auto& map = CGAL::parameters::get_parameter_reference(np, internal_np::edge_is_constrained);
    std::size_t i = 0;
    for(auto e : edges(tmesh))
      result[i++] = get(map, e);
  }
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_COMPARE_SURFACES_H
