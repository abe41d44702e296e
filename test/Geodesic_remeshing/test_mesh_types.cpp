#include "made_surfaces.h"
#include "test_support.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/Geodesic_remeshing/equidistant_curves.h>
#include <CGAL/Geodesic_remeshing/geodesic_diameter.h>
#include <CGAL/Geodesic_remeshing/geodesic_distances.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Geodesic_remeshing/region_segmentation.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/geodesic_remeshing.h>

#ifdef CGAL_USE_OPENMESH
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

// Every public function with every type of mesh that PMP takes.

namespace PMP = CGAL::Polygon_mesh_processing;
namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using made::Mesh;
using made::Point;

namespace {

template <class Kernel>
using Surface_mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Linear_cell_complex =
    CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, CGAL::Linear_cell_complex_traits<3, Epick>>::type;

template <class Graph>
constexpr bool has_floats = false;
template <>
constexpr bool has_floats<Surface_mesh<CGAL::Simple_cartesian<float>>> = true;
#ifdef CGAL_USE_OPENMESH
template <>
constexpr bool has_floats<OpenMesh::PolyMesh_ArrayKernelT<>> = true; // by its default traits
template <>
constexpr bool has_floats<OpenMesh::TriMesh_ArrayKernelT<>> = true;
#endif

template <class Graph>
struct Mesh_type : testing::Test
{
  using Traits = boost::graph_traits<Graph>;
  using Vertex_descriptor = typename Traits::vertex_descriptor;
  using Graph_point =
      typename boost::property_traits<typename boost::property_map<Graph, CGAL::vertex_point_t>::type>::value_type;

  static constexpr double tolerance = has_floats<Graph> ? 1e-6 : 1e-9;

  Graph torus, disc;

  void SetUp() override
  {
    CGAL::copy_face_graph(made::torus(3, 1, 24, 10), torus);
    CGAL::copy_face_graph(made::disc(6), disc);
  }

  // is_valid_remeshing() with the tolerance that the numbers allow
  template <class Input, class Output>
  static void expect_valid(const Input& input, const Output& output, std::size_t n)
  {
    const auto validity =
        GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(n).surface_tolerance(tolerance));
    EXPECT_TRUE(validity) << validity;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(output));
    EXPECT_TRUE(CGAL::is_triangle_mesh(output));
    EXPECT_EQ(num_vertices(output), n);
  }
};

using Mesh_types =
    testing::Types<Surface_mesh<Epick>, Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel>,
                   Surface_mesh<CGAL::Simple_cartesian<float>>, CGAL::Polyhedron_3<Epick>, Linear_cell_complex
#ifdef CGAL_USE_OPENMESH
                   ,
                   OpenMesh::TriMesh_ArrayKernelT<>
#endif
                   >;
TYPED_TEST_SUITE(Mesh_type, Mesh_types, ); // the comma is for clang, which wants an argument for the names

} // namespace

TYPED_TEST(Mesh_type, is_remeshed_to_its_own_type)
{
  for(const TypeParam* input : {&this->torus, &this->disc})
  {
    TypeParam output;
    CGAL::geodesic_remeshing(*input, 200, output);
    this->expect_valid(*input, output, 200);
  }
}

TYPED_TEST(Mesh_type, is_remeshed_in_place)
{
  TypeParam mesh = this->torus;
  CGAL::geodesic_remeshing(mesh, 150);
  this->expect_valid(this->torus, mesh, 150);
  const TypeParam once = mesh;
  CGAL::geodesic_remeshing(mesh, GR::Number_of_faces{400}, gp::features_angle_bound(60).number_of_iterations(1));
  this->expect_valid(once, mesh, 200);
}

TYPED_TEST(Mesh_type, mixes_with_another_one)
{
  Mesh surface_mesh;
  CGAL::geodesic_remeshing(this->torus, 200, surface_mesh);
  this->expect_valid(this->torus, surface_mesh, 200);
  TypeParam back;
  CGAL::geodesic_remeshing(surface_mesh, 150, back);
  this->expect_valid(surface_mesh, back, 150);
}

TYPED_TEST(Mesh_type, external_point_maps)
{
  using Vertex = typename TestFixture::Vertex_descriptor;
  std::map<Vertex, Point> points, written;
  for(const Vertex v : vertices(this->torus))
  {
    const auto& p = get(CGAL::vertex_point, this->torus, v);
    points[v] = Point(1. + CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  }
  TypeParam output;
  const auto np_in = CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points));
  const auto np_out = CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(written));
  CGAL::geodesic_remeshing(this->torus, 200, output, np_in, np_out);
  const auto validity = GR::is_valid_remeshing(this->torus, output, np_in, np_out);
  EXPECT_TRUE(validity) << validity;
  EXPECT_EQ(written.size(), 200u);
}

