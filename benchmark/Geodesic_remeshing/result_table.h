// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_BENCHMARK_RESULT_TABLE_H
#define CGAL_GEODESIC_REMESHING_BENCHMARK_RESULT_TABLE_H

#include "mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace benchmark {

// How evenly the lengths change: at each vertex the mean length of its edges; over all edges, that of the end with the
// longer ones divided by that of the other end.
struct Growth
{
  double median = 1.;
  double almost_largest = 1.; // 99.9 % are no larger
};

inline Growth measure_growth(const mesh_quality::Mesh& mesh)
{
  std::vector<double> length(mesh.num_vertices(), 0.);
  for(const auto v : mesh.vertices())
    for(const auto h : mesh.halfedges_around_target(mesh.halfedge(v)))
      length[v] += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(mesh.source(h)))) / mesh.degree(v);
  std::vector<double> ratios;
  for(const auto e : mesh.edges())
  {
    const auto [shorter, longer] = std::minmax(length[mesh.vertex(e, 0)], length[mesh.vertex(e, 1)]);
    ratios.push_back(longer / shorter);
  }
  std::sort(ratios.begin(), ratios.end());
  return {ratios[ratios.size() / 2], ratios[ratios.size() * 999 / 1000]};
}

struct Result
{
  std::string model;
  std::string method;
  mesh_quality::Quality quality;
  mesh_quality::Distance distance;
  Growth growth;
  double seconds; // user CPU

  double kilovertices_per_second() const { return static_cast<double>(quality.vertices) / 1000. / seconds; }
};

struct Column
{
  const char* name;
  const char* heading;
  int digits;
  double (*value)(const Result&);
};

inline const std::vector<Column>& columns()
{
  static const std::vector<Column> all = {
      {"vertices", "vertices", 0, [](const Result& r) { return static_cast<double>(r.quality.vertices); }},
      {"seconds", "CPU s", 3, [](const Result& r) { return r.seconds; }},
      {"min_angle", "min angle", 1, [](const Result& r) { return r.quality.min_angle; }},
      {"mean_min_angle", "mean min angle", 2, [](const Result& r) { return r.quality.mean_min_angle; }},
      {"percent_below_30", "% < 30", 2, [](const Result& r) { return r.quality.percent_below_30; }},
      {"percent_irregular", "% irregular", 1, [](const Result& r) { return r.quality.percent_irregular; }},
      {"hausdorff_percent", "Hausdorff %", 3, [](const Result& r) { return r.distance.hausdorff_percent; }},
      {"rms_percent", "RMS %", 4, [](const Result& r) { return r.distance.rms_percent; }},
      {"kilovertices_per_second", "kV / CPU s", 1, [](const Result& r) { return r.kilovertices_per_second(); }}};
  return all;
}

inline std::string number(double value, int digits)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

inline void write_csv(std::ostream& out, const std::vector<Result>& results)
{
  out << "model,method";
  for(const Column& column : columns())
    out << "," << column.name;
  out << "\n";
  for(const Result& result : results)
  {
    out << result.model << ",\"" << result.method << "\"";
    for(const Column& column : columns())
      out << "," << number(column.value(result), 6);
    out << "\n";
  }
}

// How many times as many vertices a second the first method gives on the same model
inline double ratio_of_first(const std::vector<Result>& results, const Result& result)
{
  for(const Result& other : results)
    if(other.model == result.model)
      return other.kilovertices_per_second() / result.kilovertices_per_second();
  return 1.;
}

inline double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2.;
}

namespace internal {

inline void write_row(std::ostream& out, const std::vector<std::string>& cells)
{
  out << "|";
  for(const std::string& cell : cells)
    out << " " << cell << " |";
  out << "\n";
}

inline void write_head(std::ostream& out, std::vector<std::string> cells, std::size_t number_of_texts)
{
  for(const Column& column : columns())
    cells.push_back(column.heading);
  cells.push_back("ours, times as fast");
  write_row(out, cells);
  out << "|";
  for(std::size_t i = 0; i < cells.size(); ++i)
    out << (i < number_of_texts ? "---|" : "--:|");
  out << "\n";
}

} // namespace internal

inline void write_markdown(std::ostream& out, const std::vector<Result>& results)
{
  internal::write_head(out, {"model", "method"}, 2);
  for(const Result& result : results)
  {
    std::vector<std::string> cells = {result.model, result.method};
    for(const Column& column : columns())
      cells.push_back(number(column.value(result), column.digits));
    cells.push_back(number(ratio_of_first(results, result), 1));
    internal::write_row(out, cells);
  }
}

// One row a method: the medians over the models
inline void write_medians(std::ostream& out, const std::vector<Result>& results)
{
  std::vector<std::string> methods;
  for(const Result& result : results)
    if(std::find(methods.begin(), methods.end(), result.method) == methods.end())
      methods.push_back(result.method);
  internal::write_head(out, {"method"}, 1);
  for(const std::string& method : methods)
  {
    const auto median_of = [&](const auto& value) {
      std::vector<double> values;
      for(const Result& result : results)
        if(result.method == method)
          values.push_back(value(result));
      return median(values);
    };
    std::vector<std::string> cells = {method};
    for(const Column& column : columns())
      cells.push_back(number(median_of(column.value), column.digits));
    cells.push_back(number(median_of([&](const Result& r) { return ratio_of_first(results, r); }), 1));
    internal::write_row(out, cells);
  }
}

} // namespace benchmark

#endif // CGAL_GEODESIC_REMESHING_BENCHMARK_RESULT_TABLE_H
