#include "distance_to_surface.h"
#include "made_surfaces.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Boundary, features, corners, constrained edges and vertices, patches, many components, places on the input.

namespace PMP = CGAL::Polygon_mesh_processing;
namespace GR = CGAL::Geodesic_remeshing;
namespace parameters = GR::parameters;
using CGAL::geodesic_remeshing;
using GR::internal::Constraints;
using GR::internal::Edge;
using support::Face;
using support::Halfedge;
using support::Mesh;
using support::Point;
using support::Vertex;
using Vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;

namespace {

using Segments = std::vector<std::pair<Point, Point>>;

double diagonal_of(const Mesh& mesh)
{
  const auto box = PMP::bbox(mesh);
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                   CGAL::square(box.zmax() - box.zmin()));
}

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const Vector ab = b - a, ap = p - a;
  const double length = ab.squared_length();
  const double t = length > 0. ? (std::min)(1., (std::max)(0., ap * ab / length)) : 0.;
  return std::sqrt((ap - t * ab).squared_length());
}

// How far the points of the first lines are from the second ones, at most; looked at in ten points of each segment
double distance_of_lines(const Segments& from, const Segments& to)
{
  double largest = 0.;
  for(const auto& s : from)
    for(int i = 0; i <= 10; ++i)
    {
      const Point p = s.first + .1 * i * (s.second - s.first);
      double nearest = std::numeric_limits<double>::infinity();
      for(const auto& t : to)
        nearest = (std::min)(nearest, distance_to_segment(p, t.first, t.second));
      largest = (std::max)(largest, nearest);
    }
  return largest;
}

template <class Is_line>
Segments lines_of(const Mesh& mesh, const Is_line& is_line)
{
  Segments result;
  for(Edge e : mesh.edges())
    if(is_line(e))
      result.emplace_back(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  return result;
}

Vector normal_of(const Mesh& mesh, Face f)
{
  const Halfedge h = mesh.halfedge(f);
  const Point& p = mesh.point(mesh.source(h));
  const Vector n = CGAL::cross_product(mesh.point(mesh.target(h)) - p, mesh.point(mesh.target(mesh.next(h))) - p);
  return n / std::sqrt(n.squared_length());
}

// The creases of 60 degrees and more, and the boundary
bool is_sharp(const Mesh& mesh, Edge e)
{
  const Halfedge h = mesh.halfedge(e), o = mesh.opposite(h);
  return mesh.is_border(e) || normal_of(mesh, mesh.face(h)) * normal_of(mesh, mesh.face(o)) < .5 + 1e-9;
}

std::function<bool(Edge)> sharp_edges_of(const Mesh& mesh)
{
  return [&mesh](Edge e) { return is_sharp(mesh, e); };
}

bool has_vertex_at(const Mesh& mesh, const Point& p)
{
  return std::any_of(mesh.vertices_begin(), mesh.vertices_end(), [&](Vertex v) { return mesh.point(v) == p; });
}

// Vertices at which other than two of the lines meet, or two that turn by 60 degrees
template <class Is_line>
std::vector<Point> corners_of(const Mesh& mesh, const Is_line& is_line)
{
  std::vector<Point> result;
  for(Vertex v : mesh.vertices())
  {
    std::vector<Vector> ways;
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
      if(is_line(mesh.edge(h)))
        ways.push_back(mesh.point(mesh.source(h)) - mesh.point(v));
    if(ways.empty())
      continue;
    const bool turns = ways.size() == 2 &&
                       -(ways[0] * ways[1]) < .5001 * std::sqrt(ways[0].squared_length() * ways[1].squared_length());
    if(ways.size() != 2 || turns)
      result.push_back(mesh.point(v));
  }
  return result;
}

// A result with all that it tells
struct Result
{
  using Location = PMP::Face_location<Mesh, double>;
  Mesh mesh;
  Mesh::Property_map<Vertex, Location> location = mesh.add_property_map<Vertex, Location>("v:location").first;
  Mesh::Property_map<Edge, bool> constrained = mesh.add_property_map<Edge, bool>("e:is_constrained", false).first;
  Mesh::Property_map<Face, int> patch = mesh.add_property_map<Face, int>("f:patch", -1).first;

  template <class Target, class Parameters>
  Result(const Mesh& input, const Target& target, const Parameters& np)
  {
    const auto np_out =
        parameters::vertex_location_map(location).edge_is_constrained_map(constrained).face_patch_map(patch);
    geodesic_remeshing(input, target, mesh, np, np_out);
  }
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;

  Segments lines() const
  {
    return lines_of(mesh, [this](Edge e) { return constrained[e]; });
  }
  int patch_beside(Edge e, int side) const { return patch[mesh.face(mesh.halfedge(e, side))]; }
};

void expect_guarantees(const Mesh& input, const Result& result, std::size_t vertices)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(result.mesh));
  EXPECT_EQ(result.mesh.number_of_vertices(), vertices);
  EXPECT_EQ(support::topology_of(result.mesh), support::topology_of(input));
  const double diagonal = diagonal_of(input);
  for(Vertex v : result.mesh.vertices())
  {
    const Point place = PMP::construct_point(result.location[v], input);
    EXPECT_LT(std::sqrt(CGAL::squared_distance(place, result.mesh.point(v))), 1e-9 * diagonal) << v;
  }
}

// Both ways within this part of the diagonal
void expect_lines_covered(const Segments& input, const Result& result, double tolerance)
{
  EXPECT_LE(distance_of_lines(input, result.lines()), tolerance) << "a line is lost";
  EXPECT_LE(distance_of_lines(result.lines(), input), tolerance) << "an edge is marked that is on no line";
}

void expect_corners(const std::vector<Point>& corners, const Mesh& mesh)
{
  for(const Point& p : corners)
    EXPECT_TRUE(has_vertex_at(mesh, p)) << "corner at " << p;
}

// ---- surfaces with straight lines

struct Straight_case
{
  std::string name;
  Mesh mesh;
};

std::ostream& operator<<(std::ostream& out, const Straight_case& c)
{
  return out << c.name;
}

Mesh with_hole(Mesh mesh, std::initializer_list<unsigned> faces)
{
  for(unsigned f : faces)
    CGAL::Euler::remove_face(mesh.halfedge(Face(f)), mesh);
  mesh.collect_garbage();
  return mesh;
}

std::vector<Straight_case> straight_cases()
{
  const Mesh frame = made::blocks(
      {{{{0, 0, 0}}, {{9, 3, 3}}}, {{{0, 6, 0}}, {{9, 9, 3}}}, {{{0, 3, 0}}, {{3, 6, 3}}}, {{{6, 3, 0}}, {{9, 6, 3}}}});
  const Mesh two_boxes = made::together({made::box(2, 2, 2), made::moved(made::box(1, 3, 1), Vector(5, 0, 0))});
  return {{"cube", made::box(1, 1, 1)},
          {"box", made::box(4, 3, 2)},
          {"L", made::l_shape()},
          {"stairs", made::stairs(4)},
          {"gear", made::gear(12, 8., 10., 4.)},
          {"frame", frame},
          {"thin_box", made::scaled(made::box(40, 40, 1), .1)},
          {"square", made::plane(6)},
          {"two_boxes", two_boxes}};
}

} // namespace

class Straight_lines : public testing::TestWithParam<Straight_case>
{};

