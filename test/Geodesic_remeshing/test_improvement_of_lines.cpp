#include "improvement_support.h"
#include "made_surfaces.h"

#include <set>
#include <tuple>

using namespace improvement_support;

namespace {

struct Oracle
{
  double area = 0., length_of_lines = 0.;
  std::size_t boundary_loops = 0;
  std::set<std::array<double, 3>> corners;
};

double area_of(const Mesh& mesh)
{
  double sum = 0.;
  for(const Face f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    sum += std::sqrt(CGAL::squared_area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])));
  }
  return sum;
}

template <class Is_line>
double length_of(const Mesh& mesh, const Is_line& is_line)
{
  double sum = 0.;
  for(const Edge e : mesh.edges())
    if(is_line(e))
      sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum;
}

std::size_t boundary_loops(const Mesh& mesh)
{
  std::set<Halfedge> seen;
  std::size_t loops = 0;
  for(const Halfedge h : mesh.halfedges())
  {
    if(!mesh.is_border(h) || !seen.insert(h).second)
      continue;
    ++loops;
    for(Halfedge g = mesh.next(h); g != h; g = mesh.next(g))
      seen.insert(g);
  }
  return loops;
}

// Whether a place is on an edge that is a line, or at a vertex of one.
bool is_on_line(const Mesh& surface, const Constraints& constraints, const Place& place)
{
  std::vector<Vertex> carrying;
  for(std::size_t i = 0; i < 3; ++i)
    if(place.coordinates[i] > 0.)
      carrying.push_back(vertices_of(surface, place.face)[i]);
  if(carrying.size() == 1)
    for(const Halfedge h : surface.halfedges_around_target(surface.halfedge(carrying[0])))
      if(constraints.is_line[surface.edge(h)])
        return true;
  return carrying.size() == 2 && constraints.is_line[surface.edge(surface.halfedge(carrying[0], carrying[1]))];
}

