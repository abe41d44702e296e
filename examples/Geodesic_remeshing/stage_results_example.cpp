#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace GR = CGAL::Geodesic_remeshing;

int main(int argc, char* argv[])
{
  const std::string file_name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cactus.off");
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(file_name, mesh))
  {
    std::cerr << "cannot read " << file_name << "\n";
    return EXIT_FAILURE;
  }

  GR::Stage_results results;
  const GR::Summary summary =
      CGAL::geodesic_remeshing(mesh, 3000, out, GR::parameters::stage_results(std::ref(results)));
  std::cout << "working surface: " << results.working_surface.number_of_vertices() << " vertices\n"
            << "regions: " << summary.number_of_regions << "\n"
            << "curves: " << results.curves.size() << ", with " << results.samples.size() << " samples\n"
            << "strips: " << summary.number_of_strips << ", triangulated with " << results.strips.number_of_faces()
            << " faces\n";
  return CGAL::IO::write_OFF("strips.off", results.strips, CGAL::parameters::stream_precision(17)) ? EXIT_SUCCESS
                                                                                                   : EXIT_FAILURE;
}
