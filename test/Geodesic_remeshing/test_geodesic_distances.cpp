#include <CGAL/Geodesic_remeshing/geodesic_distances.h>
#include <CGAL/Geodesic_remeshing/internal/Fast_marching.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
using namespace CGAL::Geodesic_remeshing::internal;
using Location = std::pair<Face, std::array<double, 3>>;
using Distances = Mesh::Property_map<Vertex, double>;

namespace {

Distances add_distances(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, double>("v:test_distance", -1.).first;
}

// (columns + 1) x (rows + 1) vertices at point(i, j), each quad cut in two
template <typename Point_at>
Mesh grid(unsigned columns, unsigned rows, const Point_at& point)
{
  Mesh mesh;
  for(unsigned j = 0; j <= rows; ++j)
    for(unsigned i = 0; i <= columns; ++i)
      mesh.add_vertex(point(i, j));
  const auto v = [&](unsigned i, unsigned j) { return Vertex(j * (columns + 1) + i); };
  for(unsigned j = 0; j < rows; ++j)
    for(unsigned i = 0; i < columns; ++i)
    {
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  return mesh;
}

Mesh irregular_plane(unsigned n, double aspect)
{
  std::mt19937 random(3);
  const auto shift = [&](unsigned i) { return i == 0 || i == n ? 0. : (double(random()) / random.max() - 0.5) * 0.45; };
  return grid(n, n, [&](unsigned i, unsigned j) {
    const double x = i + shift(i);
    return Point(aspect * x, j + shift(j), 0.);
  });
}

// A tube around the z-axis, open at both ends
template <typename Radius, typename Height>
Mesh tube(unsigned sides, unsigned rows, const Radius& radius, const Height& height)
{
  Mesh mesh;
  for(unsigned j = 0; j <= rows; ++j)
    for(unsigned i = 0; i < sides; ++i)
    {
      const double angle = 2. * CGAL_PI * i / sides;
      mesh.add_vertex(Point(radius(j) * std::cos(angle), radius(j) * std::sin(angle), height(j)));
    }
  const auto v = [&](unsigned i, unsigned j) { return Vertex(j * sides + i % sides); };
  for(unsigned j = 0; j < rows; ++j)
    for(unsigned i = 0; i < sides; ++i)
    {
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  return mesh;
}

Mesh sphere(unsigned meridians,
            unsigned parallels) // a parallel on the equator if the number is even; without the caps at the poles
{
  const auto latitude = [=](unsigned j) { return CGAL_PI * (double(j + 1) / (parallels + 2) - 0.5); };
  return tube(
      meridians, parallels, [&](unsigned j) { return std::cos(latitude(j)); },
      [&](unsigned j) { return std::sin(latitude(j)); });
}

// The icosahedron with `frequency` rows of faces on each face, on the unit sphere
Mesh geodesic_sphere(unsigned frequency)
{
  Mesh coarse;
  CGAL::make_icosahedron<Mesh, Point>(coarse);
  Mesh mesh;
  std::map<std::array<long long, 3>, Vertex> vertex_at;
  const auto vertex = [&](const Vector& p) {
    const double l = std::sqrt(p.squared_length());
    const std::array<long long, 3> key = {
        {std::llround(p.x() / l * 1e8), std::llround(p.y() / l * 1e8), std::llround(p.z() / l * 1e8)}};
    const auto found = vertex_at.find(key);
    return found != vertex_at.end() ? found->second
                                    : vertex_at[key] = mesh.add_vertex(Point(p.x() / l, p.y() / l, p.z() / l));
  };
  for(Face f : coarse.faces())
  {
    const auto c = vertices_of(coarse, f);
    const auto at = [&](unsigned i, unsigned j) {
      const Point p = coarse.point(c[0]);
      return vertex((p - CGAL::ORIGIN) + double(i) / frequency * (coarse.point(c[1]) - p) +
                    double(j) / frequency * (coarse.point(c[2]) - p));
    };
    for(unsigned i = 0; i < frequency; ++i)
      for(unsigned j = 0; i + j < frequency; ++j)
      {
        mesh.add_face(at(i, j), at(i + 1, j), at(i, j + 1));
        if(i + j + 1 < frequency)
          mesh.add_face(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return mesh;
}

double euclidean(const Point& p, const Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

struct Error
{
  double mean = 0.;
  double largest = 0.;
};

template <typename Truth>
Error relative_error(const Mesh& mesh, const Distances& distance, const Truth& truth)
{
  Error error;
  std::size_t n = 0;
  for(Vertex v : mesh.vertices())
  {
    const double t = truth(v);
    if(!(t > 0.))
    {
      EXPECT_NEAR(distance[v], 0., 1e-12);
      continue;
    }
    const double e = std::abs(distance[v] - t) / t;
    error.mean += e;
    error.largest = (std::max)(error.largest, e);
    ++n;
  }
  error.mean /= double(n);
  return error;
}

Error error_against_exact(const std::string& name)
{
  Mesh mesh;
  EXPECT_TRUE(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh));
  const Distances distance = add_distances(mesh);
  GR::geodesic_distances(mesh, distance, Vertex(0));
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> exact(mesh);
  exact.add_source_point(Vertex(0));
  return relative_error(mesh, distance, [&](Vertex v) { return exact.shortest_distance_to_source_points(v).first; });
}

} // namespace

// ---- distances from points

TEST(Geodesic_distances, a_plane_is_exact_from_a_vertex)
{
  Mesh mesh = grid(60, 60, [](unsigned i, unsigned j) { return Point(i, j, 0.); });
  const Distances distance = add_distances(mesh);
  const Vertex source(30 * 61 + 30);
  GR::geodesic_distances(mesh, distance, source);
  EXPECT_LT(
      relative_error(mesh, distance, [&](Vertex v) { return euclidean(mesh.point(source), mesh.point(v)); }).largest,
      1e-9);
}

TEST(Geodesic_distances, slivers_and_obtuse_faces_are_as_good)
{
  for(double aspect : {1., 5., 20.}) // 47, 91 and 99 % of the faces are obtuse
  {
    Mesh mesh = irregular_plane(60, aspect);
    const Distances distance = add_distances(mesh);
    const Vertex source(30 * 61 + 30);
    GR::geodesic_distances(mesh, distance, source);
    const Error error =
        relative_error(mesh, distance, [&](Vertex v) { return euclidean(mesh.point(source), mesh.point(v)); });
    EXPECT_LT(error.mean, 1e-4) << aspect;
    EXPECT_LT(error.largest, 1e-2) << aspect;
  }
}

TEST(Geodesic_distances, points_in_faces_and_on_edges)
{
  Mesh mesh = irregular_plane(40, 3.);
  const Distances distance = add_distances(mesh);
  for(const std::array<double, 3>& coordinates :
      {std::array<double, 3>{{.2, .5, .3}}, std::array<double, 3>{{0., .4, .6}}, std::array<double, 3>{{1., 0., 0.}}})
  {
    const Face f(2 * (20 * 40 + 20));
    const Point p = point_at(mesh, Place{f, coordinates});
    GR::geodesic_distances(mesh, distance, Location(f, coordinates));
    const Error error =
        relative_error(mesh, distance, [&](Vertex v) { return (std::max)(0., euclidean(p, mesh.point(v)) - 1e-13); });
    EXPECT_LT(error.mean, 1e-4);
    EXPECT_LT(error.largest, 1e-2);
  }
}

TEST(Geodesic_distances, several_sources_take_the_nearest)
{
  Mesh mesh = irregular_plane(40, 1.);
  const Distances distance = add_distances(mesh);
  const std::vector<Vertex> sources = {Vertex(0), Vertex(850), Vertex(1200)};
  GR::geodesic_distances(mesh, distance, sources);
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    double nearest = infinity;
    for(Vertex s : sources)
      nearest = (std::min)(nearest, euclidean(mesh.point(s), mesh.point(v)));
    return nearest;
  });
  EXPECT_LT(error.mean, 1e-3);
  EXPECT_LT(error.largest, 3e-2); // where fronts meet
}

TEST(Geodesic_distances, sphere)
{
  Mesh mesh = geodesic_sphere(32); // 10,242 vertices
  const Distances distance = add_distances(mesh);
  GR::geodesic_distances(mesh, distance, Vertex(7));
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    return v == Vertex(7) ? 0. : 2. * std::asin((std::min)(1., 0.5 * euclidean(mesh.point(Vertex(7)), mesh.point(v))));
  });
  EXPECT_LT(error.mean, 5e-4); // the inscribed polyhedron itself is smaller than the sphere by 2e-4
  EXPECT_LT(error.largest, 1e-2);
}

TEST(Geodesic_distances, cylinder)
{
  const unsigned sides = 50;
  Mesh mesh = tube(
      sides, 60, [](unsigned) { return 1.; }, [](unsigned j) { return 0.11 * j; });
  const Distances distance = add_distances(mesh);
  const Vertex source(20 * sides);
  GR::geodesic_distances(mesh, distance, source);
  const double side = 2. * std::sin(CGAL_PI / sides);
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    const unsigned i = v.idx() % sides;
    return std::hypot((std::min)(i, sides - i) * side, mesh.point(v).z() - mesh.point(source).z());
  });
  EXPECT_LT(error.mean, 5e-4);
  EXPECT_LT(error.largest, 1e-2);
}

