// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HTML_REPORT_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HTML_REPORT_H

#include "report.h"
#include "shown_mesh.h"
#include "stage_files.h"
#include "viewer_files.h"

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace command_line {

namespace internal {

constexpr std::size_t largest_number_of_shown_faces = 250000;
constexpr std::size_t largest_number_of_shown_curve_points = 250000;

// As browsers decode it; numbers in the order of bytes of the machine, which is that of all browsers' machines
template <class Number>
std::string base64(const std::vector<Number>& numbers)
{
  static const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* const bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  const std::size_t size = numbers.size() * sizeof(Number);
  std::string text;
  text.reserve((size + 2) / 3 * 4);
  for(std::size_t i = 0; i < size; i += 3)
  {
    const std::size_t left = (std::min)(size - i, std::size_t(3));
    std::uint32_t group = static_cast<std::uint32_t>(bytes[i]) << 16;
    group |= left > 1 ? static_cast<std::uint32_t>(bytes[i + 1]) << 8 : 0;
    group |= left > 2 ? static_cast<std::uint32_t>(bytes[i + 2]) : 0;
    for(std::size_t k = 0; k < 4; ++k)
      text += k > left ? '=' : digits[(group >> (18 - 6 * k)) & 63];
  }
  return text;
}

inline std::uint8_t to_byte(double part)
{
  return static_cast<std::uint8_t>(std::lround(255. * (std::min)((std::max)(part, 0.), 1.)));
}

// Twice the radius of the incircle by that of the circumcircle: 1 for an equilateral triangle, 0 for one without area
inline double triangle_quality(const std::array<Point, 3>& p)
{
  std::array<double, 3> side{};
  for(int i = 0; i < 3; ++i)
    side[i] = std::sqrt(CGAL::squared_distance(p[i], p[(i + 1) % 3]));
  const double a = side[0], b = side[1], c = side[2], product = a * b * c;
  return product > 0. ? (b + c - a) * (c + a - b) * (a + b - c) / product : 0.;
}

inline Point middle(const Mesh& mesh, Mesh::Face_index f)
{
  const auto p = mesh_quality::corners(mesh, f);
  return CGAL::centroid(p[0], p[1], p[2]);
}

// Calls `visit(number, face)` in an order in which faces that follow each other are near: searches that begin at the
// last place are fast then.
template <class Visit>
void visit_by_place(const Mesh& mesh, const Shown_mesh& shown, const Visit& visit)
{
  std::vector<Point> middles;
  std::vector<std::size_t> order;
  for(const auto f : shown.faces)
  {
    order.push_back(middles.size());
    middles.push_back(middle(mesh, f));
  }
  using Points = CGAL::Pointer_property_map<Point>::type;
  CGAL::spatial_sort(
      order.begin(), order.end(),
      CGAL::Spatial_sort_traits_adapter_3<mesh_quality::Kernel, Points>(CGAL::make_property_map(middles)));
  for(const std::size_t i : order)
    visit(i, shown.faces[i]);
}

inline nlohmann::ordered_json encoded_shape(const Mesh& mesh, const Shown_mesh& shown, const Frame& frame)
{
  std::vector<float> positions;
  positions.reserve(3 * shown.points.size());
  for(const Point& p : shown.points)
    for(const float coordinate : frame(p))
      positions.push_back(coordinate);
  std::vector<std::uint8_t> angles, qualities;
  for(const auto f : shown.faces)
  {
    const auto p = mesh_quality::corners(mesh, f);
    angles.push_back(static_cast<std::uint8_t>(std::lround(4. * mesh_quality::smallest_angle(p))));
    qualities.push_back(to_byte(triangle_quality(p)));
  }
  return {{"shown", shown.faces.size()},      {"faces", mesh.number_of_faces()},   {"positions", base64(positions)},
          {"indices", base64(shown.indices)}, {"valence", base64(shown.valences)}, {"angle", base64(angles)},
          {"quality", base64(qualities)}};
}

// How far each face is from another surface, in the middle and, unless these are known to lie on it, at its corners
inline std::vector<double> deviations(const Mesh& mesh, const Shown_mesh& shown, const Mesh& other, bool with_corners)
{
  mesh_quality::Closest_point closest(other);
  std::vector<double> result(shown.faces.size());
  visit_by_place(mesh, shown, [&](std::size_t i, Mesh::Face_index f) {
    result[i] = closest.distance(middle(mesh, f));
    for(const Point& corner : mesh_quality::corners(mesh, f))
      if(with_corners)
        result[i] = (std::max)(result[i], closest.distance(corner));
  });
  return result;
}

inline std::string encoded_deviations(const std::vector<double>& deviations, double largest)
{
  std::vector<std::uint8_t> bytes;
  for(const double deviation : deviations)
    bytes.push_back(to_byte(largest > 0. ? deviation / largest : 0.));
  return base64(bytes);
}

// The value that all but one in a thousand do not exceed, so that a single spike does not take all the colors
inline double almost_largest(std::vector<double> values)
{
  if(values.empty())
    return 0.;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) - (values.size() - 1) / 1000);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

using Region_map = Mesh::Property_map<Mesh::Face_index, int>;

inline std::string encoded_regions(const Shown_mesh& shown, const Region_map& region)
{
  std::vector<std::uint16_t> numbers;
  for(const auto f : shown.faces)
    numbers.push_back(static_cast<std::uint16_t>(region[f]));
  return base64(numbers);
}

// Of each face of the output the region that its middle is nearest to
inline std::string encoded_nearest_regions(const Mesh& mesh, const Shown_mesh& shown, const Mesh& regions,
                                           const Region_map& region)
{
  mesh_quality::Closest_point closest(regions);
  std::vector<std::uint16_t> numbers(shown.faces.size());
  visit_by_place(mesh, shown, [&](std::size_t i, Mesh::Face_index f) {
    numbers[i] = static_cast<std::uint16_t>(region[closest.face(middle(mesh, f))]);
  });
  return base64(numbers);
}

// Of many curves every second, third, ... only
inline nlohmann::ordered_json encoded_curves(const Stage_results& stages, const Frame& frame)
{
  std::size_t all = 0;
  for(const auto& curve : stages.curves)
    all += curve.size();
  const std::size_t stride = 1 + all / largest_number_of_shown_curve_points;
  std::vector<float> points;
  std::vector<std::uint32_t> sizes;
  for(std::size_t i = 0; i < stages.curves.size(); i += stride)
  {
    sizes.push_back(static_cast<std::uint32_t>(stages.curves[i].size()));
    for(const Point& p : stages.curves[i])
      for(const float coordinate : frame(p))
        points.push_back(coordinate);
  }
  return {{"points", base64(points)}, {"sizes", base64(sizes)}};
}

// Three degrees a bin
inline std::vector<std::size_t> angle_histogram(const Mesh& mesh)
{
  std::vector<std::size_t> bins(60, 0);
  for(const auto f : mesh.faces())
  {
    const auto p = mesh_quality::corners(mesh, f);
    for(int i = 0; i < 3; ++i)
      ++bins[(std::min)(std::size_t(59),
                        static_cast<std::size_t>(mesh_quality::angle(p[i], p[(i + 1) % 3], p[(i + 2) % 3]) / 3.))];
  }
  return bins;
}

// 3 to 9 neighbors, and 10 or more, of the inner vertices
inline std::vector<std::size_t> valence_histogram(const Mesh& mesh)
{
  std::vector<std::size_t> bins(8, 0);
  for(const auto v : mesh.vertices())
    if(!mesh.is_isolated(v) && !mesh.is_border(v))
      ++bins[(std::min)((std::max)(mesh.degree(v), 3u), 10u) - 3u];
  return bins;
}

inline nlohmann::ordered_json encoded_meshes(const Mesh& input, const Mesh& output, bool is_fitted,
                                             const Stage_results& stages, const Frame& frame, double& largest_deviation)
{
  const Shown_mesh shown_input = shown_mesh(input, largest_number_of_shown_faces);
  const Shown_mesh shown_output = shown_mesh(output, largest_number_of_shown_faces);
  const auto of_input = deviations(input, shown_input, output, true),
             of_output = deviations(output, shown_output, input, is_fitted);
  largest_deviation = (std::max)(almost_largest(of_input), almost_largest(of_output));
  nlohmann::ordered_json meshes;
  meshes["input"] = encoded_shape(input, shown_input, frame);
  meshes["input"]["deviation"] = encoded_deviations(of_input, largest_deviation);
  meshes["output"] = encoded_shape(output, shown_output, frame);
  meshes["output"]["deviation"] = encoded_deviations(of_output, largest_deviation);
  const auto region = stages.regions.property_map<Mesh::Face_index, int>("f:region");
  if(!region)
    return meshes;
  const Shown_mesh shown_regions = shown_mesh(stages.regions, largest_number_of_shown_faces);
  meshes["regions"] = encoded_shape(stages.regions, shown_regions, frame);
  meshes["regions"]["deviation"] = encoded_deviations(std::vector<double>(shown_regions.faces.size(), 0.), 1.);
  meshes["regions"]["region"] = encoded_regions(shown_regions, *region);
  meshes["output"]["region"] = encoded_nearest_regions(output, shown_output, stages.regions, *region);
  return meshes;
}

} // namespace internal

