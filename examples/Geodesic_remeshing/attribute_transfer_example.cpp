#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
namespace GR = CGAL::Geodesic_remeshing;
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

  // a color at each vertex, and two parts of faces
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const auto height = [&](Vertex v) { return (mesh.point(v).y() - box.ymin()) / box.y_span(); };
  auto color = mesh.add_property_map<Vertex, CGAL::IO::Color>("v:color").first;
  for(const Vertex v : mesh.vertices())
    color[v] = CGAL::IO::Color(static_cast<unsigned char>(255. * height(v)), 120, 60);
  auto part = mesh.add_property_map<Face, int>("f:part").first;
  for(const Face f : mesh.faces())
    part[f] = height(mesh.target(mesh.halfedge(f))) > .5 ? 1 : 0;

  // remesh with the border between the parts kept, and remember where each new vertex lies on the old mesh
  Mesh out;
  auto location = out.add_property_map<Vertex, Location>("v:location").first;
  CGAL::geodesic_remeshing(mesh, 5000, out, parameters::face_patch_map(part),
                           parameters::vertex_location_map(location));

  GR::transfer_vertex_property(mesh, color, out, location,
                               out.add_property_map<Vertex, CGAL::IO::Color>("v:color").first);
  auto new_part = out.add_property_map<Face, int>("f:part").first;
  GR::transfer_face_property(mesh, part, out, location, new_part);

  std::size_t upper = 0;
  for(const Face f : out.faces())
    upper += new_part[f];
  std::cout << upper << " of " << out.number_of_faces() << " faces belong to the upper part\n";
  std::ofstream file("colored.ply");
  file.precision(17);
  return CGAL::IO::write_PLY(file, out) ? EXIT_SUCCESS : EXIT_FAILURE;
}
