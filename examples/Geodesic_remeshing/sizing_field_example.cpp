#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace GR = CGAL::Geodesic_remeshing;
namespace parameters = CGAL::Geodesic_remeshing::parameters;

// Edges of length 1 at a point, and longer with the distance from it: a model of GeodesicRemeshingSizingField
class Finer_near_a_point
{
  const Mesh& m_mesh;
  Point m_center;
  double m_radius;

public:
  using vertex_descriptor = Mesh::Vertex_index;
  using FT = double;

  Finer_near_a_point(const Mesh& mesh, const Point& center, double radius)
    : m_mesh(mesh), m_center(center), m_radius(radius)
  {}

  FT at(vertex_descriptor v) const
  {
    return 1. + std::sqrt(CGAL::squared_distance(m_center, m_mesh.point(v))) / m_radius;
  }
};

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(file_name, mesh) || mesh.is_empty())
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  // the number of vertices decides how long edges really are; the field tells only where they are how many times longer
  const Finer_near_a_point sizing(mesh, mesh.point(*mesh.vertices().begin()), .1);
  CGAL::geodesic_remeshing(mesh, 3000, out, parameters::sizing_field(sizing).gradation(.3));
  std::cout << out.number_of_vertices() << " vertices\n";

  // or edges as long as the field tells, which gives what number it takes
  auto length = mesh.add_property_map<Mesh::Vertex_index, double>("v:length").first;
  for(const auto v : mesh.vertices())
    length[v] = .02 * sizing.at(v);
  CGAL::geodesic_remeshing(mesh, GR::Edge_length{1}, out, parameters::sizing_field(length));
  std::cout << out.number_of_vertices() << " vertices for the lengths as they are\n";
  return CGAL::IO::write_OFF("finer_near_a_point.off", out, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                                    : EXIT_FAILURE;
}
