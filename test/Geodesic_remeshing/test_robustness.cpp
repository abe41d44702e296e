#include "made_surfaces.h"
#include "random_surfaces.h"
#include "test_support.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// Surfaces that break remeshers, on purpose and at random; and the same result from every build.

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using made::Mesh;
using made::Point;
using made::Vector;
using made::Vertex;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;
using random_surfaces::Random;

namespace {

// What must hold whatever the surface: no angle, no distance of sheets is promised on these.
std::string faults(const GR::Remeshing_validity& v)
{
  std::string result;
  const auto add = [&](bool holds, const char* what) { result += holds ? "" : std::string(" ") + what; };
  add(v.is_manifold, "not-manifold");
  add(v.has_same_components, "components");
  add(v.has_same_genus, "genus");
  add(v.has_same_boundary_loops, "loops");
  add(v.has_number_of_vertices, "number");
  add(v.is_on_surface, "off-surface");
  return result;
}

GR::Remeshing_validity expect_valid(const Mesh& input, std::size_t number)
{
  Mesh output;
  CGAL::geodesic_remeshing(input, number, output);
  const GR::Remeshing_validity validity =
      GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(number));
  EXPECT_EQ(faults(validity), "");
  return validity;
}

// A vertex in each n-th face, this far from an edge or from a corner, in lengths of edges
Mesh with_thin_faces(Mesh mesh, double off, bool are_needles)
{
  const std::size_t faces = mesh.number_of_faces();
  for(std::size_t i = 0; i < faces; i += 7)
  {
    const Halfedge h = mesh.halfedge(Face(static_cast<Mesh::size_type>(i)));
    const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
                r = mesh.point(mesh.target(mesh.next(h)));
    const Halfedge n = CGAL::Euler::add_center_vertex(h, mesh);
    mesh.point(mesh.target(n)) =
        are_needles ? CGAL::barycenter(p, 1. - 2. * off, q, off, r, off) : CGAL::barycenter(p, .5, q, .5 - off, r, off);
  }
  return mesh;
}

// Without these faces
Mesh with_faces_removed(Mesh mesh, std::size_t first, std::size_t step, std::size_t number)
{
  for(std::size_t i = 0; i < number; ++i)
    CGAL::Euler::remove_face(mesh.halfedge(Face(static_cast<Mesh::size_type>(first + i * step))), mesh);
  mesh.collect_garbage();
  return mesh;
}

} // namespace

TEST(Hard_surface, caps_and_needles)
{
  const Mesh smooth = made::torus(3, 1, 30, 14);
  for(const double off : {1e-4, 1e-8, 1e-12, 0.})
    for(const bool are_needles : {false, true})
    {
      SCOPED_TRACE(std::to_string(off) + (are_needles ? " needles" : " caps"));
      expect_valid(with_thin_faces(smooth, off, are_needles), 300);
    }
}

// The check of the distance is not deceived by faces of no area either: found at random.
TEST(Hard_surface, faces_thin_to_the_last_bit)
{
  Random random(1549);
  expect_valid(random_surfaces::random_surface(random), 135);
}

TEST(Hard_surface, far_from_the_origin)
{
  const Mesh input = made::torus(3, 1, 30, 14);
  Mesh output, near;
  const Mesh far = made::moved(input, Vector(8e6, -8e6, 8e6)); // a million times its size
  CGAL::geodesic_remeshing(input, 400, near);
  CGAL::geodesic_remeshing(far, 400, output);
  EXPECT_EQ(faults(GR::is_valid_remeshing(far, output, gp::expected_number_of_vertices(400))), "");
  EXPECT_NEAR(support::quality_of(output).mean_smallest_angle, support::quality_of(near).mean_smallest_angle, 1.);
}

// There the coordinates themselves are no finer than 1e-7 of the size.
TEST(Hard_surface, so_far_from_the_origin_that_coordinates_are_rounded)
{
  const Mesh far = made::moved(made::torus(3, 1, 30, 14), Vector(8e9, -8e9, 8e9));
  Mesh output;
  CGAL::geodesic_remeshing(far, 400, output);
  EXPECT_EQ(faults(GR::is_valid_remeshing(far, output, gp::expected_number_of_vertices(400))), "");
  EXPECT_FALSE(GR::is_valid_remeshing(far, output, gp::surface_tolerance(1e-12)).is_on_surface);
}

