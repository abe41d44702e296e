#include <CGAL/Geodesic_remeshing/geodesic_diameter.h>

// Must not compile: `contrast` belongs to the sizing field, and the other function would ignore it.
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

double diameter(const Mesh& mesh)
{
  return CGAL::Geodesic_remeshing::geodesic_diameter(mesh, CGAL::Geodesic_remeshing::parameters::contrast(1.)).distance;
}
