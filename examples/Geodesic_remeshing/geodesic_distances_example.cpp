#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/geodesic_distances.h>
#include <CGAL/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face_location = std::pair<Mesh::Face_index, std::array<double, 3>>;

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file_name, mesh) || mesh.is_empty())
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;

  // from one vertex
  const Vertex source = *mesh.vertices().begin();
  GR::geodesic_distances(mesh, distance, source);
  Vertex farthest = source;
  for(Vertex v : mesh.vertices())
    if(distance[v] > distance[farthest])
      farthest = v;
  std::cout << "farthest from " << source << ": " << farthest << " at " << distance[farthest] << "\n";

  // from points in faces, and not farther than a tenth of that
  const double limit = distance[farthest] / 10.;
  const std::vector<Face_location> points = {{Mesh::Face_index(0), {{0.2, 0.3, 0.5}}},
                                             {mesh.face(mesh.halfedge(farthest)), {{0.1, 0.1, 0.8}}}};
  GR::geodesic_distances(mesh, distance, points, gp::maximum_distance(limit));
  std::size_t number_of_near_vertices = 0;
  for(Vertex v : mesh.vertices())
    number_of_near_vertices += distance[v] <= limit;
  std::cout << number_of_near_vertices << " vertices within " << limit << " of two points\n";

  // from a curve: the edges of a face
  const auto corners = mesh.vertices_around_face(mesh.halfedge(Mesh::Face_index(0)));
  std::vector<Vertex> curve(corners.begin(), corners.end());
  curve.push_back(curve.front()); // closed
  GR::geodesic_distances_from_curve(mesh, distance, curve);
  std::cout << "distance from a triangle to " << farthest << ": " << distance[farthest] << "\n";

  // where the upper half of the surface is twice as hard to pass
  auto weight = mesh.add_property_map<Vertex, double>("v:weight", 1.).first;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).y() > (box.ymin() + box.ymax()) / 2.)
      weight[v] = 2.;
  GR::geodesic_distances(mesh, distance, source, gp::vertex_weight_map(weight));
  std::cout << "with weights from " << source << " to " << farthest << ": " << distance[farthest] << "\n";
  return EXIT_SUCCESS;
}