// Lines of straight pieces between corners: covered exactly, once, by constrained edges; faces on flat sides add up to
// the area only if none is turned.
void expect_kept(const Mesh& surface, const Constraints& constraints, const Start& start, const bool is_flat)
{
  expect_valid(surface, start);
  expect_no_turned_faces(surface, start);
  const Mesh& mesh = start.mesh;
  EXPECT_EQ(boundary_loops(mesh), boundary_loops(surface));
  const double lines = length_of(surface, [&](const Edge e) { return constraints.is_line[e]; });
  const double covered = length_of(mesh, [&](const Edge e) { return start.constrained[e]; });
  if(is_flat)
  {
    EXPECT_NEAR(covered, lines, 1e-9 * lines);
    EXPECT_NEAR(area_of(mesh), area_of(surface), 1e-9 * area_of(surface));
  }
  else
  {
    EXPECT_LT(covered, lines * (1. + 1e-9));
    EXPECT_GT(covered, .9 * lines);
  }
  std::multiset<std::array<double, 3>> points;
  for(const Vertex v : mesh.vertices())
    points.insert({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  for(const Vertex x : surface.vertices())
    EXPECT_TRUE(!constraints.is_corner[x] ||
                points.count({{surface.point(x).x(), surface.point(x).y(), surface.point(x).z()}}) == 1);
  for(const Edge e : mesh.edges())
  {
    EXPECT_TRUE(start.constrained[e] || !mesh.is_border(e));
    for(const unsigned end : {0u, 1u})
      EXPECT_TRUE(!start.constrained[e] || is_on_line(surface, constraints, start.place[mesh.vertex(e, end)]));
  }
}

struct Case
{
  const char* name;
  Mesh surface;
  bool is_flat;
  double least_angle;
};

// An L of blocks of n; all angles are right ones
Mesh l_shape(const int n)
{
  return made::blocks({made::Block{{{0, 0, 0}}, {{3 * n, n, n}}}, made::Block{{{0, n, 0}}, {{n, 2 * n, n}}}});
}

Mesh ring(const std::size_t around, const double radius, const double width)
{
  return grid(around, 1, true, false, [=](const double i, const double j) {
    const double u = -2. * CGAL_PI * i / around, r = radius + width * j;
    return Point(r * std::cos(u), r * std::sin(u), 0.);
  });
}

Mesh roof(const std::size_t n, const double steepness)
{
  return grid(2 * n, 2 * n, false, false,
              [=](const double i, const double j) { return Point(i, j, steepness * (n - std::abs(i - n))); });
}

// A square crossed by two lines, of which one does not reach the boundary on its one side.
Constraints crossing_lines(const Mesh& square, const double middle, const double end)
{
  Constraints constraints{std::vector<char>(square.number_of_edges(), 0),
                          std::vector<char>(square.number_of_vertices(), 0)};
  for(const Edge e : square.edges())
  {
    const Point p = square.point(square.vertex(e, 0)), q = square.point(square.vertex(e, 1));
    const auto is_both = [&](const double x, const double y) {
      return std::abs(x - middle) + std::abs(y - middle) < 1e-9;
    };
    constraints.is_line[e] =
        square.is_border(e) || is_both(p.x(), q.x()) || (is_both(p.y(), q.y()) && (std::max)(p.x(), q.x()) <= end);
  }
  for(const Vertex v : square.vertices())
  {
    std::size_t degree = 0, border = 0;
    for(const Halfedge h : square.halfedges_around_target(square.halfedge(v)))
    {
      degree += constraints.is_line[square.edge(h)];
      border += square.is_border(square.edge(h));
    }
    constraints.is_corner[v] = (degree != 0 && degree != 2) || (border == 2 && square.degree(v) < 4);
  }
  return constraints;
}

void expect_consistent(const Lean_triangulation& table)
{
  std::size_t faces = 0, border = 0;
  for(Index v = 0; v < table.vertex_slots(); ++v)
  {
    if(table.is_removed(v))
      continue;
    Index ring = table.is_border(v), lines = 0;
    table.for_each_outgoing(v, [&](const Index h) {
      EXPECT_EQ(table.source(h), v);
      lines += table.is_constrained(h);
      ++ring;
    });
    EXPECT_EQ(ring, table.valence(v));
    EXPECT_EQ(lines > 0, table.is_on_line(v));
    border += table.is_border(v);
  }
  std::size_t border_edges = 0;
  for(Index h = 0; h < 4 * table.face_slots(); ++h)
  {
    if((h & 3) == 3 || table.is_removed_face(Lean_triangulation::face(h)))
      continue;
    faces += (h & 3) == 0;
    const Index o = table.opposite(h);
    if(o == Lean_triangulation::none)
    {
      EXPECT_TRUE(table.is_constrained(h));
      EXPECT_EQ(table.halfedge(table.source(h)), h);
      ++border_edges;
      continue;
    }
    EXPECT_EQ(table.opposite(o), h);
    EXPECT_EQ(table.source(o), table.target(h));
    EXPECT_EQ(table.is_constrained(o), table.is_constrained(h));
  }
  EXPECT_EQ(border, border_edges);
  EXPECT_EQ(faces + 2, 2 * table.number_of_vertices() - border); // Euler characteristic 1
}

} // namespace

// Any mixture of changes keeps where lines end and cross, and their connections, and can be taken back.
TEST(Lean_triangulation_with_lines, changes_keep_lines)
{
  const Mesh mesh = plane(12);
  const Constraints constraints = crossing_lines(mesh, 6., 9.);
  Lean_triangulation table(mesh, [&](const Edge e) { return constraints.is_line[e] != 0; });
  const auto degrees = [&] {
    std::vector<Index> result;
    for(const Vertex v : mesh.vertices())
      if(constraints.is_corner[v])
        result.push_back(table.is_removed(v) ? 0 : table.line_degree(v));
    return result;
  };
  const auto snapshot = [&] {
    std::vector<Index> all;
    for(Index h = 0; h < 4 * table.face_slots(); ++h)
      if((h & 3) != 3 && !table.is_removed_face(Lean_triangulation::face(h)))
        all.insert(all.end(), {h, table.source(h), table.opposite(h), table.is_constrained(h)});
    for(Index v = 0; v < table.vertex_slots(); ++v)
      all.insert(all.end(), {table.valence(v), table.is_removed(v) ? 0 : table.halfedge(v)});
    return all;
  };
  table.reserve_free(100);
  const auto degrees_before = degrees();
  const auto before = snapshot();
  Random_numbers random;
  table.record();
  std::size_t collapses = 0, splits = 0;
  for(int i = 0; i < 6000; ++i)
  {
    const Index f = static_cast<Index>(random(0, table.face_slots())), h = 4 * f + static_cast<Index>(random(0, 3));
    if(table.is_removed_face(f))
      continue;
    const Index w = table.target(h);
    const bool is_corner = w < mesh.number_of_vertices() && constraints.is_corner[Vertex(w)];
    const int kind = static_cast<int>(random(0, 6));
    if(kind == 0 && table.number_of_vertices() < 200)
    {
      table.split_edge(h);
      ++splits;
    }
    else if(kind == 1 && !is_corner && table.is_collapse_legal(h))
    {
      table.collapse(h);
      ++collapses;
    }
    else if(kind > 1 && table.is_flip_legal(h))
      table.flip(h);
    if(i % 500 == 0)
      expect_consistent(table);
  }
  expect_consistent(table);
  EXPECT_GT(collapses, 200u);
  EXPECT_GT(splits, 200u);
  EXPECT_EQ(degrees(), degrees_before);
  // The lines are still a connected graph that parts the square in three.
  std::size_t line_vertices = 0, line_degrees = 0;
  for(Index v = 0; v < table.vertex_slots(); ++v)
    if(!table.is_removed(v) && table.is_on_line(v))
    {
      ++line_vertices;
      line_degrees += table.line_degree(v);
    }
  EXPECT_EQ(line_vertices + 2, line_degrees / 2);
  table.undo_to(0);
  EXPECT_EQ(snapshot(), before);
}

TEST(Line_walker, slides_by_arc_length_and_stops_before_ends)
{
  const Mesh surface = plane(6);
  const Constraints constraints = crossing_lines(surface, 3., 4.);
  const Surface_walker walker(surface, constraints);
  const Line_walker lines(walker, constraints);
  const auto at = [&](const double x, const double y) {
    for(const Vertex v : surface.vertices())
      if(std::abs(surface.point(v).x() - x) + std::abs(surface.point(v).y() - y) < 1e-9)
        return place_of_vertex(surface, v);
    return Place();
  };
  const auto expect_at = [&](const Place& place, const double x, const double y) {
    EXPECT_NEAR(walker.point(place).x(), x, 1e-12);
    EXPECT_NEAR(walker.point(place).y(), y, 1e-12);
  };
  expect_at(lines.slide(at(3., 1.), Vector(7., .5, 0.)), 3., 1.5); // along the line only
  expect_at(lines.slide(lines.slide(at(3., 1.), Vector(0., .25, 0.)), Vector(0., 5., 0.)), 3., 2.125); // an end at 3
  expect_at(lines.slide(at(1., 0.), Vector(-.75, 0., 0.)), .25, 0.);
  expect_at(lines.slide(at(1., 0.), Vector(-3., 0., 0.)), .5, 0.); // a corner
  expect_at(lines.slide(at(1., 3.), Vector(1.25, 0., 0.)), 2.25, 3.);
  expect_at(lines.slide(at(4., 3.), Vector(-1., 0., 0.)), 4., 3.); // at an end
  expect_at(lines.middle(at(1., 0.), at(2., 0.), at(0., 0.)), 1.5, 0.);
  expect_at(lines.middle(at(3., 3.), at(4., 3.), at(4., 3.)), 3.5, 3.); // from end to end
  EXPECT_FALSE(lines.middle(at(0., 0.), at(3., 3.), at(3., 3.)).face.is_valid());
}

// Around a closed line there are two ways from anywhere to anywhere.
TEST(Line_walker, closed_line)
{
  const Mesh surface = made::cylinder(2., 3., 40, 3, false);
  const Constraints constraints = constraints_of(surface);
  const Surface_walker walker(surface, constraints);
  const Line_walker lines(walker, constraints);
  const double edge = 4. * std::sin(CGAL_PI / 40.);
  const auto on_rim = [&](const Index i) { return place_of_vertex(surface, Vertex(i % 40)); };
  for(Index i = 0; i < 40; ++i)
  {
    const Point p = walker.point(lines.middle(on_rim(i), on_rim(i + 30), on_rim(i + 35)));
    EXPECT_NEAR(CGAL::squared_distance(p, surface.point(Vertex((i + 35) % 40))), 4. * 4., 1e-9) << i; // opposite
    const Vector along = surface.point(Vertex((i + 1) % 40)) - surface.point(Vertex(i));
    Place place = on_rim(i);
    for(int step = 0; step < 3; ++step)
      place = lines.slide(place, .25 * along);
    const double squared_way = CGAL::squared_distance(walker.point(place), surface.point(Vertex(i)));
    EXPECT_NEAR(squared_way, CGAL::square(.75 * edge), 1e-9) << i;
  }
}

// Two vertices beside a bend, none at it: one goes there, where its other neighbour is too far away for it to go alone.
TEST(Line_fit, two_vertices_at_a_bend_slide_together)
{
  const Mesh surface = grid(24, 8, false, false, [](const double i, const double j) {
    return Point(.5 * i, .5 * j + .4 * std::abs(.5 * i - 6.), 0.);
  });
  const Constraints constraints = constraints_of(surface);
  const Point bend(6., 0., 0.);
  const std::array<std::size_t, 12> columns = {{0, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 24}};
  const auto vertex_of_surface = [&](const double i, const double j) {
    return Vertex(static_cast<Index>(25 * 2 * std::size_t(j) + columns[std::size_t(i)]));
  };
  Start start;
  start.mesh =
      grid(11, 4, false, false, [&](const double i, const double j) { return surface.point(vertex_of_surface(i, j)); });
  start.place = start.mesh.add_property_map<Vertex, Place>("v:place").first;
  start.pinned = start.mesh.add_property_map<Vertex, bool>("v:pinned", false).first;
  start.constrained = start.mesh.add_property_map<Edge, bool>("e:constrained", false).first;
  for(const Vertex v : start.mesh.vertices())
  {
    const Vertex x = vertex_of_surface(v.idx() % 12, v.idx() / 12);
    start.place[v] = place_of_vertex(surface, x);
    start.pinned[v] = constraints.is_corner[x];
  }
  for(const Edge e : start.mesh.edges())
    start.constrained[e] = start.mesh.is_border(e);
  const Surface_walker walker(surface, constraints);
  Remeshed_surface remeshed(walker, constraints, start.mesh, start.place, start.pinned, start.constrained);
  const auto distance_of_bend = [&] {
    double least = infinity;
    for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
      least = (std::min)(least, CGAL::squared_distance(remeshed.spot(v).point, bend));
    return std::sqrt(least);
  };
  EXPECT_GT(distance_of_bend(), .5);
  Line_fit(remeshed, 1., badness_of_angle(20.)).run();
  EXPECT_LT(distance_of_bend(), 1e-12);
  for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
  {
    EXPECT_LT(remeshed.ring_badness(v), badness_of_angle(19.9));
    EXPECT_TRUE(!remeshed.is_on_line(v) || is_on_line(surface, constraints, remeshed.spot(v).place));
  }
}

class Improvement_of_lines : public testing::TestWithParam<std::tuple<int, double>>
{
protected:
  static const std::vector<Case>& cases()
  {
    static const std::vector<Case> all = {
        {"plane", plane(12), true, 30.},
        {"cube", made::box(8, 8, 8), true, 30.},
        {"thin_box", made::box(16, 12, 2), true, 25.},
        {"l_shape", l_shape(5), true, 25.},
        {"roof", roof(8, 1.), true, 30.},
        {"cylinder", made::cylinder(4., 10., 24, 10), false, 25.},
        {"open_cylinder", made::cylinder(4., 10., 24, 10, false), false, 30.},
        {"narrow_ring", ring(24, 4., .8), false, 20.}, // two rows wide at most: no more than what is asked everywhere
    };
    return all;
  }
};

TEST_P(Improvement_of_lines, keeps_them_and_reaches_the_count)
{
  const Case& c = cases()[std::get<0>(GetParam())];
  const Constraints constraints = constraints_of(c.surface);
  Start start;
  spoil(c.surface, .2, start, constraints);
  const std::size_t n = static_cast<std::size_t>(std::get<1>(GetParam()) * c.surface.number_of_vertices());
  improve_to(c.surface, start, n, constraints);
  SCOPED_TRACE(c.name);
  EXPECT_EQ(start.mesh.number_of_vertices(), n);
  expect_kept(c.surface, constraints, start, c.is_flat);
  EXPECT_GT(smallest_angle(start.mesh), c.least_angle);
}

INSTANTIATE_TEST_SUITE_P(Counts, Improvement_of_lines,
                         testing::Combine(testing::Range(0, 8), testing::Values(.5, .9, 1., 1.1, 2.)));

// Lines that end, cross and meet the boundary on flat ground, where no angle tells them
class Improvement_of_given_lines : public testing::TestWithParam<double>
{};

TEST_P(Improvement_of_given_lines, keeps_them_and_reaches_the_count)
{
  const Mesh surface = plane(12);
  const Constraints constraints = crossing_lines(surface, 6., 9.);
  Start start;
  spoil(surface, .2, start, constraints);
  const std::size_t n = static_cast<std::size_t>(GetParam() * surface.number_of_vertices());
  improve_to(surface, start, n, constraints);
  EXPECT_EQ(start.mesh.number_of_vertices(), n);
  expect_kept(surface, constraints, start, true);
  EXPECT_GT(smallest_angle(start.mesh), 25.);
}

INSTANTIATE_TEST_SUITE_P(Counts, Improvement_of_given_lines, testing::Values(.4, .8, 1., 1.2, 2., 5.));

// A sheet that is flat on one side and bends on the other: there the sweeps would cost distance from the surface.
TEST(Angle_relaxation, with_lines_only_what_is_flat_or_straight_moves)
{
  constexpr double end_of_flat = 12.;
  const Mesh surface = grid(24, 16, false, false, [](const double i, const double j) {
    return Point(i, j, i > end_of_flat ? .05 * CGAL::square(i - end_of_flat) : 0.);
  });
  const Constraints constraints = constraints_of(surface);
  Start start;
  spoil(surface, .2, start, constraints);
  const Surface_walker walker(surface, constraints);
  Remeshed_surface remeshed(walker, constraints, start.mesh, start.place, start.pinned, start.constrained);
  ASSERT_TRUE(remeshed.has_lines());
  const auto is_bent = [&](const Index v) { return surface.point(Vertex(v)).x() > end_of_flat + 1.5; };
  const auto cotangents_of_flat_part = [&] {
    double sum = 0.;
    for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
      if(!is_bent(v) && !remeshed.is_on_line(v))
        sum += Cotangents(Vertex_ring(remeshed, v), remeshed.spot(v).point).sum();
    return sum;
  };
  const double before = cotangents_of_flat_part();
  const std::vector<Quadric> planes = quadrics(remeshed, Nearest_vertices(remeshed));
  for(int i = 0; i < 5; ++i)
    relax_angles(remeshed, planes, badness_of_angle(40.), .1);
  EXPECT_LT(cotangents_of_flat_part(), .9 * before);
  for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
    if(is_bent(v) || remeshed.is_on_line(v))
    {
      EXPECT_EQ(remeshed.spot(v).point, start.mesh.point(Vertex(v)));
    }
  std::size_t slid = 0;
  for(int i = 0; i < 5; ++i)
    relax_angles(remeshed, planes, badness_of_angle(40.), .1, true);
  for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
  {
    const Point &p = start.mesh.point(Vertex(v)), &q = remeshed.spot(v).point;
    slid += remeshed.is_on_line(v) && p != q;
    EXPECT_EQ(remeshed.is_on_line(v), is_on_line(surface, constraints, remeshed.spot(v).place));
    const bool is_at_end = p.x() > 23.5; // where the faces beside the line are in a plane as well
    EXPECT_TRUE(p == q || ((is_at_end || !is_bent(v)) && !remeshed.is_fixed(v)));
  }
  EXPECT_GT(slid, 20u); // of 12 + 15 + 12 on the sides of the flat part, and 15 at the end
}

// A weight of the mean deviation of a face: slots of removed faces are none.
TEST(Deviation_relaxation, empty_slots_change_nothing)
{
  const Mesh surface =
      grid(24, 16, false, false, [](const double i, const double j) { return Point(i, j, .05 * i * i); });
  const Constraints constraints = constraints_of(surface);
  Start start;
  spoil(surface, .2, start, constraints);
  const Surface_walker walker(surface, constraints);
  const auto points_after_run = [&](const Index number_of_slots) {
    Remeshed_surface remeshed(walker, constraints, start.mesh, start.place, start.pinned, start.constrained);
    const Nearest_vertices nearest(remeshed);
    remeshed.reserve_free(number_of_slots);
    Deviation_relaxation(remeshed, nearest, badness_of_angle(40.)).run(.1, 1e-6, {.15, .06});
    std::vector<Point> points;
    for(const Vertex v : start.mesh.vertices())
      points.push_back(remeshed.spot(static_cast<Index>(v)).point);
    return points;
  };
  const std::vector<Point> points = points_after_run(0);
  std::size_t moved = 0;
  for(const Vertex v : start.mesh.vertices())
    moved += points[v] != start.mesh.point(v);
  EXPECT_GT(moved, 50u);
  EXPECT_EQ(points, points_after_run(1000));
}
