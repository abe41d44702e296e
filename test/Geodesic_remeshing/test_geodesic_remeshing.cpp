#include "distance_to_surface.h"
#include "made_surfaces.h"
#include "test_support.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

// CGAL::geodesic_remeshing() as users call it, on made surfaces.

namespace PMP = CGAL::Polygon_mesh_processing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using CGAL::geodesic_remeshing;
using CGAL::Geodesic_remeshing::Edge_length;
using CGAL::Geodesic_remeshing::Number_of_faces;
using CGAL::Geodesic_remeshing::Remeshing_error;
using CGAL::Geodesic_remeshing::Stage_results;
using made::Mesh;
using made::Point;
using made::Vector;
using made::Vertex;
using support::Face;
using support::Halfedge;
using support::largest_distance;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

void expect_remeshing_of(const Mesh& input, const Mesh& output, std::size_t vertices)
{
  EXPECT_EQ(output.number_of_vertices(), vertices);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(output));
  EXPECT_TRUE(CGAL::is_triangle_mesh(output));
  EXPECT_TRUE(CGAL::is_closed(output));
  EXPECT_EQ(support::topology_of(output), support::topology_of(input));
}

std::string name_of(const testing::TestParamInfo<std::size_t>& info)
{
  return made::cases()[info.param].name;
}

} // namespace

// ---- made surfaces

class Made_surface : public testing::TestWithParam<std::size_t>
{
protected:
  const Mesh& input() const { return made::cases()[GetParam()].mesh; }
};

TEST_P(Made_surface, is_remeshed_to_the_vertex)
{
  for(std::size_t n : {150, 1000})
  {
    SCOPED_TRACE(n);
    Mesh output;
    const auto summary = geodesic_remeshing(input(), n, output);
    expect_remeshing_of(input(), output, n);
    EXPECT_EQ(summary.number_of_vertices, n);
    EXPECT_EQ(summary.number_of_faces, output.number_of_faces());
  }
}

TEST_P(Made_surface, has_its_vertices_on_the_input)
{
  Mesh output;
  geodesic_remeshing(input(), 400, output);
  EXPECT_LE(largest_distance(output, input()), 1e-9 * std::sqrt(support::area_of(input())));
}

TEST_P(Made_surface, has_no_bad_angles_at_a_fine_resolution)
{
#ifdef NDEBUG
  const std::size_t n = 3000;
#else
  const std::size_t n = 1500;                                 // with all assertions it takes a hundred times as long
#endif
  Mesh output;
  geodesic_remeshing(input(), n, output);
  const support::Quality quality = support::quality_of(output);
  EXPECT_GE(quality.smallest_angle, 20.);
  EXPECT_LE(quality.percent_below_30, .1);
  EXPECT_LE(quality.percent_irregular, 12.);
  EXPECT_FALSE(PMP::does_self_intersect(output));
}

TEST_P(Made_surface, is_remeshed_without_segmentation)
{
  Mesh output;
  geodesic_remeshing(input(), 500, output, gp::use_segmentation(false));
  expect_remeshing_of(input(), output, 500);
}

TEST_P(Made_surface, is_remeshed_without_improvement)
{
  Mesh output;
  geodesic_remeshing(input(), 500, output, gp::number_of_iterations(0u));
  expect_remeshing_of(input(), output, 500);
}

