// Remeshes models with geodesic_remeshing() and with CGAL's own remeshers in one run, and measures all results with one
// and the same code.
//
//   remeshing_benchmark [--repeats R] [--output PREFIX] [--meshes FOLDER] [MODEL=N ...]
//
// MODEL is the name of one of CGAL's example meshes or a file, N the number of vertices. The tables go to standard
// output, and with --output to PREFIX.csv (all), PREFIX.md (all) and PREFIX_medians.md. --meshes keeps the meshes, as
// FOLDER/MODEL.METHOD.off. Times are user CPU seconds, the smallest of R runs (3): what disturbs a run only makes it
// longer.

#include "comparison.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using benchmark::Result;

void write_files(const std::string& prefix, const std::vector<Result>& results)
{
  std::ofstream csv(prefix + ".csv");
  benchmark::write_csv(csv, results);
  std::ofstream markdown(prefix + ".md");
  benchmark::write_markdown(markdown, results);
  std::ofstream medians(prefix + "_medians.md");
  benchmark::write_medians(medians, results);
  if(!csv.flush() || !markdown.flush() || !medians.flush())
    throw std::runtime_error("cannot write " + prefix + ".*");
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    const benchmark::Options options = benchmark::read_options(argc, argv,
                                                               {{"bear", 10000},
                                                                {"dino", 11850},
                                                                {"camel", 23656},
                                                                {"eight", 5000},
                                                                {"elephant", 5000},
                                                                {"homer", 5000},
                                                                {"armadillo", 20000}});
    std::vector<Result> results;
    for(const benchmark::Task& task : options.tasks)
      for(Result& result : benchmark::measure(task, benchmark::all_remeshers(), options))
        results.push_back(std::move(result));
    benchmark::write_markdown(std::cout, results);
    std::cout << "\nMedians over the models:\n\n";
    benchmark::write_medians(std::cout, results);
    if(!options.output.empty())
      write_files(options.output, results);
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "remeshing_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