TEST_P(Straight_lines, corners_are_exact_and_lines_covered)
{
  const Mesh& input = GetParam().mesh;
  const Segments lines = lines_of(input, sharp_edges_of(input));
  for(std::size_t vertices : {300, 2000})
  {
    SCOPED_TRACE(vertices);
    const Result result(input, vertices, parameters::features_angle_bound(60.));
    expect_guarantees(input, result, vertices);
    expect_corners(corners_of(input, sharp_edges_of(input)), result.mesh);
    expect_lines_covered(lines, result, 1e-9 * diagonal_of(input));
    // all else is flat, so the creases of the output are the lines, too
    EXPECT_LE(distance_of_lines(lines_of(result.mesh, sharp_edges_of(result.mesh)), lines), 1e-9 * diagonal_of(input));
  }
}

TEST_P(Straight_lines, angles_are_good)
{
  const Mesh& input = GetParam().mesh;
  const Result result(input, 2000, parameters::features_angle_bound(60.));
  const support::Quality quality = support::quality_of(result.mesh);
  EXPECT_GT(quality.smallest_angle, 20.);
  EXPECT_GT(quality.mean_smallest_angle, 50.);
}

TEST_P(Straight_lines, pieces_are_numbered_by_what_the_lines_divide)
{
  const Mesh& input = GetParam().mesh;
  const Result result(input, 1000, parameters::features_angle_bound(60.));
  std::map<int, Vector> normal; // these pieces are flat
  for(Face f : result.mesh.faces())
  {
    const auto found = normal.emplace(result.patch[f], normal_of(result.mesh, f)).first;
    EXPECT_GT(found->second * normal_of(result.mesh, f), 1. - 1e-6);
  }
  EXPECT_GE(normal.size(), 1u);
  for(Edge e : result.mesh.edges())
    if(!result.mesh.is_border(e) && !result.constrained[e])
    {
      EXPECT_EQ(result.patch_beside(e, 0), result.patch_beside(e, 1));
    }
}

INSTANTIATE_TEST_SUITE_P(Made, Straight_lines, testing::ValuesIn(straight_cases()),
                         [](const testing::TestParamInfo<Straight_case>& info) { return info.param.name; });

TEST(Features, cube_with_hardly_more_vertices_than_corners)
{
  const Mesh input = made::box(1, 1, 1);
  for(std::size_t vertices : {8, 9, 10, 14, 20})
  {
    const Result result(input, vertices, parameters::features_angle_bound(60.));
    expect_guarantees(input, result, vertices);
    expect_lines_covered(lines_of(input, sharp_edges_of(input)), result, 1e-12);
  }
}

TEST(Features, too_few_vertices_for_the_corners_says_how_many_are_needed)
{
  const Mesh input = made::box(1, 1, 1);
  Mesh output = made::octahedron();
  try
  {
    geodesic_remeshing(input, 7, output, parameters::features_angle_bound(60.));
    FAIL() << "seven vertices for eight corners";
  }
  catch(const GR::Remeshing_error& error)
  {
    EXPECT_NE(std::string(error.what()).find(" 8"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(support::is_same_mesh(output, made::octahedron()));
}

TEST(Features, none_without_the_parameter)
{
  const Result result(made::box(4, 3, 2), 500, parameters::default_values());
  EXPECT_TRUE(result.lines().empty());
}

// Its edges are all there is of it.
TEST(Long_creases, of_few_faces_are_lines_without_the_parameter)
{
  const Mesh input = made::box(1, 1, 1);
  const Result result(input, 300, parameters::default_values());
  expect_guarantees(input, result, 300);
  expect_lines_covered(lines_of(input, sharp_edges_of(input)), result, 1e-9);
  EXPECT_TRUE(Result(input, 300, parameters::features_angle_bound(181.)).lines().empty());
  EXPECT_TRUE(Result(made::box(4, 4, 4), 300, parameters::default_values()).lines().empty()) << "short edges";
}

// The edge of two planes divided differently on both sides: between them are two faces that have nothing but their
// longest side and no normal.
TEST(Features, crease_between_faces_without_area)
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(0., 0., 0.)), b = mesh.add_vertex(Point(3., 0., 0.)),
             m = mesh.add_vertex(Point(1., 0., 0.)), n = mesh.add_vertex(Point(2., 0., 0.)),
             p = mesh.add_vertex(Point(1.5, 2., 0.)), q = mesh.add_vertex(Point(1.5, 0., 2.));
  mesh.add_face(a, m, p);
  mesh.add_face(m, b, p);
  mesh.add_face(a, b, m);
  mesh.add_face(b, a, n);
  mesh.add_face(n, a, q);
  mesh.add_face(b, n, q);
  ASSERT_EQ(mesh.number_of_faces(), 6u);
  const std::vector<char> sharp = GR::internal::find_sharp_edges(mesh, 60.);
  EXPECT_EQ(std::count(sharp.begin(), sharp.end(), 1), 1); // the longest side
}

// No line there would end but in the surface, or leave room for the angles of its neighbours.
TEST(Long_creases, that_dangle_or_are_near_to_others_are_none)
{
  const auto number_of_lines = [](const Mesh& mesh, const double edge_length) {
    Constraints constraints{std::vector<char>(mesh.number_of_edges(), 0),
                            std::vector<char>(mesh.number_of_vertices(), 0)};
    GR::internal::add_long_creases(mesh, edge_length, constraints);
    return std::count(constraints.is_line.begin(), constraints.is_line.end(), 1);
  };
  const auto roof = [](const double half_width) { // a ridge that ends where the four sides meet in one point
    Mesh mesh;
    const Vertex a = mesh.add_vertex(Point(-half_width, 0, 0)), b = mesh.add_vertex(Point(half_width, 0, 0));
    const Vertex c = mesh.add_vertex(Point(0, 9, 0)), top = mesh.add_vertex(Point(0, 0, 9));
    for(const auto& f : {std::array<Vertex, 3>{{a, b, top}}, {{b, c, top}}, {{c, a, top}}, {{b, a, c}}})
      mesh.add_face(f[0], f[1], f[2]);
    return mesh;
  };
  EXPECT_EQ(number_of_lines(roof(9.), 1.), 6) << "all edges";
  EXPECT_EQ(number_of_lines(roof(9.), 5.), 0) << "no edge is that long";
  EXPECT_EQ(number_of_lines(roof(1.), 1.), 0) << "two long edges meet at 12 degrees";
  Mesh hill = made::plane(6); // its ridges end where it meets the plane at 42 degrees
  for(const Vertex v : hill.vertices())
    if(CGAL::squared_distance(hill.point(v), Point(3., 3., 0.)) < .1)
      hill.point(v) = Point(3., 3., .9);
  const std::vector<char> sharp = GR::internal::find_sharp_edges(hill, 45.);
  EXPECT_GT(std::count(sharp.begin(), sharp.end(), 1), 0);
  EXPECT_EQ(number_of_lines(hill, .2), 0);
}

TEST(Features, rims_of_a_cylinder_are_covered_within_the_sagitta)
{
  const Mesh input = made::cylinder(1., 3., 90, 20);
  const Result result(input, 1500, parameters::features_angle_bound(60.));
  expect_guarantees(input, result, 1500);
  double longest = 0.;
  for(const auto& s : result.lines())
    longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(s.first, s.second)));
  const double edge_of_input = 2. * std::sin(CGAL_PI / 90.);
  expect_lines_covered(lines_of(input, sharp_edges_of(input)), result,
                       1.01 * (longest * longest + edge_of_input * edge_of_input) / 8.);
  EXPECT_GT(support::quality_of(result.mesh).mean_smallest_angle, 52.);
}

TEST(Features, ends_of_long_edges_of_a_line_are_kept)
{
  const Mesh input = made::cylinder(1., 3., 12, 4); // a prism
  const Result result(input, 3000, parameters::features_angle_bound(60.));
  expect_lines_covered(lines_of(input, sharp_edges_of(input)), result, 1e-9);
}

