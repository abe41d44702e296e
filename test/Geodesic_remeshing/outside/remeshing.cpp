#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/version.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstring>

// The whole of the remeshing, by the installed headers alone

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1.);
  CGAL::geodesic_remeshing(mesh, 100);
  return mesh.number_of_vertices() == 100 && std::strcmp(FOUND_VERSION, CGAL_GEODESIC_REMESHING_VERSION) == 0 ? 0 : 1;
}
