#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/geodesic_diameter.h>
#include <CGAL/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file_name, mesh) || mesh.is_empty())
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  const auto diameter = GR::geodesic_diameter(mesh, gp::vertex_distance_map(distance));
  std::cout << "from " << diameter.first << " (" << mesh.point(diameter.first) << ") to " << diameter.second << " ("
            << mesh.point(diameter.second) << "): " << diameter.distance << " after " << diameter.number_of_runs
            << " runs\n";
  return EXIT_SUCCESS;
}
