// Remeshes one file of whatever kind and says in one line what came of it; scripts/zoo runs it on all there are.
//
//   zoo FILE NUMBER_OF_VERTICES uniform|sized|features
//
// Ends with 0 if the result is valid or the file was refused with a reason, with 1 otherwise.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/geodesic_remeshing.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

struct Unreadable : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

Mesh read(const std::string& file)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(file, points, polygons, CGAL::parameters::verbose(false)))
    throw Unreadable("cannot be read");
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  if(!PMP::triangulate_faces(mesh))
    throw Unreadable("has faces that cannot be triangulated");
  return mesh;
}

Mesh remesh(const Mesh& input, std::size_t number, const std::string& mode)
{
  Mesh output;
  if(mode == "sized")
    CGAL::geodesic_remeshing(input, number, output, gp::sizing_field(GR::Curvature_sizing_field<Mesh>(input)));
  else if(mode == "features")
    CGAL::geodesic_remeshing(input, number, output, gp::features_angle_bound(60.));
  else
    CGAL::geodesic_remeshing(input, number, output);
  return output;
}

std::string faults(const GR::Remeshing_validity& v)
{
  std::string result;
  const auto add = [&](bool holds, const std::string& what) { result += holds ? "" : " " + what; };
  add(v.is_manifold, "not-manifold");
  add(v.has_same_components, "components");
  add(v.has_same_genus, "genus");
  add(v.has_same_boundary_loops, "loops");
  add(v.has_number_of_vertices, "number");
  add(v.is_on_surface, "off-surface");
  return result;
}

// What is not promised where sheets of the surface are nearer to each other than the edges are long, or touch: counted,
// not refused.
std::string blemishes(const GR::Remeshing_validity& v)
{
  std::string result;
  if(v.self_intersections > 0 && !v.input_intersects_itself)
    result += " intersections";
  if(v.flipped_faces > 0)
    result += " turned faces";
  if(v.degenerate_faces > 0)
    result += " degenerate faces";
  if(!result.empty() && v.input_intersects_itself)
    result += ", of an input that intersects itself";
  return result.empty() ? "" : " but for" + result;
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc != 4)
    return std::cerr << "usage: zoo FILE NUMBER_OF_VERTICES uniform|sized|features\n", 1;
  const std::string file = argv[1];
  std::cout << file.substr(file.rfind('/') + 1) << " " << argv[2] << " " << argv[3] << ": ";
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  try
  {
    const std::size_t number = static_cast<std::size_t>(std::atol(argv[2]));
    const Mesh input = read(file);
    const Mesh output = remesh(input, number, argv[3]);
    const auto validity =
        GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(number).line_tolerance(1.));
    const std::string what = faults(validity);
    if(!what.empty())
      return std::cout << "INVALID:" << what << "\n", 1;
    std::cout << "valid" << blemishes(validity) << "\n";
    return 0;
  }
  catch(const Unreadable& error)
  {
    std::cout << "refused: " << error.what() << "\n";
  }
  catch(const std::invalid_argument& error)
  {
    std::cout << "refused: " << error.what() << "\n";
  }
  catch(const GR::Remeshing_error& error)
  {
    std::cout << "refused: " << error.what() << "\n";
  }
  catch(const std::exception& error)
  {
    std::string what = error.what();
    return std::cout << "EXCEPTION: " << what.substr(0, what.find('\n')) << "\n", 1;
  }
  return 0;
}
