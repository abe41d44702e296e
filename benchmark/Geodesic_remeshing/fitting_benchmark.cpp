// Fits models, do_project(false), and puts what comes out beside what the best of other remeshers reached with the same
// number of vertices, which were measured once and are read from a file:
//
//   fitting_benchmark other_remeshers.csv [--repeats R]
//
// The table goes to standard output.

#include "mesh_quality.h"
#include "result_table.h"

#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using benchmark::number;
using mesh_quality::Mesh;

// One line of the file
struct Other
{
  std::string model, vertices, features_angle, hausdorff, nearest, rms, nearest_by_rms, min_angle, seconds;
};

std::vector<Other> read_others(const std::string& file)
{
  std::ifstream in(file);
  std::string line;
  if(!std::getline(in, line)) // the names of the columns
    throw std::runtime_error("cannot read " + file);
  std::vector<Other> result;
  while(std::getline(in, line))
  {
    std::istringstream cells(line);
    Other other;
    for(std::string Other::*cell :
        {&Other::model, &Other::vertices, &Other::features_angle, &Other::hausdorff, &Other::nearest, &Other::rms,
         &Other::nearest_by_rms, &Other::min_angle, &Other::seconds})
      if(!std::getline(cells, other.*cell, ','))
        throw std::runtime_error(file + ": a line has too few cells: " + line);
    result.push_back(other);
  }
  return result;
}

Mesh fit(const Mesh& input, const Other& other)
{
  namespace parameters = CGAL::Geodesic_remeshing::parameters;
  Mesh output;
  const auto fitted = parameters::do_project(false);
  if(other.features_angle.empty())
    CGAL::geodesic_remeshing(input, std::stoul(other.vertices), output, fitted);
  else
    CGAL::geodesic_remeshing(input, std::stoul(other.vertices), output,
                             fitted.features_angle_bound(std::stod(other.features_angle)));
  return output;
}

// How often the fitted mesh is nearer than the best of the others
struct Count
{
  int models = 0, hausdorff = 0, rms = 0;
};

std::vector<std::string> row(const Other& other, int repeats, Count& nearer)
{
  Mesh input, output;
  if(!CGAL::IO::read_OFF(CGAL::data_file_path("meshes/" + other.model + ".off"), input))
    throw std::runtime_error("cannot read " + other.model);
  double seconds = 0.;
  for(int repeat = 0; repeat < repeats; ++repeat)
  {
    CGAL::Timer timer; // user time of this process
    timer.start();
    output = fit(input, other);
    timer.stop();
    seconds = repeat == 0 ? timer.time() : (std::min)(seconds, timer.time());
  }
  const auto quality = mesh_quality::measure_quality(output);
  const auto distance = mesh_quality::measure_distance(input, output);
  ++nearer.models;
  nearer.hausdorff += distance.hausdorff_percent < std::stod(other.hausdorff);
  nearer.rms += distance.rms_percent < std::stod(other.rms);
  const auto cell = [](const std::string& text, int digits) { return number(std::stod(text), digits); };
  return {other.model,
          std::to_string(quality.vertices),
          number(distance.hausdorff_percent, 3),
          cell(other.hausdorff, 3),
          number(distance.rms_percent, 4),
          cell(other.rms, 4),
          number(quality.min_angle, 1),
          cell(other.min_angle, 1),
          number(quality.mean_min_angle, 1),
          number(quality.percent_irregular, 1),
          number(seconds, 2),
          cell(other.seconds, 2)};
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    if(argc != 2 && !(argc == 4 && argv[2] == std::string("--repeats")))
      throw std::invalid_argument("usage: fitting_benchmark other_remeshers.csv [--repeats R]");
    const int repeats = argc == 4 ? (std::max)(1, std::atoi(argv[3])) : 3;
    std::cout
        << "| model | vertices | Hausdorff % | best other | RMS % | best other | min angle | other | mean min angle "
           "| % irregular | CPU s | other |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    Count nearer;
    for(const Other& other : read_others(argv[1]))
      benchmark::internal::write_row(std::cout, row(other, repeats, nearer));
    std::cout << "\nThe smallest Hausdorff distance on " << nearer.hausdorff << " of the " << nearer.models
              << " models, the smallest RMS distance on " << nearer.rms << ".\n";
    return EXIT_SUCCESS;
  }
  catch(const std::exception& error)
  {
    std::cerr << "fitting_benchmark: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
