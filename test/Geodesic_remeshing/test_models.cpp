#include "distance_to_surface.h"
#include "test_support.h"

#include <mesh_quality.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The guarantees on the closed models of CGAL's data package.

namespace PMP = CGAL::Polygon_mesh_processing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using CGAL::geodesic_remeshing;
using CGAL::Geodesic_remeshing::internal::Edge;
using CGAL::Geodesic_remeshing::Stage_results;
using support::Face;
using support::largest_distance;
using support::Mesh;
using support::Point;
using support::Topology;
using support::Vertex;

namespace {

std::string path_of(const std::string& model)
{
  return CGAL::data_file_path("meshes/" + model + ".off");
}

Mesh read_model(const std::string& model)
{
  Mesh mesh;
  if(!CGAL::IO::read_OFF(path_of(model), mesh))
    throw std::runtime_error("cannot read " + path_of(model));
  PMP::triangulate_faces(mesh); // two of the models are of quadrilaterals
  return mesh;
}

double diagonal_of(const Mesh& mesh)
{
  const auto box = PMP::bbox(mesh);
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                   CGAL::square(box.zmax() - box.zmin()));
}

struct Case
{
  std::string model;
  std::size_t vertices;
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << c.model << " with " << c.vertices << " vertices";
}

std::vector<Case> model_cases()
{
  std::vector<Case> cases;
  for(const char* model : {"eight", "cactus", "dino", "camel", "bear", "elephant", "homer", "bull", "knot1", "3torus",
                           "double-torus-example", "armadillo", "man", "sphere"})
  {
    cases.push_back({model, 1000});
#ifdef NDEBUG // a hundred times as fast as with all assertions
    cases.push_back({model, 5000});
    cases.push_back({model, 20000});
#endif
  }
  return cases;
}

std::string name_of(const testing::TestParamInfo<Case>& info)
{
  std::string name = info.param.model + "_" + std::to_string(info.param.vertices);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// What is wanted of the shape of a result; from 5,000 vertices on more, which an input that intersects itself does not
// allow everywhere.
struct Limits
{
  double smallest_angle = 20., percent_below_30 = .1, percent_irregular = 12., mean_smallest_angle = 0.;
};

Limits limits_of(const Case& c)
{
  Limits limits;
  if(c.vertices < 5000)
    return limits;
  // camel's knees touch nearly
  limits.smallest_angle = c.model == "man" ? 20. : c.model == "camel" && c.vertices == 20000 ? 30. : 39.;
  limits.percent_irregular = c.vertices < 20000 ? c.model == "man" ? 8. : 7. : 5.;
  limits.mean_smallest_angle = 54.;
  return limits;
}

// Beside the vertices on creases, for which six is no better a valence than others
double percent_irregular(const Mesh& mesh, const Mesh::Property_map<Edge, bool>& on_line)
{
  const auto is_irregular = [&](Vertex v) {
    const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
    return mesh.degree(v) != 6 &&
           std::none_of(around.begin(), around.end(), [&](auto h) { return on_line[mesh.edge(h)]; });
  };
  return 100. * std::count_if(mesh.vertices().begin(), mesh.vertices().end(), is_irregular) / mesh.number_of_vertices();
}

class Remeshed_model : public testing::TestWithParam<Case>
{
protected:
  std::size_t vertices() const { return GetParam().vertices; }
  using On_line = Mesh::Property_map<Edge, bool>;
  struct Shares // in percent
  {
    double irregular, below_30;
  };
  Shares mean_shares(const Mesh& mesh, const On_line& on_line) const;

  const Mesh input = read_model(GetParam().model);
  Mesh output;
};

// Of a mesh and, where it is small, of those with a few vertices more: of a thousand vertices by chance three in a
// hundred are regular in one mesh and not in the next.
Remeshed_model::Shares Remeshed_model::mean_shares(const Mesh& mesh, const On_line& on_line) const
{
  Shares sum{percent_irregular(mesh, on_line), support::quality_of(mesh).percent_below_30};
  const std::size_t meshes = vertices() < 5000 ? 5 : vertices() < 20000 ? 3 : 1;
  for(std::size_t i = 1; i < meshes; ++i)
  {
    Mesh other;
    const On_line other_on_line = other.add_property_map<Edge, bool>("e:is_constrained", false).first;
    geodesic_remeshing(input, vertices() + i, other, gp::default_values(), gp::edge_is_constrained_map(other_on_line));
    sum.irregular += percent_irregular(other, other_on_line);
    sum.below_30 += support::quality_of(other).percent_below_30;
  }
  return {sum.irregular / static_cast<double>(meshes), sum.below_30 / static_cast<double>(meshes)};
}

void expect_loops(const Stage_results& stages)
{
  for(const auto& curve : stages.curves)
  {
    ASSERT_GE(curve.size(), 4u) << "three edges are around a vertex at least";
    EXPECT_EQ(curve.front(), curve.back());
  }
}

void expect_discs_and_annuli(const Mesh& cut)
{
  const auto region = cut.property_map<Face, int>("f:region").value();
  for(const auto& piece : support::topologies(cut, [&](Face f) { return region[f]; }))
  {
    const Topology& t = piece.second;
    EXPECT_EQ(t.components, 1) << "region " << piece.first;
    EXPECT_TRUE((t.euler_characteristic == 1 && t.boundary_loops == 1) ||
                (t.euler_characteristic == 0 && t.boundary_loops == 2))
        << "region " << piece.first << " has Euler characteristic " << t.euler_characteristic << " and "
        << t.boundary_loops << " boundary loops";
  }
}

} // namespace

