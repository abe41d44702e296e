// Several threads: the same result as one thread, to the last bit.

#include "improvement_support.h"
#include "made_surfaces.h"

#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = GR::parameters;
using namespace GR::internal;
using Index = Lean_triangulation::Index;

#ifdef CGAL_LINKED_WITH_TBB
// More threads than the machine may have processors, so that they interleave on any
class Parallel : public ::testing::Test
{
  tbb::global_control m_threads{tbb::global_control::max_allowed_parallelism, 4};
};
#else
class Parallel : public ::testing::Test
{
  void SetUp() override { GTEST_SKIP() << "built without TBB"; }
};
#endif

const CGAL::Parallel_if_available_tag parallel{};

using Location = std::pair<Face, std::array<double, 3>>;

struct Result
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Location> place = mesh.add_property_map<Vertex, Location>("v:location").first;
  Mesh::Property_map<Face, int> region = mesh.add_property_map<Face, int>("f:region").first;
  Mesh::Property_map<Edge, bool> on_line = mesh.add_property_map<Edge, bool>("e:on_line").first;
};

template <class NamedParameters>
void remesh(const Mesh& input, std::size_t number, Result& result, const NamedParameters& np)
{
  CGAL::geodesic_remeshing(
      input, number, result.mesh, np,
      gp::vertex_location_map(result.place).face_region_map(result.region).edge_is_constrained_map(result.on_line));
}

template <class NamedParameters>
void expect_same(const Mesh& input, std::size_t number, const NamedParameters& np)
{
  Result one, many;
  remesh(input, number, one, np);
  remesh(input, number, many, np.concurrency_tag(parallel));
  ASSERT_EQ(one.mesh.number_of_vertices(), number);
  ASSERT_EQ(many.mesh.number_of_vertices(), number);
  ASSERT_EQ(one.mesh.number_of_faces(), many.mesh.number_of_faces());
  for(Vertex v : one.mesh.vertices())
  {
    ASSERT_EQ(one.mesh.point(v), many.mesh.point(v)) << v;
    ASSERT_EQ(one.place[v], many.place[v]) << v;
  }
  for(Halfedge h : one.mesh.halfedges())
  {
    ASSERT_EQ(one.mesh.target(h), many.mesh.target(h)) << h;
    ASSERT_EQ(one.mesh.next(h), many.mesh.next(h)) << h;
  }
  for(Edge e : one.mesh.edges())
    ASSERT_EQ(one.on_line[e], many.on_line[e]) << e;
  for(Face f : one.mesh.faces())
    ASSERT_EQ(one.region[f], many.region[f]) << f;
}

} // namespace

TEST_F(Parallel, each_index_is_visited_once)
{
  const Concurrency concurrency{parallel};
  for(const std::size_t n : {0, 1, 2, 99, 100, 101, 100000})
  {
    std::vector<std::atomic<int>> visits(n);
    parallel_for(
        concurrency, n, [&](std::size_t i) { ++visits[i]; }, 100);
    for(std::size_t i = 0; i < n; ++i)
      ASSERT_EQ(visits[i], 1) << i << " of " << n;
  }
}

// Numbers of which each order of summation has a sum of its own
TEST_F(Parallel, sums_are_those_of_one_thread)
{
  const auto sum = [](Concurrency concurrency) {
    const auto of_block = [](std::size_t begin, std::size_t end) {
      double result = 0.;
      for(std::size_t i = begin; i < end; ++i)
        result += std::sin(static_cast<double>(i)) * std::pow(10., static_cast<double>(i % 13));
      return result;
    };
    return parallel_reduce(concurrency, 300000, 0., of_block, std::plus<>(), 128);
  };
  EXPECT_EQ(sum(Concurrency()), sum(Concurrency(parallel)));
}

TEST_F(Parallel, exceptions_come_through)
{
  const auto fail = [](std::size_t i) {
    if(i == 77777)
      throw std::runtime_error("77777");
  };
  EXPECT_THROW(parallel_for(Concurrency(parallel), 100000, fail, 10), std::runtime_error);
}

TEST_F(Parallel, orders_are_total)
{
  std::vector<std::pair<int, int>> one, many;
  for(int i = 0; i < 100000; ++i)
    one.emplace_back(i * 7919 % 101, i);
  many = one;
  parallel_sort(Concurrency(), one.begin(), one.end(), std::less<>());
  parallel_sort(Concurrency(parallel), many.begin(), many.end(), std::less<>());
  EXPECT_EQ(one, many);
}

