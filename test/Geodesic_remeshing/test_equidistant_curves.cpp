#include "made_surfaces.h"
#include "segmented_surface.h"
#include "test_support.h"

#include <CGAL/Geodesic_remeshing/equidistant_curves.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace CGAL::Geodesic_remeshing::internal;
using CGAL::Geodesic_remeshing::equidistant_curves;
using Curve = CGAL::Geodesic_remeshing::Equidistant_curve<Mesh, Point>;
using support::Segmented_surface;

namespace {

using Function = std::function<double(const Point&)>;

struct Traced
{
  Traced(const Mesh& surface, const Function& f, const std::vector<double>& levels) : mesh(surface), values(levels)
  {
    function = mesh.add_property_map<Vertex, double>("v:function", 0.).first;
    for(Vertex v : mesh.vertices())
      function[v] = f(mesh.point(v));
    equidistant_curves(mesh, function, values, std::back_inserter(curves));
  }

  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;

  Mesh mesh;
  Mesh::Property_map<Vertex, double> function;
  std::vector<double> values;
  std::vector<Curve> curves;
};

template <class AnyCurve>
double length_of(const AnyCurve& curve)
{
  double length = curve.is_closed ? std::sqrt(CGAL::squared_distance(curve.points.back(), curve.points.front())) : 0.;
  for(std::size_t i = 1; i < curve.points.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(curve.points[i - 1], curve.points[i]));
  return length;
}

void expect_points_at_the_value(const Traced& t, const Curve& curve)
{
  ASSERT_EQ(curve.points.size(), curve.places.size());
  for(std::size_t i = 0; i < curve.points.size(); ++i)
  {
    const auto h = curve.places[i].first;
    const double s = curve.places[i].second;
    EXPECT_TRUE(0. <= s && s <= 1.);
    const double a = t.function[t.mesh.source(h)], b = t.function[t.mesh.target(h)];
    EXPECT_NEAR(a + s * (b - a), curve.value, 1e-12 * (std::abs(a) + std::abs(b)));
    const Point& p = t.mesh.point(t.mesh.source(h));
    EXPECT_LE(CGAL::squared_distance(p + s * (t.mesh.point(t.mesh.target(h)) - p), curve.points[i]), 1e-24);
    // the source of the halfedge is lower and on the left
    EXPECT_TRUE(a <= curve.value && curve.value < b);
  }
}

// From each point to the next through the face of its halfedge; an arc from boundary to boundary
void expect_way_over_faces(const Traced& t, const Curve& curve)
{
  const std::size_t n = curve.points.size();
  for(std::size_t i = 0; i + (curve.is_closed ? 0 : 1) < n; ++i)
    EXPECT_EQ(t.mesh.face(curve.places[i].first), t.mesh.face(t.mesh.opposite(curve.places[(i + 1) % n].first)));
  if(curve.is_closed)
  {
    EXPECT_GE(n, 3u);
    return;
  }
  EXPECT_TRUE(t.mesh.is_border(t.mesh.edge(curve.places.front().first)));
  EXPECT_TRUE(t.mesh.is_border(t.mesh.edge(curve.places.back().first)));
}

// All that is to be crossed is crossed, once: an edge from a vertex that counts as lower to one that counts as higher.
void expect_all_crossings(const Traced& t)
{
  std::map<std::pair<Edge, double>, int> expected, found;
  for(Edge e : t.mesh.edges())
    for(double value : t.values)
      if((t.function[t.mesh.vertex(e, 0)] <= value) != (t.function[t.mesh.vertex(e, 1)] <= value))
        ++expected[{e, value}];
  for(const Curve& curve : t.curves)
    for(const auto& place : curve.places)
      ++found[{t.mesh.edge(place.first), curve.value}];
  EXPECT_EQ(found, expected);
}

void expect_valid_curves(const Traced& t)
{
  for(std::size_t i = 0; i < t.curves.size(); ++i)
  {
    expect_points_at_the_value(t, t.curves[i]);
    expect_way_over_faces(t, t.curves[i]);
    EXPECT_TRUE(i == 0 || t.curves[i - 1].value <= t.curves[i].value) << "in the order of the values";
    EXPECT_TRUE(t.curves[i].is_closed || !CGAL::is_closed(t.mesh)) << "arcs on a closed surface";
  }
  expect_all_crossings(t);
}

} // namespace