TEST(Hard_surface, without_area)
{
  Mesh line, output;
  for(int i = 0; i < 10; ++i)
    line.add_vertex(Point(i, 2. * i, 0.));
  for(int i = 0; i + 2 < 10; ++i)
    line.add_face(Vertex(i), Vertex(i + 1 + i % 2), Vertex(i + 2 - i % 2));
  try
  {
    CGAL::geodesic_remeshing(line, 100, output);
    FAIL() << "remeshed";
  }
  catch(const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find("no area"), std::string::npos) << e.what();
  }
}

// All distances are equal to many others: nothing but the numbers of the vertices can decide.
TEST(Hard_surface, ties_everywhere)
{
  for(const Mesh& input : {made::plane(16), made::box(8, 8, 8), made::stairs(3), made::l_shape(), made::sphere(3),
                           made::torus(3, 1, 32, 16), made::octahedron()})
    for(const std::size_t number : {100, 400})
      expect_valid(input, number);
}

TEST(Hard_surface, handle_smaller_than_the_edges)
{
  // a cube with a narrow tunnel
  const Mesh input = made::blocks({made::Block{{{0, 0, 0}}, {{12, 6, 12}}}, made::Block{{{0, 7, 0}}, {{12, 12, 12}}},
                                   made::Block{{{0, 6, 0}}, {{12, 7, 6}}}, made::Block{{{0, 6, 7}}, {{12, 7, 12}}}});
  ASSERT_EQ(support::topology_of(input).genus(), 1);
  for(const std::size_t number : {40, 150, 1000}) // edges of 5, 2.6 and 1
    expect_valid(input, number);
}

TEST(Hard_surface, ten_holes_closer_than_an_edge)
{
  const Mesh input = with_faces_removed(made::plane(24), 24 * 24 + 4, 4, 10);
  ASSERT_EQ(support::topology_of(input).boundary_loops, 11);
  for(const std::size_t number : {80, 300})
    expect_valid(input, number);
}

TEST(Hard_surface, boundary_loops_of_three_vertices)
{
  const Mesh input = with_faces_removed(made::sphere(3), 0, 64, 8);
  ASSERT_EQ(support::topology_of(input).boundary_loops, 8);
  for(const std::size_t number : {30, 100, 1000})
    expect_valid(input, number);
}

// A rod as CAD programs write it: a hundred slivers from end to end. A sliver of length l is 2 l / m pieces at least
// where none is longer than m, and since edges are halved up to twice as many.
TEST(Hard_surface, slivers_take_pieces_in_proportion_to_their_length)
{
  const double length = 1000.;
  const unsigned around = 50;
  const Mesh input = made::cylinder(5., length, around, 1);
  GR::Stage_results stages;
  Mesh output;
  const GR::Summary summary = CGAL::geodesic_remeshing(input, 2000, output, gp::stage_results(std::ref(stages)));
  EXPECT_EQ(faults(GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(2000))), "");
  const double pieces = 2. * around * 2. * length / (1.5 * summary.edge_length);
  EXPECT_LT(static_cast<double>(stages.working_surface.number_of_faces()), 3. * pieces);
}

TEST(Hard_surface, spikes_one_triangle_wide)
{
  Mesh input = made::sphere(3);
  for(unsigned i = 0; i < 6; ++i) // those of the octahedron
    input.point(Vertex(i)) = CGAL::ORIGIN + 4. * (input.point(Vertex(i)) - CGAL::ORIGIN);
  for(const std::size_t number : {60, 300, 2000})
    expect_valid(input, number);
}

