// Remeshes models with geodesic_remeshing() and with CGAL's own remeshers in one run, and measures all results with one
// and the same code.
//
//   remeshing_benchmark [--repeats R] [--output PREFIX] [MODEL=N ...]
//
// MODEL is the name of one of CGAL's example meshes or a file, N the number of vertices. The tables go to standard output, and
// with --output to PREFIX.csv (all), PREFIX.md (all) and PREFIX_medians.md.
// Times are user CPU seconds, the smallest of R runs (3): what disturbs a run only makes it longer.

#include "remeshers.h"
#include "result_table.h"

#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using benchmark::Mesh;
using benchmark::Result;

struct Task
{
  std::string model;
  std::size_t number_of_vertices;
};

struct Options
{
  int repeats = 3;
  std::string output;
  std::vector<Task> tasks;
};

Options read_options(int argc, char* argv[])
{
  Options options;
  for(int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const std::size_t equals = word.rfind('=');
    if(word == "--repeats" && i + 1 < argc)
      options.repeats = (std::max)(1, std::atoi(argv[++i]));
    else if(word == "--output" && i + 1 < argc)
      options.output = argv[++i];
    else if(word.front() != '-' && equals != std::string::npos)
      options.tasks.push_back({word.substr(0, equals), std::stoul(word.substr(equals + 1))});
    else
      throw std::invalid_argument("usage: remeshing_benchmark [--repeats R] [--output PREFIX] [MODEL=N ...]");
  }
  if(options.tasks.empty())
    options.tasks = {{"bear", 10000},    {"dino", 11850}, {"camel", 23656},    {"eight", 5000},
                     {"elephant", 5000}, {"homer", 5000}, {"armadillo", 20000}};
  return options;
}

Mesh read_model(const std::string& model)
{
  const bool is_name = model.find_first_of("./\\") == std::string::npos;
  const std::string file = is_name ? CGAL::data_file_path("meshes/" + model + ".off") : model;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

// All remeshers on one model. They take turns, so that what else the machine does meets all of them.
std::vector<Result> measure(const Task& task, int repeats)
{
  const Mesh input = read_model(task.model);
  const std::vector<benchmark::Remesher> remeshers = benchmark::all_remeshers();
  std::vector<benchmark::Run> runs;
  for(const auto& remesher : remeshers)
    runs.push_back(remesher.prepare(input, task.number_of_vertices));

  std::vector<Result> results(remeshers.size());
  std::vector<Mesh> outputs(remeshers.size());
  for(int repeat = 0; repeat < repeats; ++repeat)
    for(std::size_t i = 0; i < runs.size(); ++i)
    {
      std::cerr << task.model << ": " << remeshers[i].name << "\n";
      CGAL::Timer timer; // user time of this process
      timer.start();
      outputs[i] = runs[i]();
      timer.stop();
      results[i].seconds = repeat == 0 ? timer.time() : (std::min)(results[i].seconds, timer.time());
    }
  for(std::size_t i = 0; i < results.size(); ++i)
  {
    results[i].model = task.model;
    results[i].method = remeshers[i].name;
    results[i].quality = mesh_quality::measure_quality(outputs[i]);
    results[i].distance = mesh_quality::measure_distance(input, outputs[i]);
  }
  return results;
}

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
    const Options options = read_options(argc, argv);
    std::vector<Result> results;
    for(const Task& task : options.tasks)
      for(Result& result : measure(task, options.repeats))
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