TYPED_TEST(Mesh_type, dynamic_property_maps)
{
  using Location =
      std::pair<typename TestFixture::Traits::face_descriptor, std::array<double, 3>>; // PMP's `Face_location`
  const TypeParam& input = this->torus;
  const auto height_in = [&](auto v) { return CGAL::to_double(get(CGAL::vertex_point, input, v).z()); };
  TypeParam output;
  auto input_patch = get(CGAL::dynamic_face_property_t<int>(), input);
  for(auto f : faces(input))
    put(input_patch, f, height_in(target(halfedge(f, input), input)) > 0 ? 7 : 3);
  auto input_height = get(CGAL::dynamic_vertex_property_t<double>(), input);
  for(auto v : vertices(input))
    put(input_height, v, height_in(v));
  auto patch = get(CGAL::dynamic_face_property_t<int>(), output);
  auto location = get(CGAL::dynamic_vertex_property_t<Location>(), output);
  auto height = get(CGAL::dynamic_vertex_property_t<double>(), output);
  auto is_line = get(CGAL::dynamic_edge_property_t<char>(), output); // CGAL's edge maps of OpenMesh cannot hold bool
  CGAL::geodesic_remeshing(input, 300, output, gp::face_patch_map(input_patch),
                           gp::face_patch_map(patch).vertex_location_map(location).edge_is_constrained_map(is_line));
  std::size_t lines = 0;
  for(auto e : edges(output))
  {
    const auto f = face(halfedge(e, output), output), g = face(opposite(halfedge(e, output), output), output);
    EXPECT_EQ(get(is_line, e) != 0, get(patch, f) != get(patch, g));
    lines += get(is_line, e);
  }
  EXPECT_GT(lines, 10u);
  for(auto f : faces(output))
    EXPECT_TRUE(get(patch, f) == 3 || get(patch, f) == 7);
  GR::transfer_vertex_property(input, input_height, output, location, height);
  for(auto v : vertices(output))
    EXPECT_NEAR(get(height, v), CGAL::to_double(get(CGAL::vertex_point, output, v).z()), 1e-6);
}

TYPED_TEST(Mesh_type, distances_and_diameter)
{
  const TypeParam& input = this->torus;
  auto distance = get(CGAL::dynamic_vertex_property_t<double>(), input);
  auto to_curve = get(CGAL::dynamic_vertex_property_t<double>(), input);
  const auto diameter = GR::geodesic_diameter(input, gp::vertex_distance_map(distance));
  EXPECT_GT(diameter.distance, 9.);
  EXPECT_NEAR(get(distance, diameter.second), diameter.distance, 1e-5);
  GR::geodesic_distances(input, distance, diameter.second);
  EXPECT_NEAR(get(distance, diameter.first), diameter.distance, .02 * diameter.distance);
  const auto h = halfedge(diameter.first, input);
  GR::geodesic_distances_from_curve(
      input, to_curve, std::vector<typename TestFixture::Vertex_descriptor>{source(h, input), target(h, input)});
  for(auto v : vertices(input))
    EXPECT_GE(get(to_curve, v), 0.);
  EXPECT_EQ(get(to_curve, diameter.first), 0.);
}

TYPED_TEST(Mesh_type, regions_and_curves)
{
  const TypeParam& input = this->torus;
  auto region = get(CGAL::dynamic_face_property_t<int>(), input);
  const auto tree = GR::region_segmentation(input, .5, region);
  EXPECT_GE(tree.size(), 3u);
  for(auto f : faces(input))
    EXPECT_LT(static_cast<std::size_t>(get(region, f)), tree.size());
  auto height = get(CGAL::dynamic_vertex_property_t<double>(), input);
  for(auto v : vertices(input))
    put(height, v, CGAL::to_double(get(CGAL::vertex_point, input, v).z()));
  std::vector<GR::Equidistant_curve<TypeParam, typename TestFixture::Graph_point>> curves;
  GR::equidistant_curves(input, height, {.25}, std::back_inserter(curves));
  ASSERT_EQ(curves.size(), 2u);
  for(const auto& curve : curves)
  {
    EXPECT_TRUE(curve.is_closed);
    for(const auto& p : curve.points)
      EXPECT_NEAR(CGAL::to_double(p.z()), .25, 1e-6);
  }
}