// Steps about a number and the one that is some way further on, in a range that is no power of two
TEST_F(Parallel, each_step_is_made_once_and_within_its_block)
{
  constexpr std::uint32_t n = 10007;
  std::vector<std::atomic<int>> made(2 * n);
  for_each_in_blocks(Block_size{Concurrency(parallel), 5}, n, 2 * n, 2, [&](const std::uint32_t i, const Block block) {
    const std::uint32_t v = i / 2, w = (v + i % 13 * (i % 7)) % n;
    const std::uint32_t bits = block.bits_beyond(v, w) | block.bits_beyond(w, v);
    if(bits == 0)
      made[i] += block.begin <= v && v < block.end && block.begin <= w && w < block.end ? 1 : 1000;
    return bits;
  });
  for(std::size_t i = 0; i < 2 * n; ++i)
    ASSERT_EQ(made[i], 1) << i;
}

TEST_F(Parallel, steps_by_vertices_come_in_their_order)
{
  constexpr std::uint32_t n = 5003, steps = 40000;
  const auto vertices_of = [](const std::uint32_t i) {
    return std::array<std::uint32_t, 3>{{i % n, i / 9 % n, i % 11 == 0 ? static_cast<std::uint32_t>(-1) : i / 8}};
  };
  const auto lists = [&](const Concurrency concurrency) {
    std::vector<std::vector<std::uint32_t>> result(n);
    for_each_by_vertices(Block_size{concurrency, 6}, n, steps, vertices_of,
                         [&](const std::uint32_t i, const Block block) {
                           for(const std::uint32_t v : vertices_of(i))
                             if(block.has(v))
                               result[v].push_back(i);
                         });
    return result;
  };
  EXPECT_EQ(lists(Concurrency()), lists(Concurrency(parallel)));
}

namespace {

// Improves a surface in an order in space, its vertices moved, in small blocks.
void expect_same_improvement(const Mesh& surface, const Constraints& constraints = Constraints())
{
  namespace support = improvement_support;
  support::Start one, many;
  for(support::Start* start : {&one, &many})
  {
    support::spoil(surface, .2, *start, constraints);
    auto parameters = support::parameters_for(surface, surface.number_of_vertices());
    parameters.block_size = {start == &many ? Concurrency(parallel) : Concurrency(), 8};
    improve(surface, start->mesh, start->place, start->pinned, start->constrained, constraints, parameters,
            [](double) { return true; });
  }
  support::expect_valid(surface, one);
  ASSERT_EQ(one.mesh.number_of_halfedges(), many.mesh.number_of_halfedges());
  for(Vertex v : one.mesh.vertices())
    ASSERT_EQ(one.mesh.point(v), many.mesh.point(v)) << v;
  for(Halfedge h : one.mesh.halfedges())
    ASSERT_EQ(one.mesh.target(h), many.mesh.target(h)) << h;
}

Mesh sorted(const Mesh& mesh)
{
  Mesh result;
  copy_in_order(mesh, spatial_order(mesh, Concurrency()), result);
  return result;
}

} // namespace

TEST_F(Parallel, improvement_in_small_blocks)
{
  expect_same_improvement(sorted(improvement_support::torus(4)));
}

TEST_F(Parallel, improvement_of_an_open_surface_in_small_blocks)
{
  const Mesh plane = sorted(improvement_support::plane(70));
  expect_same_improvement(plane, improvement_support::constraints_of(plane));
}

TEST_F(Parallel, nearest_vertices_in_small_blocks)
{
  namespace support = improvement_support;
  const Mesh surface = sorted(support::torus(4));
  support::Start start;
  support::spoil(surface, .3, start);
  const Surface_walker walker(surface);
  const Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained);
  const Nearest_vertices whole(remeshed), one(remeshed, Block_size{Concurrency(), 6}),
      many(remeshed, Block_size{Concurrency(parallel), 6});
  EXPECT_EQ(one.vertex, many.vertex);
  EXPECT_EQ(one.squared_distance, many.squared_distance);
  // Which of the ways to a vertex comes first may decide whether a nearer one is found beyond it.
  std::size_t different = 0;
  for(std::size_t x = 0; x < one.vertex.size(); ++x)
    different += one.vertex[x] != whole.vertex[x];
  EXPECT_LT(different, one.vertex.size() / 100);
}

