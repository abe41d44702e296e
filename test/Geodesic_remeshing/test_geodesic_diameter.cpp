#include <CGAL/Geodesic_remeshing/geodesic_diameter.h>
#include <CGAL/Geodesic_remeshing/internal/Component_extent.h>
#include <CGAL/Geodesic_remeshing/internal/find_roots.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using namespace CGAL::Geodesic_remeshing::internal;

namespace {

// Closed surface of revolution about the z-axis, with `rows` rings between its poles
template <typename Radius, typename Height>
Mesh spindle(unsigned sides, unsigned rows, const Radius& radius, const Height& height)
{
  Mesh mesh;
  for(unsigned j = 1; j <= rows; ++j)
    for(unsigned i = 0; i < sides; ++i)
    {
      const double angle = 2. * CGAL_PI * i / sides, t = double(j) / (rows + 1);
      mesh.add_vertex(Point(radius(t) * std::cos(angle), radius(t) * std::sin(angle), height(t)));
    }
  const auto v = [&](unsigned i, unsigned j) { return Vertex(j * sides + i % sides); };
  const Vertex bottom = mesh.add_vertex(Point(0., 0., height(0.))), top = mesh.add_vertex(Point(0., 0., height(1.)));
  for(unsigned i = 0; i < sides; ++i)
  {
    mesh.add_face(bottom, v(i + 1, 0), v(i, 0));
    mesh.add_face(top, v(i, rows - 1), v(i + 1, rows - 1));
    for(unsigned j = 0; j + 1 < rows; ++j)
    {
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  }
  return mesh;
}

Mesh ellipsoid(double half_length)
{
  return spindle(
      40, 59, [](double t) { return std::sin(CGAL_PI * t); },
      [=](double t) { return -half_length * std::cos(CGAL_PI * t); });
}

} // namespace

TEST(Geodesic_diameter, the_poles_of_a_long_ellipsoid)
{
  const Mesh mesh = ellipsoid(3.);
  const auto diameter = GR::geodesic_diameter(mesh);
  EXPECT_NEAR(diameter.distance, 0.5 * 13.3649, 0.03); // half the ellipse of half axes 1 and 3
  EXPECT_NEAR(std::abs(mesh.point(diameter.first).z()), 3., 0.05);
  EXPECT_NEAR(mesh.point(diameter.first).z() + mesh.point(diameter.second).z(), 0., 0.1);
  EXPECT_GE(diameter.number_of_runs, 2u);
  EXPECT_LE(diameter.number_of_runs, 6u);
}

TEST(Geodesic_diameter, the_opposite_rims_of_a_long_cylinder)
{
  Mesh mesh = spindle(
      30, 80, [](double) { return 1.; }, [](double t) { return 20. * t; });
  CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(80 * 30)), mesh);
  CGAL::Euler::remove_center_vertex(mesh.halfedge(Vertex(80 * 30 + 1)), mesh);
  std::vector<Face> caps;
  for(Face f : mesh.faces())
    if(mesh.degree(f) > 3)
      caps.push_back(f);
  for(Face f : caps)
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  const auto diameter = GR::geodesic_diameter(mesh); // of a mesh with holes in its indices
  const double length = 20. * 79. / 81., half_way_around = 30. * std::sin(CGAL_PI / 30.);
  EXPECT_NEAR(diameter.distance, std::hypot(length, half_way_around), 0.01);
}

TEST(Geodesic_diameter, distances_from_the_first_vertex)
{
  Mesh mesh = ellipsoid(2.);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance", -1.).first;
  const auto diameter = GR::geodesic_diameter(mesh, gp::vertex_distance_map(distance));
  EXPECT_EQ(distance[diameter.first], 0.);
  EXPECT_EQ(distance[diameter.second], diameter.distance);
  for(Vertex v : mesh.vertices())
    EXPECT_LE(distance[v], diameter.distance);
}

TEST(Geodesic_diameter, the_largest_component_counts)
{
  Mesh mesh = ellipsoid(1.);
  const std::size_t first_component = mesh.number_of_vertices();
  CGAL::copy_face_graph(ellipsoid(2.), mesh);
  mesh.add_vertex(Point(100., 0., 0.));
  auto distance = mesh.add_property_map<Vertex, double>("v:distance", -1.).first;
  const auto diameter = GR::geodesic_diameter(mesh, gp::vertex_distance_map(distance));
  EXPECT_GE(diameter.first.idx(), first_component);
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(distance[v] < infinity, v.idx() >= first_component && v.idx() + 1 < mesh.number_of_vertices());
}

TEST(Geodesic_diameter, weights_stretch_the_surface)
{
  Mesh mesh = ellipsoid(1.);
  auto weight = mesh.add_property_map<Vertex, double>("v:weight", 2.5).first;
  EXPECT_NEAR(GR::geodesic_diameter(mesh, gp::vertex_weight_map(weight)).distance,
              2.5 * GR::geodesic_diameter(mesh).distance, 1e-9);
}

TEST(Geodesic_diameter, an_empty_mesh_has_none)
{
  Mesh mesh;
  const auto diameter = GR::geodesic_diameter(mesh);
  EXPECT_EQ(diameter.distance, 0.);
  EXPECT_EQ(diameter.number_of_runs, 0u);
  EXPECT_EQ(diameter.first, Mesh::null_vertex());
  mesh.add_vertex(Point(0., 0., 0.));
  EXPECT_EQ(GR::geodesic_diameter(mesh).first, Mesh::null_vertex());
}

TEST(Roots, one_for_every_component)
{
  Mesh mesh = ellipsoid(3.);
  const std::size_t first_component = mesh.number_of_vertices();
  CGAL::copy_face_graph(ellipsoid(2.), mesh);
  std::size_t number;
  const std::vector<std::uint32_t> component_of = components_of(mesh, number);
  const std::vector<Vertex> roots = find_roots(mesh, Intrinsic_triangulation(mesh), component_of, number);
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_LT(roots[0].idx(), first_component);
  EXPECT_GE(roots[1].idx(), first_component);
  EXPECT_NEAR(std::abs(mesh.point(roots[0]).z()), 3., 0.05);
  EXPECT_NEAR(std::abs(mesh.point(roots[1]).z()), 2., 0.05);
}

// Where many edges are far shorter than in the mean a search in any order would take for ever.
TEST(Roots, of_a_surface_whose_edges_differ_much)
{
  constexpr int n = 100;
  Mesh mesh;
  const auto coordinate = [](const int i) {
    return std::copysign(std::pow(1.05, std::abs(i - n / 2)) - 1., i - n / 2);
  };
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      mesh.add_vertex(Point(coordinate(i), coordinate(j), 0.));
  const auto vertex = [](const int i, const int j) { return Vertex(static_cast<Mesh::size_type>(i * (n + 1) + j)); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  std::size_t number;
  const std::vector<std::uint32_t> component_of = components_of(mesh, number);
  const std::vector<Vertex> roots = find_roots(mesh, Intrinsic_triangulation(mesh), component_of, number);
  ASSERT_EQ(roots.size(), 1u);
  const Point root = mesh.point(roots.front());
  EXPECT_DOUBLE_EQ(std::abs(root.x()), coordinate(n));
  EXPECT_DOUBLE_EQ(std::abs(root.y()), coordinate(n));
}