TYPED_TEST(Mesh_type, sizing_and_transfer)
{
  using Location = std::pair<typename TestFixture::Traits::face_descriptor, std::array<double, 3>>;
  const TypeParam& input = this->torus;
  TypeParam output;
  auto location = get(CGAL::dynamic_vertex_property_t<Location>(), output);
  const GR::Curvature_sizing_field<TypeParam> sizing(input, gp::contrast(1.));
  CGAL::geodesic_remeshing(input, 300, output, gp::sizing_field(sizing), gp::vertex_location_map(location));
  this->expect_valid(input, output, 300);
  auto number = get(CGAL::dynamic_face_property_t<int>(), input);
  int n = 0;
  for(auto f : faces(input))
    put(number, f, n++);
  auto of_face = get(CGAL::dynamic_face_property_t<int>(), output);
  GR::transfer_face_property(input, number, output, location, of_face);
  auto corner = get(CGAL::dynamic_halfedge_property_t<double>(), input);
  for(auto h : halfedges(input))
    put(corner, h, CGAL::to_double(get(CGAL::vertex_point, input, target(h, input)).x()));
  auto of_corner = get(CGAL::dynamic_halfedge_property_t<double>(), output);
  GR::transfer_corner_property(input, corner, output, location, of_corner);
  for(auto f : faces(output))
    EXPECT_TRUE(0 <= get(of_face, f) && get(of_face, f) < n);
  for(auto h : halfedges(output))
    EXPECT_NEAR(get(of_corner, h), CGAL::to_double(get(CGAL::vertex_point, output, target(h, output)).x()), 1e-5);
}

TYPED_TEST(Mesh_type, filtered_graph)
{
  auto part = get(CGAL::dynamic_face_property_t<int>(), this->torus);
  for(auto f : faces(this->torus))
    put(part, f, get(CGAL::vertex_point, this->torus, target(halfedge(f, this->torus), this->torus)).x() > 0 ? 1 : 0);
  const CGAL::Face_filtered_graph<TypeParam> half(this->torus, 1, part);
  Mesh output;
  CGAL::geodesic_remeshing(half, 150, output);
  this->expect_valid(half, output, 150);
}

// ---- types that differ little from those above

namespace {

template <class Graph>
void expect_remeshing_of_its_own_type()
{
  Graph input, output;
  CGAL::copy_face_graph(made::disc(6), input);
  CGAL::geodesic_remeshing(input, 200, output);
  CGAL::geodesic_remeshing(output, 150);
  Mesh_type<Graph>::expect_valid(input, output, 150);
}

} // namespace

TEST(Similar_mesh_types, are_remeshed)
{
  expect_remeshing_of_its_own_type<Surface_mesh<CGAL::Simple_cartesian<double>>>();
  expect_remeshing_of_its_own_type<CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>>();
#ifdef CGAL_USE_OPENMESH
  expect_remeshing_of_its_own_type<OpenMesh::PolyMesh_ArrayKernelT<>>();
#endif
}

#ifdef CGAL_USE_OPENMESH
TEST(Mesh_of_OpenMesh, in_place_leaves_no_garbage_and_keeps_properties)
{
  OpenMesh::TriMesh_ArrayKernelT<> mesh;
  CGAL::copy_face_graph(made::disc(6), mesh);
  OpenMesh::VPropHandleT<int> mark;
  mesh.add_property(mark);
  CGAL::geodesic_remeshing(mesh, 150);
  EXPECT_EQ(mesh.n_vertices(), 150u);
  for(const auto v : mesh.vertices())
    mesh.property(mark, v) = v.idx();
  EXPECT_EQ(mesh.property(mark, mesh.vertex_handle(149)), 149);
}
#endif

// ---- points that are not of CGAL

namespace {

struct Array_traits
{
  using FT = double;
  using Point_3 = std::array<double, 3>;

  template <int i>
  struct Compute_coordinate
  {
    double operator()(const Point_3& p) const { return p[i]; }
  };
  struct Construct_point
  {
    Point_3 operator()(double x, double y, double z) const { return {{x, y, z}}; }
  };

  Compute_coordinate<0> compute_x_3_object() const { return {}; }
  Compute_coordinate<1> compute_y_3_object() const { return {}; }
  Compute_coordinate<2> compute_z_3_object() const { return {}; }
  Construct_point construct_point_3_object() const { return {}; }
};

} // namespace

