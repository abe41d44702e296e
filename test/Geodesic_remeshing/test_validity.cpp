#include "made_surfaces.h"

#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <sstream>
#include <string>

// is_valid_remeshing() must see every fault: each test makes one, and only that one may be reported.

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using GR::is_valid_remeshing;
using made::Mesh;
using made::Point;
using made::Vector;
using made::Vertex;

namespace {

struct Validity : testing::Test
{
  const Mesh input = made::torus(1., .4, 60, 30);
  Mesh output;

  void SetUp() override { CGAL::geodesic_remeshing(input, 800, output); }
};

// The names of what does not hold
std::string faults(const GR::Remeshing_validity& v)
{
  std::string result;
  const auto add = [&](bool holds, const char* name) { result += holds ? "" : std::string(name) + " "; };
  add(v.is_manifold, "manifold");
  add(v.has_same_components, "components");
  add(v.has_same_genus, "genus");
  add(v.has_same_boundary_loops, "loops");
  add(v.has_number_of_vertices, "number");
  add(v.is_on_surface, "surface");
  add(v.degenerate_faces == 0, "degenerate");
  add(v.flipped_faces == 0, "flipped");
  add(v.self_intersections == 0 || v.input_intersects_itself, "intersections");
  add(v.covers_lines, "lines");
  EXPECT_EQ(static_cast<bool>(v), result.empty());
  return result;
}

} // namespace

TEST_F(Validity, a_remeshing_is_valid)
{
  const auto validity = is_valid_remeshing(input, output, gp::expected_number_of_vertices(800));
  EXPECT_EQ(faults(validity), "");
  EXPECT_LT(validity.distance, 1e-9);
  EXPECT_EQ(validity.number_of_vertices, 800u);
  std::ostringstream out;
  out << validity;
  EXPECT_EQ(out.str().find("NO"), std::string::npos);
  EXPECT_EQ(faults(is_valid_remeshing(input, input)), "");
}

TEST_F(Validity, wrong_number)
{
  const auto validity = is_valid_remeshing(input, output, gp::expected_number_of_vertices(801));
  EXPECT_EQ(faults(validity), "number ");
  std::ostringstream out;
  out << validity;
  EXPECT_NE(out.str().find("number of vertices    NO  (800)"), std::string::npos);
}

TEST_F(Validity, vertices_without_faces)
{
  for(int i = 0; i < 2; ++i)
    output.add_vertex(Point(1e6, 0, 0));
  const auto validity = is_valid_remeshing(input, output, gp::expected_number_of_vertices(800));
  EXPECT_EQ(faults(validity), "manifold number ");
  EXPECT_EQ(validity.number_of_vertices, 802u);
  output.remove_vertex(Vertex(800));
  output.remove_vertex(Vertex(801));
  EXPECT_EQ(faults(is_valid_remeshing(input, output, gp::expected_number_of_vertices(800))), "");
}

TEST_F(Validity, vertex_off_the_surface)
{
  const Vertex v = *output.vertices().begin();
  output.point(v) = output.point(v) + Vector(1e-6, 1e-6, 1e-6);
  EXPECT_EQ(faults(is_valid_remeshing(input, output)), "surface ");
  EXPECT_EQ(faults(is_valid_remeshing(input, output, gp::surface_tolerance(1e-5))), "");
}

TEST_F(Validity, hole)
{
  CGAL::Euler::remove_face(output.halfedge(*output.faces().begin()), output);
  EXPECT_EQ(faults(is_valid_remeshing(input, output)), "loops ");
}

TEST_F(Validity, another_component)
{
  CGAL::make_tetrahedron(Point(0, 0, 9), Point(1e-3, 0, 9), Point(0, 1e-3, 9), Point(0, 0, 9.001), output);
  EXPECT_EQ(faults(is_valid_remeshing(made::together({input, made::moved(made::tetrahedron(), Vector(0, 0, 9))}),
                                      output, gp::surface_tolerance(1.).expected_number_of_vertices(804))),
            "");
  EXPECT_NE(faults(is_valid_remeshing(input, output, gp::surface_tolerance(10.))).find("components"),
            std::string::npos);
}

TEST_F(Validity, another_genus)
{
  Mesh sphere;
  CGAL::geodesic_remeshing(made::sphere(3), 300, sphere);
  EXPECT_NE(faults(is_valid_remeshing(input, sphere, gp::surface_tolerance(10.))).find("genus"), std::string::npos);
}

TEST_F(Validity, turned_inside_out)
{
  CGAL::Polygon_mesh_processing::reverse_face_orientations(output);
  EXPECT_EQ(faults(is_valid_remeshing(input, output)), "flipped ");
  EXPECT_EQ(is_valid_remeshing(input, output).flipped_faces, output.number_of_faces());
}

TEST_F(Validity, degenerate_face)
{
  const auto h = *output.halfedges().begin();
  output.point(output.source(h)) = output.point(output.target(h));
  EXPECT_EQ(is_valid_remeshing(input, output).degenerate_faces, 2u);
  EXPECT_NE(faults(is_valid_remeshing(input, output)).find("degenerate"), std::string::npos);
}

