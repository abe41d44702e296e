#include "distance_to_surface.h"
#include "made_surfaces.h"
#include "test_support.h"

#include <CGAL/Geodesic_remeshing/internal/Downhill_search.h>
#include <CGAL/Geodesic_remeshing/internal/Fit_cost.h>
#include <CGAL/Geodesic_remeshing/internal/nearest_in_triangle.h>
#include <CGAL/Geodesic_remeshing/internal/squared_distance_to_segment.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Random.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// The fitted mode: vertices leave the surface so that the mesh as a whole is nearest to it.

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using CGAL::geodesic_remeshing;
using GR::internal::Lean_triangulation;
using made::Mesh;
using made::Point;
using made::Vector;
using made::Vertex;
using support::largest_distance;

namespace {

// Of a point from a mesh
class Distance
{
public:
  explicit Distance(const Mesh& mesh) : m_tree(mesh.faces().begin(), mesh.faces().end(), mesh) {}
  double operator()(const Point& p) const { return std::sqrt(m_tree.squared_distance(p)); }

private:
  CGAL::AABB_tree<CGAL::AABB_traits_3<GR::internal::Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>> m_tree;
};

// Of the points of a surface from a mesh: of the middles of its faces, by their areas
double rms_distance(const Mesh& surface, const Mesh& mesh)
{
  double sum = 0., area = 0.;
  const Distance distance(mesh);
  for(const auto f : surface.faces())
  {
    const auto v = GR::internal::vertices_of(surface, f);
    const Point &p = surface.point(v[0]), &q = surface.point(v[1]), &r = surface.point(v[2]);
    const double share = std::sqrt(CGAL::squared_area(p, q, r));
    sum += share * CGAL::square(distance(CGAL::centroid(p, q, r)));
    area += share;
  }
  return std::sqrt(sum / area);
}

Mesh fitted(const Mesh& input, std::size_t n)
{
  Mesh output;
  geodesic_remeshing(input, n, output, gp::do_project(false));
  return output;
}

double smallest_angle(const Mesh& mesh)
{
  return support::quality_of(mesh).smallest_angle;
}

} // namespace

// ---- the parts

TEST(Nearest_in_triangle, is_that_of_the_kernel)
{
  const Point a(0, 0, 0), b(3, 0, 1), c(1, 2, 0);
  const GR::internal::Kernel::Triangle_3 triangle(a, b, c);
  for(int i = -4; i <= 8; ++i)
    for(int j = -4; j <= 8; ++j)
      for(int k = -2; k <= 2; ++k)
      {
        const Point p(.5 * i, .5 * j, .75 * k);
        const auto nearest = GR::internal::nearest_in_triangle(p, a, b, c);
        EXPECT_NEAR(nearest.squared_distance, CGAL::squared_distance(p, triangle), 1e-12);
        const auto& x = nearest.coordinates;
        const Point foot = CGAL::barycenter(a, x[0], b, x[1], c, x[2]);
        EXPECT_NEAR(CGAL::squared_distance(p, foot), nearest.squared_distance, 1e-12);
        EXPECT_GE((std::min)({x[0], x[1], x[2]}), 0.);
      }
}

// Of triangles without area, an edge without length among them, it is that of the sides.
TEST(Nearest_in_triangle, without_area)
{
  using Vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;
  CGAL::Random random(7);
  const auto number = [&] { return random.get_double(-1., 1.); };
  for(int i = 0; i < 100000; ++i)
  {
    const Point a(number(), number(), number()), p(number(), number(), number());
    const Vector way(number(), number(), number());
    const std::array<double, 3> at = {{0., i % 3 == 0 ? 0. : number(), number()}};
    std::array<Point, 3> t = {{a, a + at[1] * way, a + at[2] * way}};
    std::rotate(t.begin(), t.begin() + i % 7 % 3, t.end());
    const auto nearest = GR::internal::nearest_in_triangle(p, t[0], t[1], t[2]);
    double least = 1e9;
    for(int k = 0; k < 3; ++k)
      least = (std::min)(least, GR::internal::squared_distance_to_segment(p, t[k], t[(k + 1) % 3]));
    ASSERT_NEAR(std::sqrt(nearest.squared_distance), std::sqrt(least), 1e-6) << i;
  }
}

TEST(Downhill_search, finds_the_nearest_face_of_a_sphere_from_any_face_on_its_side)
{
  const Mesh mesh = made::sphere(3);
  const Lean_triangulation table(mesh);
  const auto point_of = [&](Lean_triangulation::Index v) -> const Point& { return mesh.point(Vertex(v)); };
  const GR::internal::Downhill_search<decltype(point_of)> search(table, point_of, 0.);
  const Distance distance(mesh);
  const Point p(.3, -.8, .9);
  for(Lean_triangulation::Index f = 0; f < table.face_slots(); ++f)
  {
    if((point_of(table.source(4 * f)) - CGAL::ORIGIN) * (p - CGAL::ORIGIN) > 0.)
    {
      EXPECT_NEAR(std::sqrt(search.run(f, p, Vector(0, 0, 0)).nearest.squared_distance), distance(p), 1e-12);
    }
  }
}