// Several trials a round, on a mesh where their places crowd
TEST_F(Parallel, trials_at_the_largest_deviations)
{
  namespace support = improvement_support;
  const Mesh surface = sorted(support::torus(4));
  const auto run = [&](const Concurrency concurrency, const std::size_t trials) {
    support::Start start;
    support::spoil(surface, .02, start);
    const Surface_walker walker(surface);
    Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained,
                              Block_size{concurrency, 8});
    const Nearest_vertices nearest(remeshed);
    Deviation_descent(remeshed, nearest, badness_of_angle(20.)).run(trials, 0.);
    const Deviations deviations(remeshed, nearest);
    double largest = 0.;
    std::vector<Point> points;
    for(Index f = 0; f < remeshed.connectivity().face_slots(); ++f)
      largest = (std::max)(largest, deviations.now({0., false, f}));
    for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
      points.push_back(remeshed.spot(v).point);
    return std::make_pair(largest, points);
  };
  const auto before = run(Concurrency(), 0), one = run(Concurrency(), 1000), many = run(Concurrency(parallel), 1000);
  EXPECT_LT(one.first, .8 * before.first);
  EXPECT_EQ(one.first, many.first);
  EXPECT_EQ(one.second, many.second);
}

TEST_F(Parallel, closed_surface)
{
  expect_same(made::rounded(made::cactus_blocks(), 4), 9000, gp::use_segmentation(true));
}

// Above the number of vertices from which on a mesh is put into an order in space
TEST_F(Parallel, dense_input)
{
  expect_same(made::rounded(made::cactus_blocks(), 5), 2000, gp::use_defect_moves(false));
}

TEST_F(Parallel, several_handles)
{
  expect_same(made::chain_of_tori(3), 5000, gp::use_defect_moves(true));
}

TEST_F(Parallel, surface_with_boundary)
{
  expect_same(made::disc(30), 5000, gp::use_segmentation(true));
}

TEST_F(Parallel, features_and_sizes)
{
  Mesh input = made::stairs(3);
  auto size = input.add_property_map<Vertex, double>("v:size", 1.).first;
  for(Vertex v : input.vertices())
    size[v] = 1. + .03 * input.point(v).z();
  expect_same(input, 6000, gp::features_angle_bound(60.).sizing_field(size));
}

TEST_F(Parallel, fitted)
{
  expect_same(made::rounded(made::cactus_blocks(), 3), 1500, gp::do_project(false));
}

TEST_F(Parallel, visitor_stops_the_work)
{
  struct Impatient : GR::Default_visitor
  {
    bool progress(double done) { return done < .7; }
  };
  const Mesh input = made::rounded(made::cactus_blocks(), 3);
  Mesh out;
  EXPECT_THROW(CGAL::geodesic_remeshing(input, 2000, out, gp::visitor(Impatient()).concurrency_tag(parallel)),
               GR::Remeshing_error);
  EXPECT_TRUE(out.is_empty());
}

TEST_F(Parallel, check_of_a_result)
{
  const Mesh input = made::rounded(made::cactus_blocks(), 4);
  Mesh out;
  CGAL::geodesic_remeshing(input, 3000, out, gp::concurrency_tag(parallel));
  const auto one = GR::is_valid_remeshing(input, out);
  const auto many = GR::is_valid_remeshing(input, out, gp::concurrency_tag(parallel));
  EXPECT_TRUE(bool(many));
  EXPECT_EQ(one.distance, many.distance);
  std::swap(out.point(Vertex(0)), out.point(Vertex(2000))); // the faces around both are wrong
  const auto one_bad = GR::is_valid_remeshing(input, out);
  const auto many_bad = GR::is_valid_remeshing(input, out, gp::concurrency_tag(parallel));
  EXPECT_FALSE(bool(many_bad));
  EXPECT_GT(many_bad.self_intersections, 0u);
  EXPECT_EQ(one_bad.self_intersections, many_bad.self_intersections);
  EXPECT_EQ(one_bad.flipped_faces, many_bad.flipped_faces);
}
