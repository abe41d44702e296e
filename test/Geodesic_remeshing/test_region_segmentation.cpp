#include "made_surfaces.h"
#include "segmented_surface.h"
#include "test_support.h"

#include <CGAL/Geodesic_remeshing/internal/Stage_surfaces.h>
#include <CGAL/Geodesic_remeshing/region_segmentation.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Geodesic_remeshing::internal;
using CGAL::Geodesic_remeshing::region_segmentation;
using CGAL::Geodesic_remeshing::Region_kind;
using support::Segmented_surface;
using support::Topology;

namespace {

std::size_t number_of(Region_kind kind, const Segmentation& segmentation)
{
  std::size_t n = 0;
  for(const Region& region : segmentation.regions)
    n += region.kind == kind;
  return n;
}

Vector normal_of(const Mesh& mesh, Face f)
{
  const auto v = vertices_of(mesh, f);
  const Vector n = CGAL::cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0]));
  return n / std::sqrt(n.squared_length());
}

double area_along(const Mesh& mesh, Face f, const Vector& normal)
{
  const auto v = vertices_of(mesh, f);
  return .5 * CGAL::cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0])) * normal;
}

// The vertex of a bridge from which both ways lead up
Vertex saddle_of_bridge(const Segmented_surface& s, std::size_t bridge)
{
  const auto& vertices = s.segmentation.bridges[bridge];
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](Vertex a, Vertex b) { return s.order.rank[a] < s.order.rank[b]; });
}

// The highest maximum of a component lives for ever.
std::size_t number_of_persistent_maxima(const Segmented_surface& s, double least)
{
  const Mesh& mesh = s.working.mesh;
  support::Union_of_indices hills(mesh.number_of_vertices()); // represented by their highest vertices
  std::size_t persistent = 0;
  for(std::size_t i = s.order.ascending.size(); i-- > 0;)
  {
    const Vertex v = s.order.ascending[i];
    for(Vertex w : mesh.vertices_around_target(mesh.halfedge(v)))
    {
      if(s.order.rank[w] < i || hills.find(w) == hills.find(v))
        continue;
      Vertex low(static_cast<Mesh::size_type>(hills.find(v))), high(static_cast<Mesh::size_type>(hills.find(w)));
      if(s.order.rank[low] > s.order.rank[high])
        std::swap(low, high);
      persistent += low != v && s.distance[low] - s.distance[v] >= least;
      hills.unite(low, high);
    }
  }
  return persistent + s.roots.size();
}

void expect_total_order(const Segmented_surface& s)
{
  ASSERT_EQ(s.order.ascending.size(), s.working.mesh.number_of_vertices());
  for(std::size_t i = 0; i < s.order.ascending.size(); ++i)
    EXPECT_EQ(s.order.rank[s.order.ascending[i]], i);
  std::vector<Vertex> minima;
  for(Vertex v : s.working.mesh.vertices())
    if(!has_lower_neighbour(s.working.mesh, s.order.rank, v))
      minima.push_back(v);
  std::vector<Vertex> roots = s.roots;
  std::sort(roots.begin(), roots.end());
  EXPECT_EQ(minima, roots);
}

void expect_kinds_and_links(const Segmented_surface& s)
{
  const auto& regions = s.segmentation.regions;
  for(std::size_t r = 0; r < regions.size(); ++r)
  {
    for(std::size_t p : regions[r].parents)
    {
      EXPECT_GT(p, r) << "children before their parents";
      EXPECT_EQ(std::count(regions[p].children.begin(), regions[p].children.end(), r), 1);
      EXPECT_EQ(regions[p].top, regions[r].bottom);
    }
    for(std::size_t c : regions[r].children)
      EXPECT_EQ(std::count(regions[c].parents.begin(), regions[c].parents.end(), r), 1);
    EXPECT_EQ(regions[r].children.empty(), regions[r].kind == Region_kind::leaf) << "region " << r;
    EXPECT_EQ(regions[r].parents.empty(), regions[r].kind == Region_kind::root) << "region " << r;
    EXPECT_LE(regions[r].parents.size(), 2u);
  }
  EXPECT_EQ(number_of(Region_kind::root, s.segmentation), s.roots.size());
  for(const Region& region : regions)
  {
    const bool is_at_root = std::count(s.roots.begin(), s.roots.end(), region.centre) == 1;
    EXPECT_TRUE(region.kind != Region_kind::root || is_at_root);
  }
}

