#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace GR = CGAL::Geodesic_remeshing;

// Names the stages as they begin, and stops the work when it takes too long
class Time_limit : public GR::Default_visitor
{
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_end;

public:
  explicit Time_limit(std::chrono::seconds limit) : m_end(Clock::now() + limit) {}

  void stage(const std::string& name) { std::cout << name << "\n"; }
  bool progress(double) { return Clock::now() < m_end; }
};

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }
  Time_limit visitor(std::chrono::minutes(5));
  try
  {
    CGAL::geodesic_remeshing(mesh, 3000, out, GR::parameters::visitor(std::ref(visitor)));
  }
  catch(const GR::Remeshing_error& error)
  {
    std::cerr << error.what() << "\n"; // out is as it was
    return EXIT_FAILURE;
  }
  std::cout << out.number_of_vertices() << " vertices\n";
}