TEST(Equidistant_curves, boundary_arcs_of_a_linear_function_are_straight)
{
  const Traced t(made::plane(10), [](const Point& p) { return p.x() + .3 * p.y(); }, {.5, 2., 4.05, 7.7, 12.2});
  expect_valid_curves(t);
  ASSERT_EQ(t.curves.size(), 5u);
  for(const Curve& curve : t.curves)
  {
    EXPECT_FALSE(curve.is_closed);
    EXPECT_NEAR(length_of(curve), std::sqrt(CGAL::squared_distance(curve.points.front(), curve.points.back())), 1e-12);
    // smaller values on the left: the way is the gradient (1, .3) turned to the left
    EXPECT_GT((curve.points.back() - curve.points.front()) * Vector(.3, -1., 0.) * -1., 0.);
  }
}

TEST(Equidistant_curves, circles_on_a_plane_have_their_length)
{
  const Point centre(20.3, 19.8, 0.);
  const Traced t(made::plane(40), [&](const Point& p) { return std::sqrt(CGAL::squared_distance(p, centre)); },
                 {4., 6.5, 10., 13.25, 18.});
  expect_valid_curves(t);
  ASSERT_EQ(t.curves.size(), 5u);
  for(const Curve& curve : t.curves)
  {
    EXPECT_TRUE(curve.is_closed);
    EXPECT_NEAR(length_of(curve), 2. * CGAL_PI * curve.value, .004 * 2. * CGAL_PI * curve.value);
    Vector area(0., 0., 0.); // with the centre, the smaller values, on the left it goes counterclockwise
    for(std::size_t i = 0; i < curve.points.size(); ++i)
      area = area + CGAL::cross_product(curve.points[i] - centre, curve.points[(i + 1) % curve.points.size()] - centre);
    EXPECT_GT(area.z(), 0.);
  }
}

TEST(Equidistant_curves, parallels_of_a_sphere_have_their_length)
{
  const Traced t(made::sphere(5), [](const Point& p) { return std::acos(p.z()); }, {.2, .9, CGAL_PI / 2., 2.2, 3.});
  expect_valid_curves(t);
  ASSERT_EQ(t.curves.size(), 5u);
  for(const Curve& curve : t.curves)
    EXPECT_NEAR(length_of(curve), 2. * CGAL_PI * std::sin(curve.value), .003 * 2. * CGAL_PI);
}

TEST(Equidistant_curves, torus_cut_across_and_along)
{
  const Mesh torus = made::torus(3, 1, 60, 24);
  const Traced across(torus, [](const Point& p) { return p.x(); }, {-3.5, -2.5, -1., .1, 1., 2.5, 3.5});
  expect_valid_curves(across);
  std::map<double, int> loops;
  for(const Curve& curve : across.curves)
    ++loops[curve.value];
  // a plane across the hole cuts two loops, further out one
  EXPECT_EQ(loops, (std::map<double, int>{{-3.5, 1}, {-2.5, 1}, {-1., 2}, {.1, 2}, {1., 2}, {2.5, 1}, {3.5, 1}}));
  const Traced along(torus, [](const Point& p) { return p.z(); }, {-1.5, -.5, .5, 1.5});
  expect_valid_curves(along);
  ASSERT_EQ(along.curves.size(), 4u);
  double sum = 0.;
  for(const Curve& curve : along.curves)
    sum += length_of(curve);
  EXPECT_NEAR(sum, 2. * 2. * CGAL_PI * 6., .005 * sum); // inner and outer radius add up to 6
}

TEST(Equidistant_curves, vertices_exactly_at_the_value)
{
  const Traced t(made::plane(8), [](const Point& p) { return p.x(); }, {0., 1., 4., 7., 8.});
  expect_valid_curves(t);
  ASSERT_EQ(t.curves.size(), 4u); // the highest value has nothing above
  for(const Curve& curve : t.curves)
  {
    EXPECT_NEAR(length_of(curve), 8., 1e-12);
    for(const Point& p : curve.points)
      EXPECT_EQ(p.x(), curve.value);
  }
}