TEST(Features, bound_must_be_positive)
{
  const Mesh input = made::box(1, 1, 1);
  Mesh output;
  for(double bound : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(geodesic_remeshing(input, 100, output, parameters::features_angle_bound(bound)),
                 std::invalid_argument);
}

TEST(Features, tip_of_a_cone_is_a_vertex)
{
  Mesh input = made::cylinder(1., 1., 40, 10);
  for(Vertex v : input.vertices()) // the upper end drawn together
  {
    const Point p = input.point(v);
    const double r = 1. - p.z();
    input.point(v) = Point(r * p.x(), r * p.y(), 1.5 * p.z());
  }
  const Result result(input, 800, parameters::features_angle_bound(60.));
  expect_guarantees(input, result, 800);
  EXPECT_TRUE(has_vertex_at(result.mesh, Point(0, 0, 1.5)));
}

// ---- boundary

namespace {

struct Open_case
{
  std::string name;
  Mesh mesh;
  double tolerance; // of the boundary, at 1500 vertices
};

std::ostream& operator<<(std::ostream& out, const Open_case& c)
{
  return out << c.name;
}

std::vector<Open_case> open_cases()
{
  return {
      {"square", made::plane(10), 1e-9},
      {"disc", made::disc(20), 2e-3},
      {"tube", made::cylinder(1., 4., 60, 30, false), 4e-3},
      {"punctured_torus", with_hole(made::torus(3., 1., 40, 20), {101}), .15},
      {"torus_with_three_holes", with_hole(made::torus(3., 1., 40, 20), {101, 700, 1200}), .15},
      {"sphere_with_four_holes", with_hole(made::sphere(4), {0, 300, 700, 1100}), .05},
      {"open_box", with_hole(made::box(1, 1, 1), {0, 1}), 1e-9},
      {"two_discs", made::together({made::disc(8), made::moved(made::disc(12, 2.), Vector(5, 0, 0))}), 2e-2},
      {"closed_and_open", made::together({made::sphere(3), made::moved(made::disc(12, 2.), Vector(5, 0, 0))}), 1e-2}};
}

} // namespace

class Open_surfaces : public testing::TestWithParam<Open_case>
{};

TEST_P(Open_surfaces, keep_their_boundary)
{
  const Mesh& input = GetParam().mesh;
  const auto border = [&](Edge e) { return input.is_border(e); };
  for(std::size_t vertices : {100, 1500})
  {
    const Result result(input, vertices, parameters::features_angle_bound(181.)); // nor creases
    expect_guarantees(input, result, vertices);
    for(Edge e : result.mesh.edges())
      EXPECT_EQ(result.constrained[e], result.mesh.is_border(e));
    if(vertices == 1500)
    {
      expect_lines_covered(lines_of(input, border), result, GetParam().tolerance);
      EXPECT_GT(support::quality_of(result.mesh).smallest_angle, 20.);
      EXPECT_GT(support::quality_of(result.mesh).mean_smallest_angle, 52.);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Open_surfaces, testing::ValuesIn(open_cases()),
                         [](const testing::TestParamInfo<Open_case>& info) { return info.param.name; });

TEST(Open_surface, corners_of_a_square_and_nothing_but_rows_beside_its_sides)
{
  const Result result(made::plane(10), 1500, parameters::default_values());
  expect_corners({Point(0, 0, 0), Point(10, 0, 0), Point(0, 10, 0), Point(10, 10, 0)}, result.mesh);
  EXPECT_GT(support::quality_of(result.mesh).mean_smallest_angle, 56.);
}

TEST(Open_surface, boundary_of_constrained_vertices_is_kept_exactly)
{
  Mesh input = made::disc(10);
  auto constrained = input.add_property_map<Vertex, bool>("v:given", false).first;
  for(Vertex v : input.vertices())
    constrained[v] = input.is_border(v);
  const Result result(input, 800, parameters::vertex_is_constrained_map(constrained));
  expect_guarantees(input, result, 800);
  expect_lines_covered(lines_of(input, [&](Edge e) { return input.is_border(e); }), result, 1e-12);
  for(Vertex v : input.vertices())
  {
    if(constrained[v])
    {
      EXPECT_TRUE(has_vertex_at(result.mesh, input.point(v)));
    }
  }
}

// Every edge of a line is an edge of the output that is marked, and there are no others.
template <class Is_line>
void expect_lines_kept(const Mesh& input, const Is_line& is_line, const Result& result)
{
  std::set<std::pair<Point, Point>> edges;
  const auto ends = [](const Mesh& mesh, Edge e) {
    return std::minmax({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});
  };
  for(Edge e : input.edges())
    if(is_line(e))
      edges.insert(ends(input, e));
  std::size_t found = 0;
  for(Edge e : result.mesh.edges())
    if(result.constrained[e])
    {
      ++found;
      EXPECT_EQ(edges.count(ends(result.mesh, e)), 1u) << "an edge that was none, or a part of one";
    }
  EXPECT_EQ(found, edges.size());
}

TEST(Protected_lines, boundary_edges_stay_as_they_are)
{
  // shorter than the new edges and longer
  for(const Mesh& input : {made::disc(10), made::plane(4), made::cylinder(1., 4., 60, 30, false)})
    for(std::size_t vertices : {200, 800})
    {
      SCOPED_TRACE(vertices);
      const Result result(input, vertices, parameters::protect_constraints(true));
      expect_guarantees(input, result, vertices);
      expect_lines_kept(
          input, [&](Edge e) { return input.is_border(e); }, result);
    }
}

TEST(Protected_lines, features_stay_as_they_are)
{
  for(const Straight_case& c : straight_cases())
  {
    if(c.name != "cube" && c.name != "L" && c.name != "gear") // edges much longer than the new ones, as long, and both
      continue;
    SCOPED_TRACE(c.name);
    const Result result(c.mesh, 600, parameters::features_angle_bound(60.).protect_constraints(true));
    expect_guarantees(c.mesh, result, 600);
    expect_lines_kept(c.mesh, sharp_edges_of(c.mesh), result);
  }
}

TEST(Protected_lines, noisy_boundary_of_a_model)
{
  Mesh input;
  ASSERT_TRUE(CGAL::IO::read_OFF(CGAL::data_file_path("meshes/lion-head.off"), input));
  const Result result(input, 3000, parameters::protect_constraints(true));
  expect_guarantees(input, result, 3000);
  expect_lines_kept(
      input, [&](Edge e) { return input.is_border(e); }, result);
}

TEST(Protected_lines, too_few_vertices_say_how_many_are_needed)
{
  Mesh output;
  const Mesh input = made::plane(30);
  try
  {
    geodesic_remeshing(input, 119, output, parameters::protect_constraints(true));
    FAIL();
  }
  catch(const GR::Remeshing_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("need 120"), std::string::npos) << error.what();
  }
  geodesic_remeshing(input, 119, output, parameters::protect_constraints(false));
  EXPECT_EQ(output.number_of_vertices(), 119u);
}

TEST(Protected_lines, edge_length_and_number_of_faces_count_with_them)
{
  const Mesh input = made::disc(15); // 90 edges on the boundary
  Mesh output;
  geodesic_remeshing(input, GR::Edge_length{.2}, output, parameters::protect_constraints(true));
  const double inside = 2. / std::sqrt(3.) * CGAL_PI / .04 - .5 * 2. * CGAL_PI / .2;
  EXPECT_NEAR(output.number_of_vertices(), 90. + inside, .1 * (90. + inside));
  geodesic_remeshing(input, GR::Number_of_faces{600}, output, parameters::protect_constraints(true));
  EXPECT_EQ(output.number_of_faces(), 600u);
}

TEST(Open_surface, number_of_faces_to_one)
{
  for(const Mesh& input : {made::plane(5), made::disc(8), made::cylinder(1., 4., 60, 30, false)})
    for(std::size_t faces : {200, 1001, 1002})
    {
      Mesh output;
      geodesic_remeshing(input, GR::Number_of_faces{faces}, output);
      EXPECT_LE(output.number_of_faces(), faces);
      EXPECT_GE(output.number_of_faces() + 1, faces) << "an odd number may not be possible";
    }
}

TEST(Open_surface, edge_length)
{
  const Mesh input = made::plane(10);
  Mesh output;
  geodesic_remeshing(input, GR::Edge_length{.5}, output);
  double sum = 0.;
  for(Edge e : output.edges())
    sum += std::sqrt(CGAL::squared_distance(output.point(output.vertex(e, 0)), output.point(output.vertex(e, 1))));
  EXPECT_NEAR(sum / output.number_of_edges(), .5, .02);
}

TEST(Open_surface, one_triangle)
{
  Mesh input, output;
  CGAL::make_triangle(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), input);
  for(std::size_t vertices : {3, 4, 6, 50})
  {
    geodesic_remeshing(input, vertices, output);
    EXPECT_EQ(output.number_of_vertices(), vertices);
    EXPECT_EQ(support::topology_of(output), support::topology_of(input));
    expect_corners({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, output);
  }
  EXPECT_THROW(geodesic_remeshing(input, 2, output), GR::Remeshing_error);
}

// A Moebius strip cannot be a halfedge mesh; as a soup it has an edge whose faces run through it in one direction.

// ---- what the user constrains

namespace {

struct Constrained_sphere
{
  Mesh mesh = made::sphere(4);
  Mesh::Property_map<Edge, bool> edges = mesh.add_property_map<Edge, bool>("e:given", false).first;
  Mesh::Property_map<Vertex, bool> vertices = mesh.add_property_map<Vertex, bool>("v:given", false).first;

  // All edges whose ends fulfil this
  template <class Condition>
  void constrain(const Condition& condition)
  {
    for(Edge e : mesh.edges())
      if(condition(mesh.point(mesh.vertex(e, 0))) && condition(mesh.point(mesh.vertex(e, 1))))
        edges[e] = true;
  }

  Segments lines() const
  {
    return lines_of(mesh, [this](Edge e) { return edges[e]; });
  }
};

} // namespace

TEST(Constrained_edges, circle_dangling_arc_and_crossing)
{
  Constrained_sphere s;
  s.constrain([](const Point& p) { return p.z() == 0.; });                                // closed
  s.constrain([](const Point& p) { return p.x() == 0. && p.y() >= 0. && p.z() >= -.3; }); // crosses it, with two ends
  s.constrain([](const Point& p) { return p.y() == 0. && p.x() > .2 && p.z() > .2; });    // touches nothing
  for(std::size_t vertices : {150, 1500})
  {
    const Result result(s.mesh, vertices, parameters::edge_is_constrained_map(s.edges));
    expect_guarantees(s.mesh, result, vertices);
    expect_lines_covered(s.lines(), result, vertices == 150 ? .06 : .006);
    expect_corners(corners_of(s.mesh, [&](Edge e) { return s.edges[e]; }), result.mesh);
  }
}

TEST(Constrained_edges, lines_nearer_to_each_other_than_the_edge_length)
{
  Constrained_sphere s;
  s.constrain([](const Point& p) { return p.z() == 0.; });
  // a row of edges beside the equator
  for(Edge e : s.mesh.edges())
  {
    const Point &p = s.mesh.point(s.mesh.vertex(e, 0)), &q = s.mesh.point(s.mesh.vertex(e, 1));
    if(p.z() > 0. && q.z() > 0. && (std::max)(p.z(), q.z()) < .13 && std::abs(p.z() - q.z()) < .03)
      s.edges[e] = true;
  }
  for(std::size_t vertices : {200, 400})
  {
    const Result result(s.mesh, vertices, parameters::edge_is_constrained_map(s.edges));
    expect_guarantees(s.mesh, result, vertices);
    expect_corners(corners_of(s.mesh, [&](Edge e) { return s.edges[e]; }), result.mesh);
  }
}

TEST(Constrained_edges, every_edge)
{
  Constrained_sphere s;
  s.mesh = made::sphere(2);
  s.edges = s.mesh.add_property_map<Edge, bool>("e:given", true).first;
  const Result result(s.mesh, 500, parameters::edge_is_constrained_map(s.edges));
  expect_guarantees(s.mesh, result, 500);
  for(Vertex v : s.mesh.vertices())
    EXPECT_TRUE(has_vertex_at(result.mesh, s.mesh.point(v)));
  EXPECT_LT(distance_of_lines(s.lines(), result.lines()), 1e-9);
}

TEST(Constrained_vertices, are_vertices_of_the_output)
{
  Constrained_sphere s;
  for(unsigned v : {3u, 50u, 51u, 400u, 700u})
    s.vertices[Vertex(v)] = true;
  const Result result(s.mesh, 300, parameters::vertex_is_constrained_map(s.vertices));
  expect_guarantees(s.mesh, result, 300);
  for(Vertex v : s.mesh.vertices())
    if(s.vertices[v])
    {
      EXPECT_TRUE(has_vertex_at(result.mesh, s.mesh.point(v))) << v;
    }
}

// ---- patches

TEST(Patches, octants_of_a_sphere)
{
  Mesh input = made::sphere(4);
  auto patch = input.add_property_map<Face, int>("f:octant", 0).first;
  const auto octant = [](const Mesh& mesh, Face f) {
    const Halfedge h = mesh.halfedge(f);
    const Point &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                &r = mesh.point(mesh.target(mesh.next(h)));
    const Point c = CGAL::centroid(p, q, r);
    return 100 + (c.x() > 0.) + 2 * (c.y() > 0.) + 4 * (c.z() > 0.);
  };
  for(Face f : input.faces())
    patch[f] = octant(input, f);
  for(std::size_t vertices : {6, 30, 1000}) // six: every patch is one face, all its vertices are corners
  {
    const Result result(input, vertices, parameters::face_patch_map(patch));
    expect_guarantees(input, result, vertices);
    for(Face f : result.mesh.faces())
      EXPECT_EQ(result.patch[f], octant(result.mesh, f));
    for(Edge e : result.mesh.edges())
      EXPECT_EQ(result.constrained[e], result.patch_beside(e, 0) != result.patch_beside(e, 1));
  }
}

// Large inputs are renumbered inside: what the maps tell of their edges, vertices and faces has to go along.
TEST(Patches, of_a_large_surface_with_a_line_and_sizes)
{
  Mesh input = made::torus(3., 1., 300, 120);
  const auto center_of = [](const Mesh& mesh, Face f) {
    const auto v = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    const auto first = v.begin();
    return CGAL::centroid(mesh.point(*first), mesh.point(*std::next(first)), mesh.point(*std::next(first, 2)));
  };
  const auto side_of = [&](const Mesh& mesh, Face f) { return center_of(mesh, f).y() > 0. ? 7 : 3; };
  auto side = input.add_property_map<Face, int>("f:side").first;
  for(Face f : input.faces())
    side[f] = side_of(input, f);
  auto size = input.add_property_map<Vertex, double>("v:size").first;
  for(Vertex v : input.vertices())
    size[v] = input.point(v).x() > 0. ? 1. : 2.;
  auto is_on_equator = input.add_property_map<Edge, bool>("e:is_on_equator", false).first;
  for(Edge e : input.edges())
    is_on_equator[e] = input.point(input.vertex(e, 0)).x() > 3.9 && input.point(input.vertex(e, 1)).x() > 3.9 &&
                       std::abs(input.point(input.vertex(e, 0)).z()) < 1e-9 &&
                       std::abs(input.point(input.vertex(e, 1)).z()) < 1e-9;

  const Result result(input, 1500,
                      parameters::face_patch_map(side).sizing_field(size).edge_is_constrained_map(is_on_equator));
  expect_guarantees(input, result, 1500);
  for(Face f : result.mesh.faces())
    EXPECT_EQ(result.patch[f], side_of(result.mesh, f)) << f;
  const auto is_line = [&](Edge e) {
    return is_on_equator[e] || side[input.face(input.halfedge(e, 0))] != side[input.face(input.halfedge(e, 1))];
  };
  expect_lines_covered(lines_of(input, is_line), result, .005 * diagonal_of(input));
  EXPECT_GE(std::count_if(input.edges().begin(), input.edges().end(), [&](Edge e) { return is_on_equator[e]; }), 10);
}

TEST(Patches, in_place)
{
  Mesh mesh = made::box(2, 2, 2);
  auto patch = mesh.add_property_map<Face, int>("f:side", 0).first;
  const auto side = [&](Face f) { return int(std::lround(normal_of(mesh, f) * Vector(1, 2, 3))); };
  for(Face f : mesh.faces())
    patch[f] = side(f);
  geodesic_remeshing(mesh, 400, parameters::face_patch_map(patch));
  EXPECT_EQ(mesh.number_of_vertices(), 400u);
  for(Face f : mesh.faces())
    EXPECT_EQ(patch[f], side(f));
}

// The result has more edges than the range has room for.
TEST(Constrained_edges, maps_of_fixed_size_are_only_read_in_place)
{
  Mesh mesh = made::box(2, 2, 2);
  const auto is_at_bottom = [&](Vertex v) { return mesh.point(v).z() < .5; };
  std::unique_ptr<bool[]> marks(new bool[mesh.number_of_edges()]);
  for(Edge e : mesh.edges())
    marks[e.idx()] = is_at_bottom(mesh.vertex(e, 0)) && is_at_bottom(mesh.vertex(e, 1));
  const std::vector<bool> before(marks.get(), marks.get() + mesh.number_of_edges());
  const auto map = boost::make_iterator_property_map(marks.get(), CGAL::get(boost::edge_index, mesh));
  geodesic_remeshing(mesh, 400, parameters::edge_is_constrained_map(map));
  EXPECT_EQ(mesh.number_of_vertices(), 400u);
  EXPECT_EQ(std::vector<bool>(marks.get(), marks.get() + before.size()), before);
}

// ---- components

TEST(Regions_of_faces, are_those_of_the_segmented_surface)
{
  const Mesh input = made::rounded(made::cactus_blocks(), 2);
  GR::Stage_results stages;
  Mesh output;
  auto region = output.add_property_map<Face, int>("f:region", -1).first;
  const GR::Summary summary = geodesic_remeshing(input, 2000, output, parameters::stage_results(std::ref(stages)),
                                                 parameters::face_region_map(region));
  const auto of_surface = stages.regions.property_map<Face, int>("f:region").value();
  std::map<int, double> area, area_of_surface;
  for(Face f : output.faces())
  {
    ASSERT_GE(region[f], 0);
    ASSERT_LT(region[f], int(summary.number_of_regions));
    area[region[f]] += PMP::face_area(f, output);
  }
  for(Face f : stages.regions.faces())
    area_of_surface[of_surface[f]] += PMP::face_area(f, stages.regions);
  EXPECT_GE(area.size(), 3u);
  const double all = PMP::area(input);
  for(const auto& a : area_of_surface)
    EXPECT_NEAR(area[a.first], a.second, .02 * all) << a.first;
}

// Then contraction uses up the surface that was segmented.
TEST(Regions_of_faces, of_an_output_with_far_fewer_faces_than_the_input)
{
  const Mesh input = made::rounded(made::cactus_blocks(), 3);
  GR::Stage_results stages;
  Mesh output;
  auto region = output.add_property_map<Face, int>("f:region", -1).first;
  const int n = static_cast<int>(input.number_of_vertices() / 8);
  const GR::Summary summary = geodesic_remeshing(input, n, output, parameters::stage_results(std::ref(stages)),
                                                 parameters::face_region_map(region));
  const auto of_surface = stages.regions.property_map<Face, int>("f:region").value();
  std::map<int, double> area, area_of_surface;
  for(Face f : output.faces())
    area[region[f]] += PMP::face_area(f, output) / PMP::area(output);
  for(Face f : stages.regions.faces())
    area_of_surface[of_surface[f]] += PMP::face_area(f, stages.regions) / PMP::area(stages.regions);
  EXPECT_EQ(area_of_surface.size(), summary.number_of_regions);
  for(const auto& a : area_of_surface) // shares, since so few faces have a tenth less area than the surface
    EXPECT_NEAR(area[a.first], a.second, .02) << a.first;
}

TEST(Regions_of_faces, in_place_and_with_lines)
{
  Mesh mesh = made::box(3, 2, 2);
  auto region = mesh.add_property_map<Face, int>("f:region", -1).first;
  const GR::Summary summary =
      geodesic_remeshing(mesh, 1000, parameters::features_angle_bound(60.).face_region_map(region));
  EXPECT_EQ(mesh.number_of_vertices(), 1000u);
  std::map<int, Vector> normal; // each side of the box is a region
  for(Face f : mesh.faces())
    EXPECT_GT(normal.emplace(region[f], normal_of(mesh, f)).first->second * normal_of(mesh, f), 1. - 1e-6);
  EXPECT_EQ(normal.size(), summary.number_of_regions);
}

TEST(Many_components, five_thousand_small_ones)
{
  std::vector<Mesh> meshes;
  for(int i = 0; i < 5000; ++i)
  {
    const Vector to(4 * (i % 71), 4 * (i / 71), 0);
    meshes.push_back(i % 3 == 0 ? made::moved(made::plane(1), to) : made::moved(made::sphere(1 + i % 2), to));
  }
  const Mesh input = made::together(meshes);
  Mesh output;
  geodesic_remeshing(input, 40000, output);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(output));
  EXPECT_EQ(output.number_of_vertices(), 40000u);
  EXPECT_EQ(support::topology_of(output), support::topology_of(input));
}

TEST(Many_components, small_ones_get_what_they_need_beside_large_ones)
{
  const Mesh input = made::together({made::sphere(5, 10.), made::moved(made::sphere(3, .01), Vector(20, 0, 0)),
                                     made::moved(made::torus(.03, .01, 20, 10), Vector(30, 0, 0)),
                                     made::moved(made::disc(4, .01), Vector(40, 0, 0))});
  for(std::size_t vertices : {40, 300})
  {
    const Result result(input, vertices, parameters::default_values());
    expect_guarantees(input, result, vertices);
  }
  Mesh output;
  EXPECT_THROW(geodesic_remeshing(input, 17, output), GR::Remeshing_error) << "4 + 4 + 7 + 3 are needed";
}

// ---- sheets much nearer to each other than the edges are long

namespace {

// A square folded over an edge: two sheets at this distance, and half a tube between them
Mesh folded_sheet(double distance)
{
  constexpr double width = 10.;
  const double radius = .5 * distance, half_tube = CGAL_PI * radius;
  constexpr int n = 64;
  Mesh mesh = made::plane(n);
  for(Vertex v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    const double s =
        p.x() / n * (2. * width + half_tube) - width - .5 * half_tube; // the way over the fold, 0 in its middle
    const double beyond = std::abs(s) - .5 * half_tube, up = s < 0. ? -1. : 1.;
    const double y = p.y() * width / n;
    if(beyond > 0.)
      mesh.point(v) = Point(-beyond, y, up * radius);
    else
      mesh.point(v) = Point(radius * std::cos(s / radius), y, radius * std::sin(s / radius));
  }
  return mesh;
}

Mesh thin_box(double thickness)
{
  Mesh mesh = made::box(30, 30, 1);
  for(Vertex v : mesh.vertices())
    mesh.point(v) = Point(mesh.point(v).x(), mesh.point(v).y(), thickness * mesh.point(v).z());
  return mesh;
}

void expect_apart(const Mesh& input, const Result& result, std::size_t vertices)
{
  expect_guarantees(input, result, vertices);
  EXPECT_FALSE(PMP::does_self_intersect(result.mesh));
  EXPECT_NEAR(PMP::area(result.mesh), PMP::area(input), .03 * PMP::area(input));
}

} // namespace

TEST(Thin_sheets, folded_sheet_stays_folded)
{
  for(double distance : {.1, .04, .01})
  {
    SCOPED_TRACE(distance);
    const Mesh input = folded_sheet(distance); // edges of about .6
    const Result result(input, 700, parameters::default_values());
    expect_apart(input, result, 700);
    // away from the fold every edge is in one of the sheets
    for(Edge e : result.mesh.edges())
    {
      const Point& p = result.mesh.point(result.mesh.vertex(e, 0));
      const Point& q = result.mesh.point(result.mesh.vertex(e, 1));
      if(p.x() < -2. && q.x() < -2.)
      {
        EXPECT_GT(p.z() * q.z(), 0.);
      }
    }
  }
}

TEST(Thin_sheets, thin_box)
{
  for(double thickness : {.3, .1, .01})
  {
    SCOPED_TRACE(thickness);
    const Mesh input = thin_box(thickness); // edges of about 3.2
    const Result result(input, 200, parameters::features_angle_bound(60.));
    expect_apart(input, result, 200);
    expect_corners(corners_of(input, sharp_edges_of(input)), result.mesh);
    expect_lines_covered(lines_of(input, sharp_edges_of(input)), result, 1e-9 * diagonal_of(input));
  }
}

TEST(Thin_sheets, nested_spheres)
{
  // edges of about .14; the spheres of the input are at most .002 within round ones, faces .004 within those
  const Mesh input = made::together({made::sphere(4), made::sphere(4, 1.02), made::sphere(4, .98)});
  const Result result(input, 2200, parameters::default_values());
  expect_apart(input, result, 2200);
  for(Vertex v : result.mesh.vertices())
    for(Halfedge h : result.mesh.halfedges_around_target(result.mesh.halfedge(v)))
    {
      const auto radius = [&](Vertex w) { return std::sqrt((result.mesh.point(w) - CGAL::ORIGIN).squared_length()); };
      EXPECT_NEAR(radius(v), radius(result.mesh.source(h)), .005);
    }
}

// ---- models

namespace {

struct Model_case
{
  std::string model;
  std::size_t vertices;
  double feature_angle; // 0: none
  double mean_angle;    // at least
  double lines;         // distance of the lines, in percent of the diagonal
  double distance;      // of the surfaces, at most
};

std::ostream& operator<<(std::ostream& out, const Model_case& c)
{
  return out << c.model << ", " << c.vertices;
}

} // namespace

class Model_with_lines : public testing::TestWithParam<Model_case>
{};

TEST_P(Model_with_lines, keeps_them)
{
  const Model_case& c = GetParam();
  const std::string file = CGAL::data_file_path("meshes/" + c.model + ".off");
  if(c.model == std::string("joint_refined") && !std::ifstream(file))
    GTEST_SKIP() << "the data of this version of CGAL does not have it yet";
  Mesh input;
  ASSERT_TRUE(CGAL::IO::read_OFF(file, input));
  const Result result(input, c.vertices,
                      parameters::features_angle_bound(c.feature_angle > 0. ? c.feature_angle : 999.));
  expect_guarantees(input, result, c.vertices);
  const double diagonal = diagonal_of(input);
  const std::function<bool(Edge)> is_line =
      c.feature_angle > 0. ? sharp_edges_of(input) : [&](Edge e) { return input.is_border(e); };
  EXPECT_LE(distance_of_lines(lines_of(input, is_line), result.lines()), .01 * c.lines * diagonal);
  EXPECT_LE(distance_of_lines(result.lines(), lines_of(input, is_line)), .01 * c.lines * diagonal);
  EXPECT_GE(support::quality_of(result.mesh).smallest_angle, 20.);
  EXPECT_GE(support::quality_of(result.mesh).mean_smallest_angle, c.mean_angle);
  EXPECT_LE(support::largest_distance(result.mesh, input), .01 * c.distance * diagonal);
}

INSTANTIATE_TEST_SUITE_P(
    Data, Model_with_lines,
    testing::Values(Model_case{"fandisk", 3238, 60., 53.5, .19, 1.},
                    Model_case{"anchor_dense", 3000, 60., 53., .45, 2.},
                    Model_case{"joint_refined", 3000, 60., 55.7, .5, 1.}, Model_case{"rotor", 5000, 60., 54., .12, 1.},
                    Model_case{"pinion", 4000, 60., 52., .11, 1.},
                    Model_case{"mannequin-devil", 5000, 0., 55., .08, 3.},
                    Model_case{"lion-head", 5000, 0., 55., .02, 4.}, Model_case{"nefertiti", 3000, 0., 54.5, .015, 1.},
                    Model_case{"mesh_with_border", 1000, 0., 57., .03, 1.},
                    Model_case{"cylinder", 1000, 0., 57.5, .08, 1.}, Model_case{"patch-01", 2000, 0., 54., .03, 3.}),
    [](const testing::TestParamInfo<Model_case>& info) {
      std::string name = info.param.model;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// ---- the parts

namespace internal = GR::internal;

TEST(Lines, pieces_cover_every_line_once_and_end_at_corners)
{
  for(const Straight_case& c : straight_cases())
  {
    SCOPED_TRACE(c.name);
    internal::Input_surface<Mesh> input;
    const auto np = parameters::features_angle_bound(60.);
    internal::copy_input(c.mesh, np, input);
    const Constraints constraints = internal::find_constraints(c.mesh, np, input, .2);
    std::size_t edges = 0;
    for(const auto& piece : internal::trace_lines(input.mesh, constraints))
    {
      edges += piece.halfedges.size();
      for(std::size_t i = 0; i < piece.halfedges.size(); ++i)
      {
        EXPECT_TRUE(constraints.is_line[input.mesh.edge(piece.halfedges[i]).idx()]);
        if(i > 0)
        {
          EXPECT_EQ(input.mesh.target(piece.halfedges[i - 1]), input.mesh.source(piece.halfedges[i]));
        }
        if(i > 0 || piece.is_ring)
        {
          EXPECT_FALSE(constraints.is_corner[input.mesh.source(piece.halfedges[i]).idx()]);
        }
      }
      EXPECT_EQ(constraints.is_corner[input.mesh.source(piece.halfedges.front()).idx()] == 0, piece.is_ring);
    }
    EXPECT_EQ(edges, std::size_t(std::count(constraints.is_line.begin(), constraints.is_line.end(), 1)));
  }
}

TEST(Lines, corners_depend_on_the_scale)
{
  // a boundary that goes up and down at every vertex
  Mesh input = made::plane(40);
  for(Vertex v : input.vertices())
    if(input.point(v).y() == 0.)
      input.point(v) = Point(input.point(v).x(), int(std::lround(input.point(v).x())) % 2 == 0 ? -.6 : .6, 0.);
  internal::Input_surface<Mesh> copy;
  internal::copy_input(input, parameters::default_values(), copy);
  const auto corners = [&](double edge_length) {
    const Constraints c = internal::find_constraints(input, parameters::default_values(), copy, edge_length);
    return std::count_if(c.is_corner.begin(), c.is_corner.end(), [](char x) { return x != 0; });
  };
  EXPECT_GT(corners(.5), 35);
  EXPECT_LE(corners(8.), 8);
}

// Each of 80,000 turns is a candidate for a corner: to look at all corners for each took 10 seconds.
TEST(Lines, corners_of_a_long_saw_take_no_time)
{
  constexpr int teeth = 40000;
  Mesh saw;
  for(int i = 0; i <= 2 * teeth; ++i)
  {
    saw.add_vertex(Point(i, i % 2 == 0 ? 1. : 2., 0.));
    saw.add_vertex(Point(i, 0., 0.));
  }
  for(unsigned i = 0; i < 4 * teeth; i += 2)
  {
    saw.add_face(Vertex(i), Vertex(i + 1), Vertex(i + 3));
    saw.add_face(Vertex(i), Vertex(i + 3), Vertex(i + 2));
  }
  internal::Input_surface<Mesh> copy;
  internal::copy_input(saw, parameters::default_values(), copy);
  const std::clock_t start = std::clock();
  const Constraints c = internal::find_constraints(saw, parameters::default_values(), copy, 1.);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 3.);
  EXPECT_GT(std::count(c.is_corner.begin(), c.is_corner.end(), 1), teeth);
}

TEST(Lines, single_bend_is_a_corner)
{
  Mesh input = made::plane(40);
  for(Vertex v : input.vertices())
  {
    const double x = input.point(v).x();
    if(input.point(v).y() == 0.)
      input.point(v) = Point(x, (std::lround(x) % 2 == 0 ? .05 : -.05) - .36 * std::abs(x - 20.), 0.);
  }
  internal::Input_surface<Mesh> copy;
  internal::copy_input(input, parameters::default_values(), copy);
  const Constraints c = internal::find_constraints(input, parameters::default_values(), copy, 4.);
  for(Vertex v : copy.mesh.vertices())
  {
    const double x = copy.mesh.point(v).x();
    if(copy.mesh.point(v).y() < 1. && x > 1. && x < 39.)
    {
      EXPECT_EQ(c.is_corner[v] != 0, x == 20.) << x;
    }
  }
}

TEST(Lines, spurs_and_specks_that_were_only_detected_are_dropped)
{
  const Mesh mesh = made::plane(20);
  // a long line with a spur of length 2 at its middle, and a line of length 3 that touches nothing
  const auto is_marked = [](const Point& p, const Point& q) {
    const double low = (std::min)(p.y(), q.y()), high = (std::max)(p.y(), q.y());
    return (p.y() == 10. && q.y() == 10.) || (p.x() == 10. && q.x() == 10. && low >= 10. && high <= 12.) ||
           (p.x() == 4. && q.x() == 4. && low >= 2. && high <= 5.);
  };
  const auto left = [&](double edge_length, bool all_given) {
    std::vector<char> marked(mesh.number_of_edges(), 0), none(mesh.number_of_vertices(), 0);
    for(Edge e : mesh.edges())
      marked[e] = is_marked(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
    internal::remove_specks(mesh, edge_length, all_given ? marked : std::vector<char>(marked.size(), 0), none, marked);
    return std::count(marked.begin(), marked.end(), 1);
  };
  EXPECT_EQ(left(1., false), 20 + 2 + 3);
  EXPECT_EQ(left(1.75, false), 20 + 2) << "a line with two ends must be twice as long as a spur";
  EXPECT_EQ(left(2.5, false), 20);
  EXPECT_EQ(left(2.5, true), 20 + 2 + 3);
}

TEST(Lines, cutting_along_them_leaves_the_pieces_apart)
{
  for(const Straight_case& c : straight_cases())
  {
    SCOPED_TRACE(c.name);
    internal::Input_surface<Mesh> input;
    const auto np = parameters::features_angle_bound(60.);
    internal::copy_input(c.mesh, np, input);
    const Constraints constraints = internal::find_constraints(c.mesh, np, input, .5);
    internal::Working_surface working, pieces;
    internal::make_working_surface(input.mesh, constraints, 1., working);
    std::vector<char> is_corner = constraints.is_corner;
    is_corner.resize(working.mesh.number_of_vertices(), 0);
    internal::copy_working_surface(working, pieces);
    internal::cut_along_lines(pieces, is_corner);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(pieces.mesh));
    EXPECT_EQ(is_corner.size(), pieces.mesh.number_of_vertices());
    EXPECT_EQ(pieces.mesh.number_of_faces(), working.mesh.number_of_faces());
    for(Face f : working.mesh.faces())
    {
      const auto before = internal::vertices_of(working.mesh, f), after = internal::vertices_of(pieces.mesh, f);
      for(int i = 0; i < 3; ++i)
        EXPECT_EQ(working.mesh.point(before[i]), pieces.mesh.point(after[i]));
    }
    for(Edge e : pieces.mesh.edges())
      EXPECT_EQ(pieces.is_line[e], pieces.mesh.is_border(e));
    std::size_t number, whole;
    internal::components_of(pieces.mesh, number);
    internal::components_of(working.mesh, whole);
    EXPECT_GE(number, whole);
    if(c.name == "cube" || c.name == "box")
    {
      EXPECT_EQ(number, 6u);
    }
  }
}

TEST(Lines, samples_divide_each_piece_evenly)
{
  const Mesh mesh = made::box(4, 3, 2);
  internal::Input_surface<Mesh> input;
  const auto np = parameters::features_angle_bound(60.);
  internal::copy_input(mesh, np, input);
  const Constraints constraints = internal::find_constraints(mesh, np, input, .3);
  internal::Working_surface working;
  internal::make_working_surface(input.mesh, constraints, .45, working);
  const auto pieces = internal::trace_marked_lines(working.mesh, constraints);
  EXPECT_EQ(pieces.size(), 12u);
  const auto samples = internal::Line_sampler(input.mesh, working).run(constraints, pieces, .3);
  EXPECT_EQ(samples.size(), 8u + 4 * (12 + 9 + 6)); // 4, 3 and 2 divided by 13, 10 and 7
  for(const auto& s : samples)
  {
    const auto& c = s.place.coordinates;
    EXPECT_TRUE(c[0] == 0. || c[1] == 0. || c[2] == 0.) << "exactly on an edge";
    EXPECT_EQ(s.is_pinned, s.vertex.is_valid());
  }
}

// A box of this thickness, 4 long and 4 wide, ready to have its lines sampled for this edge length
struct Thin_box
{
  Thin_box(double thickness, double edge_length)
  {
    Mesh mesh = made::box(1, 1, 1);
    for(Vertex v : mesh.vertices())
    {
      const auto& p = mesh.point(v);
      mesh.point(v) = Point(4. * p.x(), 4. * p.y(), thickness * p.z());
    }
    const auto np = parameters::features_angle_bound(60.);
    internal::copy_input(mesh, np, input);
    const Constraints constraints = internal::find_constraints(mesh, np, input, edge_length);
    internal::make_working_surface(input.mesh, constraints, 1.5 * edge_length, working);
    pieces = internal::trace_marked_lines(working.mesh, constraints);
  }

  internal::Input_surface<Mesh> input;
  internal::Working_surface working;
  std::vector<internal::Line_piece> pieces;
};

TEST(Lines, gaps_between_them_are_measured_over_the_surface)
{
  const Thin_box box(.1, .4);
  const internal::Line_gaps all(box.working.mesh, 10.), narrow(box.working.mesh, 1.), none(box.working.mesh, .05);
  for(const auto& piece : box.pieces)
    for(Halfedge h : piece.halfedges)
    {
      const Vector way(box.working.mesh.point(box.working.mesh.source(h)),
                       box.working.mesh.point(box.working.mesh.target(h)));
      const bool is_upright = way.z() != 0.;
      for(Halfedge side : {h, box.working.mesh.opposite(h)})
      {
        const double gap = all.beside(side);
        EXPECT_NEAR(gap, is_upright || gap > 1. ? 4. : .1, 1e-9);
        EXPECT_EQ(narrow.beside(side) < 1., gap < 1.);
        EXPECT_EQ(none.beside(side), internal::infinity);
      }
      EXPECT_EQ((std::min)(all.beside(h), all.beside(box.working.mesh.opposite(h))) < 1., !is_upright);
    }
}

TEST(Lines, samples_are_denser_where_gaps_are_narrower_than_edges)
{
  // How many times as many samples the eight long lines get, in a gap so many edge lengths wide
  const auto density = [](double width, double most_vertices) {
    Thin_box box(.1, .1 / width);
    internal::Line_densities(box.working.mesh, .1 / width, box.pieces).run(most_vertices);
    double length = 0.;
    const internal::Metric metric(box.working.mesh);
    for(const auto& piece : box.pieces)
      if(internal::even_length_of(metric, piece) > 1.)
        length += internal::length_of(metric, piece);
      else
        EXPECT_TRUE(piece.densities.empty()) << "the upright ones are far from each other";
    return length / (8. * 4.);
  };
  EXPECT_NEAR(density(.4, 1e9), 1., 1e-9) << "wide enough";
  EXPECT_NEAR(density(.25, 1e9), .5 * std::tan(35. * CGAL_PI / 180.) / .25, 1e-6);
  EXPECT_NEAR(density(.16, 1e9), 2., 1e-6) << "no more than twice as many";
  EXPECT_NEAR(density(.14, 1e9), 1., 1e-9) << "too narrow for good angles";
  EXPECT_NEAR(density(.25, 1e-9), 1., 1e-9) << "not enough vertices";
}

// A ring that is narrow for two fifths of a radian around a place, and four edges long there
TEST(Lines, narrow_places_of_a_closed_line_may_lie_across_its_start)
{
  constexpr double edge_length = .1;
  const auto added = [&](double place) {
    constexpr int n = 600;
    Mesh ring;
    for(int i = 0; i < n; ++i)
    {
      const double t = 2. * CGAL_PI * i / n, away = std::abs(std::remainder(t - place, 2. * CGAL_PI));
      const double outer = 1. + .25 * edge_length + (std::min)(1., (std::max)(0., 4. * (away - .2)));
      for(const double radius : {1., outer})
        ring.add_vertex(Point(radius * std::cos(t), radius * std::sin(t), 0.));
    }
    for(int i = 0; i < n; ++i)
    {
      const Vertex in(2 * i), out(2 * i + 1), next_in(2 * i == 2 * n - 2 ? 0 : 2 * i + 2),
          next_out(static_cast<Mesh::size_type>(next_in) + 1);
      ring.add_face(in, out, next_out);
      ring.add_face(in, next_out, next_in);
    }
    internal::Input_surface<Mesh> input;
    internal::copy_input(ring, CGAL::parameters::default_values(), input);
    const Constraints constraints =
        internal::find_constraints(ring, CGAL::parameters::default_values(), input, edge_length);
    internal::Working_surface working;
    internal::make_working_surface(input.mesh, constraints, 1.5 * edge_length, working);
    std::vector<internal::Line_piece> pieces = internal::trace_marked_lines(working.mesh, constraints);
    internal::Line_densities(working.mesh, edge_length, pieces).run(1e9);
    const internal::Metric metric(working.mesh);
    double sum = 0.;
    for(const auto& piece : pieces)
      sum += (internal::length_of(metric, piece) - internal::even_length_of(metric, piece)) / edge_length;
    return sum;
  };
  EXPECT_GT(added(1.), 2.);
  for(const double place : {0., .1, -.1, 3.})
    EXPECT_NEAR(added(place), added(1.), .1) << place;
}

// A disc whose wavy boundary has 65,536 vertices, thousands between two of the output. That took half a minute when
// each of them was tried as a place for one of the output.
TEST(Lines, many_vertices_between_two_of_the_output)
{
  Mesh disc;
  std::vector<Vertex> before;
  double radius = 1.;
  for(std::size_t n = 65536; n >= 8; n /= 2)
  {
    std::vector<Vertex> ring;
    for(std::size_t i = 0; i < n; ++i)
    {
      const double t = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
      const double r = before.empty() ? 1. + .03 * std::sin(11. * t) : radius;
      ring.push_back(disc.add_vertex(Point(r * std::cos(t), r * std::sin(t), 0.)));
    }
    for(std::size_t i = 0; !before.empty() && i < n; ++i)
    {
      const Vertex middle = before[2 * i + 1], next = ring[(i + 1) % n];
      disc.add_face(before[2 * i], middle, ring[i]);
      disc.add_face(middle, before[(2 * i + 2) % (2 * n)], next);
      disc.add_face(middle, next, ring[i]);
    }
    radius *= before.empty() ? .9 : .85;
    before = std::move(ring);
  }
  const Vertex center = disc.add_vertex(Point(0, 0, 0));
  for(std::size_t i = 0; i < before.size(); ++i)
    disc.add_face(before[i], before[(i + 1) % before.size()], center);
  Mesh output;
  CGAL::geodesic_remeshing(disc, 100, output);
  EXPECT_EQ(output.number_of_vertices(), 100u);
}

// Lines along both sides of a thin plate's rim
TEST(Features, gaps_narrower_than_edges_have_good_angles)
{
  Mesh mesh = made::box(1, 1, 1), out;
  for(Vertex v : mesh.vertices())
    mesh.point(v) = Point(mesh.point(v).x(), mesh.point(v).y(), .006 * mesh.point(v).z());
  CGAL::geodesic_remeshing(mesh, 2000, out, parameters::features_angle_bound(60.));
  EXPECT_EQ(out.number_of_vertices(), 2000u);
  EXPECT_GT(support::quality_of(out).smallest_angle, 24.) << "14 where all edges are equally long";
  EXPECT_GT(support::quality_of(out).mean_smallest_angle, 51.);
}

TEST(Lines, cells_are_contracted_along_them)
{
  Mesh mesh = made::plane(20);
  std::vector<Vertex> samples;
  for(Vertex v : mesh.vertices())
  {
    const int x = int(mesh.point(v).x()), y = int(mesh.point(v).y());
    if(x % 5 == 0 && y % 5 == 0)
      samples.push_back(v);
  }
  auto is_line = mesh.add_property_map<Edge, bool>("e:line", false).first;
  for(Edge e : mesh.edges()) // the middle line, too
    is_line[e] = mesh.point(mesh.vertex(e, 0)).x() == 10. && mesh.point(mesh.vertex(e, 1)).x() == 10.;
  EXPECT_TRUE(internal::Cell_contractor(mesh, samples, is_line).run().empty());
  mesh.collect_garbage();
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(mesh.number_of_vertices(), 25u);
  EXPECT_EQ(mesh.number_of_faces(), 32u);
  std::size_t border = 0, middle = 0;
  for(Edge e : mesh.edges())
  {
    const Point &p = mesh.point(mesh.vertex(e, 0)), &q = mesh.point(mesh.vertex(e, 1));
    border += mesh.is_border(e);
    middle += is_line[e] && p.x() == 10. && q.x() == 10.;
    if(is_line[e])
    {
      EXPECT_TRUE(p.x() == q.x() || p.y() == q.y()) << "lines stay straight";
    }
  }
  EXPECT_EQ(border, 16u);
  EXPECT_EQ(middle, 4u);
}