TEST(Geodesic_distances, cone)
{
  const unsigned sides = 50;
  Mesh mesh = tube(
      sides, 50, [](unsigned j) { return 0.01 * (j + 1); }, [](unsigned j) { return 0.02 * (j + 1); });
  const Vertex apex = mesh.add_vertex(Point(0., 0., 0.));
  for(unsigned i = 0; i < sides; ++i)
    mesh.add_face(apex, Vertex((i + 1) % sides), Vertex(i));
  const Distances distance = add_distances(mesh);
  const Vertex source(30 * sides);
  GR::geodesic_distances(mesh, distance, source);
  const double slope = std::sqrt(5.); // of the way to the apex, a unit of radius
  const double sector = 2. * std::asin(std::sin(CGAL_PI / sides) / slope);
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    const double r = slope * 0.31;
    if(v == apex)
      return r;
    const unsigned i = v.idx() % sides;
    const double s = slope * 0.01 * (v.idx() / sides + 1);
    return std::sqrt((std::max)(0., r * r + s * s - 2. * r * s * std::cos(sector * (std::min)(i, sides - i))) +
                     (v == source ? 0. : 1e-30));
  });
  EXPECT_LT(error.mean, 2e-3);
  EXPECT_LT(error.largest, 5e-2);
}

TEST(Geodesic_distances, near_exact_distances_of_models)
{
  EXPECT_LT(error_against_exact("cactus.off").mean, 2e-3);
  EXPECT_LT(error_against_exact("eight.off").mean, 3e-3);
}

