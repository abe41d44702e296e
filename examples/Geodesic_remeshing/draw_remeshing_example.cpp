#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/geodesic_remeshing.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bear.off");
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }
  auto region = out.add_property_map<Mesh::Face_index, int>("f:region", 0).first;
  CGAL::geodesic_remeshing(mesh, 3000, out, parameters::default_values(), parameters::face_region_map(region));

  const std::array<CGAL::IO::Color, 6> colors = {
      {{141, 211, 199}, {255, 255, 179}, {190, 186, 218}, {251, 128, 114}, {128, 177, 211}, {253, 180, 98}}};
  auto color =
      out.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first; // the viewer looks for this name
  for(const auto f : out.faces())
    color[f] = colors[static_cast<std::size_t>(region[f]) % colors.size()];
  CGAL::draw(mesh, "input");
  CGAL::draw(out, "3000 vertices, by region");
}