// One page with everything in it: both meshes to turn with the mouse, histograms, tables
inline void write_html(std::ostream& out, const std::string& title, const Report& report, const Mesh& input,
                       const Mesh& output, const Stage_results& stages)
{
  const Frame frame{CGAL::Polygon_mesh_processing::bbox(input)};
  double largest_deviation = 0.;
  nlohmann::ordered_json data;
  data["title"] = title;
  data["report"] = report_as_json(report);
  data["histograms"] = {
      {"angles", {{"input", internal::angle_histogram(input)}, {"output", internal::angle_histogram(output)}}},
      {"valences", {{"input", internal::valence_histogram(input)}, {"output", internal::valence_histogram(output)}}}};
  data["meshes"] = internal::encoded_meshes(input, output, report.is_fitted, stages, frame, largest_deviation);
  data["largest_deviation"] = 100. * largest_deviation / mesh_quality::diagonal(input);
  data["curves"] = internal::encoded_curves(stages, frame);
  for(int i = 0; i < number_of_region_colors; ++i)
  {
    const CGAL::IO::Color color = region_color(i);
    data["region_colors"].push_back({color.red(), color.green(), color.blue()});
  }
  // "<" would let the name of a file end the element of the page that the data are in
  std::string text = data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  for(std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
    text.replace(at, 1, "\\u003c");
  out << viewer_before_data() << text << viewer_after_data();
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_HTML_REPORT_H
