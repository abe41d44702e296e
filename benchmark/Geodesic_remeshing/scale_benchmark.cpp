// Time a stage and peak memory of one remeshing of a large mesh, as a row of a table:
//
//   scale_benchmark MESH SUBDIVISIONS INPUT_VERTICES OUTPUT_VERTICES
//
// MESH is subdivided so many times, and then, unless INPUT_VERTICES is zero, remeshed to that number: the input. One
// row a process, since memory that was used before would serve again. The last column is the time of CGAL's
// isotropic_remeshing() with the same length of edges. Without arguments: the head of the table.
//
//   scale_benchmark --stages MESH OUTPUT_VERTICES
//
// prints another table, of the milliseconds and the share of each stage, the least of nine runs.

#include "remeshers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/geodesic_remeshing.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// Of this process, in bytes; Linux tells
double memory(const std::string& name)
{
  std::ifstream in("/proc/self/status");
  for(std::string line; std::getline(in, line);)
    if(line.rfind(name, 0) == 0)
      return 1024. * std::atof(line.c_str() + name.size() + 1);
  return 0.;
}

// Gives back what was used so far, and lets the peak begin anew.
void forget_peak()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << "5";
}

bool read_input(char* const argv[], Mesh& input)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return false;
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(std::atoi(argv[2])));
  const long vertices = std::atol(argv[3]);
  if(vertices > 0)
    CGAL::geodesic_remeshing(mesh, vertices, input);
  else
    CGAL::copy_face_graph(mesh, input);
  return true;
}

// The columns, each with the stages that it adds up
const std::pair<const char*, const char*> columns[] = {{"input, refinement", "input sizing refinement output"},
                                                       {"distances", "distances"},
                                                       {"regions", "regions"},
                                                       {"curves, samples", "curves samples"},
                                                       {"strips", "strips"},
                                                       {"improvement", "improvement"}};

void print_head()
{
  std::cout << "| input | output |";
  for(const auto& column : columns)
    std::cout << " " << column.first << " |";
  std::cout << " total | microseconds a vertex | peak MB | bytes a vertex | isotropic_remeshing, 3 iterations |\n|";
  for(std::size_t i = 0; i < std::size(columns) + 7; ++i)
    std::cout << "--:|";
  std::cout << "\n";
}

void print_row(const std::size_t input, const CGAL::Geodesic_remeshing::Summary& summary, const double bytes)
{
  std::cout << std::fixed << std::setprecision(2) << "| " << input << " | " << summary.number_of_vertices << " |";
  double total = 0.;
  for(const auto& column : columns)
  {
    double sum = 0.;
    for(const auto& [stage, seconds] : summary.seconds)
      if((" " + std::string(column.second) + " ").find(" " + stage + " ") != std::string::npos)
        sum += seconds;
    total += sum;
    std::cout << " " << sum << " |";
  }
  const double vertices = static_cast<double>(input + summary.number_of_vertices);
  std::cout << " " << total << " | " << 1e6 * total / vertices << " | " << std::setprecision(0) << bytes / 1e6 << " | "
            << bytes / vertices << " |";
}

// Beyond some size it takes minutes.
void print_isotropic(const Mesh& input, const std::size_t number_of_vertices)
{
  constexpr std::size_t most = 2000000;
  CGAL::Timer timer;
  timer.start();
  if(input.number_of_vertices() <= most)
    benchmark::isotropic(input, benchmark::uniform_edge_length(input, number_of_vertices), 3);
  timer.stop();
  if(input.number_of_vertices() <= most)
    std::cout << " " << std::setprecision(2) << timer.time() << " |\n";
  else
    std::cout << " |\n";
}

bool print_stages(const std::string& file, const long vertices)
{
  Mesh input;
  if(!CGAL::IO::read_polygon_mesh(file, input))
    return false;
  std::vector<std::pair<std::string, double>> least;
  for(int run = 0; run < 9; ++run)
  {
    Mesh output;
    const auto summary = CGAL::geodesic_remeshing(input, vertices, output);
    if(run == 0)
      least = summary.seconds;
    for(std::size_t i = 0; i < least.size(); ++i)
      least[i].second = (std::min)(least[i].second, summary.seconds[i].second);
  }
  double total = 0.;
  for(const auto& stage : least)
    total += stage.second;
  least.emplace_back("total", total);
  std::cout << std::fixed << std::setprecision(0) << "| stage | milliseconds | % |\n|---|--:|--:|\n";
  for(const auto& stage : least)
    std::cout << "| " << stage.first << " | " << 1000. * stage.second << " | " << 100. * stage.second / total << " |\n";
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc == 4 && argv[1] == std::string("--stages"))
    return print_stages(argv[2], std::atol(argv[3])) ? EXIT_SUCCESS : EXIT_FAILURE;
  if(argc == 1)
    print_head();
  if(argc != 5)
    return argc == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
  Mesh input, output;
  if(!read_input(argv, input))
    return EXIT_FAILURE;
  forget_peak();
  const double before = memory("VmRSS");
  const auto summary = CGAL::geodesic_remeshing(input, std::atol(argv[4]), output);
  print_row(input.number_of_vertices(), summary, memory("VmHWM") - before);
  print_isotropic(input, output.number_of_vertices());
  return EXIT_SUCCESS;
}