void expect_rounded_heights(const Segmented_surface& s)
{
  for(const Region& region : s.segmentation.regions)
  {
    EXPECT_GE(region.height, 0.);
    if(region.kind == Region_kind::root)
      continue;
    EXPECT_EQ(region.spacing, s.curve_distance);
    EXPECT_NEAR(region.height, region.number_of_levels * s.curve_distance, 1e-9 * region.height);
  }
}

// A tree under each root, but for one loop a handle: what is cut at every junction and glued again.
void expect_loops_of_graph(const Segmented_surface& s, const Topology& topology)
{
  const std::size_t n = s.segmentation.regions.size();
  EXPECT_EQ(n + topology.components, s.segmentation.number_of_junctions + topology.genus());
  std::size_t splits = 0;
  for(const Region& region : s.segmentation.regions)
    splits += region.parents.size() > 1;
  EXPECT_EQ(splits, static_cast<std::size_t>(topology.genus()));
}

void expect_every_vertex_has_a_region(const Segmented_surface& s)
{
  const Segmentation& g = s.segmentation;
  const int n = static_cast<int>(g.regions.size());
  for(Vertex v : s.working.mesh.vertices())
  {
    ASSERT_TRUE(0 <= g.region[v] && g.region[v] < n) << "vertex " << v;
    ASSERT_TRUE(0 <= g.field_region[v] && g.field_region[v] < n) << "vertex " << v;
    EXPECT_TRUE(std::isfinite(g.field[v])) << "vertex " << v;
    EXPECT_GE(g.level[v], 1);
  }
}

// A component so small that no curve fits on it is one piece, closed.
bool covers_a_component(const Segmentation& segmentation, int r)
{
  const Region& root = segmentation.regions[r];
  return root.kind == Region_kind::root && root.children.size() == 1 &&
         segmentation.regions[root.children.front()].kind == Region_kind::leaf &&
         segmentation.regions[root.children.front()].number_of_levels == 0;
}

// The paper's "simply connected": the front of a region moves through it without meeting itself.
void expect_discs_and_annuli(const Segmented_surface& s, const Topology& topology)
{
  const Mesh cut = cut_along_regions(s.working.mesh, s.segmentation);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cut));
  EXPECT_EQ(support::topology_of(cut), topology);
  EXPECT_NEAR(area(cut), area(s.surface), 1e-9 * area(s.surface));
  const auto region = cut.property_map<Face, int>("f:region").value();
  for(const auto& piece : support::topologies(cut, [&](Face f) { return region[f]; }))
  {
    const Topology& t = piece.second;
    EXPECT_EQ(t.components, 1) << "region " << piece.first;
    if(covers_a_component(s.segmentation, piece.first))
      continue;
    EXPECT_TRUE((t.euler_characteristic == 1 && t.boundary_loops == 1) ||
                (t.euler_characteristic == 0 && t.boundary_loops == 2))
        << "region " << piece.first << " has Euler characteristic " << t.euler_characteristic << " and "
        << t.boundary_loops << " boundary loops";
  }
}

void expect_valid_segmentation(const Segmented_surface& s)
{
  const Topology topology = support::topology_of(s.surface);
  expect_total_order(s);
  expect_kinds_and_links(s);
  expect_rounded_heights(s);
  expect_loops_of_graph(s, topology);
  expect_every_vertex_has_a_region(s);
  expect_discs_and_annuli(s, topology);
}

using made::cases;
using made::Case;

} // namespace

// ---- the working surface

TEST(Working_surface, covers_the_input_with_short_edges)
{
  for(const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const double whole = area(c.mesh), length = edge_length_for(whole, 700);
    Working_surface working;
    make_working_surface(c.mesh, length, working);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(working.mesh));
    EXPECT_EQ(support::topology_of(working.mesh), support::topology_of(c.mesh));
    for(Edge e : working.mesh.edges())
      EXPECT_LE(Metric(working.mesh).length(e), length);
    // no vertex but on the surface, and where it says
    for(Vertex v : working.mesh.vertices())
      EXPECT_LE(CGAL::squared_distance(point_at(c.mesh, working.place[v]), working.mesh.point(v)), 1e-24 * whole);
    // the faces in an input face cover it: their area, with the sign of its normal, adds up
    std::vector<double> covered(c.mesh.number_of_faces(), 0.);
    for(Face f : working.mesh.faces())
      covered[working.input_face[f]] += area_along(working.mesh, f, normal_of(c.mesh, working.input_face[f]));
    for(Face f : c.mesh.faces())
      EXPECT_NEAR(covered[f], area_along(c.mesh, f, normal_of(c.mesh, f)), 1e-12 * whole);
  }
}

