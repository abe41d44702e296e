// Seconds that pass in each stage with one thread and with several, the least of nine runs in turn:
//
//   thread_benchmark MESH SUBDIVISIONS OUTPUT_VERTICES THREADS
//
// MESH is subdivided so many times. Means something only on a machine that does nothing else.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/geodesic_remeshing.h>
#include <CGAL/subdivision_method_3.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Seconds = std::vector<std::pair<std::string, double>>;

Seconds seconds_with(const std::size_t threads, const Mesh& input, const std::size_t vertices)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Mesh output;
  return CGAL::geodesic_remeshing(input, vertices, output, CGAL::parameters::concurrency_tag(CGAL::Parallel_tag()))
      .seconds;
}

void keep_least(Seconds& least, const Seconds& seconds)
{
  if(least.empty())
    least = seconds;
  for(std::size_t i = 0; i < least.size(); ++i)
    least[i].second = (std::min)(least[i].second, seconds[i].second);
}

void add_total(Seconds& seconds)
{
  double total = 0.;
  for(const auto& stage : seconds)
    total += stage.second;
  seconds.emplace_back("total", total);
}

} // namespace

int main(int argc, char* argv[])
{
  Mesh input;
  if(argc != 5 || !CGAL::IO::read_polygon_mesh(argv[1], input))
    return EXIT_FAILURE;
  CGAL::Subdivision_method_3::Loop_subdivision(input, CGAL::parameters::number_of_iterations(std::atoi(argv[2])));
  const auto vertices = static_cast<std::size_t>(std::atol(argv[3])),
             threads = static_cast<std::size_t>(std::atol(argv[4]));
  Seconds one, many;
  for(int run = 0; run < 9; ++run)
  {
    keep_least(one, seconds_with(1, input, vertices));
    keep_least(many, seconds_with(threads, input, vertices));
  }
  add_total(one);
  add_total(many);
  std::cout << std::fixed << std::setprecision(2) << "| stage | 1 thread | " << threads
            << " threads | ratio |\n|---|--:|--:|--:|\n";
  for(std::size_t i = 0; i < one.size(); ++i)
    std::cout << "| " << one[i].first << " | " << one[i].second << " | " << many[i].second << " | "
              << one[i].second / many[i].second << " |\n";
  return EXIT_SUCCESS;
}