TEST_F(Validity, self_intersection)
{
  // a vertex of the outer side goes through the tube to the inner one
  Vertex outer;
  for(Vertex v : output.vertices())
    outer = !outer.is_valid() || output.point(v).x() > output.point(outer).x() ? v : outer;
  output.point(outer) = Point(.55, 0., 0.);
  const auto validity = is_valid_remeshing(input, output, gp::surface_tolerance(1.));
  EXPECT_GT(validity.self_intersections, 0u);
  EXPECT_NE(faults(validity).find("intersections"), std::string::npos);
  EXPECT_EQ(faults(is_valid_remeshing(output, output)), ""); // not where the input intersects itself
}

// Of such an edge the two faces have no area, and no sheet goes through another one.
TEST_F(Validity, degenerate_faces_of_the_input_are_no_intersections)
{
  Mesh degenerate = input;
  const auto h = *degenerate.halfedges().begin();
  const Point p = degenerate.point(degenerate.source(h));
  const auto to_new = CGAL::Euler::split_edge(h, degenerate);
  degenerate.point(degenerate.target(to_new)) = p;
  CGAL::Euler::split_face(to_new, degenerate.next(degenerate.next(to_new)), degenerate);
  const auto other = degenerate.opposite(h);
  CGAL::Euler::split_face(other, degenerate.next(degenerate.next(other)), degenerate);
  ASSERT_TRUE(CGAL::is_triangle_mesh(degenerate));
  EXPECT_EQ(faults(is_valid_remeshing(degenerate, output)), "");

  const auto g = *output.halfedges().begin();
  output.point(output.source(g)) = CGAL::ORIGIN - (output.point(output.source(g)) - CGAL::ORIGIN);
  const auto validity = is_valid_remeshing(degenerate, output, gp::surface_tolerance(1.));
  EXPECT_GT(validity.self_intersections, 0u);
  EXPECT_FALSE(validity.input_intersects_itself);
}

TEST_F(Validity, not_a_triangle_mesh)
{
  CGAL::Euler::join_face(*output.halfedges().begin(), output);
  EXPECT_NE(faults(is_valid_remeshing(input, output)).find("manifold"), std::string::npos);
  EXPECT_NE(faults(is_valid_remeshing(input, Mesh())).find("manifold"), std::string::npos);
}

TEST(Validity_of_lines, boundary_and_constrained_edges)
{
  Mesh plane = made::plane(10);
  auto marks = plane.add_property_map<Mesh::Edge_index, bool>("e:marks", false).first;
  EXPECT_EQ(faults(is_valid_remeshing(plane, plane)), "");
  Mesh coarse = made::scaled(made::plane(2), 5.);
  EXPECT_EQ(faults(is_valid_remeshing(plane, coarse, gp::edge_is_constrained_map(marks))), "");
  // the line x = 5 is one of the coarse mesh as well, x = 3 is not
  for(const double x : {5., 3.})
  {
    for(auto e : plane.edges())
      marks[e] = plane.point(plane.vertex(e, 0)).x() == x && plane.point(plane.vertex(e, 1)).x() == x;
    const auto validity = is_valid_remeshing(plane, coarse, gp::edge_is_constrained_map(marks));
    EXPECT_EQ(faults(validity), x == 5. ? "" : "lines ");
    EXPECT_EQ(faults(is_valid_remeshing(plane, coarse, gp::edge_is_constrained_map(marks).line_tolerance(.2))), "");
  }
  // a corner of the boundary is cut off
  CGAL::Euler::remove_face(coarse.halfedge(*coarse.faces().begin()), coarse);
  EXPECT_EQ(faults(is_valid_remeshing(plane, coarse)), "lines ");
}

// What a boundary turns to and fro within an edge of the output no mesh of that size covers; of a smooth one the same
// distance is a fault.
TEST(Validity_of_lines, rough_boundary)
{
  Mesh rough = made::plane(60), output;
  std::mt19937 random(3);
  for(const Vertex v : rough.vertices())
    rough.point(v) = rough.point(v) + Vector(0., 0., 4. * random() / static_cast<double>(std::mt19937::max()));
  CGAL::geodesic_remeshing(rough, 200, output);
  const auto validity = is_valid_remeshing(rough, output);
  EXPECT_GT(validity.line_distance, .015);
  EXPECT_EQ(faults(validity), "");
  EXPECT_EQ(faults(is_valid_remeshing(rough, output, gp::line_tolerance(.015))), "lines ");
  const Mesh narrower = made::moved(made::scaled(made::plane(20), 2.88), Vector(1.2, 1.2, 0.));
  EXPECT_EQ(faults(is_valid_remeshing(made::plane(60), narrower)), "lines ");
  EXPECT_LT(is_valid_remeshing(made::plane(60), narrower).line_distance, .03);
}

TEST(Validity_of_lines, bad_input_is_refused)
{
  EXPECT_THROW(is_valid_remeshing(Mesh(), made::plane(2)), std::invalid_argument);
}