TEST_P(Remeshed_model, has_topology_shape_and_place)
{
  const auto on_line = output.add_property_map<Edge, bool>("e:is_constrained", false).first;
  const auto summary =
      geodesic_remeshing(input, vertices(), output, gp::default_values(), gp::edge_is_constrained_map(on_line));

  EXPECT_EQ(output.number_of_vertices(), vertices());
  EXPECT_EQ(summary.number_of_vertices, output.number_of_vertices());
  EXPECT_EQ(summary.number_of_faces, output.number_of_faces());
  EXPECT_FALSE(output.has_garbage());
  ASSERT_TRUE(CGAL::is_valid_polygon_mesh(output)); // manifold and oriented: what a halfedge structure can hold
  ASSERT_TRUE(CGAL::is_triangle_mesh(output));
  EXPECT_TRUE(CGAL::is_closed(output));
  EXPECT_EQ(support::topology_of(output), support::topology_of(input));

  EXPECT_LE(largest_distance(output, input), 1e-9 * diagonal_of(input));

  const support::Quality quality = support::quality_of(output);
  const Limits limits = limits_of(GetParam());
  EXPECT_GE(quality.smallest_angle, limits.smallest_angle);
#ifdef NDEBUG
  const Shares shares = mean_shares(output, on_line);
  EXPECT_LE(shares.irregular, limits.percent_irregular);
  EXPECT_LE(shares.below_30, limits.percent_below_30);
#endif
  EXPECT_GE(quality.mean_smallest_angle, limits.mean_smallest_angle);
  std::vector<std::pair<Face, Face>> pairs;
  PMP::self_intersections(output, std::back_inserter(pairs));
  EXPECT_TRUE(pairs.empty() || PMP::does_self_intersect(input)) << pairs.size() << " pairs of faces intersect";
}

// Regions are looked at with the curves, since both cost another run.
TEST_P(Remeshed_model, has_regions_that_are_discs_and_annuli_and_curves_that_are_loops)
{
  Stage_results stages;
  geodesic_remeshing(input, vertices(), output,
                     gp::stage_results(std::ref(stages))
                         .number_of_iterations(0u)
                         .features_angle_bound(181.)); // the creases of 3torus would divide it into pieces
  const Topology topology = support::topology_of(input);
  EXPECT_EQ(support::topology_of(stages.working_surface), topology);
  EXPECT_EQ(support::topology_of(stages.regions), topology);
  EXPECT_EQ(support::topology_of(stages.strips), topology);
  EXPECT_NEAR(support::area_of(stages.working_surface), support::area_of(input), 1e-9 * support::area_of(input));
  EXPECT_NEAR(support::area_of(stages.regions), support::area_of(input), 1e-9 * support::area_of(input));
  // elephant has a handle no longer than the edges of its working surface: its regions there touch themselves
  if(GetParam().model != "elephant" || vertices() > 1000)
    expect_discs_and_annuli(stages.regions);
  expect_loops(stages);
  EXPECT_NEAR(static_cast<double>(stages.samples.size()), static_cast<double>(vertices()), .1 * vertices());
}

