#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  Mesh out;
  auto is_sharp = out.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  auto patch = out.add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
  CGAL::geodesic_remeshing(mesh, 3000, out,
                           parameters::features_angle_bound(60), // edges sharper than this are kept, and their corners
                           parameters::edge_is_constrained_map(is_sharp).face_patch_map(patch));

  std::size_t sharp_edges = 0;
  for(const auto e : out.edges())
    sharp_edges += is_sharp[e];
  int patches = 0;
  for(const auto f : out.faces())
    patches = (std::max)(patches, patch[f] + 1);
  std::cout << out.number_of_vertices() << " vertices, " << sharp_edges << " edges on features between " << patches
            << " patches\n";
  return CGAL::IO::write_OFF("features.off", out, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS : EXIT_FAILURE;
}
