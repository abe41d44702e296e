#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
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

  // short edges where the surface bends
  const CGAL::Geodesic_remeshing::Curvature_sizing_field<Mesh> by_curvature(mesh, parameters::contrast(.5));
  Mesh out;
  CGAL::geodesic_remeshing(mesh, 3000, out, parameters::sizing_field(by_curvature));
  std::cout << "by curvature: " << out.number_of_vertices() << " vertices\n";
  CGAL::IO::write_OFF("by_curvature.off", out, CGAL::parameters::stream_precision(17));

  // any other sizing is a property map: here edges are four times as long at the bottom as at the top
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  auto length = mesh.add_property_map<Mesh::Vertex_index, double>("v:length").first;
  for(const auto v : mesh.vertices())
    length[v] = 4. - 3. * (mesh.point(v).y() - box.ymin()) / box.y_span();
  CGAL::geodesic_remeshing(mesh, 3000, out, parameters::sizing_field(length).gradation(.2));
  std::cout << "by height: " << out.number_of_vertices() << " vertices\n";
  CGAL::IO::write_OFF("by_height.off", out, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
