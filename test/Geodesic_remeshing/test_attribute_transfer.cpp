#include "made_surfaces.h"

#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

// What the vertices, faces and corners of the input carry arrives at those of the output.

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using made::Mesh;
using made::Point;
using made::Vector;
using made::Vertex;
using Face = Mesh::Face_index;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;
using Location = PMP::Face_location<Mesh, double>;

namespace {

struct Attribute_transfer : testing::Test
{
  Mesh input = made::torus(1., .4, 60, 30), output;
  Mesh::Property_map<Vertex, Location> locations = output.add_property_map<Vertex, Location>("v:location").first;

  template <class NamedParameters>
  void remesh(const NamedParameters& np)
  {
    CGAL::geodesic_remeshing(input, 2000, output, np, gp::vertex_location_map(locations));
  }

  template <class Value, class Function>
  auto vertex_values(const Function& value)
  {
    auto from = input.add_property_map<Vertex, Value>("v:value").first;
    for(Vertex v : input.vertices())
      from[v] = value(input.point(v));
    auto to = output.add_property_map<Vertex, Value>("v:value").first;
    GR::transfer_vertex_property(input, from, output, locations, to);
    input.remove_property_map(from);
    return to;
  }
};

double distance(const Point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

} // namespace

TEST_F(Attribute_transfer, locations_are_those_of_PMP)
{
  remesh(gp::number_of_iterations(3));
  for(Vertex v : output.vertices())
  {
    EXPECT_LT(distance(PMP::construct_point(locations[v], input), output.point(v)), 1e-12);
    EXPECT_TRUE(PMP::is_in_face(locations[v], input));
  }
}

TEST_F(Attribute_transfer, linear_functions_are_exact)
{
  remesh(gp::number_of_iterations(3));
  const auto points = vertex_values<Point>([](const Point& p) { return p; });
  const auto vectors = vertex_values<Vector>([](const Point& p) { return 2. * (p - CGAL::ORIGIN); });
  const auto numbers = vertex_values<double>([](const Point& p) { return 1. + p.x() - 3. * p.z(); });
  const auto floats = vertex_values<float>([](const Point& p) { return static_cast<float>(p.y()); });
  const auto arrays = vertex_values<std::array<float, 2>>([](const Point& p) {
    return std::array<float, 2>{{static_cast<float>(p.x()), static_cast<float>(p.z())}};
  });
  for(Vertex v : output.vertices())
  {
    const Point& p = output.point(v);
    EXPECT_LT(distance(points[v], p), 1e-12);
    EXPECT_LT((vectors[v] - 2. * (p - CGAL::ORIGIN)).squared_length(), 1e-24);
    EXPECT_NEAR(numbers[v], 1. + p.x() - 3. * p.z(), 1e-12);
    EXPECT_NEAR(floats[v], p.y(), 1e-6);
    EXPECT_NEAR(arrays[v][0], p.x(), 1e-6);
    EXPECT_NEAR(arrays[v][1], p.z(), 1e-6);
  }
}

TEST_F(Attribute_transfer, locations_may_have_numbers_of_any_type)
{
  using Float_location = PMP::Face_location<Mesh, float>;
  auto inexact = output.add_property_map<Vertex, Float_location>("v:inexact").first;
  CGAL::geodesic_remeshing(input, 500, output, gp::number_of_iterations(1), gp::vertex_location_map(inexact));
  auto height = input.add_property_map<Vertex, double>("v:height").first;
  auto corner = input.add_property_map<Halfedge, double>("h:height").first;
  for(Halfedge h : input.halfedges())
    corner[h] = height[input.target(h)] = input.point(input.target(h)).z();
  auto carried = output.add_property_map<Vertex, double>("v:height").first;
  auto carried_at_corner = output.add_property_map<Halfedge, double>("h:height").first;
  GR::transfer_vertex_property(input, height, output, inexact, carried);
  GR::transfer_corner_property(input, corner, output, inexact, carried_at_corner);
  for(Halfedge h : output.halfedges())
  {
    EXPECT_NEAR(carried[output.target(h)], output.point(output.target(h)).z(), 1e-6);
    EXPECT_NEAR(carried_at_corner[h], output.point(output.target(h)).z(), 1e-6);
  }
}

TEST_F(Attribute_transfer, colours_are_mixed_and_labels_are_not)
{
  remesh(gp::number_of_iterations(3));
  const auto colours = vertex_values<CGAL::IO::Color>(
      [](const Point& p) { return CGAL::IO::Color(static_cast<unsigned char>(100. + 60. * p.x()), 10, 20, 255); });
  const auto labels = vertex_values<int>([](const Point& p) { return p.x() > 0. ? 7 : 1000; });
  std::size_t near_border = 0;
  for(Vertex v : output.vertices())
  {
    const Point& p = output.point(v);
    EXPECT_NEAR(colours[v].red(), 100. + 60. * p.x(), 1.6); // half a step of either
    EXPECT_EQ(colours[v].green(), 10);
    EXPECT_EQ(colours[v].alpha(), 255);
    EXPECT_TRUE(labels[v] == 7 || labels[v] == 1000);
    if(std::abs(p.x()) > .15)
      EXPECT_EQ(labels[v], p.x() > 0. ? 7 : 1000);
    else
      ++near_border;
  }
  EXPECT_GT(near_border, 10u);
}

TEST_F(Attribute_transfer, patches_keep_their_border)
{
  auto patch = input.add_property_map<Face, int>("f:patch").first;
  const auto side = [](const Mesh& mesh, Face f) {
    const auto h = mesh.halfedge(f);
    return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h))))
               .z() > 0.;
  };
  for(Face f : input.faces())
    patch[f] = side(input, f) ? 5 : 9;
  remesh(gp::face_patch_map(patch));
  auto carried = output.add_property_map<Face, int>("f:patch").first;
  GR::transfer_face_property(input, patch, output, locations, carried);
  for(Face f : output.faces())
    EXPECT_EQ(carried[f], side(output, f) ? 5 : 9);
}