TEST(Downhill_search, stays_on_the_sheet_where_it_begins)
{
  const Mesh mesh = made::box(4, 4, 1);
  const Lean_triangulation table(mesh);
  const auto point_of = [&](Lean_triangulation::Index v) -> const Point& { return mesh.point(Vertex(v)); };
  const GR::internal::Downhill_search<decltype(point_of)> search(table, point_of, 4.);
  const Point p(2.1, 2.2, .4); // nearer to the lower side
  for(const auto f : mesh.faces())
  {
    const auto v = GR::internal::vertices_of(mesh, f);
    const bool is_upper = mesh.point(v[0]).z() + mesh.point(v[1]).z() + mesh.point(v[2]).z() == 3.;
    const bool is_lower = mesh.point(v[0]).z() + mesh.point(v[1]).z() + mesh.point(v[2]).z() == 0.;
    const auto foot = search.run(Lean_triangulation::Index(f), p, Vector(0, 0, 1));
    if(is_upper)
    {
      EXPECT_NEAR(foot.judged_distance, .36, 1e-12);
    }
    if(is_lower) // seen from behind
    {
      EXPECT_NEAR(foot.judged_distance, .16 + 4., 1e-12);
    }
  }
}

TEST(Fit_system, finds_the_common_point_of_planes)
{
  GR::internal::Fit_system system;
  for(const auto& [normal, distance] :
      {std::pair(Vector(1, 0, 0), 2.), std::pair(Vector(0, .6, .8), -1.), std::pair(Vector(.6, 0, -.8), .5)})
    system.add({{{1., 0., 0.}}, distance * normal, distance * distance}, 1., 3., 1.);
  const Vector step = system.least();
  EXPECT_NEAR(step * Vector(1, 0, 0), 2., 1e-12);
  EXPECT_NEAR(step * Vector(0, .6, .8), -1., 1e-12);
  EXPECT_NEAR(step * Vector(.6, 0, -.8), .5, 1e-12);
}

// ---- whole remeshings

TEST(Fitting, makes_a_valid_mesh_much_nearer_to_the_surface)
{
  for(const Mesh& input : {made::torus(3, 1, 60, 24), made::spiky_sphere(5, 1.2, .35)})
  {
    Mesh plain;
    geodesic_remeshing(input, 700, plain);
    Mesh output;
    const auto summary = geodesic_remeshing(input, 700, output, gp::do_project(false));
    EXPECT_TRUE(GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(700).surface_tolerance(.02)))
        << GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(700).surface_tolerance(.02));
    EXPECT_GE(smallest_angle(output), 30.);
    const double distance = rms_distance(input, output);
    EXPECT_LT(distance, .5 * rms_distance(input, plain));
    EXPECT_LT(largest_distance(input, output), largest_distance(input, plain));
    EXPECT_NEAR(summary.rms_distance, distance, .15 * distance);
    EXPECT_GE(summary.largest_distance, .99 * largest_distance(output, input));
    EXPECT_LT(summary.largest_distance, .25);
  }
}

TEST(Fitting, leaves_the_surface_only_when_asked)
{
  const Mesh input = made::sphere(4);
  Mesh on_surface, by_name;
  const auto summary = geodesic_remeshing(input, 300, on_surface);
  geodesic_remeshing(input, 300, by_name, gp::do_project(true));
  EXPECT_TRUE(support::is_same_mesh(on_surface, by_name));
  EXPECT_LT(largest_distance(on_surface, input), 1e-9);
  EXPECT_EQ(summary.rms_distance, 0.);
  EXPECT_GT(largest_distance(fitted(input, 300), input), 1e-4);
}

TEST(Fitting, gives_the_same_mesh_each_time)
{
  const Mesh input = made::torus(2, 1, 40, 20);
  EXPECT_TRUE(support::is_same_mesh(fitted(input, 500), fitted(input, 500)));
}

TEST(Fitting, is_the_same_at_any_scale_and_place_but_for_rounding)
{
  const Mesh input = made::spiky_sphere(4, 1., .4);
  const double distance = rms_distance(input, fitted(input, 400));
  const Mesh small = made::scaled(input, 1e-6);
  EXPECT_NEAR(rms_distance(small, fitted(small, 400)) / 1e-6, distance, .2 * distance);
}

TEST(Fitting, keeps_features_and_corners)
{
  const Mesh input = made::divided(made::box(2, 3, 2), 3);
  Mesh output;
  auto is_line = output.add_property_map<GR::internal::Edge, bool>("e:line", false).first;
  geodesic_remeshing(input, 800, output, gp::do_project(false).features_angle_bound(60),
                     gp::edge_is_constrained_map(is_line));
  EXPECT_EQ(output.number_of_vertices(), 800u);
  // Flat sides and straight creases leave nothing to fit.
  EXPECT_LT(largest_distance(output, input), 1e-3);
  EXPECT_LT(largest_distance(input, output), 1e-3);
  for(const auto e : output.edges())
    for(int i = 0; i < 2 && is_line[e]; ++i)
    {
      const Point& p = output.point(output.vertex(e, i));
      const int at_ends = (p.x() == 0. || p.x() == 2.) + (p.y() == 0. || p.y() == 3.) + (p.z() == 0. || p.z() == 2.);
      EXPECT_GE(at_ends, 2) << p;
    }
}

