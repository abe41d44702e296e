// Remeshes models with sizes that follow the curvature: geodesic_remeshing() without and with a Curvature_sizing_field,
// and CGAL's isotropic_remeshing() with an Adaptive_sizing_field whose tolerance is tuned to the same number of
// vertices (not timed).
//
//   sizing_benchmark [--repeats R] [--output PREFIX] [--meshes FOLDER] [MODEL=N ...]
//
// The arguments are those of remeshing_benchmark; the table goes to standard output, and with --output to PREFIX.md.
// Times include that for the sizing field. Then, unless models are named, two tables of what the parameters do:
// contrasts on homer, to PREFIX_contrasts.md, and gradations on fandisk, to PREFIX_gradations.md.

#include "comparison.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/geodesic_remeshing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using benchmark::Result;

std::string percent_less(const Result& result, const Result& other)
{
  return benchmark::number(100. * (result.distance.rms_percent / other.distance.rms_percent - 1.), 0);
}

void write_head(std::ostream& out)
{
  out << "| model | method |";
  for(const auto& column : benchmark::columns())
    out << " " << column.heading << " |";
  out << " RMS to uniform, % | RMS to adaptive, % | growth, median | growth, 99.9 % |\n|---|---|";
  for(std::size_t i = 0; i < benchmark::columns().size() + 4; ++i)
    out << "--:|";
  out << "\n";
}

// The first result is that of the uniform mesh, the last that of the other remesher.
void write_rows(std::ostream& out, const std::vector<Result>& results)
{
  for(const Result& result : results)
  {
    std::vector<std::string> cells = {result.model, result.method};
    for(const auto& column : benchmark::columns())
      cells.push_back(benchmark::number(column.value(result), column.digits));
    cells.push_back(percent_less(result, results.front()));
    cells.push_back(percent_less(result, results.back()));
    cells.push_back(benchmark::number(result.growth.median, 3));
    cells.push_back(benchmark::number(result.growth.almost_largest, 3));
    benchmark::internal::write_row(out, cells);
  }
}

// The longest edges by the shortest ones, 99 % to 1 %
double spread_of_lengths(const benchmark::Mesh& mesh)
{
  std::vector<double> lengths;
  for(const auto e : mesh.edges())
    lengths.push_back(std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)))));
  std::sort(lengths.begin(), lengths.end());
  return lengths[lengths.size() * 99 / 100] / lengths[lengths.size() / 100];
}

struct Sized
{
  mesh_quality::Quality quality;
  mesh_quality::Distance distance;
  benchmark::Growth growth;
  double spread;
};

// by parameters of the sizing field
template <class NamedParameters>
Sized sized(const benchmark::Mesh& input, std::size_t number_of_vertices, const NamedParameters& np)
{
  const CGAL::Geodesic_remeshing::Curvature_sizing_field<benchmark::Mesh> sizing(input, np);
  benchmark::Mesh output;
  CGAL::geodesic_remeshing(input, number_of_vertices, output,
                           CGAL::Geodesic_remeshing::parameters::sizing_field(sizing));
  return {mesh_quality::measure_quality(output), mesh_quality::measure_distance(input, output),
          benchmark::measure_growth(output), spread_of_lengths(output)};
}

std::string table_of_contrasts()
{
  using benchmark::number;
  const benchmark::Mesh input = benchmark::read_model("homer");
  std::ostringstream out;
  out << "| contrast | longest to shortest edges (99 % to 1 %) | RMS % | Hausdorff % | min angle | mean min angle | "
         "% irregular |\n|--:|--:|--:|--:|--:|--:|--:|\n";
  for(const double contrast : {0., .3, .5, .6, 1., 2.})
  {
    const Sized r = sized(input, 3000, CGAL::Geodesic_remeshing::parameters::contrast(contrast));
    benchmark::internal::write_row(out, {number(contrast, 1), number(r.spread, 1), number(r.distance.rms_percent, 3),
                                         number(r.distance.hausdorff_percent, 2), number(r.quality.min_angle, 1),
                                         number(r.quality.mean_min_angle, 1), number(r.quality.percent_irregular, 1)});
  }
  return out.str();
}

std::string table_of_gradations()
{
  using benchmark::number;
  const benchmark::Mesh input = benchmark::read_model("fandisk");
  std::ostringstream out;
  out << "| gradation | RMS % | min angle | mean min angle | % irregular | growth, median | growth, 99.9 % |\n"
         "|--:|--:|--:|--:|--:|--:|--:|\n";
  for(const double gradation : {.05, .12, .2, .4, std::numeric_limits<double>::infinity()})
  {
    const Sized r = sized(input, 5000, CGAL::Geodesic_remeshing::parameters::contrast(.5).gradation(gradation));
    benchmark::internal::write_row(out, {std::isfinite(gradation) ? number(gradation, 2) : "infinite",
                                         number(r.distance.rms_percent, 3), number(r.quality.min_angle, 1),
                                         number(r.quality.mean_min_angle, 1), number(r.quality.percent_irregular, 1),
                                         number(r.growth.median, 2), number(r.growth.almost_largest, 2)});
  }
  return out.str();
}

void publish(const std::string& table, const std::string& output, const std::string& suffix)
{
  std::cout << table;
  const std::string file = output + suffix + ".md";
  if(!output.empty() && !(std::ofstream(file) << table).flush())
    throw std::runtime_error("cannot write " + file);
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    std::vector<benchmark::Task> models;
    for(const char* model : {"homer", "bear", "dino", "camel", "elephant", "armadillo", "fandisk", "triceratops"})
      models.push_back({model, 5000});
    const benchmark::Options options = benchmark::read_options(argc, argv, models);
    const std::vector<benchmark::Remesher> remeshers = {benchmark::geodesic_remesher(),
                                                        benchmark::geodesic_remesher_by_curvature(.5),
                                                        benchmark::adaptive_remesher(10)};
    std::ostringstream table;
    write_head(table);
    for(const benchmark::Task& task : options.tasks)
      write_rows(table, benchmark::measure(task, remeshers, options));
    publish(table.str(), options.output, "");
    if(options.has_own_tasks)
      return EXIT_SUCCESS;
    std::cout << "\n";
    publish(table_of_contrasts(), options.output, "_contrasts");
    std::cout << "\n";
    publish(table_of_gradations(), options.output, "_gradations");
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "sizing_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
