#include "made_surfaces.h"
#include "test_support.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/Geodesic_remeshing/equidistant_curves.h>
#include <CGAL/Geodesic_remeshing/geodesic_distances.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Geodesic_remeshing/region_segmentation.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What cannot be worked on is refused, by every function, with a message in the caller's own terms.

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using made::Mesh;
using made::Point;
using made::Vector;
using made::Vertex;
using Face = Mesh::Face_index;
using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class Exception, class Work>
void expect_refused(const Work& work, const std::string& words)
{
  try
  {
    work();
    ADD_FAILURE() << "is not refused: " << words;
  }
  catch(const Exception& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

template <class Target>
void expect_target_refused(const Mesh& mesh, const Target& target, const std::string& words)
{
  Mesh out = made::tetrahedron();
  expect_refused<std::invalid_argument>([&] { CGAL::geodesic_remeshing(mesh, target, out); }, words);
  EXPECT_TRUE(support::is_same_mesh(out, made::tetrahedron())) << "the output is as it was";
}

// Every function that takes a mesh as the remeshing does
void expect_mesh_refused(Mesh mesh, const std::string& words)
{
  SCOPED_TRACE(words);
  expect_target_refused(mesh, 100, words);
  auto region = mesh.add_property_map<Face, int>("f:region", -1).first;
  auto height = mesh.add_property_map<Vertex, double>("v:height", 0.).first;
  auto location = mesh.add_property_map<Vertex, Location>("v:location").first;
  auto corner = mesh.add_property_map<Mesh::Halfedge_index, int>("h:corner", 0).first;
  std::vector<GR::Equidistant_curve<Mesh, Point>> curves;
  const std::map<std::string, std::function<void()>> functions = {
      {"Curvature_sizing_field", [&] { GR::Curvature_sizing_field<Mesh> field(mesh); }},
      {"region_segmentation", [&] { GR::region_segmentation(mesh, 1., region); }},
      {"equidistant_curves", [&] { GR::equidistant_curves(mesh, height, {.5}, std::back_inserter(curves)); }},
      {"is_valid_remeshing", [&] { GR::is_valid_remeshing(mesh, made::plane(2)); }},
      {"transfer_face_property", [&] { GR::transfer_face_property(mesh, region, mesh, location, region); }},
      {"transfer_corner_property", [&] { GR::transfer_corner_property(mesh, corner, mesh, location, corner); }}};
  for(const auto& function : functions)
  {
    SCOPED_TRACE(function.first);
    expect_refused<std::invalid_argument>(function.second, words);
  }
  EXPECT_FALSE(GR::is_valid_remeshing(made::plane(2), mesh).is_manifold);
}

// A mesh from rows of vertices, with isolated ones before them
Mesh mesh_of(const std::vector<std::vector<std::size_t>>& faces, const std::vector<Point>& points,
             std::size_t isolated = 0)
{
  Mesh mesh;
  for(std::size_t i = 0; i < isolated; ++i)
    mesh.add_vertex(Point(-1, -1, -1));
  for(const Point& p : points)
    mesh.add_vertex(p);
  for(const auto& f : faces)
  {
    std::vector<Vertex> corners;
    for(const std::size_t v : f)
      corners.push_back(Vertex(static_cast<Mesh::size_type>(isolated + v)));
    mesh.add_face(corners);
  }
  return mesh;
}

// Two squares of n * n cells that have one vertex in common; returns it as well
std::pair<Mesh, Vertex> touching_squares(unsigned n, std::size_t isolated)
{
  std::map<std::pair<unsigned, unsigned>, std::size_t> number;
  std::vector<Point> points;
  const auto at = [&](unsigned x, unsigned y) {
    const auto inserted = number.emplace(std::make_pair(x, y), points.size());
    if(inserted.second)
      points.push_back(Point(x, y, 0));
    return inserted.first->second;
  };
  std::vector<std::vector<std::size_t>> faces;
  for(const unsigned begin : {0u, n})
    for(unsigned x = begin; x < begin + n; ++x)
      for(unsigned y = begin; y < begin + n; ++y)
      {
        faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
        faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      }
  const auto shared = static_cast<Mesh::size_type>(isolated + at(n, n));
  return {mesh_of(faces, points, isolated), Vertex(shared)};
}

} // namespace

// Walking around the vertex reaches both fans, over the boundary between them.
TEST(Refused_mesh, fans_with_boundary_that_touch)
{
  for(const std::size_t isolated : {0, 3})
  {
    const auto squares = touching_squares(4, isolated);
    const auto name = std::to_string(static_cast<std::size_t>(squares.second));
    expect_mesh_refused(squares.first, "vertex " + name + " is not manifold");
  }
}

TEST(Refused_mesh, edge_without_faces)
{
  Mesh between_isolated = made::plane(4);
  const Vertex a = between_isolated.add_vertex(Point(9, 0, 0)), b = between_isolated.add_vertex(Point(9, 1, 0));
  between_isolated.add_edge(a, b);
  expect_mesh_refused(between_isolated, "edge between the vertices 25 and 26 has no face");
  Mesh across = made::plane(4);
  across.add_edge(Vertex(0), Vertex(12));
  expect_mesh_refused(across, "edge between the vertices 0 and 12 has no face");
}

TEST(Refused_mesh, messages_have_the_indices_of_the_caller)
{
  Mesh mesh = made::plane(4);
  CGAL::Euler::remove_face(mesh.halfedge(Face(3)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  const Face f(20);
  Mesh::Halfedge_index h = mesh.halfedge(f);
  while(mesh.is_border(mesh.opposite(h)))
    h = mesh.next(h);
  CGAL::Euler::join_face(h, mesh);
  expect_mesh_refused(mesh, "face 20 has 4 vertices");

  Mesh with_isolated = mesh_of({{0, 1, 2}}, {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, 2);
  auto function = with_isolated.add_property_map<Vertex, double>("v:function", 0.).first;
  function[Vertex(3)] = not_a_number;
  std::vector<GR::Equidistant_curve<Mesh, Point>> curves;
  expect_refused<std::invalid_argument>(
      [&] { GR::equidistant_curves(with_isolated, function, {.5}, std::back_inserter(curves)); }, "vertex 3");
}

// There the middle of an edge is one of its ends, and dividing it would never end.
TEST(Refused_edge_length, below_the_rounding_of_coordinates)
{
  Mesh out;
  Mesh far = made::moved(made::scaled(made::plane(16), 1. / 16.), Vector(1e13, 1e13, 1e13)); // rounded to .002
  expect_refused<GR::Remeshing_error>([&] { CGAL::geodesic_remeshing(far, 100000, out); }, "nearer to the origin");
  EXPECT_EQ(out.number_of_vertices(), 0u);
  auto region = far.add_property_map<Face, int>("f:region", -1).first;
  expect_refused<GR::Remeshing_error>([&] { GR::region_segmentation(far, .003, region); }, "nearer to the origin");

  CGAL::geodesic_remeshing(far, 100, out);
  EXPECT_EQ(out.number_of_vertices(), 100u);
  GR::region_segmentation(far, .1, region);
  EXPECT_EQ(region[Face(0)], 0);

  // the shortest length of a sizing counts
  auto length = far.add_property_map<Vertex, double>("v:length", 1.).first;
  length[Vertex(0)] = .01;
  expect_refused<GR::Remeshing_error>(
      [&] { CGAL::geodesic_remeshing(far, GR::Edge_length{.2}, out, gp::sizing_field(length).gradation(100.)); },
      "nearer to the origin");
}

TEST(Refused_target, more_vertices_than_can_be_numbered)
{
  const Mesh plane = made::plane(16);
  expect_target_refused(plane, std::size_t(5000000000), "5000000000 vertices");
  expect_target_refused(plane, (std::numeric_limits<std::size_t>::max)(), "more than 500000000 ");
  expect_target_refused(plane, 500000001, "more than 500000000 ");
  expect_target_refused(plane, GR::Number_of_faces{std::size_t(4000000000)}, "2000000000 vertices");
  expect_target_refused(plane, GR::Number_of_faces{(std::numeric_limits<std::size_t>::max)()}, "more than 500000000 ");
  expect_target_refused(made::sphere(2), GR::Number_of_faces{std::size_t(4000000000)}, "2000000000 vertices");
  expect_target_refused(plane, GR::Edge_length{4e-4}, "the edge length is too small");
  Mesh mesh = plane;
  auto region = mesh.add_property_map<Face, int>("f:region", -1).first;
  expect_refused<std::invalid_argument>([&] { GR::region_segmentation(mesh, 1e-4, region); },
                                        "the curve distance is too small");
}

TEST(Refused_target, no_faces)
{
  expect_target_refused(made::plane(4), GR::Number_of_faces{0}, "positive");
  expect_target_refused(made::sphere(2), GR::Number_of_faces{0}, "positive");
}

TEST(Refused_parameter, ball_radius)
{
  const Mesh mesh = made::sphere(2);
  for(const double bad : {-5., -1., 0., not_a_number, infinity})
    expect_refused<std::invalid_argument>([&] { GR::Curvature_sizing_field<Mesh> field(mesh, gp::ball_radius(bad)); },
                                          "radius");
}

TEST(Refused_parameter, number_of_iterations)
{
  Mesh out;
  expect_refused<std::invalid_argument>(
      [&] { CGAL::geodesic_remeshing(made::sphere(2), 50, out, gp::number_of_iterations(-1)); },
      "the number of iterations");
  CGAL::geodesic_remeshing(made::sphere(2), 50, out, gp::number_of_iterations(0));
  EXPECT_EQ(out.number_of_vertices(), 50u);
}

TEST(Refused_parameter, values_of_curves)
{
  Mesh mesh = made::sphere(2);
  auto height = mesh.add_property_map<Vertex, double>("v:height", 0.).first;
  std::vector<GR::Equidistant_curve<Mesh, Point>> curves;
  for(const std::vector<double>& bad :
      {std::vector<double>{2., not_a_number, .5}, {.1, not_a_number, .5}, {not_a_number}, {.5, .1}})
    expect_refused<std::invalid_argument>(
        [&] { GR::equidistant_curves(mesh, height, bad, std::back_inserter(curves)); }, "ascending");
}

TEST(Refused_parameter, maximum_distance)
{
  Mesh mesh = made::plane(4);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance", -1.).first;
  const std::vector<Vertex> side = {Vertex(0), mesh.source(mesh.halfedge(Vertex(0)))};
  for(const double bad : {-1., not_a_number, -infinity})
  {
    const auto np = gp::maximum_distance(bad);
    expect_refused<std::invalid_argument>([&] { GR::geodesic_distances(mesh, distance, Vertex(0), np); },
                                          "maximum distance");
    expect_refused<std::invalid_argument>([&] { GR::geodesic_distances_from_curve(mesh, distance, side, np); },
                                          "maximum distance");
  }
  EXPECT_EQ(distance[Vertex(0)], -1.) << "the map is as it was";
  GR::geodesic_distances(mesh, distance, Vertex(0), gp::maximum_distance(0.));
  EXPECT_EQ(distance[Vertex(0)], 0.);
}
