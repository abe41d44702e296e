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
  for(const Face f : mesh.faces()) {
    const auto v = vertices_of(mesh, f);
    sum += std::sqrt(CGAL::squared_area(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])));
  }
  return sum;
}

template <class Is_line> double length_of(const Mesh& mesh, const Is_line& is_line)
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
  for(const Halfedge h : mesh.halfedges()) {
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

// Lines of straight pieces between corners: covered exactly, once, by constrained edges; faces on flat sides add up to the area
// only if none is turned.
void expect_kept(const Mesh& surface, const Constraints& constraints, const Start& start, const bool is_flat)
{
  expect_valid(surface, start);
  expect_no_turned_faces(surface, start);
  const Mesh& mesh = start.mesh;
  EXPECT_EQ(boundary_loops(mesh), boundary_loops(surface));
  const double lines = length_of(surface, [&](const Edge e) { return constraints.is_line[e]; });
  const double covered = length_of(mesh, [&](const Edge e) { return start.constrained[e]; });
  if(is_flat) {
    EXPECT_NEAR(covered, lines, 1e-9 * lines);
    EXPECT_NEAR(area_of(mesh), area_of(surface), 1e-9 * area_of(surface));
  }
  else {
    EXPECT_LT(covered, lines * (1. + 1e-9));
    EXPECT_GT(covered, .9 * lines);
  }
  std::multiset<std::array<double, 3>> points;
  for(const Vertex v : mesh.vertices())
    points.insert({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  for(const Vertex x : surface.vertices())
    EXPECT_TRUE(!constraints.is_corner[x] ||
                points.count({{surface.point(x).x(), surface.point(x).y(), surface.point(x).z()}}) == 1);
  for(const Edge e : mesh.edges()) {
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

Mesh roof(const std::size_t n, const double steepness)
{
  return grid(2 * n, 2 * n, false, false, [=](const double i, const double j) {
    return Point(i, j, steepness * (n - std::abs(i - n)));
  });
}

} // namespace

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
                         testing::Combine(testing::Range(0, 7), testing::Values(.5, .9, 1., 1.1, 2.)));