#ifdef NDEBUG
// Where most triangles are needles, whatever is done, there is an end to trying: it took 500 times as long.
TEST(Hard_surface, many_spikes_take_no_minutes)
{
  const auto seconds = [](const Mesh& input) {
    Mesh output;
    const std::clock_t start = std::clock();
    CGAL::geodesic_remeshing(input, 300, output);
    return double(std::clock() - start) / CLOCKS_PER_SEC;
  };
  const Mesh smooth = made::sphere(5);
  Mesh spiky = smooth;
  for(unsigned i = 0; i < spiky.number_of_vertices(); i += 100)
    spiky.point(Vertex(i)) = CGAL::ORIGIN + 4. * (spiky.point(Vertex(i)) - CGAL::ORIGIN);
  EXPECT_LT(seconds(spiky), 150. * seconds(smooth));
}
#endif

TEST(Hard_surface, hundred_times_as_many_vertices)
{
  expect_valid(made::octahedron(), 600);
  expect_valid(made::torus(3, 1, 6, 5), 3000);
  expect_valid(made::plane(1), 400);
}

// So thin that all the vertices in a row would not reach from end to end: refused at once, with a number that would do.
TEST(Hard_surface, thread)
{
  const Mesh thread = made::cylinder(1e-4, 1e3, 3, 1);
  Mesh output = made::octahedron();
  try
  {
    CGAL::geodesic_remeshing(thread, 50, output);
    FAIL() << "remeshed";
  }
  catch(const GR::Remeshing_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("too long and thin for 50 vertices"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(support::is_same_mesh(output, made::octahedron()));
  expect_valid(made::cylinder(.03, 10., 5, 1), 500); // three hundred times as long as wide
}

// A line with two corners only, one edge of the face, and one around it: three points of the first make no face.
TEST(Hard_surface, parts_of_one_obtuse_face)
{
  Mesh input = made::sphere(3);
  for(unsigned i = 0; i < 12; ++i)
  {
    const double x = 3. * i + 4., y = .1 + .1 * i;
    input.add_face(input.add_vertex(Point(x, 0., 0.)), input.add_vertex(Point(x + 2., .3 * y, y)),
                   input.add_vertex(Point(x + 1., y, 0.)));
  }
  for(const std::size_t number : {60, 300})
    EXPECT_EQ(expect_valid(input, number).degenerate_faces, 0u);
}

// A crescent closed to a ring by its two tips, which are two vertices at one point.
TEST(Hard_surface, lines_between_corners_at_one_point)
{
  constexpr unsigned n = 16;
  Mesh input;
  std::vector<Vertex> inner, outer;
  for(unsigned i = 0; i <= n; ++i)
  {
    const double u = 2. * CGAL_PI * (i % n) / n, width = 2. * std::sin(CGAL_PI * i / n);
    const auto add = [&](double r) { return input.add_vertex(Point(r * std::cos(u), r * std::sin(u), 0.)); };
    inner.push_back(add(3.));
    outer.push_back(i == 0 || i == n ? inner.back() : add(3. + width));
  }
  for(unsigned i = 0; i < n; ++i)
  {
    if(i + 1 < n)
      input.add_face(inner[i], outer[i + 1], inner[i + 1]);
    if(i > 0)
      input.add_face(inner[i], outer[i], outer[i + 1]);
  }
  for(const std::size_t number : {12, 40, 300})
    EXPECT_EQ(expect_valid(input, number).degenerate_faces, 0u);
}

// Two sheets that lie on each other: nothing parts them, and trying to takes no minutes.
TEST(Hard_surface, sheets_on_each_other)
{
  const Mesh input = made::together({made::plane(12), made::moved(made::plane(12), Vector(.3, .3, 0.))});
  const auto start = std::chrono::steady_clock::now();
  EXPECT_GT(expect_valid(input, 600).self_intersections, 600u);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 30.);
}

// Ten small spheres just inside of a large one: its triangles cut through them until there are smaller ones.
TEST(Hard_surface, sheets_nearer_to_each_other_than_triangles_are_flat)
{
  std::vector<Mesh> spheres = {made::sphere(4)};
  for(int i = 0; i < 10; ++i)
  {
    const double u = .3 + .22 * i, x = std::cos(u) * std::sin(.9), y = std::sin(u) * std::sin(.9), z = std::cos(.9);
    const Vector at(x, std::cos(.3) * y - std::sin(.3) * z, std::sin(.3) * y + std::cos(.3) * z);
    spheres.push_back(made::moved(made::scaled(made::sphere(1), .04), .954 * at));
  }
  for(const std::size_t number : {150, 250})
    EXPECT_EQ(expect_valid(made::together(spheres), number).self_intersections, 0u);
}

namespace {

Mesh read_model(const std::string& name)
{
  Mesh mesh;
  EXPECT_TRUE(CGAL::IO::read_OFF(CGAL::data_file_path("meshes/" + name + ".off"), mesh));
  return mesh;
}

} // namespace

// Thin walls, a bowl as thin as paper and a fold: triangles of one size cut through what is behind them, or turn over,
// as all of these did before the stages were run again with smaller ones there. Of three, one may be left where that
// does not help.
TEST(Hard_surface, thin_walls_and_folds)
{
  struct Case
  {
    const char* name;
    std::size_t vertices;
  };
  std::vector<Case> cases = {{"helmet", 200}};
#ifdef NDEBUG // a hundred times as fast as with all assertions
  cases.insert(cases.end(), {{"couplingdown", 200}, {"femur", 2000}});
#endif
  std::vector<std::string> blemished;
  for(const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const GR::Remeshing_validity validity = expect_valid(read_model(c.name), c.vertices);
    if(validity.self_intersections + validity.flipped_faces > 0)
      blemished.push_back(c.name);
  }
  EXPECT_LE(blemished.size(), cases.size() / 3) << testing::PrintToString(blemished);
}

namespace {

// That a refusal of four vertices says to try
std::size_t number_to_try(const Mesh& input)
{
  Mesh output;
  std::string message;
  try
  {
    CGAL::geodesic_remeshing(input, 4, output);
  }
  catch(const GR::Remeshing_error& error)
  {
    message = error.what();
  }
  const std::string before = "; try ";
  EXPECT_NE(message.find(before), std::string::npos) << message;
  return message.find(before) == std::string::npos ? 4
                                                   : std::stoul(message.substr(message.find(before) + before.size()));
}

} // namespace

// Handles, thin places, corners and lines need more vertices than the bounds that a refusal tells: it names a number
// that can be reached, too.
TEST(Hard_surface, refusals_name_a_number_that_can_be_reached)
{
  for(const char* name : {"anchor", "blobby_3cc", "boeing", "couplingdown", "eight", "mask_cone", "pig"})
  {
    SCOPED_TRACE(name);
    const Mesh input = read_model(name);
    Mesh output;
    const std::size_t number = number_to_try(input);
    EXPECT_NO_THROW(CGAL::geodesic_remeshing(input, number, output));
    EXPECT_EQ(output.number_of_vertices(), number);
  }
}

// Each of them can have four vertices, and hardly any needs more.
TEST(Hard_surface, refusals_of_very_many_parts_name_no_needless_number)
{
  std::vector<Mesh> parts;
  for(int i = 0; i < 200; ++i)
    parts.push_back(made::moved(made::scaled(made::tetrahedron(), 1. + .001 * i), Vector(4. * i, 0., 0.)));
  const Mesh input = made::together(parts);
  const std::size_t number = number_to_try(input);
  EXPECT_LE(number, 2u * 4u * parts.size());
  expect_valid(input, number);
}

// All that is left is to make edges longer, which flattens faces that are flat already.
TEST(Hard_surface, any_number_of_vertices_on_a_band_narrower_than_edges)
{
  Mesh band = made::plane(20);
  for(const Vertex v : band.vertices())
    band.point(v) = Point(500. * band.point(v).x(), .05 * band.point(v).y(), 0.);
  for(const std::size_t number : {10, 20, 50, 51, 100, 101, 200})
    expect_valid(band, number);
}

// On sharp creases a corner is as near to a face that looks away as to its own: that alone turns no face over.
TEST(Hard_surface, corners_on_creases)
{
  const Mesh input = read_model("bull");
  Mesh output;
  CGAL::geodesic_remeshing(input, 2000, output, gp::features_angle_bound(60.));
  EXPECT_EQ(GR::is_valid_remeshing(input, output, gp::line_tolerance(1.)).flipped_faces, 0u);
}

// Where the stages are run once more, to have smaller triangles in such places, the visitor can stop them as well; it
// is told of no stage twice, and never of less progress.
TEST(Hard_surface, visitor_where_stages_are_repeated)
{
  struct Visitor
  {
    int calls_left;
    int calls = 0;
    double last = 0.;
    std::vector<std::string> stages = {};
    void stage(const std::string& name) { stages.push_back(name); }
    bool progress(double done)
    {
      EXPECT_GE(done, last);
      last = done;
      ++calls;
      return calls_left-- != 0;
    }
  };
  const Mesh input = read_model("helmet");
  Mesh output = made::octahedron();
  Visitor all{-1}, of_another{-1};
  CGAL::geodesic_remeshing(input, 200, output, gp::visitor(std::ref(all)));
  CGAL::geodesic_remeshing(made::torus(3, 1, 30, 14), 200, output, gp::visitor(std::ref(of_another)));
  EXPECT_GT(all.calls, of_another.calls + 10);
  EXPECT_EQ(all.stages, of_another.stages);
  output = made::octahedron();
  for(const int calls : {all.calls - 15, all.calls - 3})
  {
    Visitor visitor{calls};
    EXPECT_THROW(CGAL::geodesic_remeshing(input, 200, output, gp::visitor(std::ref(visitor))), GR::Remeshing_error);
    EXPECT_EQ(visitor.calls, calls + 1);
    EXPECT_TRUE(support::is_same_mesh(output, made::octahedron()));
  }
}

// The cheapest places to take a vertex from all bear it not: others do. Found at random.
TEST(Hard_surface, fewest_vertices_of_a_thin_torus)
{
  Random random(50104);
  expect_valid(random_surfaces::random_surface(random), 7);
}

namespace {

// The same surface with its vertices and faces in another order
Mesh renumbered(const Mesh& mesh, std::uint64_t seed)
{
  Random random(seed);
  const auto order = [&](std::size_t n) {
    std::vector<std::size_t> result(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::size_t j = random.below(i + 1);
      result[i] = result[j];
      result[j] = i;
    }
    return result;
  };
  Mesh result;
  std::vector<Vertex> copy(mesh.number_of_vertices());
  for(const std::size_t v : order(mesh.number_of_vertices()))
    copy[v] = result.add_vertex(mesh.point(Vertex(static_cast<Mesh::size_type>(v))));
  for(const std::size_t f : order(mesh.number_of_faces()))
  {
    const Halfedge h = mesh.halfedge(Face(static_cast<Mesh::size_type>(f)));
    result.add_face(copy[mesh.source(h)], copy[mesh.target(h)], copy[mesh.target(mesh.next(h))]);
  }
  return result;
}

// Turned about two axes, as far as doubles go
Mesh turned(Mesh mesh, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  for(Vertex v : mesh.vertices())
  {
    const Point p = mesh.point(v);
    const double x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
    mesh.point(v) = Point(x, c * y - s * p.z(), s * y + c * p.z());
  }
  return mesh;
}

std::vector<Mesh> invariance_surfaces()
{
  return {made::rounded(made::cactus_blocks(), 4), made::chain_of_tori(2),
          with_faces_removed(made::stairs(3), 5, 40, 4)};
}

} // namespace

// Scaling by a power of two rounds nothing: the bytes are the same but for the exponents.
TEST(Invariance, scaled_by_a_power_of_two)
{
  for(const Mesh& input : invariance_surfaces())
    for(const double factor : {0x1p-20, 0x1p10})
    {
      Mesh output, scaled_output;
      CGAL::geodesic_remeshing(input, 700, output);
      CGAL::geodesic_remeshing(made::scaled(input, factor), 700, scaled_output);
      EXPECT_TRUE(support::is_same_mesh(scaled_output, made::scaled(output, factor))) << factor;
    }
}

namespace {

support::Quality quality_of_remeshing(const Mesh& input, std::size_t number)
{
  Mesh output;
  CGAL::geodesic_remeshing(input, number, output);
  EXPECT_EQ(faults(GR::is_valid_remeshing(input, output, gp::expected_number_of_vertices(number))), "");
  return support::quality_of(output);
}

double standard_deviation(const std::vector<double>& values)
{
  const double number = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.) / number;
  double squares = 0.;
  for(double value : values)
    squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (number - 1.));
}

} // namespace

