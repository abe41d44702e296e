// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_THIN_PLACES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_THIN_PLACES_H

#include "options.h"
#include "soup.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace command_line {

// Where faces of the result intersect: because the input does, because sheets of it lie on each other, or because there
// are too few vertices for its walls and gaps. Then there is a number of vertices with which edges are as short as
// these are wide.
class Thin_places
{
  using Kernel = mesh_quality::Kernel;
  using Face = Mesh::Face_index;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;

public:
  Thin_places(const Mesh& input, const Mesh& output) : m_input(input), m_output(output)
  {
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(output.faces(), output,
                                                                                       std::back_inserter(m_pairs));
    if(m_pairs.empty())
      return;
    m_part_of.resize(input.number_of_faces());
    CGAL::Polygon_mesh_processing::connected_components(
        input, boost::make_iterator_property_map(m_part_of.begin(), CGAL::get(boost::face_index, input)));
  }

  // One line, empty where there is nothing to say
  std::string hint(const Options& options, double edge_length) const
  {
    if(m_pairs.empty())
      return "";
    const Tree tree(m_input.faces().begin(), m_input.faces().end(), m_input);
    const std::string pairs = std::to_string(m_pairs.size()) +
                              (m_pairs.size() == 1 ? " pair of faces intersects: " : " pairs of faces intersect: ");
    if(does_input_intersect(tree))
      return pairs + "the input intersects itself there";
    const double width = width_in_edges(tree);
    if(!(width > 0.))
      return pairs + "sheets of the input touch or lie on each other there, which no number of vertices parts";
    if(width > 1.)
      return pairs + "walls or gaps are hardly wider than edges are long there";
    return pairs + "walls or gaps are thinner than edges are long there (about " + finer(options, edge_length, width) +
           ", with edges as short as they are wide, leaves few or none)";
  }

private:
  static constexpr std::size_t most = 1000; // of very many pairs or faces, these tell as much

  std::array<Point, 3> corners(Face f) const
  {
    const auto h = m_output.halfedge(f);
    return {{m_output.point(m_output.source(h)), m_output.point(m_output.target(h)),
             m_output.point(m_output.target(m_output.next(h)))}};
  }

  // Each once; a face may be in hundreds of pairs.
  std::vector<Face> faces_in_pairs() const
  {
    std::vector<Face> faces;
    for(const auto& pair : m_pairs)
      faces.insert(faces.end(), {pair.first, pair.second});
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  bool does_input_intersect(const Tree& tree) const
  {
    const std::vector<Face> faces = faces_in_pairs();
    std::vector<Face> near;
    for(std::size_t i = 0; i < faces.size(); i += 1 + faces.size() / most)
    {
      const auto p = corners(faces[i]);
      tree.all_intersected_primitives(Kernel::Iso_cuboid_3(p[0].bbox() + p[1].bbox() + p[2].bbox()),
                                      std::back_inserter(near));
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<std::pair<Face, Face>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(near, m_input,
                                                                                       std::back_inserter(pairs));
    return !pairs.empty();
  }

  // How far it is from where the face lies to what looks the other way, behind a wall or across a gap, divided by the
  // length of the face's edges. What looks the same way is no wall, unless it is another part.
  double width_at(const Tree& tree, Face f) const
  {
    const auto p = corners(f);
    const auto nearest_point = tree.closest_point_and_primitive(CGAL::centroid(p[0], p[1], p[2]));
    const Point& start = nearest_point.first;
    const Face face = nearest_point.second;
    const auto normal = CGAL::Polygon_mesh_processing::compute_face_normal(face, m_input);
    const auto is_no_wall = [&](const Face g) {
      return m_part_of[g] == m_part_of[face] &&
             CGAL::Polygon_mesh_processing::compute_face_normal(g, m_input) * normal >= 0.;
    };
    double nearest = std::numeric_limits<double>::infinity();
    for(const double side : {1., -1.})
      if(const auto hit = tree.first_intersection(Kernel::Ray_3(start, side * normal), is_no_wall))
        if(const Point* const end = std::get_if<Point>(&hit->first))
          nearest = (std::min)(nearest, CGAL::squared_distance(start, *end));
    const double edges =
        CGAL::squared_distance(p[0], p[1]) + CGAL::squared_distance(p[1], p[2]) + CGAL::squared_distance(p[2], p[0]);
    return std::sqrt(3. * nearest / edges);
  }

  // In the median; zero where sheets touch, or lie on each other with nothing opposite. Beside a sharp edge the width
  // is that of a wedge, which tells nothing, unless there is nothing else.
  double width_in_edges(const Tree& tree) const
  {
    constexpr double least = .02; // else it would be 2500 times as many vertices
    std::vector<double> widths;
    const std::size_t step = 1 + m_pairs.size() / most;
    std::size_t number = 0;
    for(std::size_t i = 0; i < m_pairs.size(); i += step, ++number)
    {
      const double width = (std::min)(width_at(tree, m_pairs[i].first), width_at(tree, m_pairs[i].second));
      if(std::isfinite(width) && width > least)
        widths.push_back(width);
    }
    if(10 * widths.size() <= number)
      return 0.;
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    return *middle;
  }

  // The target in place of that of the options, with two digits
  static std::string finer(const Options& options, double edge_length, double width)
  {
    if(options.edge_length)
    {
      std::ostringstream out;
      out.precision(2);
      out << "--edge-length " << width * edge_length;
      return out.str();
    }
    const double number = static_cast<double>(options.vertices ? *options.vertices : *options.faces) / (width * width);
    const double unit = std::pow(10., std::floor(std::log10(number)) - 1.);
    std::ostringstream out;
    out.precision(0);
    out << (options.vertices ? "--vertices " : "--faces ") << std::fixed << unit * std::ceil(number / unit);
    return out.str();
  }

  const Mesh& m_input;
  const Mesh& m_output;
  std::vector<std::pair<Face, Face>> m_pairs;
  std::vector<std::size_t> m_part_of; // of the faces of the input
};

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_THIN_PLACES_H