// ---- distances from curves

TEST(Geodesic_distances_from_curve, straight_line_on_a_plane)
{
  for(double aspect : {1., 5., 20.})
  {
    Mesh mesh = irregular_plane(60, aspect);
    const Distances distance = add_distances(mesh);
    std::vector<Vertex> curve;
    for(unsigned i = 0; i <= 60; ++i)
      curve.push_back(Vertex(i));
    GR::geodesic_distances_from_curve(mesh, distance, curve);
    EXPECT_LT(relative_error(mesh, distance, [&](Vertex v) { return mesh.point(v).y(); }).mean,
              aspect > 10. ? 1e-2 : 2e-3)
        << aspect;
  }
}

TEST(Geodesic_distances_from_curve, through_the_interior_of_faces)
{
  Mesh mesh = grid(40, 40, [](unsigned i, unsigned j) { return Point(i, j, 0.); });
  const Distances distance = add_distances(mesh);
  // y = 20.25, from the left side of every quad over its diagonal; its faces lie below and above
  std::vector<Location> curve;
  const auto add = [&](unsigned face, double x) {
    Location location(Face(face), {});
    const auto corners = vertices_of(mesh, location.first);
    for(unsigned k = 0; k < 3; ++k) // barycentric, as the faces have area 1/2
    {
      const Point& p = mesh.point(corners[(k + 1) % 3]);
      const Point& q = mesh.point(corners[(k + 2) % 3]);
      location.second[k] = (p.x() - x) * (q.y() - 20.25) - (q.x() - x) * (p.y() - 20.25);
    }
    curve.push_back(location);
  };
  for(unsigned i = 0; i < 40; ++i)
  {
    add(2 * (20 * 40 + i) + 1, i);
    add(2 * (20 * 40 + i) + 1, i + 0.25);
  }
  add(2 * (20 * 40 + 39), 40.);
  GR::geodesic_distances_from_curve(mesh, distance, curve);
  const Error error = relative_error(mesh, distance, [&](Vertex v) { return std::abs(mesh.point(v).y() - 20.25); });
  EXPECT_LT(error.largest, 1e-9);
}