TEST(Geom_traits, tell_the_coordinates_of_any_type_of_points)
{
  const Mesh input = made::torus(3, 1, 24, 10);
  std::map<made::Vertex, Array_traits::Point_3> points, written;
  for(const auto v : input.vertices())
    points[v] = {{input.point(v).x(), input.point(v).y(), input.point(v).z()}};
  const auto np_in =
      CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points)).geom_traits(Array_traits());
  const auto np_out =
      CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(written)).geom_traits(Array_traits());
  Mesh output, expected;
  CGAL::geodesic_remeshing(input, 200, output, np_in, np_out);
  CGAL::geodesic_remeshing(input, 200, expected);
  ASSERT_EQ(written.size(), 200u);
  for(const auto v : expected.vertices())
    EXPECT_EQ(Point(written[v][0], written[v][1], written[v][2]), expected.point(v));
  EXPECT_TRUE(GR::is_valid_remeshing(input, output, np_in, np_out));
  EXPECT_EQ(GR::geodesic_diameter(input, np_in).distance, GR::geodesic_diameter(input).distance);
  std::map<made::Vertex, double> height;
  for(const auto& p : points)
    height[p.first] = p.second[2];
  std::vector<GR::Equidistant_curve<Mesh, Array_traits::Point_3>> curves;
  GR::equidistant_curves(input, boost::make_assoc_property_map(height), {.25}, std::back_inserter(curves), np_in);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_NEAR(curves.front().points.front()[2], .25, 1e-12);
  CGAL::geodesic_remeshing(output, 150,
                           gp::vertex_point_map(boost::make_assoc_property_map(written)).geom_traits(Array_traits()));
  EXPECT_EQ(output.number_of_vertices(), 150u);
}

// What CGAL::to_double() tells of such a number gets nearer when somebody asks for its exact value.
TEST(Lazily_exact_points, are_the_same_before_and_after_they_are_computed)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Exact::FT far = 1e7;
  const Mesh sphere = made::torus(3, 1, 24, 10);
  Surface_mesh<Exact> lazy;
  CGAL::copy_face_graph(sphere, lazy);
  for(const auto v : lazy.vertices())
  {
    const Exact::Point_3& p = lazy.point(v);
    lazy.point(v) = Exact::Point_3(p.x() / 3 + far - far, p.y() / 3 + far - far, p.z() / 3 + far - far);
  }
  Mesh before, after;
  CGAL::geodesic_remeshing(lazy, 100, before);
  for(const auto v : lazy.vertices())
    CGAL::exact(lazy.point(v));
  CGAL::geodesic_remeshing(lazy, 100, after);
  ASSERT_EQ(before.number_of_vertices(), after.number_of_vertices());
  for(const auto v : before.vertices())
    EXPECT_EQ(before.point(v), after.point(v));
}

// ---- parameters of an input that is replaced

TEST(In_place, a_map_that_can_be_written_to_tells_of_the_output)
{
  Mesh mesh = made::torus(3, 1, 24, 10);
  std::map<Mesh::Face_index, int> patch;
  for(const auto f : mesh.faces())
    patch[f] = mesh.point(mesh.target(mesh.halfedge(f))).z() > 0 ? 7 : 3;
  auto is_line = mesh.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
  CGAL::geodesic_remeshing(mesh, 300,
                           gp::face_patch_map(boost::make_assoc_property_map(patch)).edge_is_constrained_map(is_line));
  for(const auto e : mesh.edges())
    EXPECT_EQ(is_line[e], patch[mesh.face(mesh.halfedge(e, 0))] != patch[mesh.face(mesh.halfedge(e, 1))]);
}

TEST(In_place, a_map_that_can_only_be_read_is_only_read)
{
  Mesh mesh = made::torus(3, 1, 24, 10);
  const auto is_line = CGAL::Constant_property_map<Mesh::Edge_index, bool>(false);
  const auto all_one = CGAL::Static_boolean_property_map<Mesh::Face_index, true>();
  CGAL::geodesic_remeshing(mesh, 150, gp::edge_is_constrained_map(is_line).face_patch_map(all_one));
  EXPECT_EQ(mesh.number_of_vertices(), 150u);
}

// ---- named parameters that other tests have not, and all of them together

namespace {

// Indices in the reverse of the mesh's own order
template <class Range>
auto backwards(const Range& range)
{
  std::map<std::decay_t<decltype(*range.begin())>, std::size_t> result;
  std::size_t i = range.size();
  for(const auto d : range)
    result[d] = --i;
  return result;
}

template <class Map>
auto as_property_map(Map& map)
{
  return boost::make_assoc_property_map(map);
}

} // namespace

