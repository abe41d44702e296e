#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace GR = CGAL::Geodesic_remeshing;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }
  CGAL::geodesic_remeshing(mesh, 3000, out);

  // all that can be checked: topology, distance, degenerate and turned faces, self-intersections
  const GR::Remeshing_validity validity = GR::is_valid_remeshing(mesh, out);
  std::cout << validity;
  return validity ? EXIT_SUCCESS : EXIT_FAILURE;
}