INSTANTIATE_TEST_SUITE_P(Models, Remeshed_model, testing::ValuesIn(model_cases()), name_of);

// ---- the same bytes

class Model_twice : public testing::TestWithParam<std::string>
{};

TEST_P(Model_twice, gives_the_same_bytes)
{
  const Mesh input = read_model(GetParam());
  Mesh once, twice;
  geodesic_remeshing(input, 1000, once);
  geodesic_remeshing(input, 1000, twice);
  EXPECT_TRUE(support::is_same_mesh(once, twice));
}

TEST_P(Model_twice, gives_the_same_bytes_from_OFF_and_from_PLY)
{
  const Mesh input = read_model(GetParam());
  Mesh from_ply, once, twice;
  std::stringstream ply(std::ios::in | std::ios::out | std::ios::binary);
  CGAL::IO::set_binary_mode(ply);
  ASSERT_TRUE(CGAL::IO::write_PLY(ply, input));
  ASSERT_TRUE(CGAL::IO::read_PLY(ply, from_ply));
  geodesic_remeshing(input, 1000, once);
  geodesic_remeshing(from_ply, 1000, twice);
  EXPECT_TRUE(support::is_same_mesh(once, twice));
}

INSTANTIATE_TEST_SUITE_P(Models, Model_twice, testing::Values("dino", "eight"));

#ifdef NDEBUG
// bear's ears and bull's ridges and horns are what is farthest: .34 and .72 if the last steps leave them as they are
TEST(Model, is_near_where_it_is_farthest)
{
  const auto hausdorff_percent = [](const std::string& model) {
    const Mesh input = read_model(model);
    Mesh output;
    geodesic_remeshing(input, 5000, output);
    return mesh_quality::measure_distance(input, output, 50000).hausdorff_percent;
  };
  EXPECT_LE(hausdorff_percent("bear"), .25);
  EXPECT_LE(hausdorff_percent("bull"), .68);
}
#endif

// ---- what cannot be

// Where curves go different ways along the edges of one face, and behind bridges, regions need not be discs, but what
// shows them is whole.
TEST(Model, has_regions_everywhere_though_its_handles_are_smaller_than_the_edges)
{
  const std::vector<std::pair<std::string, std::size_t>> cases = {
      {"cheese", 1000}, {"couplingdown", 1000}, {"femur", 1000}, {"turbine", 1000}};
  for(const auto& c : cases)
  {
    SCOPED_TRACE(c.first);
    const Mesh input = read_model(c.first);
    Mesh output;
    Stage_results stages;
    geodesic_remeshing(input, c.second, output,
                       gp::stage_results(std::ref(stages)).number_of_iterations(0u).features_angle_bound(181.));
    EXPECT_EQ(support::topology_of(stages.regions), support::topology_of(input));
    EXPECT_NEAR(support::area_of(stages.regions), support::area_of(input), 1e-9 * support::area_of(input));
    const auto region = stages.regions.property_map<Face, int>("f:region").value();
    for(const Face f : stages.regions.faces())
      ASSERT_GE(region[f], 0);
  }
}

TEST(Model_of_quadrilaterals, is_refused)
{
  Mesh input, output;
  ASSERT_TRUE(CGAL::IO::read_OFF(path_of("double-torus-example"), input));
  ASSERT_FALSE(CGAL::is_triangle_mesh(input));
  EXPECT_THROW(geodesic_remeshing(input, 1000, output), std::invalid_argument);
}