TEST(Equidistant_curves, saddle_exactly_at_the_value)
{
  const Traced t(made::plane(8), [](const Point& p) { return (p.x() - 4.) * (p.y() - 4.); }, {-3., 0., 3.});
  expect_valid_curves(t);
  std::map<double, int> arcs;
  for(const Curve& curve : t.curves)
    ++arcs[curve.value];
  // at 0 the lines x = 4 and y = 4, as two arcs that touch
  EXPECT_EQ(arcs, (std::map<double, int>{{-3., 2}, {0., 2}, {3., 2}}));
}

TEST(Equidistant_curves, plateau_has_its_rim_at_most)
{
  const Mesh mesh = made::plane(20);
  const Traced flat(mesh, [](const Point&) { return 1.; }, {0., 1., 2.});
  EXPECT_TRUE(flat.curves.empty());
  const Point centre(10, 10, 0);
  const auto mesa = [&](const Point& p) { return (std::min)(-4., -std::sqrt(CGAL::squared_distance(p, centre))); };
  const Traced top(mesh, mesa, {-7., -4.}); // nothing lies above the plateau at -4
  expect_valid_curves(top);
  EXPECT_EQ(top.curves.size(), 1u);
  const auto bowl = [&](const Point& p) { return (std::max)(4., std::sqrt(CGAL::squared_distance(p, centre))); };
  const Traced rim(mesh, bowl, {4.});
  expect_valid_curves(rim);
  ASSERT_EQ(rim.curves.size(), 1u);
  EXPECT_TRUE(rim.curves[0].is_closed);
  for(const Point& p : rim.curves[0].points) // along the last vertices of the plateau
  {
    EXPECT_LE(CGAL::squared_distance(p, centre), 16.);
    EXPECT_GT(CGAL::squared_distance(p, centre), 6.);
  }
}

TEST(Equidistant_curves, made_surfaces_with_many_values)
{
  for(const made::Case& c : made::cases())
  {
    SCOPED_TRACE(c.name);
    std::vector<double> values;
    for(int i = -40; i < 40; ++i)
      values.push_back(.5 * i);
    expect_valid_curves(Traced(
        c.mesh, [](const Point& p) { return p.x() + .5 * p.z(); }, values));
  }
}

TEST(Equidistant_curves, no_values_no_curves)
{
  EXPECT_TRUE(Traced(made::sphere(2), [](const Point& p) { return p.z(); }, {}).curves.empty());
  EXPECT_TRUE(Traced(made::sphere(2), [](const Point& p) { return p.z(); }, {-2., 5.}).curves.empty());
}

TEST(Equidistant_curves, takes_polyhedra_and_point_maps)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Traced t(made::torus(3, 1, 30, 12), [](const Point& p) { return p.x(); }, {-1., .5, 3.});
  Polyhedron polyhedron;
  CGAL::copy_face_graph(t.mesh, polyhedron);
  std::map<Polyhedron::Vertex_const_handle, double> function;
  for(auto v : vertices(polyhedron))
    function[v] = v->point().x();
  using Polyhedron_curve = CGAL::Geodesic_remeshing::Equidistant_curve<Polyhedron, Point>;
  std::vector<Polyhedron_curve> curves;
  equidistant_curves(polyhedron, boost::make_assoc_property_map(function), t.values, std::back_inserter(curves));
  // the copy has its edges in another order, and the curves begin elsewhere
  ASSERT_EQ(curves.size(), t.curves.size());
  std::vector<double> lengths, expected;
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    EXPECT_EQ(curves[i].value, t.curves[i].value);
    lengths.push_back(length_of(curves[i]));
    expected.push_back(length_of(t.curves[i]));
  }
  std::sort(lengths.begin(), lengths.end());
  std::sort(expected.begin(), expected.end());
  for(std::size_t i = 0; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i], expected[i], 1e-9);

  Mesh collapsed = t.mesh;
  auto points = collapsed.add_property_map<Vertex, Point>("v:elsewhere").first;
  for(Vertex v : collapsed.vertices())
  {
    points[v] = collapsed.point(v);
    collapsed.point(v) = Point(0, 0, 0);
  }
  std::vector<Curve> again;
  equidistant_curves(collapsed, t.function, t.values, std::back_inserter(again),
                     CGAL::parameters::vertex_point_map(points));
  ASSERT_EQ(again.size(), t.curves.size());
  for(std::size_t i = 0; i < again.size(); ++i)
    EXPECT_EQ(again[i].points, t.curves[i].points);
}