// Not around all faces of the apex for each piece of the curve: that took five seconds.
TEST(Geodesic_distances_from_curve, around_the_apex_of_very_many_faces)
{
  const unsigned n = 20000;
  Mesh mesh;
  const Vertex apex = mesh.add_vertex(Point(0., 0., 0.));
  for(unsigned i = 0; i < n; ++i)
    mesh.add_vertex(Point(std::cos(2. * CGAL_PI * i / n), std::sin(2. * CGAL_PI * i / n), 0.));
  std::vector<Location> curve;
  for(unsigned i = 0; i < n; ++i)
  {
    const Face f = mesh.add_face(apex, Vertex(1 + i), Vertex(1 + (i + 1) % n));
    Location location(f, {});
    const auto corners = vertices_of(mesh, f);
    for(unsigned k = 0; k < 3; ++k)
      location.second[k] = corners[k] == apex || corners[k] == Vertex(1 + i) ? .5 : 0.;
    curve.push_back(location);
  }
  curve.push_back(curve.front());
  const Distances distance = add_distances(mesh);
  GR::geodesic_distances_from_curve(mesh, distance, curve);
  for(Vertex v : mesh.vertices())
    EXPECT_NEAR(distance[v], .5, 1e-8); // at the apex .5 * cos(pi / n)
}

TEST(Geodesic_distances_from_curve, open_curve_ends_as_a_point)
{
  Mesh mesh = grid(60, 60, [](unsigned i, unsigned j) { return Point(i, j, 0.); });
  const Distances distance = add_distances(mesh);
  std::vector<Vertex> curve;
  for(unsigned i = 20; i <= 40; ++i)
    curve.push_back(Vertex(30 * 61 + i));
  GR::geodesic_distances_from_curve(mesh, distance, curve);
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    const Point& p = mesh.point(v);
    return std::hypot((std::max)({0., 20. - p.x(), p.x() - 40.}), p.y() - 30.);
  });
  EXPECT_LT(error.mean, 2e-3);
  EXPECT_LT(error.largest, 5e-2);
}

TEST(Geodesic_distances_from_curve, closed_curve_around_a_sphere)
{
  const unsigned meridians = 120, parallels = 60;
  Mesh mesh = sphere(meridians, parallels);
  const Distances distance = add_distances(mesh);
  std::vector<Vertex> curve;
  for(unsigned i = 0; i <= meridians; ++i)
    curve.push_back(Vertex((parallels / 2) * meridians + i % meridians));
  GR::geodesic_distances_from_curve(mesh, distance, curve);
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    const double z = std::abs(mesh.point(v).z());
    return z < 1e-9 ? 0. : std::asin(z);
  });
  EXPECT_LT(error.mean, 2e-3);
  EXPECT_LT(error.largest, 1e-2);
}

// ---- parameters

TEST(Geodesic_distances, weights_stretch_the_surface)
{
  // with the weight exp(x) the plane is the image of the plane under the complex exponential
  const unsigned n = 80;
  Mesh mesh = grid(n, n, [&](unsigned i, unsigned j) { return Point(double(i) / n, double(j) / n, 0.); });
  const Distances distance = add_distances(mesh);
  auto weight = mesh.add_property_map<Vertex, double>("v:test_weight").first;
  for(Vertex v : mesh.vertices())
    weight[v] = std::exp(mesh.point(v).x());
  // a source from which no straight way in the image leaves it
  const Vertex source((n / 2) * (n + 1) + n);
  GR::geodesic_distances(mesh, distance, source, gp::vertex_weight_map(weight));
  const Error error = relative_error(mesh, distance, [&](Vertex v) {
    const Point& p = mesh.point(v);
    return std::hypot(std::exp(p.x()) * std::cos(p.y() - 0.5) - std::exp(1.), std::exp(p.x()) * std::sin(p.y() - 0.5));
  });
  EXPECT_LT(error.mean, 2e-3);
  EXPECT_LT(error.largest, 1e-2);
}

TEST(Geodesic_distances, weights_may_jump)
{
  // the way around by the light vertices is shorter than many edges
  Mesh mesh = irregular_plane(20, 1.);
  const Distances distance = add_distances(mesh);
  auto weight = mesh.add_property_map<Vertex, double>("v:test_weight").first;
  for(Vertex v : mesh.vertices())
    weight[v] = v.idx() % 3 == 0 ? 1e-3 : 1e3;
  GR::geodesic_distances(mesh, distance, Vertex(0), gp::vertex_weight_map(weight));
  for(Vertex v : mesh.vertices())
    EXPECT_TRUE(distance[v] >= 0. && distance[v] < infinity);
}

