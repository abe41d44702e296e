#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file_name, mesh) || mesh.is_empty())
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  // any edges and vertices may be marked: here the sharp edges, and one vertex somewhere
  auto is_line = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_line", false).first;
  PMP::detect_sharp_edges(mesh, 60, is_line);
  auto is_corner = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_corner", false).first;
  is_corner[*mesh.vertices().begin()] = true;
  const auto marks = parameters::edge_is_constrained_map(is_line).vertex_is_constrained_map(is_corner);

  // lines are covered by edges as long as the others
  Mesh out;
  auto lies_on_line = out.add_property_map<Mesh::Edge_index, bool>("e:is_line", false).first;
  CGAL::geodesic_remeshing(mesh, 3000, out, marks, parameters::edge_is_constrained_map(lies_on_line));
  std::size_t edges = 0;
  for(const auto e : out.edges())
    edges += lies_on_line[e];
  std::cout << out.number_of_vertices() << " vertices, " << edges << " edges cover the lines\n";

  // lines keep their vertices and edges, so that the result fits to what the lines are shared with
  Mesh fitting;
  CGAL::geodesic_remeshing(mesh, 3000, fitting, marks.protect_constraints(true));
  std::cout << fitting.number_of_vertices() << " vertices with the lines as they were\n";
  return CGAL::IO::write_OFF("constraints.off", out, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                             : EXIT_FAILURE;
}
