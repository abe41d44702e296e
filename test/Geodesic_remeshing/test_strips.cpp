#include "made_surfaces.h"
#include "segmented_surface.h"
#include "test_support.h"

#include <CGAL/Geodesic_remeshing/internal/sample_surface.h>
#include <CGAL/Geodesic_remeshing/internal/triangulate_strips.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

// Samples on the curves, the strips between them, and their triangulation.

using namespace CGAL::Geodesic_remeshing::internal;
using made::cases;
using support::Segmented_surface;
using support::Topology;

namespace {

// The stages up to the samples
struct Sampled_surface
{
  Sampled_surface(const Mesh& mesh, std::size_t vertices)
    : edge_length(edge_length_for(area(mesh), vertices)), stages(mesh, std::sqrt(.75) * edge_length),
      curves(Curve_tracer(stages.working.mesh, stages.segmentation).trace()),
      samples(sample_surface(stages.surface, stages.working, stages.segmentation, curves, Line_samples(), stages.roots,
                             edge_length, vertices))
  {}

  double edge_length;
  Segmented_surface stages;
  Level_curves curves;
  std::vector<Sample> samples;
};

std::string name_of(const testing::TestParamInfo<std::size_t>& info)
{
  return cases()[info.param].name;
}

void expect_triangulation_of(const Mesh& mesh, const Topology& topology)
{
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_EQ(support::topology_of(mesh), topology);
  for(Vertex v : mesh.vertices()) // no two edges between the same vertices
  {
    std::vector<Vertex> ring(mesh.vertices_around_target(mesh.halfedge(v)).begin(),
                             mesh.vertices_around_target(mesh.halfedge(v)).end());
    std::sort(ring.begin(), ring.end());
    EXPECT_TRUE(std::adjacent_find(ring.begin(), ring.end()) == ring.end()) << v;
    EXPECT_GE(ring.size(), 3u) << v;
  }
}

// An edge is not Delaunay if the angles opposite to it add up to more than 180 degrees.
std::size_t number_not_delaunay(const Mesh& mesh)
{
  std::size_t n = 0;
  for(Edge e : mesh.edges())
  {
    if(mesh.is_border(e))
      continue;
    double sum = 0.;
    for(Halfedge h : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)})
      sum += support::angle_at(mesh.point(mesh.source(h)), mesh.point(mesh.target(mesh.next(h))),
                               mesh.point(mesh.target(h)));
    n += sum > 180. + 1e-6;
  }
  return n;
}

} // namespace

// ---- samples

class Samples : public testing::TestWithParam<std::size_t>
{};

TEST_P(Samples, have_their_place_on_the_input)
{
  for(std::size_t vertices : {30, 1500})
  {
    const Sampled_surface s(cases()[GetParam()].mesh, vertices);
    const double whole = area(s.stages.surface);
    for(const Sample& sample : s.samples)
    {
      const auto& c = sample.place.coordinates;
      EXPECT_TRUE(sample.place.face.is_valid() && sample.place.face.idx() < s.stages.surface.number_of_faces());
      EXPECT_GE((std::min)({c[0], c[1], c[2]}), 0.);
      EXPECT_NEAR(c[0] + c[1] + c[2], 1., 1e-12);
      EXPECT_LE(CGAL::squared_distance(point_at(s.stages.surface, sample.place), sample.point), 1e-24 * whole);
      EXPECT_EQ(s.stages.working.input_face[sample.face], sample.place.face);
    }
  }
}

TEST_P(Samples, are_nearly_as_many_as_asked_for)
{
  for(std::size_t vertices : {1000, 4000})
  {
    const Sampled_surface s(cases()[GetParam()].mesh, vertices);
    // what is left is for the improvement; on short loops one sample more or less is much
    EXPECT_NEAR(static_cast<double>(s.samples.size()), static_cast<double>(vertices),
                (vertices > 1000 ? .03 : .1) * vertices);
  }
}

