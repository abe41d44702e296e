#include "snippets.h"

#include <CGAL/Geodesic_remeshing/version.h>
#include <CGAL/boost/graph/generators.h>

#include <cstring>

// The whole of the remeshing, by the installed headers alone: the program of the README, as it stands there, does what
// it says, and the other pieces of code of README and manual compile.

int main()
{
  Mesh mesh, remeshed;
  CGAL::make_icosahedron(mesh, Mesh::Point(0, 0, 0), 1.);
  CGAL::IO::write_polygon_mesh("bear.off", mesh);
  program_of_readme();
  CGAL::IO::read_polygon_mesh("remeshed.off", remeshed);
  return remeshed.number_of_vertices() == 5000 && std::strcmp(FOUND_VERSION, CGAL_GEODESIC_REMESHING_VERSION) == 0 ? 0
                                                                                                                   : 1;
}
