#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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
  std::cout << out.number_of_vertices() << " vertices\n"; // 3000

  CGAL::geodesic_remeshing(mesh, GR::Number_of_faces{3000}, out);
  std::cout << out.number_of_faces()
            << " faces\n"; // 3000; an odd number can be reached only on a surface with boundary

  // in place: the mesh itself is replaced
  const GR::Summary summary = CGAL::geodesic_remeshing(mesh, GR::Edge_length{.02});
  std::cout << mesh.number_of_vertices() << " vertices, edges about " << summary.edge_length << " long\n";
  return CGAL::IO::write_OFF("by_edge_length.off", mesh, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                                 : EXIT_FAILURE;
}
