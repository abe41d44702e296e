#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/region_segmentation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/dino.off");
  const double curve_distance = argc > 2 ? std::atof(argv[2]) : .02;
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  auto region = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;
  const auto tree = CGAL::Geodesic_remeshing::region_segmentation(mesh, curve_distance, region);

  std::vector<std::size_t> number_of_faces(tree.size(), 0);
  for(Mesh::Face_index f : mesh.faces())
    ++number_of_faces[region[f]];
  const char* const kinds[] = {"leaf", "interior", "root"};
  for(std::size_t r = 0; r < tree.size(); ++r)
  {
    std::cout << "region " << r << " (" << kinds[static_cast<int>(tree[r].kind)] << "): height " << tree[r].height
              << ", " << number_of_faces[r] << " faces";
    for(std::size_t parent : tree[r].parents)
      std::cout << ", child of " << parent;
    std::cout << "\n";
  }
  return EXIT_SUCCESS;
}