// So few vertices that hardly a curve fits: what was asked for, or a clear error
TEST_P(Made_surface, with_very_few_vertices_is_exact_or_refused)
{
#ifdef NDEBUG
  const std::vector<std::size_t> numbers = {1, 3, 4, 5, 7, 8, 10, 11, 13, 20, 31, 40, 50};
#else
  const std::vector<std::size_t> numbers = {1, 4, 7, 13, 40}; // with all assertions it takes a hundred times as long
#endif
  for(std::size_t n : numbers)
  {
    SCOPED_TRACE(n);
    Mesh output;
    try
    {
      geodesic_remeshing(input(), n, output);
      expect_remeshing_of(input(), output, n);
    }
    catch(const Remeshing_error& error)
    {
      EXPECT_NE(std::string(error.what()).find(std::to_string(n)), std::string::npos) << error.what();
      EXPECT_EQ(output.number_of_vertices(), 0u);
      const auto topology = support::topology_of(input());
      EXPECT_FALSE(n >= 30 && topology.genus() == 0 && topology.components == 1) << "a sphere with so many must do";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Made_surface, testing::Range(std::size_t(0), made::cases().size()), name_of);

TEST(Geodesic_remeshing, sphere_from_four_vertices_on)
{
  const Mesh input = made::sphere(3);
  for(std::size_t n = 4; n <= 50; ++n)
  {
    SCOPED_TRACE(n);
    Mesh output;
    geodesic_remeshing(input, n, output);
    expect_remeshing_of(input, output, n);
  }
}

TEST(Geodesic_remeshing, many_components)
{
  std::vector<Mesh> parts;
  for(int i = 0; i < 60; ++i)
    parts.push_back(made::moved(made::scaled(i % 3 == 0 ? made::torus(2, .7, 20, 10) : made::sphere(2), 1. + .02 * i),
                                Vector(8. * (i % 8), 8. * (i / 8), 0)));
  const Mesh input = made::together(parts);
  Mesh output;
  geodesic_remeshing(input, 6000, output);
  expect_remeshing_of(input, output, 6000);
}

// ---- targets

TEST(Targets, number_of_faces)
{
  const Mesh torus = made::torus(3, 1, 40, 16), sphere = made::sphere(3);
  for(std::size_t n : {500, 501, 2000})
  {
    Mesh output;
    geodesic_remeshing(torus, Number_of_faces{n}, output);
    EXPECT_EQ(output.number_of_faces(), n / 2 * 2);
    geodesic_remeshing(sphere, Number_of_faces{n}, output);
    EXPECT_EQ(output.number_of_faces(), n / 2 * 2);
  }
}

TEST(Targets, edge_length)
{
  const Mesh input = made::torus(3, 1, 60, 24);
  for(double length : {.5, .25, .1})
  {
    SCOPED_TRACE(length);
    Mesh output;
    const auto summary = geodesic_remeshing(input, Edge_length{length}, output);
    double sum = 0.;
    for(auto e : output.edges())
      sum += std::sqrt(CGAL::squared_distance(output.point(output.vertex(e, 0)), output.point(output.vertex(e, 1))));
    EXPECT_NEAR(sum / static_cast<double>(output.number_of_edges()), length, .05 * length);
    EXPECT_NEAR(summary.edge_length, length, .01 * length);
  }
}

TEST(Targets, any_integral_type)
{
  const Mesh input = made::sphere(3);
  Mesh output;
  geodesic_remeshing(input, 300, output);
  EXPECT_EQ(output.number_of_vertices(), 300u);
  geodesic_remeshing(input, static_cast<unsigned short>(310), output);
  EXPECT_EQ(output.number_of_vertices(), 310u);
  geodesic_remeshing(input, 320ll, output);
  EXPECT_EQ(output.number_of_vertices(), 320u);
}

// ---- meshes and maps

TEST(Meshes, in_place)
{
  const Mesh input = made::torus(3, 1, 40, 16);
  Mesh output, mesh = input;
  geodesic_remeshing(input, 700, output);
  geodesic_remeshing(mesh, 700);
  EXPECT_FALSE(mesh.has_garbage());
  EXPECT_TRUE(support::is_same_mesh(mesh, output));
  EXPECT_TRUE(mesh.does_recycle_garbage());
  mesh.set_recycle_garbage(false);
  geodesic_remeshing(mesh, 300, gp::number_of_iterations(1u));
  expect_remeshing_of(input, mesh, 300);
  EXPECT_FALSE(mesh.does_recycle_garbage());
}

TEST(Meshes, output_is_cleared_first)
{
  Mesh output = made::sphere(1), expected;
  geodesic_remeshing(made::sphere(3), 200, output);
  geodesic_remeshing(made::sphere(3), 200, expected);
  EXPECT_TRUE(support::is_same_mesh(output, expected));
}

TEST(Meshes, polyhedron_in_and_out)
{
  const Mesh input = made::torus(3, 1, 40, 16);
  Polyhedron polyhedron, remeshed;
  CGAL::copy_face_graph(input, polyhedron);
  geodesic_remeshing(polyhedron, 600, remeshed);
  EXPECT_EQ(num_vertices(remeshed), 600u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(remeshed));
  EXPECT_TRUE(CGAL::is_closed(remeshed));
  Mesh copy;
  CGAL::copy_face_graph(remeshed, copy);
  expect_remeshing_of(input, copy, 600);
  EXPECT_LE(largest_distance(copy, input), 1e-9);
  geodesic_remeshing(polyhedron, 500); // in place
  EXPECT_EQ(num_vertices(polyhedron), 500u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(polyhedron));
}

TEST(Meshes, other_kernels)
{
  using Simple_point = CGAL::Simple_cartesian<double>::Point_3;
  const Mesh input = made::sphere(3);
  CGAL::Surface_mesh<Simple_point> simple, out;
  for(Vertex v : input.vertices()) // in the same order, which copy_face_graph() would not keep
    simple.add_vertex(Simple_point(input.point(v).x(), input.point(v).y(), input.point(v).z()));
  for(Face f : input.faces())
  {
    const Halfedge h = input.halfedge(f);
    simple.add_face(input.target(h), input.target(input.next(h)), input.source(h));
  }
  Mesh expected;
  geodesic_remeshing(simple, 300, out);
  geodesic_remeshing(input, 300, expected);
  ASSERT_EQ(out.number_of_vertices(), 300u);
  std::vector<Point> points, expected_points; // the output's order of vertices is its own business
  for(Vertex v : out.vertices())
    points.push_back(Point(out.point(v).x(), out.point(v).y(), out.point(v).z()));
  for(Vertex v : expected.vertices())
    expected_points.push_back(expected.point(v));
  std::sort(points.begin(), points.end());
  std::sort(expected_points.begin(), expected_points.end());
  EXPECT_EQ(points, expected_points);
}

TEST(Meshes, vertex_point_maps_in_and_out)
{
  Mesh input = made::torus(3, 1, 40, 16), expected, output;
  geodesic_remeshing(input, 400, expected);
  auto points = input.add_property_map<Vertex, Point>("v:elsewhere").first;
  for(Vertex v : input.vertices())
  {
    points[v] = input.point(v);
    input.point(v) = Point(0, 0, 0);
  }
  auto written = output.add_property_map<Vertex, Point>("v:written", Point(9, 9, 9)).first;
  geodesic_remeshing(input, 400, output, CGAL::parameters::vertex_point_map(points),
                     CGAL::parameters::vertex_point_map(written));
  ASSERT_EQ(output.number_of_vertices(), 400u);
  for(Vertex v : output.vertices())
    EXPECT_EQ(written[v], expected.point(v));
}

TEST(Meshes, names_of_CGAL_and_of_the_package_in_one_chain)
{
  Mesh input = made::sphere(3), output, expected;
  auto points = input.add_property_map<Vertex, Point>("v:elsewhere").first;
  for(Vertex v : input.vertices())
    points[v] = input.point(v);
  geodesic_remeshing(input, 250, output, gp::use_segmentation(false).vertex_point_map(points).number_of_iterations(1u));
  geodesic_remeshing(input, 250, expected, gp::number_of_iterations(1u).use_segmentation(false));
  EXPECT_TRUE(support::is_same_mesh(output, expected));
}

// ---- the same bytes

TEST(Determinism, twice_the_same)
{
  for(const Mesh& input :
      {made::sphere(3), made::box(6, 6, 6), made::branching_tubes({20, 12, 15}), made::chain_of_tori(2)})
  {
    Mesh once, twice;
    geodesic_remeshing(input, 200, once);
    geodesic_remeshing(input, 200, twice);
    EXPECT_TRUE(support::is_same_mesh(once, twice));
  }
}

// What was removed from a mesh before must not matter.
TEST(Determinism, garbage_in_the_input_does_not_matter)
{
  Mesh input = made::together({made::sphere(2), made::moved(made::torus(3, 1, 40, 16), Vector(9, 0, 0))});
  std::vector<Vertex> sphere;
  for(Vertex v : input.vertices())
    if(v.idx() < made::sphere(2).number_of_vertices())
      sphere.push_back(v);
  for(Face f : input.faces())
    if(std::find(sphere.begin(), sphere.end(), input.target(input.halfedge(f))) != sphere.end())
      input.remove_face(f);
  for(auto e : input.edges())
    if(std::find(sphere.begin(), sphere.end(), input.vertex(e, 0)) != sphere.end())
      input.remove_edge(e);
  for(Vertex v : sphere)
    input.remove_vertex(v);
  ASSERT_TRUE(input.has_garbage());
  Mesh compact = input, output;
  compact.collect_garbage();
  geodesic_remeshing(input, 400, output);
  expect_remeshing_of(compact, output, 400);
}

// ---- the visitor

namespace {

struct Witness
{
  void stage(const std::string& name) { stages.push_back(name); }

  bool progress(double done)
  {
    all_done.push_back(done);
    return done < stop_at;
  }

  std::vector<std::string> stages;
  std::vector<double> all_done;
  double stop_at = std::numeric_limits<double>::infinity();
};

} // namespace

TEST(Visitor, is_told_the_stages_in_their_order_and_the_progress)
{
  Witness witness;
  Mesh output;
  const auto summary = geodesic_remeshing(made::torus(3, 1, 40, 16), 2000, output, gp::visitor(std::ref(witness)));
  const std::vector<std::string> order = {"input",  "sizing",  "refinement", "distances",   "regions",
                                          "curves", "samples", "strips",     "improvement", "output"};
  EXPECT_EQ(witness.stages, order);
  ASSERT_EQ(summary.seconds.size(), order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(summary.seconds[i].first, order[i]);
    EXPECT_GE(summary.seconds[i].second, 0.);
  }
  ASSERT_GE(witness.all_done.size(), order.size());
  EXPECT_TRUE(std::is_sorted(witness.all_done.begin(), witness.all_done.end()));
  EXPECT_EQ(witness.all_done.front(), 0.);
  EXPECT_EQ(witness.all_done.back(), 1.);
}

TEST(Visitor, stops_the_work_and_the_output_stays)
{
  Witness all;
  const Mesh input = made::sphere(3);
  Mesh complete;
  geodesic_remeshing(input, 300, complete, gp::visitor(std::ref(all)));
  for(double done : all.all_done)
  {
    if(!(done < 1.))
      break; // then the output is written
    Witness witness;
    witness.stop_at = done;
    Mesh output = made::octahedron(), in_place = input;
    EXPECT_THROW(geodesic_remeshing(input, 300, output, gp::visitor(std::ref(witness))), Remeshing_error);
    EXPECT_TRUE(support::is_same_mesh(output, made::octahedron())) << "stopped at " << done;
    EXPECT_EQ(std::count_if(witness.all_done.begin(), witness.all_done.end(), [&](double d) { return d >= done; }), 1)
        << "once is enough";
    EXPECT_THROW(geodesic_remeshing(in_place, 300, gp::visitor(std::ref(witness))), Remeshing_error);
    EXPECT_TRUE(support::is_same_mesh(in_place, input)) << "stopped at " << done;
  }
}

TEST(Visitor, changes_nothing)
{
  Witness witness;
  Stage_results stages;
  Mesh output, expected;
  geodesic_remeshing(made::torus(3, 1, 40, 16), 500, output,
                     gp::visitor(std::ref(witness)).stage_results(std::ref(stages)));
  geodesic_remeshing(made::torus(3, 1, 40, 16), 500, expected);
  EXPECT_TRUE(support::is_same_mesh(output, expected));
}

TEST(Stage_results, are_kept)
{
  const Mesh input = made::chain_of_tori(2);
  Stage_results stages;
  Mesh output;
  const auto summary = geodesic_remeshing(input, 800, output, gp::stage_results(std::ref(stages)));
  const auto topology = support::topology_of(input);
  EXPECT_EQ(support::topology_of(stages.working_surface), topology);
  EXPECT_EQ(support::topology_of(stages.regions), topology);
  EXPECT_EQ(support::topology_of(stages.strips), topology);
  EXPECT_EQ(stages.curves.size(), summary.number_of_curves);
  ASSERT_TRUE((stages.working_surface.property_map<Vertex, double>("v:distance")));
  ASSERT_TRUE((stages.regions.property_map<Face, int>("f:region")));
  const auto region = stages.regions.property_map<Face, int>("f:region").value();
  for(Face f : stages.regions.faces())
    EXPECT_TRUE(0 <= region[f] && region[f] < static_cast<int>(summary.number_of_regions));
  // every strip vertex is a sample, or one that had to stay
  EXPECT_GE(stages.strips.number_of_vertices() + 2, stages.samples.size());
}

// ---- bad input

namespace {

template <class Exception, class Target>
void expect_refused(const Mesh& input, const Target& target, const std::string& word)
{
  Mesh output = made::octahedron();
  try
  {
    geodesic_remeshing(input, target, output);
    ADD_FAILURE() << "not refused";
  }
  catch(const Exception& error)
  {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
  EXPECT_TRUE(support::is_same_mesh(output, made::octahedron())) << "the output is as it was";
}

} // namespace

TEST(Bad_input, quadrilaterals)
{
  Mesh input = made::sphere(1);
  CGAL::Euler::join_face(input.halfedge(Vertex(0)), input);
  input.collect_garbage();
  expect_refused<std::invalid_argument>(input, 100, "4 vertices");
}

TEST(Bad_input, empty)
{
  Mesh input;
  expect_refused<std::invalid_argument>(input, 100, "no face");
  input.add_vertex(Point(0, 0, 0));
  expect_refused<std::invalid_argument>(input, 100, "no face");
}

TEST(Bad_input, coordinates_that_are_not_finite)
{
  for(double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for(int axis = 0; axis < 3; ++axis)
    {
      Mesh input = made::sphere(2);
      input.point(Vertex(11)) = Point(axis == 0 ? bad : 0., axis == 1 ? bad : 0., axis == 2 ? bad : 0.);
      expect_refused<std::invalid_argument>(input, 100, "vertex 11");
    }
}

TEST(Bad_input, targets_that_are_none)
{
  const Mesh input = made::sphere(2);
  expect_refused<std::invalid_argument>(input, 0, "positive");
  expect_refused<std::invalid_argument>(input, -5, "positive");
  for(double length :
      {0., -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e-9})
    expect_refused<std::invalid_argument>(input, Edge_length{length}, "length");
  expect_refused<Remeshing_error>(input, Number_of_faces{2}, "2 faces");
}

TEST(Bad_input, fewer_vertices_than_the_topology_needs)
{
  expect_refused<Remeshing_error>(made::sphere(2), 3, "4");           // a tetrahedron
  expect_refused<Remeshing_error>(made::torus(3, 1, 40, 16), 6, "7"); // the Csaszar torus
  expect_refused<Remeshing_error>(made::chain_of_tori(2), 9, "10");   // Jungerman and Ringel
  expect_refused<Remeshing_error>(made::together({made::sphere(2), made::moved(made::sphere(2), Vector(4, 0, 0))}), 7,
                                  "8");
}

// ---- input that is no error

TEST(Odd_input, isolated_vertices_are_left_out)
{
  const Mesh clean = made::torus(3, 1, 40, 16);
  Mesh input, output, expected;
  input.add_vertex(Point(50, 50, 50));
  input += clean;
  input.add_vertex(Point(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  geodesic_remeshing(input, 400, output);
  geodesic_remeshing(clean, 400, expected);
  EXPECT_TRUE(support::is_same_mesh(output, expected));
}

TEST(Odd_input, tiny_and_huge_coordinates)
{
  const Mesh input = made::rounded(made::cactus_blocks(), 4);
  Mesh expected;
  geodesic_remeshing(input, 1000, expected);
  const support::Quality quality = support::quality_of(expected);
  for(double factor : {1e-12, 1e12})
  {
    SCOPED_TRACE(factor);
    const Mesh scaled = made::scaled(input, factor);
    Mesh output;
    geodesic_remeshing(scaled, 1000, output);
    expect_remeshing_of(scaled, output, 1000);
    EXPECT_LE(largest_distance(output, scaled), 1e-9 * factor * 40.);
    EXPECT_NEAR(support::quality_of(output).mean_smallest_angle, quality.mean_smallest_angle, 1.);
    EXPECT_GE(support::quality_of(output).smallest_angle, 20.);
  }
}

// A power of two changes no digit, so nothing that is decided may change.
TEST(Odd_input, scaled_by_a_power_of_two)
{
  const Mesh input = made::torus(3, 1, 40, 16);
  Mesh output, expected;
  geodesic_remeshing(made::scaled(input, 1024.), 500, output);
  geodesic_remeshing(input, 500, expected);
  EXPECT_TRUE(support::is_same_mesh(output, made::scaled(expected, 1024.)));
}

// Faces without area: edges of no length, and corners on the opposite edges
TEST(Odd_input, degenerate_faces)
{
  Mesh input = made::torus(3, 1, 40, 16);
  for(int i = 0; i < 30; ++i)
  {
    const Vertex v(static_cast<Mesh::size_type>(20 * i));
    const Halfedge h = input.halfedge(v);
    if(i % 2 == 0) // split off a point at the same place
    {
      const Point p = input.point(v);
      const Halfedge n = CGAL::Euler::split_vertex(h, input.opposite(input.next(input.opposite(input.next(h)))), input);
      for(Vertex w : {input.source(n), input.target(n)})
        input.point(w) = p;
    }
    else // a new vertex on an edge, joined to one side only: beside it a face that is a line
    {
      const Halfedge n = CGAL::Euler::add_center_vertex(h, input);
      input.point(input.target(n)) = CGAL::midpoint(input.point(input.source(h)), input.point(input.target(h)));
    }
  }
  for(Face f : input.faces()) // the splits leave quadrilaterals
    while(input.degree(f) > 3)
    {
      const Halfedge h = input.halfedge(f);
      CGAL::Euler::split_face(h, input.next(input.next(h)), input);
    }
  ASSERT_TRUE(CGAL::is_triangle_mesh(input));
  ASSERT_TRUE(CGAL::is_closed(input));
  ASSERT_GE(std::count_if(input.faces().begin(), input.faces().end(),
                          [&](Face f) { return PMP::is_degenerate_triangle_face(f, input); }),
            30);
  Mesh output;
  geodesic_remeshing(input, 1000, output);
  expect_remeshing_of(input, output, 1000);
  EXPECT_LE(largest_distance(output, input), 1e-9);
  EXPECT_GE(support::quality_of(output).smallest_angle, 20.);
}

TEST(Odd_input, everything_in_one_point)
{
  Mesh input = made::sphere(1), output = made::octahedron();
  for(Vertex v : input.vertices())
    input.point(v) = Point(1, 2, 3);
  EXPECT_THROW(geodesic_remeshing(input, 40, output), std::invalid_argument);
  EXPECT_TRUE(support::is_same_mesh(output, made::octahedron()));
}

// Slivers: a sphere pressed flat to a thousandth, and one with triangles a hundred times as long as wide
TEST(Odd_input, slivers)
{
  for(const Mesh& input : {made::ellipsoid(4, 1, 1, .001), made::cylinder(1, 3, 200, 2)})
  {
    Mesh output;
    geodesic_remeshing(input, 800, output);
    expect_remeshing_of(input, output, 800);
    EXPECT_LE(largest_distance(output, input), 1e-9);
  }
}