TEST(Geodesic_distances, maximum_distance_leaves_the_rest_at_infinity)
{
  Mesh mesh = irregular_plane(40, 1.);
  const Distances distance = add_distances(mesh);
  GR::geodesic_distances(mesh, distance, Vertex(0), gp::maximum_distance(10.));
  for(Vertex v : mesh.vertices())
  {
    const double true_distance = euclidean(mesh.point(Vertex(0)), mesh.point(v));
    if(std::abs(true_distance - 10.) > 1e-2)
    {
      EXPECT_EQ(distance[v] < infinity, true_distance < 10.);
    }
  }
}

TEST(Geodesic_distances, other_components_and_isolated_vertices_are_not_reached)
{
  Mesh mesh = irregular_plane(5, 1.);
  const std::size_t first_component = mesh.number_of_vertices();
  CGAL::copy_face_graph(irregular_plane(5, 1.), mesh);
  const Vertex isolated = mesh.add_vertex(Point(0., 0., 1.));
  const Distances distance = add_distances(mesh);
  GR::geodesic_distances(mesh, distance, Vertex(3));
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(distance[v] < infinity, v.idx() < first_component);
  GR::geodesic_distances(mesh, distance, isolated);
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(distance[v] < infinity, v == isolated);
}

TEST(Geodesic_distances, a_polyhedron_of_floats)
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<float>, CGAL::Polyhedron_items_with_id_3>;
  Polyhedron polyhedron;
  CGAL::copy_face_graph(geodesic_sphere(4), polyhedron);
  CGAL::set_halfedgeds_items_id(polyhedron);
  std::map<Polyhedron::Vertex_const_handle, float> distance;
  const auto source = *vertices(polyhedron).begin();
  GR::geodesic_distances(polyhedron, boost::make_assoc_property_map(distance), source);
  ASSERT_EQ(distance.size(), num_vertices(polyhedron));
  for(const auto& d : distance)
    EXPECT_NEAR(
        d.second,
        2. * std::asin((std::min)(1., 0.5 * std::sqrt(CGAL::squared_distance(d.first->point(), source->point())))),
        0.1);
}

// ---- hard and bad input

TEST(Geodesic_distances, the_unit_of_length_does_not_matter)
{
  Mesh mesh = geodesic_sphere(6);
  const Distances distance = add_distances(mesh);
  GR::geodesic_distances(mesh, distance, Vertex(0));
  for(double scale : {std::ldexp(1., -40), std::ldexp(1., 40)}) // about 1e-12 and 1e12, and no rounding
  {
    Mesh scaled = mesh;
    for(Vertex v : scaled.vertices())
      scaled.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    const Distances scaled_distance = scaled.add_property_map<Vertex, double>("v:scaled").first;
    GR::geodesic_distances(scaled, scaled_distance, Vertex(0));
    for(Vertex v : mesh.vertices())
      EXPECT_NEAR(scaled_distance[v] / scale, distance[v], 1e-12);
  }
}

TEST(Geodesic_distances, degenerate_faces_work)
{
  // equal points, faces without area, edges without length
  for(double y : {0., 1e-300, 1e-9})
  {
    Mesh mesh = grid(20, 20, [&](unsigned i, unsigned j) { return Point(i / 2, j % 3 == 0 ? j : j * y, 0.); });
    const Distances distance = add_distances(mesh);
    for(unsigned source : {0u, 210u, 440u})
    {
      GR::geodesic_distances(mesh, distance, Vertex(source));
      for(Vertex v : mesh.vertices())
        EXPECT_TRUE(distance[v] >= 0. && distance[v] < infinity);
      GR::geodesic_distances(mesh, distance, Location(Face(source), {{.2, .3, .5}}));
      for(Vertex v : mesh.vertices())
        EXPECT_TRUE(distance[v] >= 0. && distance[v] < infinity);
    }
  }
  Mesh point = grid(5, 5, [](unsigned, unsigned) { return Point(1., 2., 3.); });
  const Distances distance = add_distances(point);
  GR::geodesic_distances(point, distance, Vertex(0));
  for(Vertex v : point.vertices())
    EXPECT_EQ(distance[v], 0.);
}