TEST(Fitting, keeps_the_boundary)
{
  Mesh input = made::disc(20);
  for(const Vertex v : input.vertices()) // a dome
  {
    const Point& p = input.point(v);
    input.point(v) = Point(p.x(), p.y(), .7 * (1. - p.x() * p.x() - p.y() * p.y()));
  }
  const Mesh output = fitted(input, 200);
  EXPECT_TRUE(GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(200).surface_tolerance(.02)));
  for(const auto e : output.edges())
    if(output.is_border(e))
    {
      EXPECT_NEAR(output.point(output.vertex(e, 0)).z(), 0., 1e-12);
    }
  Mesh plain;
  geodesic_remeshing(input, 200, plain);
  EXPECT_LT(rms_distance(input, output), .6 * rms_distance(input, plain));
}

TEST(Fitting, keeps_thin_sheets_apart)
{
  const Mesh input = made::divided(made::box(12, 12, 1));
  const Mesh output = fitted(input, 250); // edges of more than the thickness
  EXPECT_EQ(output.number_of_vertices(), 250u);
  EXPECT_FALSE(PMP::does_self_intersect(output));
  EXPECT_EQ(support::topology_of(output), support::topology_of(input));
  EXPECT_LT(largest_distance(output, input), .5);
}

TEST(Fitting, of_few_large_faces_does_not_mistake_the_sides_of_thin_walls)
{
  const Mesh input = made::gear(16, 2., 4., .3); // as thick as the edges of the output are long
  Mesh output;
  const GR::Summary summary = geodesic_remeshing(input, 1500, output, gp::do_project(false));
  EXPECT_LT(summary.largest_distance, .5 * summary.edge_length);
  EXPECT_FALSE(PMP::does_self_intersect(output));
}

TEST(Fitting, tells_the_nearest_place_of_each_vertex)
{
  using Location = PMP::Face_location<Mesh, double>;
  const Mesh input = made::torus(3, 1, 40, 16);
  Mesh output;
  auto location = output.add_property_map<Vertex, Location>("v:location").first;
  geodesic_remeshing(input, 400, output, gp::do_project(false), gp::vertex_location_map(location));
  const Distance distance(input);
  for(const Vertex v : output.vertices())
  {
    const Point nearest = PMP::construct_point(location[v], input);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(nearest, output.point(v))), distance(output.point(v)), 1e-9);
  }
}

TEST(Fitting, follows_a_sizing_and_else_the_curvature)
{
  Mesh input = made::ellipsoid(5, 1., 1., 4.), uniform;
  const auto ones = input.add_property_map<Vertex, double>("v:size", 1.).first;
  geodesic_remeshing(input, 600, uniform, gp::do_project(false).sizing_field(ones));
  const Mesh by_curvature = fitted(input, 600);
  const auto number_at_tips = [](const Mesh& mesh) {
    const auto all = mesh.vertices();
    return std::count_if(all.begin(), all.end(), [&](Vertex v) { return std::abs(mesh.point(v).z()) > 3.5; });
  };
  EXPECT_GT(number_at_tips(by_curvature), 1.2 * number_at_tips(uniform));
  // A length asks for as many vertices as without fitting.
  Mesh plain, of_length;
  geodesic_remeshing(input, GR::Edge_length{.3}, plain);
  geodesic_remeshing(input, GR::Edge_length{.3}, of_length, gp::do_project(false));
  EXPECT_EQ(of_length.number_of_vertices(), plain.number_of_vertices());
}

TEST(Fitting, is_a_stage_that_the_visitor_can_stop)
{
  struct Visitor : GR::Default_visitor
  {
    void stage(const std::string& name) { is_fitting = name == "fitting"; }
    bool progress(double) { return !is_fitting || ++asked < 3; }
    bool is_fitting = false;
    int asked = 0;
  } visitor;
  Mesh output = made::octahedron();
  EXPECT_THROW(geodesic_remeshing(made::sphere(3), 200, output, gp::do_project(false).visitor(std::ref(visitor))),
               GR::Remeshing_error);
  EXPECT_EQ(visitor.asked, 3);
  EXPECT_TRUE(support::is_same_mesh(output, made::octahedron()));
}

TEST(Fitting, of_tiny_meshes_keeps_their_topology)
{
  for(const std::size_t n : {4u, 5u, 8u, 20u})
  {
    const Mesh input = made::sphere(3), output = fitted(input, n);
    EXPECT_EQ(output.number_of_vertices(), n);
    EXPECT_EQ(support::topology_of(output), support::topology_of(input));
  }
}