TEST(Named_parameters_of_meshes, index_maps_are_a_matter_of_speed)
{
  const Mesh input = made::torus(3, 1, 24, 10);
  const auto vertex = backwards(input.vertices());
  const auto halfedge = backwards(input.halfedges());
  const auto face = backwards(input.faces());
  const auto all = gp::vertex_index_map(as_property_map(vertex))
                       .halfedge_index_map(as_property_map(halfedge))
                       .face_index_map(as_property_map(face));
  Mesh output, expected;
  auto location =
      output.add_property_map<made::Vertex, std::pair<Mesh::Face_index, std::array<double, 3>>>("v:place").first;
  CGAL::geodesic_remeshing(input, 200, output, all, gp::vertex_location_map(location));
  CGAL::geodesic_remeshing(input, 200, expected);
  EXPECT_TRUE(support::is_same_mesh(output, expected));
  EXPECT_NEAR(GR::geodesic_diameter(input, all).distance, GR::geodesic_diameter(input).distance, 1e-9);
  EXPECT_TRUE(GR::is_valid_remeshing(input, output, all));
  std::map<Mesh::Face_index, std::size_t> of_output, expected_of_output;
  GR::transfer_face_property(input, as_property_map(face), output, location, as_property_map(of_output), all);
  GR::transfer_face_property(input, as_property_map(face), output, location, as_property_map(expected_of_output));
  EXPECT_EQ(of_output, expected_of_output);
}

TEST(Named_parameters_of_meshes, defect_moves_leave_fewer_irregular_vertices)
{
  const Mesh input = made::sphere(4);
  Mesh with, without;
  CGAL::geodesic_remeshing(input, 2000, with, gp::use_defect_moves(true));
  CGAL::geodesic_remeshing(input, 2000, without, gp::use_defect_moves(false));
  EXPECT_LT(support::quality_of(with).percent_irregular, support::quality_of(without).percent_irregular);
}

TEST(Named_parameters_of_meshes, all_together_in_any_order)
{
  const Mesh input = made::box(6, 6, 6);
  const auto vertex = backwards(input.vertices());
  const auto vertex_index = as_property_map(vertex);
  const auto length = CGAL::Constant_property_map<made::Vertex, double>(1.);
  const auto no_edge = CGAL::Static_boolean_property_map<Mesh::Edge_index, false>();
  const auto no_vertex = CGAL::Static_boolean_property_map<made::Vertex, false>();
  const auto one_patch = CGAL::Static_boolean_property_map<Mesh::Face_index, true>();
  GR::Default_visitor visitor;
  GR::Stage_results stages;
  Mesh once, reversed;
  auto location =
      once.add_property_map<made::Vertex, std::pair<Mesh::Face_index, std::array<double, 3>>>("v:place").first;
  auto is_line = once.add_property_map<Mesh::Edge_index, bool>("e:line").first;
  auto patch = once.add_property_map<Mesh::Face_index, int>("f:patch").first;
  auto region = once.add_property_map<Mesh::Face_index, int>("f:region").first;
  CGAL::geodesic_remeshing(input, 400, once,
                           gp::vertex_point_map(input.points())
                               .geom_traits(Epick())
                               .vertex_index_map(vertex_index)
                               .sizing_field(length)
                               .gradation(.2)
                               .minimum_length(.01)
                               .maximum_length(10.)
                               .features_angle_bound(60.)
                               .edge_is_constrained_map(no_edge)
                               .vertex_is_constrained_map(no_vertex)
                               .face_patch_map(one_patch)
                               .protect_constraints(false)
                               .use_segmentation(false)
                               .number_of_iterations(2u)
                               .use_defect_moves(false)
                               .do_project(true)
                               .visitor(std::ref(visitor))
                               .stage_results(std::ref(stages)),
                           gp::vertex_point_map(once.points())
                               .geom_traits(Epick())
                               .vertex_location_map(location)
                               .edge_is_constrained_map(is_line)
                               .face_patch_map(patch)
                               .face_region_map(region));
  CGAL::geodesic_remeshing(input, 400, reversed,
                           gp::stage_results(std::ref(stages))
                               .do_project(true)
                               .visitor(visitor)
                               .use_defect_moves(false)
                               .number_of_iterations(2)
                               .use_segmentation(false)
                               .protect_constraints(false)
                               .face_patch_map(one_patch)
                               .vertex_is_constrained_map(no_vertex)
                               .edge_is_constrained_map(no_edge)
                               .features_angle_bound(60)
                               .maximum_length(10)
                               .minimum_length(.01f)
                               .gradation(.2)
                               .sizing_field(length)
                               .vertex_index_map(vertex_index)
                               .geom_traits(Epick())
                               .vertex_point_map(input.points()));
  EXPECT_TRUE(support::is_same_mesh(once, reversed));
  EXPECT_TRUE(GR::is_valid_remeshing(
      input, once, gp::line_tolerance(1e-9).surface_tolerance(1e-9).expected_number_of_vertices(400)));
  EXPECT_GT(std::count(is_line.begin(), is_line.end(), true), 12);
}
