// The remeshing: of small meshes of any shape, with any parameters, it makes a valid mesh or throws what it documents.
// Two bytes for the parameters, one for the number of points, three a point, then three a face.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace {

Mesh mesh_of(const std::uint8_t* data, std::size_t size)
{
  const std::size_t number = 3 + data[0] % 30;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  std::size_t i = 1;
  for(; i + 2 < size && points.size() < number; i += 3)
    points.emplace_back(static_cast<std::int8_t>(data[i]), static_cast<std::int8_t>(data[i + 1]),
                        static_cast<std::int8_t>(data[i + 2]));
  for(; i + 2 < size && !points.empty() && faces.size() < 80; i += 3)
    faces.push_back({data[i] % points.size(), data[i + 1] % points.size(), data[i + 2] % points.size()});
  PMP::repair_polygon_soup(points, faces);
  PMP::orient_polygon_soup(points, faces);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return mesh;
}

bool is_sound(const GR::Remeshing_validity& v)
{
  return v.is_manifold && v.has_same_components && v.has_same_genus && v.has_same_boundary_loops &&
         v.has_number_of_vertices && v.distance < 1e-6;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size < 12)
    return 0;
  const Mesh input = mesh_of(data + 2, size - 2);
  const std::size_t number = 3 + data[0];
  const auto np =
      gp::number_of_iterations(data[1] & 3u).use_segmentation((data[1] & 4) == 0).use_defect_moves((data[1] & 8) == 0);
  Mesh output;
  try
  {
    if((data[1] & 16) == 0)
      CGAL::geodesic_remeshing(input, number, output, np);
    else
      CGAL::geodesic_remeshing(input, number, output, np.features_angle_bound(30. + (data[1] >> 5) * 20.));
  }
  catch(const std::invalid_argument&)
  {
    return 0;
  }
  catch(const GR::Remeshing_error&)
  {
    return 0;
  }
  if(!is_sound(GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(number))))
    std::abort();
  return 0;
}
