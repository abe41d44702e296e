#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/equidistant_curves.h>
#include <CGAL/Geodesic_remeshing/geodesic_distances.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Curve = CGAL::Geodesic_remeshing::Equidistant_curve<Mesh, Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh;
  if(!CGAL::IO::read_OFF(file_name, mesh) || mesh.is_empty())
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  // the distances from the first vertex, and the curves at 5 %, 10 %, ... of the largest
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  CGAL::Geodesic_remeshing::geodesic_distances(mesh, distance, *mesh.vertices().begin());
  double largest = 0.;
  for(Mesh::Vertex_index v : mesh.vertices())
    largest = (std::max)(largest, distance[v]);
  std::vector<double> values;
  for(int i = 1; i < 20; ++i)
    values.push_back(.05 * i * largest);

  std::vector<Curve> curves;
  CGAL::Geodesic_remeshing::equidistant_curves(mesh, distance, values, std::back_inserter(curves));

  // polylines in the form that CGAL's examples and Lab read: the number of points, then the points
  std::ofstream out("curves.polylines.txt");
  out.precision(17);
  for(const Curve& curve : curves)
  {
    out << curve.points.size() + (curve.is_closed ? 1 : 0);
    for(const auto& point : curve.points)
      out << " " << point;
    if(curve.is_closed)
      out << " " << curve.points.front();
    out << "\n";
  }
  std::cout << curves.size() << " curves at " << values.size() << " distances\n";
  return out.good() ? EXIT_SUCCESS : EXIT_FAILURE;
}