// Other roundings, other ties: another mesh, but as good a one. Each result is one throw; what is bounded is how far
// the throws lie apart, all together, since the farthest of many says little.
TEST(Invariance, moved_turned_scaled_and_renumbered)
{
  const std::size_t number = 1000;
  for(const Mesh& input : invariance_surfaces())
  {
    std::vector<Mesh> inputs = {input, made::moved(input, Vector(3., 100., -7.)), made::scaled(input, 1e-3)};
    for(std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      inputs.push_back(turned(input, .7 * static_cast<double>(seed)));
      inputs.push_back(renumbered(input, seed));
      inputs.push_back(turned(renumbered(input, seed), .9 * static_cast<double>(seed)));
    }
    std::vector<double> angles, irregular;
    for(const Mesh& other : inputs)
    {
      SCOPED_TRACE(angles.size());
      const support::Quality quality = quality_of_remeshing(other, number);
      angles.push_back(quality.mean_smallest_angle);
      irregular.push_back(quality.percent_irregular);
    }
    EXPECT_LT(standard_deviation(angles), .8);
    EXPECT_LT(standard_deviation(irregular), 1.2);
  }
}

namespace {

struct Random_case
{
  Mesh input;
  std::size_t number;
  unsigned int iterations;
  bool use_segmentation, use_defect_moves, has_features, has_sizing;
  double contrast;
  std::string description;

