// Remeshes models with sizes that follow the curvature: geodesic_remeshing() without and with a Curvature_sizing_field,
// and CGAL's isotropic_remeshing() with an Adaptive_sizing_field whose tolerance is tuned to the same number of
// vertices (not timed).
//
//   sizing_benchmark [--repeats R] [--output PREFIX] [--meshes FOLDER] [MODEL=N ...]
//
// The arguments are those of remeshing_benchmark; the table goes to standard output, and with --output to PREFIX.md.
// Times include that for the sizing field.

#include "comparison.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
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
    std::cout << table.str();
    if(!options.output.empty() && !(std::ofstream(options.output + ".md") << table.str()).flush())
      throw std::runtime_error("cannot write " + options.output + ".md");
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "sizing_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
