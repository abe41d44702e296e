#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/homer.off");
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  Mesh out;
  const auto summary = CGAL::geodesic_remeshing(mesh, 2000, out, parameters::do_project(false));
  std::cout << summary.number_of_vertices << " vertices, edges about " << summary.edge_length << " long; RMS distance "
            << summary.rms_distance << ", largest distance " << summary.largest_distance << "\n";
  return CGAL::IO::write_OFF("fitted.off", out, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