TEST(Working_surface, faces_know_the_input_face_they_lie_in)
{
  for(const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const double whole = area(c.mesh);
    Working_surface working;
    make_working_surface(c.mesh, edge_length_for(whole, 700), working);
    for(Face f : working.mesh.faces())
      for(const std::array<double, 3>& weights : {std::array<double, 3>{{1., 0., 0.}}, {{0., .5, .5}}, {{.2, .3, .5}}})
      {
        const Place place = place_on_input(c.mesh, working, f, weights);
        EXPECT_EQ(place.face, working.input_face[f]);
        EXPECT_NEAR(place.coordinates[0] + place.coordinates[1] + place.coordinates[2], 1., 1e-12);
        EXPECT_GE(*std::min_element(place.coordinates.begin(), place.coordinates.end()), 0.);
        EXPECT_LE(CGAL::squared_distance(point_at(c.mesh, place), point_at(working.mesh, Place{f, weights})),
                  1e-24 * whole);
      }
  }
}

TEST(Working_surface, short_edges_are_left_alone)
{
  const Mesh mesh = made::torus(3, 1, 40, 16);
  Working_surface working;
  make_working_surface(mesh, 100., working);
  EXPECT_TRUE(support::is_same_mesh(working.mesh, mesh));
}

TEST(Working_surface, is_copied_only_to_be_changed)
{
  const Mesh mesh = made::torus(3, 1, 40, 16);
  const auto marked = [&](bool is_line) {
    Constraints constraints;
    constraints.is_line.assign(mesh.number_of_edges(), 0);
    constraints.is_line[0] = is_line;
    return constraints;
  };
  const double long_enough = 100., too_short = .3;
  for(const bool has_line : {false, true})
    for(const double length : {long_enough, too_short})
      for(const bool is_copy_wanted : {false, true})
      {
        SCOPED_TRACE(std::to_string(has_line) + " " + std::to_string(length) + " " + std::to_string(is_copy_wanted));
        Mesh surface = mesh;
        Stage_surfaces surfaces;
        surfaces.refine(surface, marked(has_line), length);
        EXPECT_EQ(&surfaces.whole() == &surface, length == long_enough);
        std::vector<char> is_corner;
        surfaces.cut(is_corner, is_copy_wanted);
        EXPECT_EQ(is_corner.size(), surfaces.mesh_of_pieces().number_of_vertices());
        EXPECT_EQ(&surfaces.mesh_of_pieces() == &surfaces.whole(), !has_line && !is_copy_wanted);
        const Mesh pieces = surfaces.mesh_of_pieces();
        Working_surface& working = surfaces.working();
        EXPECT_NE(&working.mesh, &surface);
        EXPECT_TRUE(support::is_same_mesh(surfaces.pieces().mesh, pieces));
        EXPECT_EQ(&surfaces.pieces() == &working, !has_line && !is_copy_wanted);
        EXPECT_EQ(support::is_same_mesh(working.mesh, mesh), length == long_enough);
        const auto marks = lines_of(working.mesh);
        EXPECT_EQ(std::any_of(working.mesh.edges_begin(), working.mesh.edges_end(), [&](Edge e) { return marks[e]; }),
                  has_line);
      }
}

TEST(Working_surface, lines_ask_for_shorter_edges)
{
  Mesh mesh = made::torus(3, 1, 40, 16);
  Constraints constraints;
  constraints.is_line.assign(mesh.number_of_edges(), 0);
  double longest = 0.;
  for(Edge e : mesh.edges())
    longest = (std::max)(longest, Metric(mesh).length(e));
  mark_lines(mesh, constraints);
  EXPECT_FALSE(has_long_edges(mesh, longest));
  EXPECT_TRUE(has_long_edges(mesh, .999 * longest));
  constraints.is_line[7] = 1;
  mark_lines(mesh, constraints);
  const double on_line = Metric(mesh).length(Edge(7)) / part_on_lines;
  EXPECT_FALSE(has_long_edges(mesh, 1.001 * on_line));
  EXPECT_TRUE(has_long_edges(mesh, .999 * on_line));
}

