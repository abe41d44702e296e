// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_BENCHMARK_COMPARISON_H
#define CGAL_GEODESIC_REMESHING_BENCHMARK_COMPARISON_H

// What the benchmarks of remeshers have in common: their arguments, and how a model is remeshed and measured.

#include "remeshers.h"
#include "result_table.h"

#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace benchmark {

struct Task
{
  std::string model;
  std::size_t number_of_vertices;
};

struct Options
{
  int repeats = 3;
  std::string output;
  std::string meshes; // a folder for the meshes that are measured; empty: they are not kept
  std::vector<Task> tasks;
  bool has_own_tasks = false; // named by the caller
};

// Reads [--repeats R] [--output PREFIX] [--meshes FOLDER] [MODEL=N ...]; without a model: the tasks given.
inline Options read_options(int argc, char* argv[], const std::vector<Task>& tasks)
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
    else if(word == "--meshes" && i + 1 < argc)
      options.meshes = argv[++i];
    else if(word.front() != '-' && equals != std::string::npos)
      options.tasks.push_back({word.substr(0, equals), std::stoul(word.substr(equals + 1))});
    else
      throw std::invalid_argument(std::string("usage: ") + argv[0] +
                                  " [--repeats R] [--output PREFIX] [--meshes FOLDER] [MODEL=N ...]");
  }
  options.has_own_tasks = !options.tasks.empty();
  if(!options.has_own_tasks)
    options.tasks = tasks;
  return options;
}

inline Mesh read_model(const std::string& model)
{
  const bool is_name = model.find_first_of("./\\") == std::string::npos;
  const std::string file = is_name ? CGAL::data_file_path("meshes/" + model + ".off") : model;
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

// FOLDER/MODEL.METHOD.off, with nothing but letters and digits in the names
inline void keep_mesh(const std::string& folder, const std::string& model, const std::string& method, const Mesh& mesh)
{
  std::string name = method;
  for(char& c : name)
    if(!std::isalnum(static_cast<unsigned char>(c)))
      c = '_';
  const std::string file =
      (std::filesystem::path(folder) / (std::filesystem::path(model).stem().string() + "." + name + ".off")).string();
  if(!CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::stream_precision(9)))
    throw std::runtime_error("cannot write " + file);
}

// All remeshers on one model. They take turns, so that what else the machine does meets all of them.
inline std::vector<Result> measure(const Task& task, const std::vector<Remesher>& remeshers, const Options& options,
                                   std::vector<Mesh>* kept = nullptr)
{
  const Mesh input = read_model(task.model);
  std::vector<Run> runs;
  for(const auto& remesher : remeshers)
    runs.push_back(remesher.prepare(input, task.number_of_vertices));

  std::vector<Result> results(remeshers.size());
  std::vector<Mesh> outputs(remeshers.size());
  for(int repeat = 0; repeat < options.repeats; ++repeat)
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
    results[i].growth = measure_growth(outputs[i]);
    results[i].quality = mesh_quality::measure_quality(outputs[i]);
    results[i].distance = mesh_quality::measure_distance(input, outputs[i]);
    if(!options.meshes.empty())
      keep_mesh(options.meshes, task.model, remeshers[i].name, outputs[i]);
  }
  if(kept != nullptr)
    *kept = std::move(outputs);
  return results;
}

} // namespace benchmark

#endif // CGAL_GEODESIC_REMESHING_BENCHMARK_COMPARISON_H