TEST_P(Samples, begin_with_the_root_and_have_the_tips)
{
  const Sampled_surface s(cases()[GetParam()].mesh, 1000);
  const auto nearest = [&](Vertex v) {
    const Point& p = s.stages.working.mesh.point(v);
    return *std::min_element(s.samples.begin(), s.samples.end(), [&](const Sample& a, const Sample& b) {
      return CGAL::squared_distance(a.point, p) < CGAL::squared_distance(b.point, p);
    });
  };
  EXPECT_EQ(s.samples.front().point, s.stages.working.mesh.point(s.stages.roots.front()));
  for(Vertex root : s.stages.roots)
  {
    EXPECT_EQ(nearest(root).point, s.stages.working.mesh.point(root));
    EXPECT_TRUE(nearest(root).is_pinned);
  }
  for(Vertex tip : s.stages.segmentation.tips) // or so near to another one that both would make a needle
  {
    const Sample sample = nearest(tip);
    EXPECT_TRUE(sample.is_pinned);
    EXPECT_LE(CGAL::squared_distance(sample.point, s.stages.working.mesh.point(tip)),
              .25 * s.edge_length * s.edge_length);
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Samples, testing::Range(std::size_t(0), cases().size()), name_of);

namespace {

// The angles around the axis of the samples on the side of a cylinder, curve by curve, from one end to the other
std::vector<std::vector<double>> angles_on_cylinder(const Sampled_surface& s, double length)
{
  std::map<std::pair<int, int>, std::vector<const Sample*>> rows;
  for(const Sample& sample : s.samples)
    if(sample.level > 0 && sample.point.z() > .2 * length && sample.point.z() < .8 * length)
      rows[{sample.region, sample.level}].push_back(&sample);
  std::vector<std::pair<double, std::vector<double>>> ordered;
  for(const auto& row : rows)
  {
    std::vector<double> angles;
    double z = 0.;
    for(const Sample* sample : row.second)
    {
      angles.push_back(std::atan2(sample->point.y(), sample->point.x()));
      z += sample->point.z() / static_cast<double>(row.second.size());
    }
    std::sort(angles.begin(), angles.end());
    ordered.emplace_back(z, angles);
  }
  std::sort(ordered.begin(), ordered.end());
  std::vector<std::vector<double>> result;
  for(const auto& row : ordered)
    result.push_back(row.second);
  return result;
}

} // namespace

// On the side of a long cylinder the curves are its parallels, but for what the root is off the axis.
TEST(Samples_on_cylinder, are_equally_spaced)
{
  const Sampled_surface s(made::cylinder(1, 20, 48, 160), 2500);
  const auto rows = angles_on_cylinder(s, 20);
  ASSERT_GE(rows.size(), 30u);
  for(const auto& row : rows)
  {
    if(row.size() < 10)
      continue; // cut at the ends of what is looked at
    const double step = 2. * CGAL_PI / static_cast<double>(row.size());
    for(std::size_t i = 0; i < row.size(); ++i)
    {
      const double gap = i + 1 < row.size() ? row[i + 1] - row[i] : row[0] + 2. * CGAL_PI - row[i];
      EXPECT_NEAR(gap, step, .1 * step);
    }
  }
}

TEST(Samples_on_cylinder, lie_opposite_the_middles_of_the_curve_before)
{
  const Sampled_surface s(made::cylinder(1, 20, 48, 160), 2500);
  const auto rows = angles_on_cylinder(s, 20);
  std::size_t pairs = 0;
  for(std::size_t i = 1; i < rows.size(); ++i)
  {
    if(rows[i].size() != rows[i - 1].size() || rows[i].size() < 10)
      continue; // with other numbers they cannot all be
    ++pairs;
    const double step = 2. * CGAL_PI / static_cast<double>(rows[i].size());
    for(double angle : rows[i])
    {
      double nearest = step;
      for(double other : rows[i - 1])
        nearest = (std::min)(nearest, std::abs(std::remainder(angle - other, 2. * CGAL_PI)));
      EXPECT_NEAR(nearest, .5 * step, .15 * step);
    }
  }
  EXPECT_GE(pairs, 20u);
}

// ---- strips

class Strips : public testing::TestWithParam<std::size_t>
{};

TEST_P(Strips, have_Euler_characteristics_that_add_up)
{
  const Mesh& mesh = cases()[GetParam()].mesh;
  for(std::size_t vertices : {30, 200, 2000})
  {
    SCOPED_TRACE(std::to_string(vertices) + " vertices");
    const Segmented_surface s(mesh, std::sqrt(.75) * edge_length_for(area(mesh), vertices));
    const Level_curves curves = Curve_tracer(s.working.mesh, s.segmentation).trace();
    for(const Face f : s.working.mesh.faces())
      ASSERT_TRUE(Face_division(s.working.mesh, curves, f).is_possible()) << "face " << f;
    const auto strips = find_strips(s.working.mesh, curves);
    // cut along all curves and looked at again
    const auto label = [&](std::size_t interval) { return static_cast<int>(strips.first[interval]); };
    const Mesh cut = Surface_cutter<decltype(label)>(s.working.mesh, curves, label).run();
    const auto strip = cut.property_map<Face, int>("f:region").value();
    const auto pieces = support::topologies(cut, [&](Face f) { return strip[f]; });
    const Topology whole = support::topology_of(mesh);
    EXPECT_EQ(support::topology_of(cut), whole);
    EXPECT_EQ(pieces.size(), strips.second);
    int euler_characteristic = 0, loops = 0;
    for(const auto& piece : pieces)
    {
      EXPECT_EQ(piece.second.components, 1) << "strip " << piece.first;
      euler_characteristic += piece.second.euler_characteristic;
      loops += piece.second.boundary_loops;
    }
    EXPECT_EQ(euler_characteristic, whole.euler_characteristic);
    const int sides = 2 * static_cast<int>(curves.curves.size());
    EXPECT_LE(loops, sides) << "a curve has a strip on either side";
    EXPECT_TRUE(whole.genus() > 0 || loops == sides) << "which is the same only where it does not part the surface";
  }
}

// From so few samples that a strip has handles in it to many
TEST_P(Strips, are_triangulated_with_the_topology_of_the_surface)
{
  const Mesh& mesh = cases()[GetParam()].mesh;
  const Topology topology = support::topology_of(mesh);
  const double whole = area(mesh);
  for(std::size_t vertices : {12, 30, 60, 200, 1000})
  {
    SCOPED_TRACE(std::to_string(vertices) + " vertices");
    Sampled_surface s(mesh, vertices);
    Placed_mesh result;
    triangulate_strips(s.stages.surface, s.stages.working, s.samples, s.edge_length, result);
    expect_triangulation_of(result.mesh, topology);
    for(std::size_t i = 0; i < (std::min)(s.samples.size(), std::size_t(result.mesh.number_of_vertices())); ++i)
      EXPECT_LE(
          CGAL::squared_distance(point_at(s.stages.surface, result.place[Vertex(static_cast<Mesh::size_type>(i))]),
                                 result.mesh.point(Vertex(static_cast<Mesh::size_type>(i)))),
          1e-24 * whole);
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Strips, testing::Range(std::size_t(0), cases().size()), name_of);

// ---- cells

// Any samples will do, also so few that their dual is no triangulation of the surface: then some vertices stay.
TEST(Cell_contractor, keeps_the_topology_from_any_samples)
{
  for(const made::Case& c : cases())
  {
    const Topology topology = support::topology_of(c.mesh);
    for(std::size_t every : {2, 5, 17, 90, 100000})
    {
      SCOPED_TRACE(c.name + ", every " + std::to_string(every));
      Mesh mesh = made::divided(c.mesh);
      std::vector<Vertex> samples;
      for(std::size_t v = 0; v < mesh.number_of_vertices(); v += every)
        samples.push_back(Vertex(static_cast<Mesh::size_type>(v)));
      // a component without a sample has no cell
      for(std::size_t v = 0; v < mesh.number_of_vertices() && topology.components > 1; v += 97)
        samples.push_back(Vertex(static_cast<Mesh::size_type>(v)));
      std::sort(samples.begin(), samples.end());
      samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
      const std::vector<Vertex> left = Cell_contractor(mesh, samples).run();
      EXPECT_EQ(mesh.number_of_vertices(), samples.size() + left.size());
      for(Vertex v : samples)
        EXPECT_FALSE(mesh.is_removed(v));
      mesh.collect_garbage();
      expect_triangulation_of(mesh, topology);
    }
  }
}

// ---- Delaunay

namespace {

// A plane whose inner vertices are shaken, the same on every machine
Mesh shaken_plane(unsigned n)
{
  Mesh mesh = made::plane(n);
  std::uint64_t state = 1;
  const auto random = [&] {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) / 9007199254740992. - .5;
  };
  for(Vertex v : mesh.vertices())
    if(!mesh.is_border(v))
      mesh.point(v) = mesh.point(v) + Vector(.6 * random(), .6 * random(), 0.);
  return mesh;
}

} // namespace

TEST(Delaunay_flipper, makes_a_plane_delaunay)
{
  Mesh mesh = shaken_plane(30);
  for(Vertex v : mesh.vertices()) // long triangles
    mesh.point(v) = Point(mesh.point(v).x(), 4. * mesh.point(v).y(), 0.);
  ASSERT_GT(number_not_delaunay(mesh), 100u);
  const double area_before = area(mesh);
  EXPECT_GT(Delaunay_flipper(mesh).run(), 100u);
  EXPECT_EQ(number_not_delaunay(mesh), 0u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_NEAR(area(mesh), area_before, 1e-9 * area_before);
  EXPECT_EQ(Delaunay_flipper(mesh).run(), 0u) << "nothing is left to do";
}

// Four points on a circle: either diagonal is right, and neither is flipped for ever.
TEST(Delaunay_flipper, leaves_squares_alone)
{
  Mesh mesh = made::plane(10);
  EXPECT_EQ(Delaunay_flipper(mesh).run(), 0u);
}

// By rounded lengths both diagonals of some of them look wrong: these were flipped to and fro, 1,801 times.
TEST(Delaunay_flipper, comes_to_an_end_on_turned_squares)
{
  Mesh mesh = made::plane(64);
  const double c = std::cos(.3), s = std::sin(.3);
  for(Vertex v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    mesh.point(v) = Point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), 0.);
  }
  EXPECT_LE(Delaunay_flipper(mesh).run(), 64u * 64u / 2u);
  EXPECT_EQ(Delaunay_flipper(mesh).run(), 0u);
}

TEST(Delaunay_flipper, keeps_the_topology_of_curved_surfaces)
{
  for(const made::Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Mesh mesh = c.mesh;
    const std::size_t before = number_not_delaunay(mesh);
    Delaunay_flipper(mesh).run();
    expect_triangulation_of(mesh, support::topology_of(c.mesh));
    EXPECT_LE(number_not_delaunay(mesh), before);
  }
}

// After the contraction many edges are wrong; after the flips only those that cannot be flipped may be.
TEST(Delaunay_flipper, mends_what_the_contraction_leaves)
{
  for(const made::Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    Sampled_surface s(c.mesh, 1500);
    Sample_inserter inserter(s.stages.surface, s.stages.working, .15 * s.edge_length);
    const std::vector<Vertex> vertices = inserter.run(s.samples);
    Mesh& mesh = s.stages.working.mesh;
    Cell_contractor(mesh, vertices).run();
    mesh.collect_garbage();
    const std::size_t before = number_not_delaunay(mesh);
    Delaunay_flipper(mesh).run();
    EXPECT_LE(number_not_delaunay(mesh), before / 10);
  }
}