// ---- the order of the vertices

TEST(Vertex_order, ties_by_index)
{
  const Mesh mesh = made::octahedron();
  const std::vector<double> distance = {0., 2., 1., 1., 1., 1.}; // vertices 0 and 1 are opposite
  const Vertex_order order = order_vertices(mesh, distance, {Vertex(0)});
  EXPECT_EQ(order.ascending, (std::vector<Vertex>{Vertex(0), Vertex(2), Vertex(3), Vertex(4), Vertex(5), Vertex(1)}));
  for(std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(order.rank[order.ascending[i]], i);
}

TEST(Vertex_order, minima_that_are_not_roots_are_flooded)
{
  const Mesh mesh = made::plane(8);
  std::vector<double> distance;
  for(Vertex v : mesh.vertices())
    distance.push_back(mesh.point(v).x() + mesh.point(v).y());
  distance[4 * 9 + 4] = .5; // two dips
  distance[6 * 9 + 2] = 0.; // one as low as the root
  const Vertex_order order = order_vertices(mesh, distance, {Vertex(0)});
  EXPECT_EQ(order.ascending.front(), Vertex(0));
  std::set<Vertex> all(order.ascending.begin(), order.ascending.end());
  EXPECT_EQ(all.size(), mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(has_lower_neighbour(mesh, order.rank, v), v != Vertex(0)) << v;
}

TEST(Vertex_order, plateau_has_no_minimum_but_the_root)
{
  const Mesh mesh = made::sphere(3);
  const Vertex root(7);
  const Vertex_order order = order_vertices(mesh, std::vector<double>(mesh.number_of_vertices(), 1.), {root});
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(has_lower_neighbour(mesh, order.rank, v), v != root) << v;
}

// ---- the regions of made surfaces

class Regions_of_made_surfaces : public testing::TestWithParam<std::size_t>
{};

TEST_P(Regions_of_made_surfaces, are_discs_and_annuli_from_coarse_to_fine)
{
  const Mesh& mesh = cases()[GetParam()].mesh;
  for(std::size_t vertices : {50, 300, 2000})
  {
    if(vertices == 50 && euler_characteristic(mesh) == -8)
      continue; // five handles with ten vertices each: no room for a front beside them
    SCOPED_TRACE(std::to_string(vertices) + " vertices");
    expect_valid_segmentation(Segmented_surface(mesh, std::sqrt(.75) * edge_length_for(area(mesh), vertices)));
  }
}

// All distances rounded up to a coarse step: plateaus, whole curves of equal maxima, saddles that are polygons.
TEST_P(Regions_of_made_surfaces, are_discs_and_annuli_with_plateaus)
{
  const Mesh& mesh = cases()[GetParam()].mesh;
  Segmented_surface s(mesh, std::sqrt(.75) * edge_length_for(area(mesh), 400));
  for(double part : {.4, 1.})
  {
    SCOPED_TRACE("steps of " + std::to_string(part) + " curve distances");
    const std::vector<double> exact = s.distance;
    for(double& d : s.distance)
      d = std::ceil(d / (part * s.curve_distance)) * part * s.curve_distance; // only the root stays at 0
    s.segment_again();
    expect_valid_segmentation(s);
    s.distance = exact;
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Regions_of_made_surfaces, testing::Range(std::size_t(0), cases().size()),
                         [](const auto& info) { return cases()[info.param].name; });

// ---- the tree

// The root is the end of one limb; each other limb ends in a leaf.
TEST(Region_tree, one_leaf_for_each_limb_but_the_root_s)
{
  const std::vector<int> lengths = {30, 22, 25, 18, 27, 20};
  for(std::size_t limbs = 2; limbs <= lengths.size(); ++limbs)
  {
    SCOPED_TRACE(std::to_string(limbs) + " limbs");
    const Segmented_surface s(
        made::branching_tubes({lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(limbs)}), 3.);
    EXPECT_EQ(number_of(Region_kind::leaf, s.segmentation), limbs - 1);
    EXPECT_EQ(s.segmentation.tips.size(), limbs - 1);
    std::set<std::pair<int, bool>> ends; // the axis and side of the tip
    std::vector<Vertex> tips = s.segmentation.tips;
    tips.push_back(s.roots.front());
    for(Vertex v : tips)
    {
      const Vector p = s.working.mesh.point(v) - Point(2, 2, 2);
      int axis = 0;
      for(int i = 1; i < 3; ++i)
        axis = std::abs(p[i]) > std::abs(p[axis]) ? i : axis;
      EXPECT_GT(std::abs(p[axis]), 15.) << "far out on a limb";
      ends.emplace(axis, p[axis] > 0.);
    }
    EXPECT_EQ(ends.size(), limbs) << "no two on the same limb";
  }
}

// What rises less than half a curve distance is noise; with finer curves the same bumps are tips.
TEST(Region_tree, small_bumps_are_pruned)
{
  const Mesh mesh = made::spiky_sphere(5, .6, .15); // along a spike it is .62 from foot to tip
  const Segmented_surface coarse(mesh, 1.5);
  const Segmented_surface fine(mesh, .05);
  EXPECT_EQ(number_of(Region_kind::leaf, coarse.segmentation), 1u);
  EXPECT_EQ(number_of(Region_kind::leaf, fine.segmentation), 5u); // of six spikes one has the root
}

// A maximum dies at the saddle where it meets a higher one (persistence); those that live for half a curve distance are
// leaves.
TEST(Region_tree, leaves_are_the_maxima_that_are_not_noise)
{
  for(const Case& c : cases())
  {
    if(support::topology_of(c.mesh).genus() > 0)
      continue; // where fronts meet themselves there are leaves besides
    for(std::size_t vertices : {100, 1000})
    {
      SCOPED_TRACE(c.name + ", " + std::to_string(vertices) + " vertices");
      const Segmented_surface s(c.mesh, std::sqrt(.75) * edge_length_for(area(c.mesh), vertices));
      EXPECT_EQ(number_of(Region_kind::leaf, s.segmentation), number_of_persistent_maxima(s, .5 * s.curve_distance));
    }
  }
}

TEST(Region_tree, handles_split_a_front_each)
{
  for(int genus = 1; genus <= 5; ++genus)
  {
    SCOPED_TRACE("genus " + std::to_string(genus));
    const Mesh mesh = made::chain_of_tori(genus);
    ASSERT_EQ(support::topology_of(mesh).genus(), genus);
    for(double curve_distance : {.6, 1.5, 4.})
      expect_valid_segmentation(Segmented_surface(mesh, curve_distance));
  }
}

// Two equal limbs; the mean of the distances at mirrored vertices is the same to the last bit.
TEST(Region_tree, two_equal_maxima)
{
  const Mesh mesh = made::blocks({made::Block{{{-2, -2, 0}}, {{2, 2, 40}}}, made::Block{{{-16, -2, 0}}, {{16, 2, 4}}}});
  Segmented_surface s(mesh, 2.);
  const auto mirrored = [&](Vertex v) {
    const Point& p = s.working.mesh.point(v);
    for(Vertex w : s.working.mesh.vertices())
      if(s.working.mesh.point(w) == Point(-p.x(), p.y(), p.z()))
        return w;
    return Vertex();
  };
  s.march_from(*std::min_element(mesh.vertices().begin(), mesh.vertices().end(), [&](Vertex a, Vertex b) {
    return CGAL::squared_distance(mesh.point(a), Point(0, 0, 40)) <
           CGAL::squared_distance(mesh.point(b), Point(0, 0, 40));
  }));
  const std::vector<double> distance = s.distance;
  for(Vertex v : s.working.mesh.vertices())
  {
    ASSERT_TRUE(mirrored(v).is_valid()) << "long edges would be split, and not alike";
    s.distance[v] = .5 * (distance[v] + distance[mirrored(v)]);
  }
  s.segment_again();
  expect_valid_segmentation(s);
  ASSERT_EQ(number_of(Region_kind::leaf, s.segmentation), 2u);
  const auto& regions = s.segmentation.regions;
  EXPECT_EQ(s.distance[regions[0].centre], s.distance[regions[1].centre]);
  EXPECT_EQ(regions[1].centre, mirrored(regions[0].centre));
  EXPECT_NEAR(regions[0].height, regions[1].height, 1.001 * s.curve_distance);
  EXPECT_EQ(regions[0].parents, regions[1].parents);
}

// The fronts of two leaves that meet exactly when they come to a curve: a hair decides whether that curve is the last
// of the leaf or the first of the region below, and either must do.
TEST(Region_tree, saddle_exactly_at_a_level)
{
  const Mesh mesh = made::branching_tubes({24, 16, 16});
  const Segmented_surface coarse(mesh, 2.);
  ASSERT_EQ(coarse.segmentation.bridges.size(), 1u);
  for(int levels : {3, 7, 12})
    for(double hair : {-1e-9, -1e-15, 0., 1e-15, 1e-9})
    {
      SCOPED_TRACE(std::to_string(levels) + " levels and " + std::to_string(hair));
      const double rise =
          coarse.distance[coarse.segmentation.regions.front().centre] - coarse.distance[saddle_of_bridge(coarse, 0)];
      const Segmented_surface s(mesh, (1. + hair) * rise / levels);
      expect_valid_segmentation(s);
      EXPECT_EQ(number_of(Region_kind::leaf, s.segmentation), 2u);
    }
}

TEST(Region_tree, one_hill_is_a_leaf_and_a_root)
{
  const Segmented_surface s(made::ellipsoid(4, 1, 1, 5), .5);
  ASSERT_EQ(s.segmentation.regions.size(), 2u);
  EXPECT_EQ(s.segmentation.regions[0].kind, Region_kind::leaf);
  EXPECT_EQ(s.segmentation.regions[1].kind, Region_kind::root);
  const double sum = s.segmentation.regions[0].height + s.segmentation.regions[1].height;
  EXPECT_NEAR(sum, s.distance[s.order.ascending.back()], .05 * sum);
}

TEST(Region_tree, components_have_trees_of_their_own)
{
  std::vector<Mesh> parts;
  for(int i = 0; i < 6; ++i)
    parts.push_back(made::moved(i % 2 == 0 ? made::sphere(3) : made::torus(2, .6, 24, 8), made::Vector(6. * i, 0, 0)));
  const Segmented_surface s(made::together(parts), .3);
  expect_valid_segmentation(s);
  EXPECT_EQ(s.roots.size(), 6u);
  for(Edge e : s.working.mesh.edges()) // no two regions touch but through their parents: numbers are not shared
  {
    const auto part = [&](Vertex v) { return std::lround(s.working.mesh.point(v).x() / 6.); };
    const Vertex a = s.working.mesh.vertex(e, 0), b = s.working.mesh.vertex(e, 1);
    EXPECT_EQ(part(a), part(b));
  }
}

// ---- without segmentation

TEST(One_region, curves_are_those_of_the_distance_from_the_root)
{
  const Segmented_surface s(made::branching_tubes({20, 12, 15}), 2.);
  const Segmentation one = one_region(s.working.mesh, s.distance, s.order, s.roots.front(), 2.);
  ASSERT_EQ(one.regions.size(), 1u);
  EXPECT_EQ(one.field, s.distance);
  EXPECT_NEAR(one.regions[0].spacing * one.regions[0].number_of_levels, s.distance[s.order.ascending.back()], 1e-9);
  EXPECT_EQ(one.tips, s.segmentation.tips);
}

// ---- the public function

TEST(Region_segmentation, fills_the_map_and_returns_the_tree)
{
  Mesh mesh = made::branching_tubes({20, 12, 15});
  auto map = mesh.add_property_map<Face, std::size_t>("f:region", std::size_t(-1)).first;
  const auto tree = region_segmentation(mesh, 2., map);
  std::set<std::size_t> used;
  for(Face f : mesh.faces())
  {
    ASSERT_LT(map[f], tree.size());
    used.insert(map[f]);
  }
  std::size_t leaves = 0;
  for(std::size_t r = 0; r < tree.size(); ++r)
  {
    EXPECT_TRUE(tree[r].height <= 4. || used.count(r) == 1);
    if(tree[r].kind != Region_kind::root)
    {
      EXPECT_NEAR(tree[r].height, 2. * static_cast<double>(tree[r].number_of_curves), 1e-9);
    }
    if(tree[r].kind != Region_kind::leaf)
      continue;
    ++leaves;
    for(Face f : mesh.faces_around_target(mesh.halfedge(tree[r].center)))
    {
      EXPECT_EQ(map[f], r) << "a face at the centre";
    }
  }
  EXPECT_EQ(leaves, 2u);
}

TEST(Region_segmentation, takes_polyhedra_and_point_maps)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Mesh mesh = made::branching_tubes({20, 12, 15});
  auto regions = mesh.add_property_map<Face, int>("f:region", -1).first;
  const auto tree = region_segmentation(mesh, 2., regions);
  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  std::map<boost::graph_traits<Polyhedron>::face_descriptor, int> of_face;
  const auto same = region_segmentation(polyhedron, 2., boost::make_assoc_property_map(of_face));
  ASSERT_EQ(same.size(), tree.size());
  for(std::size_t r = 0; r < tree.size(); ++r)
    EXPECT_EQ(same[r].height, tree[r].height);
  // the points in a map of their own, the mesh itself collapsed to a point
  auto points = mesh.add_property_map<Vertex, Point>("v:elsewhere").first;
  for(Vertex v : mesh.vertices())
  {
    points[v] = mesh.point(v);
    mesh.point(v) = Point(0, 0, 0);
  }
  auto again = mesh.add_property_map<Face, int>("f:again", -1).first;
  region_segmentation(mesh, 2., again, CGAL::parameters::vertex_point_map(points));
  for(Face f : mesh.faces())
    EXPECT_EQ(again[f], regions[f]);
}

// Each component with boundary is one region, so that the Euler characteristics of the regions are those of the
// components; closed ones beside them have their trees.
TEST(Region_segmentation, components_with_boundary_are_regions)
{
  const Mesh tubes = made::branching_tubes({20, 12, 15});
  Mesh alone = tubes;
  const auto tree_alone = region_segmentation(alone, 2., alone.add_property_map<Face, int>("f:region", -1).first);
  Mesh mesh = made::together({made::moved(made::plane(20), made::Vector(0., 0., 60.)), tubes,
                              made::moved(made::cylinder(5., 30., 60, 30, false), made::Vector(0., 0., -90.))});
  auto map = mesh.add_property_map<Face, int>("f:region", -1).first;
  const auto tree = region_segmentation(mesh, 2., map);
  EXPECT_EQ(tree.size(), tree_alone.size() + 2);
  auto component = mesh.add_property_map<Face, std::size_t>("f:component").first;
  CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  std::map<int, std::set<std::size_t>> components_of;
  std::map<int, std::size_t> faces_of;
  for(Face f : mesh.faces())
  {
    ASSERT_GE(map[f], 0);
    ASSERT_LT(map[f], int(tree.size()));
    components_of[map[f]].insert(component[f]);
    ++faces_of[map[f]];
  }
  for(const auto& c : components_of)
    EXPECT_EQ(c.second.size(), 1u) << c.first;
  EXPECT_TRUE(std::any_of(faces_of.begin(), faces_of.end(), [](const auto& f) { return f.second == 800; }))
      << "the square";
  std::size_t on_boundary = 0, roots = 0;
  for(const auto& region : tree)
  {
    const bool is_on_boundary = mesh.is_border(region.center, true);
    on_boundary += is_on_boundary;
    roots += region.kind == Region_kind::root;
    EXPECT_TRUE(!is_on_boundary || (region.parents.empty() && region.children.empty()));
  }
  EXPECT_EQ(on_boundary, 2u);
  EXPECT_EQ(roots, 3u);
}

TEST(Region_segmentation, refuses_what_it_cannot_segment)
{
  Mesh mesh = made::sphere(2);
  auto map = mesh.add_property_map<Face, int>("f:region", -1).first;
  for(double d : {0., -1., infinity, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(region_segmentation(mesh, d, map), std::invalid_argument);
  Mesh empty;
  EXPECT_THROW(region_segmentation(empty, 1., empty.add_property_map<Face, int>("f:region").first),
               std::invalid_argument);
  mesh.point(Vertex(3)) = Point(0, infinity, 0);
  EXPECT_THROW(region_segmentation(mesh, .1, map), std::invalid_argument);
  for(Face f : mesh.faces())
    EXPECT_EQ(map[f], -1);
}