// Texture coordinates on a torus jump by one along a circle each way.
TEST_F(Attribute_transfer, seams_stay_sharp)
{
  using Uv = std::array<double, 2>;
  auto uv = input.add_property_map<Halfedge, Uv>("h:uv", Uv()).first;
  auto seam = input.add_property_map<Edge, bool>("e:seam", false).first;
  const auto turn = [](double y, double x) {
    const double t = std::atan2(y, x) / (2. * CGAL_PI);
    return t < -1e-9 ? t + 1. : t;
  };
  const auto coordinates = [&](const Point& p) {
    return Uv{{turn(p.y(), p.x()), turn(p.z(), std::hypot(p.x(), p.y()) - 1.)}};
  };
  const auto unwrap = [](Uv at, const Uv& centre) { // the coordinates of a corner of a face with that centre
    for(int i = 0; i < 2; ++i)
      at[i] += std::round(centre[i] - at[i]);
    return at;
  };
  const auto centre_of = [](const Mesh& mesh, Face f) {
    const auto h = mesh.halfedge(f);
    return CGAL::centroid(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                          mesh.point(mesh.target(mesh.next(h))));
  };
  for(Face f : input.faces())
    for(Halfedge h : input.halfedges_around_face(input.halfedge(f)))
      uv[h] = unwrap(coordinates(input.point(input.target(h))), coordinates(centre_of(input, f)));
  for(Edge e : input.edges())
  {
    const Halfedge h = input.halfedge(e), o = input.opposite(h);
    seam[e] = uv[h] != uv[input.prev(o)] || uv[o] != uv[input.prev(h)];
  }
  remesh(gp::edge_is_constrained_map(seam));
  auto carried = output.add_property_map<Halfedge, Uv>("h:uv", Uv{{-9., -9.}}).first;
  GR::transfer_corner_property(input, uv, output, locations, carried);
  std::size_t at_seams = 0;
  for(Face f : output.faces())
    for(Halfedge h : output.halfedges_around_face(output.halfedge(f)))
    {
      const Uv expected = unwrap(coordinates(output.point(output.target(h))), coordinates(centre_of(output, f)));
      EXPECT_NEAR(carried[h][0], expected[0], .01);
      EXPECT_NEAR(carried[h][1], expected[1], .01);
      at_seams += expected[0] > .999 || expected[1] > .999;
    }
  EXPECT_GT(at_seams, 50u); // corners at the far side of a seam
}

TEST(Attribute_transfer_of_boundaries, an_open_surface)
{
  Mesh input = made::plane(20), output;
  auto locations = output.add_property_map<Vertex, Location>("v:location").first;
  CGAL::geodesic_remeshing(input, 500, output, gp::number_of_iterations(3), gp::vertex_location_map(locations));
  auto corner = input.add_property_map<Halfedge, double>("h:x", 0.).first;
  for(Halfedge h : input.halfedges())
    corner[h] = input.is_border(h) ? -1e9 : input.point(input.target(h)).x();
  auto carried = output.add_property_map<Halfedge, double>("h:x", -1.).first;
  GR::transfer_corner_property(input, corner, output, locations, carried);
  for(Halfedge h : output.halfedges())
    EXPECT_NEAR(carried[h], output.is_border(h) ? -1. : output.point(output.target(h)).x(), 1e-9);
}

// Though they convert to numbers, a mean of them would be another one, or none at all.
TEST(Attribute_transfer_of_labels, enumerators_and_descriptors_are_not_interpolated)
{
  enum Material { wood, stone, steel, glass };
  const std::array<double, 3> at = {{.5, .3, .2}};
  namespace internal = GR::internal;
  EXPECT_EQ(internal::interpolate<Material>(wood, glass, glass, at), wood);
  EXPECT_EQ(internal::interpolate<Face>(Face(10), Face(1000), Face(2000), at), Face(10));
  const std::array<int, 2> a = {{1, 2}}, b = {{3, 4}}, c = {{5, 6}};
  EXPECT_EQ((internal::interpolate<std::array<int, 2>>(a, b, c, at)), a);
  EXPECT_EQ(internal::interpolate<Vector>(Vector(2, 0, 0), Vector(0, 10, 0), Vector(0, 0, 5), at), Vector(1, 3, 1));
}