  explicit Random_case(std::uint64_t seed)
  {
    Random random(seed);
    input = random_surfaces::random_surface(random);
    number = static_cast<std::size_t>(std::pow(10., random.between(.7, 2.9)));
    iterations = random.chance(.2) ? static_cast<unsigned int>(random.below(3)) : 3;
    use_segmentation = random.chance(.8);
    use_defect_moves = random.chance(.7);
    has_features = random.chance(.3);
    has_sizing = random.chance(.3);
    contrast = random.between(0., 2.);
    std::ostringstream out;
    out << "seed " << seed << ": " << input.number_of_vertices() << " vertices to " << number << ", iterations "
        << iterations << ", segmentation " << use_segmentation << ", defect moves " << use_defect_moves << ", features "
        << has_features << ", sizing " << has_sizing << " " << contrast;
    description = out.str();
  }

  template <class NamedParameters>
  void remesh(Mesh& output, const NamedParameters& np) const
  {
    if(has_features)
      CGAL::geodesic_remeshing(input, number, output, np.features_angle_bound(60.));
    else
      CGAL::geodesic_remeshing(input, number, output, np);
  }

  // Of coordinates, beside the size: far from the origin it is more than the tolerance.
  double rounding() const
  {
    const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(input);
    double largest = 0., size = 0.;
    for(int i = 0; i < 3; ++i)
    {
      largest = (std::max)({largest, std::abs(box.max(i)), std::abs(box.min(i))});
      size = (std::max)(size, box.max(i) - box.min(i));
    }
    return 4. * std::numeric_limits<double>::epsilon() * largest / size;
  }