TEST(Equidistant_curves, refuses_what_it_cannot_trace)
{
  Mesh mesh = made::sphere(2), empty;
  auto function = mesh.add_property_map<Vertex, double>("v:function", 0.).first;
  std::vector<Curve> curves;
  EXPECT_THROW(equidistant_curves(mesh, function, {1., .5}, std::back_inserter(curves)), std::invalid_argument);
  function[Vertex(5)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(equidistant_curves(mesh, function, {.5}, std::back_inserter(curves)), std::invalid_argument);
  auto none = empty.add_property_map<Vertex, double>("v:function", 0.).first;
  EXPECT_THROW(equidistant_curves(empty, none, {.5}, std::back_inserter(curves)), std::invalid_argument);
  EXPECT_TRUE(curves.empty());
}

// ---- the curves of the regions

namespace {

// Between two vertices of one region a curve is where the distance from its top has its value.
void expect_curves_at_their_distance(const Segmented_surface& s, const Level_curves& curves)
{
  const Segmentation& g = s.segmentation;
  for(const Level_curve& curve : curves.curves)
    for(std::size_t i = curve.begin; i < curve.end; ++i)
    {
      const Curve_point& p = curves.points[i];
      const Vertex a = s.working.mesh.source(p.halfedge), b = s.working.mesh.target(p.halfedge);
      EXPECT_TRUE(0. <= p.position && p.position <= 1.);
      if(g.field_region[a] != curve.region || g.field_region[b] != curve.region)
        continue;
      const double value = g.regions[curve.region].value(curve.level);
      EXPECT_NEAR(g.field[a] + p.position * (g.field[b] - g.field[a]), value, 1e-9 * value);
      EXPECT_LE(g.field[a], g.field[b]) << "the top is on the left";
    }
}

void expect_loops(const Segmented_surface& s, const Level_curves& curves)
{
  const Mesh& mesh = s.working.mesh;
  for(const Level_curve& curve : curves.curves)
  {
    EXPECT_TRUE(curve.is_closed);
    const std::size_t n = curve.end - curve.begin;
    for(std::size_t i = 0; i < n; ++i)
      EXPECT_EQ(mesh.face(curves.points[curve.begin + i].halfedge),
                mesh.face(mesh.opposite(curves.points[curve.begin + (i + 1) % n].halfedge)));
  }
  for(Face f : mesh.faces()) // a curve that enters a face leaves it
  {
    std::map<std::pair<int, int>, int> crossings;
    for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      for(std::size_t c = curves.crossing_begin[mesh.edge(h)]; c < curves.crossing_begin[mesh.edge(h) + 1]; ++c)
        ++crossings[{curves.crossings[c].region, curves.crossings[c].level}];
    for(const auto& crossing : crossings)
      EXPECT_EQ(crossing.second, 2);
  }
}

} // namespace

class Curves_of_regions : public testing::TestWithParam<std::size_t>
{};

TEST_P(Curves_of_regions, are_loops_at_their_distance)
{
  const Mesh& mesh = made::cases()[GetParam()].mesh;
  for(std::size_t vertices : {100, 1500})
  {
    const Segmented_surface s(mesh, std::sqrt(.75) * edge_length_for(area(mesh), vertices));
    const Level_curves curves = Curve_tracer(s.working.mesh, s.segmentation).trace();
    EXPECT_EQ(curves.points.size(), curves.crossings.size()) << "each crossing is on one curve";
    expect_loops(s, curves);
    expect_curves_at_their_distance(s, curves);
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Curves_of_regions, testing::Range(std::size_t(0), made::cases().size()),
                         [](const auto& info) { return made::cases()[info.param].name; });