TEST(Geodesic_distances, bad_input_is_refused_with_its_place)
{
  const auto message = [](const auto& call) -> std::string {
    try
    {
      call();
    }
    catch(const std::invalid_argument& e)
    {
      return e.what();
    }
    return "";
  };
  Mesh mesh = grid(3, 3, [](unsigned i, unsigned j) { return Point(i, j, 0.); });
  const Distances distance = add_distances(mesh);
  auto weight = mesh.add_property_map<Vertex, double>("v:test_weight", 1.).first;
  weight[Vertex(5)] = 0.;
  EXPECT_EQ(message([&] { GR::geodesic_distances(mesh, distance, Vertex(0), gp::vertex_weight_map(weight)); }),
            "geodesic_distances(): the weight of vertex 5 is not a positive number");
  EXPECT_EQ(message([&] {
              GR::geodesic_distances(mesh, distance, Location(Face(1), {{.5, .5, .5}}));
            }),
            "geodesic_distances(): the coordinates of a point of face 1 do not add up to one");
  EXPECT_EQ(message([&] {
              GR::geodesic_distances(mesh, distance, Location(Face(2), {{-.5, .5, 1.}}));
            }),
            "geodesic_distances(): a point of face 2 is not in the face");
  const std::vector<Vertex> torn = {Vertex(0), Vertex(1), Vertex(3)};
  EXPECT_EQ(message([&] { GR::geodesic_distances_from_curve(mesh, distance, torn); }),
            "geodesic_distances_from_curve(): points 1 and 2 of the curve have no face in common");
  EXPECT_EQ(distance[Vertex(0)], -1.); // nothing was written
  mesh.point(Vertex(7)) = Point(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  EXPECT_EQ(message([&] { GR::geodesic_distances(mesh, distance, Vertex(0)); }),
            "geodesic_distances(): the coordinates of vertex 7 are not finite");
  Mesh tiny = irregular_plane(3, 20.);
  for(Vertex v : tiny.vertices())
    tiny.point(v) = CGAL::ORIGIN + 1e-100 * (tiny.point(v) - CGAL::ORIGIN);
  EXPECT_EQ(message([&] { GR::geodesic_distances(tiny, add_distances(tiny), Vertex(0)); }),
            "geodesic_distances(): the edges are too short or too long to compute with");
  Mesh quad;
  quad.add_face(quad.add_vertex(Point(0., 0., 0.)), quad.add_vertex(Point(1., 0., 0.)),
                quad.add_vertex(Point(1., 1., 0.)), quad.add_vertex(Point(0., 1., 0.)));
  EXPECT_EQ(message([&] { GR::geodesic_distances(quad, add_distances(quad), Vertex(0)); }),
            "geodesic_distances(): face 0 is not a triangle");
}

// ---- the parts

TEST(Intrinsic_triangulation, spokes_are_glued_and_angles_add_up)
{
  for(Mesh mesh : {irregular_plane(20, 20.), geodesic_sphere(5), sphere(7, 30)})
  {
    const Intrinsic_triangulation triangulation(mesh);
    const std::size_t n = mesh.number_of_vertices();
    ASSERT_EQ(triangulation.number_of_vertices(), n);
    double angles = 0.;
    std::size_t faces = 0;
    for(unsigned v = 0; v < n; ++v)
      for(auto spoke = triangulation.begin(v); spoke != triangulation.end(v); ++spoke)
      {
        EXPECT_EQ(triangulation.reverse(*spoke).neighbor, v);
        EXPECT_EQ(triangulation.reverse(*spoke).length, spoke->length);
        if(!(spoke->rim >= 0.))
          continue;
        ++faces;
        angles += spoke[1].angle - spoke->angle;
      }
    EXPECT_EQ(faces, 3 * mesh.number_of_faces());
    EXPECT_NEAR(angles / (CGAL_PI * mesh.number_of_faces()), 1., 1e-9);
  }
}

TEST(Intrinsic_triangulation, is_Delaunay)
{
  Mesh mesh = irregular_plane(20, 20.);
  const Intrinsic_triangulation triangulation(mesh);
  for(unsigned v = 0; v < mesh.number_of_vertices(); ++v)
    for(auto spoke = triangulation.begin(v); spoke != triangulation.end(v); ++spoke)
    {
      const auto reverse = &triangulation.reverse(*spoke); // its face lies on the other side
      if(!(spoke->rim >= 0.) || !(reverse->rim >= 0.))
        continue;
      const auto opposite_angle = [](double a, double b, double base) {
        return std::acos((std::max)(-1., (std::min)(1., (a * a + b * b - base * base) / (2. * a * b))));
      };
      EXPECT_LT(opposite_angle(spoke->rim, spoke[1].length, spoke->length) +
                    opposite_angle(reverse->rim, reverse[1].length, spoke->length),
                CGAL_PI + 1e-5);
    }
}

TEST(Fast_marching, stops_goes_on_and_forgets)
{
  const Mesh mesh = geodesic_sphere(8);
  const Intrinsic_triangulation triangulation(mesh);
  Fast_marching whole(triangulation), parts(triangulation);
  whole.add_source(Vertex(0));
  whole.march(Front_shape::circular);
  for(int run = 0; run < 2; ++run)
  {
    parts.add_source(Vertex(0));
    double last = -1.;
    int stops = 0;
    std::size_t previous = 0;
    do
    {
      previous = parts.reached().size();
      std::size_t settled = 0;
      parts.march(
          Front_shape::circular, [](Vertex) { return true; },
          [&](Vertex, double d) {
            EXPECT_GE(d, last);
            last = d;
            return ++settled < 50;
          });
      ++stops;
    } while(stops < 100);
    EXPECT_EQ(previous, mesh.number_of_vertices());
    for(Vertex v : mesh.vertices())
      EXPECT_EQ(parts.distance(v), whole.distance(v));
    parts.clear();
    EXPECT_TRUE(parts.reached().empty());
    EXPECT_EQ(parts.distance(Vertex(0)), infinity);
  }
}

TEST(Fast_marching, stays_in_its_domain)
{
  const Mesh mesh = grid(20, 20, [](unsigned i, unsigned j) { return Point(i, j, 0.); });
  const Intrinsic_triangulation triangulation(mesh);
  Fast_marching marching(triangulation);
  marching.add_source(Vertex(0));
  marching.march(
      Front_shape::circular, [](Vertex v) { return v.idx() % 21 != 10; }, [](Vertex, double) { return true; });
  for(Vertex v : mesh.vertices())
    EXPECT_EQ(marching.distance(v) < infinity, v.idx() % 21 < 10);
}

TEST(Fast_marching, a_front_may_start_below_zero)
{
  const Mesh mesh = grid(20, 20, [](unsigned i, unsigned j) { return Point(i, j, 0.); });
  const Intrinsic_triangulation triangulation(mesh);
  Fast_marching marching(triangulation);
  for(unsigned i = 0; i <= 20; ++i)
    marching.add_source(Vertex(i), -2.5);
  marching.march(Front_shape::planar);
  for(Vertex v : mesh.vertices())
    EXPECT_NEAR(marching.distance(v), mesh.point(v).y() - 2.5, 1e-9);
}

// Two cones with the same apex, as CGAL's `is_valid_polygon_mesh()` does not allow
TEST(Geodesic_distances, closed_fans_that_touch_are_refused)
{
  Mesh mesh;
  const Vertex apex = mesh.add_vertex(Point(0, 0, 0)), other = mesh.add_vertex(Point(0, 0, 0));
  for(const double z : {1., -1.})
  {
    std::array<Vertex, 6> rim;
    for(std::size_t i = 0; i < 6; ++i)
      rim[i] = mesh.add_vertex(Point(std::cos(i), z * std::sin(i), z));
    for(std::size_t i = 0; i < 6; ++i)
      mesh.add_face(z > 0. ? apex : other, rim[i], rim[(i + 1) % 6]);
  }
  auto distance = add_distances(mesh);
  CGAL::Geodesic_remeshing::geodesic_distances(mesh, distance, apex);
  EXPECT_EQ(distance[Vertex(9)], infinity);
  std::vector<Mesh::Halfedge_index> ring(mesh.halfedges_around_target(mesh.halfedge(other)).begin(),
                                         mesh.halfedges_around_target(mesh.halfedge(other)).end());
  for(const auto h : ring)
    mesh.set_target(h, apex);
  mesh.remove_vertex(other);
  const auto before = distance[Vertex(9)] = 7.;
  try
  {
    CGAL::Geodesic_remeshing::geodesic_distances(mesh, distance, apex);
    ADD_FAILURE() << "not refused";
  }
  catch(const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find("vertex 0 is not manifold"), std::string::npos) << error.what();
  }
  EXPECT_EQ(distance[Vertex(9)], before);
}
