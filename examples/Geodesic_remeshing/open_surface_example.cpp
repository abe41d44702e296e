#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

std::size_t number_of_boundary_loops(const Mesh& mesh)
{
  std::vector<bool> seen(mesh.number_of_halfedges(), false);
  std::size_t loops = 0;
  for(const auto start : mesh.halfedges())
  {
    if(!mesh.is_border(start) || seen[start])
      continue;
    ++loops;
    for(const auto h : CGAL::halfedges_around_face(start, mesh))
      seen[h] = true;
  }
  return loops;
}

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off");
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  // Nothing has to be said about the boundary. Each vertex comes with its place on the input.
  Mesh out;
  auto location = out.add_property_map<Vertex, Location>("v:location").first;
  CGAL::geodesic_remeshing(mesh, 2000, out, parameters::default_values(), parameters::vertex_location_map(location));

  double largest = 0.;
  for(const Vertex v : out.vertices())
    largest = (std::max)(largest, CGAL::squared_distance(out.point(v), PMP::construct_point(location[v], mesh)));
  std::cout << number_of_boundary_loops(mesh) << " boundary loops before, " << number_of_boundary_loops(out)
            << " after; places tell the points up to " << std::sqrt(largest) << "\n";
  return CGAL::IO::write_OFF("open_surface.off", out, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                              : EXIT_FAILURE;
}
