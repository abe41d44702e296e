// Geodesic distances from one vertex: ours, CGAL's Heat_method_3 (with intrinsic Delaunay triangulation) and CGAL's
// exact Surface_mesh_shortest_path, the reference of the errors. User CPU seconds, the least of three runs (exact: of
// one).

#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Geodesic_remeshing::internal;
using Heat = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;
using Exact = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

struct Measurement
{
  std::string method;
  double setup = infinity;  // seconds
  double source = infinity; // seconds
  std::vector<double> distance = {};
};

struct Stopwatch
{
  Stopwatch() { timer.start(); }

  double lap()
  {
    const double time = timer.time();
    timer.reset();
    return time;
  }

  CGAL::Timer timer; // user time of this process
};

Measurement measure_ours(const Mesh& mesh, Vertex source)
{
  Measurement result{"ours"};
  for(int repeat = 0; repeat < 3; ++repeat)
  {
    Stopwatch watch;
    const Intrinsic_triangulation triangulation(mesh);
    Fast_marching marching(triangulation);
    result.setup = (std::min)(result.setup, watch.lap());
    marching.add_source(source);
    marching.march(Front_shape::circular);
    result.source = (std::min)(result.source, watch.lap());
    result.distance.clear();
    for(Vertex v : mesh.vertices())
      result.distance.push_back(marching.distance(v));
  }
  return result;
}

Measurement measure_heat(const Mesh& mesh, Vertex source)
{
  Measurement result{"CGAL heat method"};
  for(int repeat = 0; repeat < 3; ++repeat)
  {
    Mesh copy = mesh;
    auto distance = copy.add_property_map<Vertex, double>("v:distance", 0.).first;
    Stopwatch watch;
    Heat heat(copy);
    heat.add_source(source);
    heat.estimate_geodesic_distances(distance); // the first call factorizes
    const double first = watch.lap();
    heat.clear_sources();
    heat.add_source(source);
    heat.estimate_geodesic_distances(distance);
    result.source = (std::min)(result.source, watch.lap());
    result.setup = (std::min)(result.setup, first - result.source);
    result.distance.clear();
    for(Vertex v : mesh.vertices())
      result.distance.push_back(distance[v]);
  }
  return result;
}

Measurement measure_exact(const Mesh& mesh, Vertex source)
{
  Measurement result{"CGAL exact"};
  Stopwatch watch;
  Exact exact(mesh);
  exact.add_source_point(source);
  exact.build_sequence_tree();
  for(Vertex v : mesh.vertices())
    result.distance.push_back(exact.shortest_distance_to_source_points(v).first);
  result.source = watch.lap();
  result.setup = 0.;
  return result;
}

void write_row(const std::string& model, const Measurement& measurement, const std::vector<double>& reference)
{
  double sum = 0., largest = 0.;
  std::size_t n = 0;
  for(std::size_t i = 0; i < reference.size(); ++i)
    if(reference[i] > 0.)
    {
      const double error = 100. * std::abs(measurement.distance[i] - reference[i]) / reference[i];
      sum += error;
      largest = (std::max)(largest, error);
      ++n;
    }
  std::cout << "| " << model << " | " << reference.size() << " | " << measurement.method << std::fixed
            << std::setprecision(4) << " | " << measurement.setup << " | " << measurement.source << std::setprecision(2)
            << " | " << 1e6 * measurement.source / static_cast<double>(reference.size()) << std::setprecision(4)
            << " | " << sum / static_cast<double>(n) << " | " << std::setprecision(2) << largest << " |" << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> models(argv + 1, argv + argc);
  if(models.empty())
    models = {"bear", "dino", "camel", "elephant", "homer", "fandisk", "armadillo", "refined_elephant"};
  std::cout << "| model | vertices | method | set-up s | source s | source us/vertex | mean error % | largest % |\n"
            << "|---|--:|---|--:|--:|--:|--:|--:|\n";
  for(const std::string& model : models)
  {
    Mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + model + ".off"), mesh))
    {
      std::cerr << "distance_benchmark: cannot read " << model << "\n";
      return EXIT_FAILURE;
    }
    const Vertex source(0);
    const Measurement exact = measure_exact(mesh, source);
    write_row(model, measure_ours(mesh, source), exact.distance);
    write_row(model, measure_heat(mesh, source), exact.distance);
    write_row(model, exact, exact.distance);
  }
  return EXIT_SUCCESS;
}