  // What is wrong, "" if nothing is, or why it was refused, with a "(" before
  std::string run() const
  {
    Mesh output;
    try
    {
      const auto np =
          gp::use_segmentation(use_segmentation).number_of_iterations(iterations).use_defect_moves(use_defect_moves);
      if(has_sizing)
        remesh(output, np.sizing_field(GR::Curvature_sizing_field<Mesh>(input, gp::contrast(contrast))));
      else
        remesh(output, np);
    }
    catch(const std::invalid_argument& error)
    {
      return std::string("(") + error.what();
    }
    catch(const GR::Remeshing_error& error)
    {
      return std::string("(") + error.what();
    }
    catch(const std::exception& error)
    {
      return error.what();
    }
    return faults(GR::is_valid_remeshing(input, output,
                                         gp::expected_number_of_vertices(number).surface_tolerance(1e-9 + rounding())));
  }
};

std::uint64_t environment(const char* name, std::uint64_t otherwise)
{
  const char* const value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

// The first seeds always; from GEODESIC_REMESHING_SEED on, for GEODESIC_REMESHING_SECONDS, if these are set. A seed
// that fails can be run alone: GEODESIC_REMESHING_SEED=... GEODESIC_REMESHING_SECONDS=0
TEST(Random_surfaces, are_remeshed_or_refused)
{
  const std::uint64_t first = environment("GEODESIC_REMESHING_SEED", 1);
  const double seconds = static_cast<double>(environment("GEODESIC_REMESHING_SECONDS", 0));
  const std::uint64_t least = std::getenv("GEODESIC_REMESHING_SEED") == nullptr ? 25 : 1;
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t seed = first;
  std::size_t refused = 0;
  for(; seed < first + least || seconds_since(start) < seconds; ++seed)
  {
    const Random_case random_case(seed);
    const auto begin = std::chrono::steady_clock::now();
    RecordProperty("seed", std::to_string(seed)); // the last one in the report if the program dies
    if(seconds > 0.)
      std::ofstream("last_seed.txt") << random_case.description << "\n";
    const std::string outcome = random_case.run();
    const bool is_refused = !outcome.empty() && outcome.front() == '(';
    refused += is_refused;
    if(is_refused && seconds > 0.)
      std::cout << random_case.description << outcome << "\n";
    EXPECT_TRUE(outcome.empty() || is_refused) << random_case.description << ":" << outcome;
    EXPECT_LT(seconds_since(begin), 60.) << random_case.description;
  }
  std::cout << seed - first << " surfaces, " << refused << " of them refused\n";
  if(seed - first >= 25)
  {
    EXPECT_LT(4 * refused, seed - first);
  }
}

namespace {

// FNV-1a over the bits of all coordinates and the vertices of all faces
std::uint64_t checksum(const Mesh& mesh)
{
  std::uint64_t sum = 0xCBF29CE484222325ull;
  const auto add = [&](std::uint64_t bits) {
    for(int i = 0; i < 8; ++i, bits >>= 8)
      sum = (sum ^ (bits & 0xFF)) * 0x100000001B3ull;
  };
  for(Vertex v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
    {
      const double x = mesh.point(v)[i];
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof(bits));
      add(bits);
    }
  for(Face f : mesh.faces())
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      add(v.idx());
  return sum;
}

} // namespace

// The sums are written to a file beside the program: scripts/test compares those of its builds, of two compilers, with
// and without optimisation and assertions.
TEST(Same_bytes, from_every_build)
{
  std::ofstream out("checksums.txt");
  out << std::hex << std::setfill('0');
  const Mesh closed = made::rounded(made::cactus_blocks(), 4), tori = made::chain_of_tori(2),
             open = with_faces_removed(made::stairs(3), 5, 40, 4);
  const auto write = [&](const char* name, const Mesh& input, const auto& np) {
    Mesh once, again;
    CGAL::geodesic_remeshing(input, 700, once, np);
    CGAL::geodesic_remeshing(input, 700, again, np);
    EXPECT_EQ(checksum(once), checksum(again)) << name;
    out << name << " " << std::setw(16) << checksum(once) << "\n";
  };
  write("closed", closed, gp::default_values());
  write("genus_2", tori, gp::default_values());
  write("open", open, gp::default_values());
  write("features", open, gp::features_angle_bound(60.));
  Mesh marked = closed; // by curvature the sizes would be those of the version of CGAL
  auto size = marked.add_property_map<Vertex, double>("v:size", 1.).first;
  for(Vertex v : marked.vertices())
    size[v] = 1. + .03 * marked.point(v).z();
  write("sized", marked, gp::sizing_field(size));
  EXPECT_TRUE(out.flush());
}
