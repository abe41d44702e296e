#include "improvement_support.h"

using namespace improvement_support;

TEST(Surface_walker, plane_is_crossed_straight)
{
  const Mesh surface = plane(20);
  const Surface_walker walker(surface);
  Random_numbers random;
  for(int i = 0; i < 200; ++i)
  {
    const Place from{Face(static_cast<Index>(random(0, 800))), {{.2, .3, .5}}};
    const Point p = walker.point(from), q(random(0, 20), random(0, 20), 0.);
    // What points off the plane does not count.
    const Place to = walker.walk(from, q - p + Vector(0., 0., random(-5, 5)));
    EXPECT_NEAR(CGAL::squared_distance(walker.point(to), q), 0., 1e-18);
  }
}

// A small way off: on the boundary there are none but its own vertices.
TEST(Surface_walker, boundary_ends_the_way)
{
  const Mesh surface = plane(5);
  const Surface_walker walker(surface);
  const Place from{Face(0), {{.2, .5, .3}}};
  const Point p = walker.point(from), q = walker.point(walker.walk(from, Vector(-30., 0., 0.)));
  EXPECT_GT(q.x(), 0.);
  EXPECT_LT(q.x(), p.x());
  EXPECT_NEAR(q.y(), p.y(), 1e-12);
}

// Nor is there on the boundary for a way that just reaches it.
TEST(Surface_walker, way_to_the_boundary_ends_before_it)
{
  const Mesh surface = plane(4);
  const Surface_walker walker(surface);
  for(const Face f : surface.faces())
    for(const Vector& way : {Vector(-1., 0., 0.), Vector(1., 0., 0.), Vector(0., -1., 0.), Vector(0., 1., 0.)})
    {
      const Place from{f, {{.25, .5, .25}}};
      const Point p = walker.point(from);
      const double room = way.x() < 0. ? p.x() : way.x() > 0. ? 4. - p.x() : way.y() < 0. ? p.y() : 4. - p.y();
      const Point q = walker.point(walker.walk(from, room * way)); // all of these numbers are exact
      EXPECT_TRUE(q.x() > 0. && q.x() < 4. && q.y() > 0. && q.y() < 4.) << p << " to " << q;
    }
}

TEST(Surface_walker, grid_vertices_are_passed_through)
{
  const Mesh surface = plane(10);
  const Surface_walker walker(surface);
  for(const Vector& way :
      {Vector(3., 0., 0.), Vector(0., 3., 0.), Vector(3., 3., 0.), Vector(-2., -2., 0.), Vector(-3., 2., 0.)})
  {
    const Vertex v(5 * 11 + 5);
    const Point q = surface.point(v) + way;
    EXPECT_NEAR(CGAL::squared_distance(walker.point(walker.walk(place_of_vertex(surface, v), way)), q), 0., 1e-18);
  }
}

// A prism unrolls to the plane: the way around it is a straight line there.
TEST(Surface_walker, prism_is_unrolled)
{
  constexpr std::size_t sides = 24;
  const double side = 2. * std::sin(CGAL_PI / sides);
  const Mesh surface = grid(sides, 30, true, false, [&](const double i, const double j) {
    return Point(std::cos(2. * CGAL_PI * i / sides), std::sin(2. * CGAL_PI * i / sides), .2 * j);
  });
  const Surface_walker walker(surface);
  for(const double slope : {-.3, 0., .1, .45})
  {
    // From the side between corners 0 and 1, half way, on the level of 2.5; once around and 3.5 sides more.
    const Place from{Face(2 * (12 * sides)), {{.25, .5, .25}}};
    const Point p = walker.point(from);
    const Vector along = surface.point(Vertex(1)) - surface.point(Vertex(0));
    const double start = CGAL::scalar_product(p - surface.point(Vertex(12 * sides)), along) / along.squared_length();
    const double way = (sides + 3.5) * side;
    const Point q = walker.point(walker.walk(from, way * (along / side + Vector(0., 0., slope))));
    const double end = std::fmod(start + sides + 3.5, double(sides)), part = end - std::floor(end);
    const Point a = surface.point(Vertex(static_cast<Index>(end))),
                b = surface.point(Vertex(static_cast<Index>(end) + 1));
    const double height = p.z() + slope * way;
    if(height < 0. || height > 6.)
      continue; // has met the boundary
    const Point expected(a.x() + part * (b.x() - a.x()), a.y() + part * (b.y() - a.y()), height);
    EXPECT_NEAR(CGAL::squared_distance(q, expected), 0., 1e-18) << "slope " << slope;
  }
}

// A way past the apex of a cone keeps the law of cosines: the apex is where a vertex of the plane would be.
TEST(Surface_walker, cone_is_unrolled)
{
  for(const int sides : {3, 5, 9})
  {
    Mesh surface;
    const Vertex apex = surface.add_vertex(Point(0., 0., 2.));
    for(int i = 0; i < sides; ++i)
      surface.add_vertex(Point(std::cos(2. * CGAL_PI * i / sides), std::sin(2. * CGAL_PI * i / sides), 0.));
    for(int i = 0; i < sides; ++i)
      surface.add_face(apex, Vertex(1 + i), Vertex(1 + (i + 1) % sides));
    const Surface_walker walker(surface);
    const Place from{Face(0), {{.7, .2, .1}}};
    const Point p = walker.point(from);
    const Vector to_apex = surface.point(apex) - p, side = CGAL::cross_product(walker.normal(Face(0)), to_apex);
    for(const double angle : {-.8, -.2, -.01, .02, .3, 1.2})
    {
      const double r = std::sqrt(to_apex.squared_length()), length = 1.1 * r;
      const Vector way = 1.1 * (std::cos(angle) * to_apex + std::sin(angle) * side);
      const Point q = walker.point(walker.walk(from, way));
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(q, surface.point(apex))),
                  std::sqrt(r * r + length * length - 2. * r * length * std::cos(angle)), 1e-9);
    }
  }
}

TEST(Surface_walker, sphere_is_crossed_on_great_circles)
{
  const Mesh surface = sphere(32);
  const Surface_walker walker(surface);
  Random_numbers random;
  for(int i = 0; i < 100; ++i)
  {
    const Place from{Face(static_cast<Index>(random(0, static_cast<double>(surface.number_of_faces())))),
                     {{.3, .3, .4}}};
    const Vector n = walker.normal(from.face);
    Vector way = CGAL::cross_product(n, Vector(random(-1, 1), random(-1, 1), random(-1, 1)));
    const double length = random(.1, 1.5);
    way = way * (length / std::sqrt(way.squared_length()));
    const Vector expected = std::cos(length) * n + std::sin(length) / length * way;
    EXPECT_LT(std::sqrt((walker.point(walker.walk(from, way)) - (CGAL::ORIGIN + expected)).squared_length()), .03);
  }
}

// A long strip without area, numbered against the way that normals come: they go from face to face, not in rounds.
TEST(Surface_walker, normals_reach_the_end_of_a_strip_without_area)
{
  const unsigned n = 200000;
  Mesh surface;
  for(unsigned i = 0; i < n + 2; ++i)
    surface.add_vertex(Point(i, 0., 0.));
  surface.add_vertex(Point(n, 1., 0.));
  for(unsigned i = 0; i < n; ++i)
    surface.add_face(Vertex(i), Vertex(i + 1 + i % 2), Vertex(i + 2 - i % 2));
  surface.add_face(Vertex(n), Vertex(n + 1), Vertex(n + 2));
  const Surface_walker walker(surface);
  ASSERT_EQ(surface.number_of_faces(), n + 1);
  for(const Face f : surface.faces())
    ASSERT_NE(walker.normal(f), CGAL::NULL_VECTOR);
}

TEST(Surface_walker, faces_without_area_are_harmless)
{
  // The middle row of the grid has no height, and one column no width.
  const Mesh surface = grid(10, 10, false, false, [](const double i, const double j) {
    return Point(i > 4. ? i - 1. : i, j > 5. ? j - 1. : j, 0.);
  });
  const Surface_walker walker(surface);
  for(const Face f : surface.faces())
  {
    EXPECT_NEAR(walker.normal(f).z(), 1., 1e-12);
    for(const Vector& way : {Vector(4., 1., 0.), Vector(-4., 2., 0.), Vector(0., 3., 0.), Vector(1., -5., 0.)})
    {
      const Place to = walker.walk(Place{f, {{.2, .3, .5}}}, way);
      EXPECT_NEAR(to.coordinates[0] + to.coordinates[1] + to.coordinates[2], 1., 1e-12);
      EXPECT_GE((std::min)({to.coordinates[0], to.coordinates[1], to.coordinates[2]}), 0.);
    }
  }
}

// Any mixture of flips, collapses and splits leaves a triangulation of the same topology, and can be taken back.
TEST(Lean_triangulation, changes_are_taken_back)
{
  const Mesh mesh = torus(1);
  Lean_triangulation table(mesh);
  const auto snapshot = [&] {
    std::vector<Index> all;
    for(Index f = 0; f < table.face_slots(); ++f)
      for(Index h = 4 * f; h < 4 * f + 3 && !table.is_removed_face(f); ++h)
        all.insert(all.end(), {h, table.source(h), table.opposite(h)});
    for(Index v = 0; v < table.vertex_slots(); ++v)
      all.insert(all.end(), {table.valence(v), table.is_removed(v) ? 0 : table.halfedge(v)});
    return all;
  };
  const auto expect_consistent = [&] {
    std::size_t corners = 0, valences = 0;
    for(Index v = 0; v < table.vertex_slots(); ++v)
    {
      if(table.is_removed(v))
        continue;
      Index ring = 0;
      table.for_each_outgoing(v, [&](const Index h) { ring += table.source(h) == v; });
      EXPECT_EQ(ring, table.valence(v));
      valences += ring;
    }
    for(Index f = 0; f < table.face_slots(); ++f)
      for(Index h = 4 * f; h < 4 * f + 3 && !table.is_removed_face(f); ++h, ++corners)
      {
        EXPECT_EQ(table.opposite(table.opposite(h)), h);
        EXPECT_EQ(table.source(table.opposite(h)), table.target(h));
      }
    EXPECT_EQ(corners, valences);
    EXPECT_EQ(corners, 6 * table.number_of_vertices()); // Euler characteristic 0
  };
  table.reserve_free(50);
  const auto before = snapshot();
  Random_numbers random;
  table.record();
  for(int i = 0; i < 3000; ++i)
  {
    const Index f = static_cast<Index>(random(0, table.face_slots())), h = 4 * f + static_cast<Index>(random(0, 3));
    if(table.is_removed_face(f))
      continue;
    const int kind = static_cast<int>(random(0, 6));
    if(kind == 0 && table.number_of_vertices() < 660 && table.valence(table.source(h)) > 4)
      table.split(h, table.rotate(table.rotate(h)));
    else if(kind == 1 && table.is_collapse_legal(h))
      table.collapse(h);
    else if(kind > 1 && table.is_flip_legal(h))
      table.flip(h);
    if(i % 500 == 0)
      expect_consistent();
  }
  expect_consistent();
  EXPECT_NE(snapshot(), before);
  table.undo_to(0);
  EXPECT_EQ(snapshot(), before);
}

// A hexagon of radius one around a point a little off its middle: no two sides of a triangle are equally long.
TEST(Cotangents, slope_is_that_of_differences)
{
  Mesh mesh;
  const Point p(.11, .07, .05);
  mesh.add_vertex(p);
  for(int i = 0; i < 6; ++i)
    mesh.add_vertex(Point(std::cos(CGAL_PI * i / 3.), std::sin(CGAL_PI * i / 3.), .02 * i * i));
  for(int i = 0; i < 6; ++i)
    mesh.add_face(Vertex(0), Vertex(1 + i), Vertex(1 + (i + 1) % 6));
  Start start;
  spoil(mesh, 0., start);
  const Surface_walker walker(mesh);
  const Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained);
  const Vertex_ring ring(remeshed, 0);
  double sum = 0.;
  for(const Face f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    double smallest = 180.;
    for(int i = 0; i < 3; ++i)
      smallest = (std::min)(
          smallest, CGAL::approximate_angle(mesh.point(v[i]), mesh.point(v[(i + 1) % 3]), mesh.point(v[(i + 2) % 3])));
    sum += 1. / std::tan(smallest * CGAL_PI / 180.);
  }
  const Cotangents cotangents(ring, p);
  EXPECT_NEAR(cotangents.sum(), sum, 1e-12 * sum);
  constexpr double step = 1e-5;
  for(const Vector& way : {Vector(step, 0., 0.), Vector(0., step, 0.), Vector(0., 0., step)})
    EXPECT_NEAR((Cotangents(ring, p + way).sum() - Cotangents(ring, p - way).sum()) / (2. * step),
                cotangents.slope() * way / step, 1e-7);
}

TEST(Angle_relaxation, angles_grow_and_no_good_one_is_lost)
{
  const Mesh surface = torus(1);
  Start start;
  spoil(surface, .2, start);
  const Surface_walker walker(surface);
  Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained);
  const auto measure = [&](double& sum, double& worst) {
    sum = worst = 0.;
    for(Index v = 0; v < remeshed.connectivity().vertex_slots(); ++v)
    {
      const Vertex_ring ring(remeshed, v);
      sum += Cotangents(ring, remeshed.spot(v).point).sum();
      worst = (std::max)(worst, ring.badness());
    }
  };
  const std::vector<Quadric> planes = quadrics(remeshed, Nearest_vertices(remeshed));
  const double good = badness_of_angle(40.);
  double sum, worst;
  measure(sum, worst);
  const double first = sum;
  for(int i = 0; i < 10; ++i)
  {
    const double sum_before = sum, worst_before = worst;
    relax_angles(remeshed, planes, good, .1);
    measure(sum, worst);
    EXPECT_LT(sum, sum_before);
    EXPECT_LE(worst, (std::max)(worst_before, good));
  }
  EXPECT_LT(sum, .8 * first);
}

class Improvement_to_a_count : public testing::TestWithParam<std::size_t>
{};

TEST_P(Improvement_to_a_count, torus_from_a_spoilt_start)
{
  const Mesh surface = torus(1);
  Start start;
  spoil(surface, .3, start);
  improve_to(surface, start, GetParam());
  EXPECT_EQ(start.mesh.number_of_vertices(), GetParam());
  expect_valid(surface, start);
  expect_no_turned_faces(surface, start);
  EXPECT_GT(smallest_angle(start.mesh), 30.);
}

// The start has 640; fewer, more, as many.
INSTANTIATE_TEST_SUITE_P(Counts, Improvement_to_a_count, testing::Values(300, 600, 640, 700, 1300));

TEST(Improvement, sphere_from_a_spoilt_start)
{
  const Mesh surface = sphere(16);
  Start start;
  spoil(surface, .05, start);
  const std::size_t n = surface.number_of_vertices() - 26;
  improve_to(surface, start, n);
  EXPECT_EQ(start.mesh.number_of_vertices(), n);
  expect_valid(surface, start);
  expect_no_turned_faces(surface, start);
  EXPECT_GT(smallest_angle(start.mesh), 35.);
  EXPECT_LT(percent_irregular(start.mesh), 15.);
}

TEST(Improvement, corners_stay_and_tips_stay_near)
{
  const Mesh surface = torus(1);
  Constraints pinned, constraints;
  pinned.is_corner.assign(surface.number_of_vertices(), 0);
  constraints.is_corner = pinned.is_corner;
  std::vector<Point> corners, tips;
  for(const Vertex v : surface.vertices())
  {
    const Index i = static_cast<Index>(v) % 97;
    pinned.is_corner[v] = i == 0 || i == 40;
    constraints.is_corner[v] = i == 0;
    if(pinned.is_corner[v])
      (i == 0 ? corners : tips).push_back(surface.point(v));
  }
  Start start;
  spoil(surface, .1, start, pinned);
  ASSERT_GE(corners.size(), 3u);
  ASSERT_GE(tips.size(), 3u);
  const Improvement_parameters parameters = parameters_for(surface, 500);
  improve(surface, start.mesh, start.place, start.pinned, start.constrained, constraints, parameters,
          [](double) { return true; });
  const auto distance_to_mesh = [&](const Point& p) {
    double least = infinity;
    for(const Vertex v : start.mesh.vertices())
      least = (std::min)(least, CGAL::squared_distance(p, start.mesh.point(v)));
    return std::sqrt(least);
  };
  for(const Point& p : corners)
    EXPECT_EQ(distance_to_mesh(p), 0.);
  for(const Point& p : tips)
    EXPECT_LE(distance_to_mesh(p), .31 * parameters.edge_length);
  expect_valid(surface, start);
}

TEST(Improvement, same_start_same_bytes)
{
  const Mesh surface = torus(1);
  std::array<Start, 2> start;
  for(Start& s : start)
  {
    spoil(surface, .3, s);
    improve_to(surface, s, 610);
  }
  ASSERT_EQ(start[0].mesh.number_of_faces(), start[1].mesh.number_of_faces());
  for(const Vertex v : start[0].mesh.vertices())
    EXPECT_EQ(start[0].mesh.point(v), start[1].mesh.point(v));
  for(const Face f : start[0].mesh.faces())
    EXPECT_EQ(vertices_of(start[0].mesh, f), vertices_of(start[1].mesh, f));
}

TEST(Improvement, progress_rises_and_stops_the_work)
{
  const Mesh surface = torus(1);
  Start start;
  spoil(surface, .3, start);
  double last = 0.;
  improve(surface, start.mesh, start.place, start.pinned, start.constrained, Constraints(),
          parameters_for(surface, 640), [&](const double progress) {
            EXPECT_GE(progress, last);
            EXPECT_LE(progress, 1.);
            last = progress;
            return progress < .5;
          });
  EXPECT_GE(last, .5);
  EXPECT_LT(last, 1.);
  expect_valid(surface, start);
}

TEST(Improvement, what_the_topology_forbids_is_not_made)
{
  // A torus needs seven vertices.
  const Mesh surface = torus(1);
  Start start;
  spoil(surface, .1, start);
  improve_to(surface, start, 5);
  EXPECT_GT(start.mesh.number_of_vertices(), 6u);
  expect_valid(surface, start);
}

// A tip on a leash is taken away, and the next new vertex gets its slot, but not its leash; unless all is taken back.
TEST(Remeshed_surface, new_vertex_is_not_held_by_the_one_before)
{
  const Mesh surface = torus(1);
  Start start;
  spoil(surface, 0., start);
  const Surface_walker walker(surface);
  Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained);
  Lean_triangulation& table = remeshed.connectivity();
  Index h = 0;
  while(!table.is_collapse_legal(h))
    ++h;
  const Index v = table.source(h), w = table.target(h);
  for(const Index tip : {v, w})
    remeshed.pin_tip(tip);
  remeshed.keep_tips_on_leash(.1);
  ASSERT_FALSE(remeshed.is_free(v) || remeshed.is_free(w));
  const Remeshed_surface::Spot spots[] = {remeshed.spot(v), remeshed.spot(w)};
  remeshed.record();
  const auto mark = remeshed.mark();
  table.collapse(h);
  const Index removed = table.is_removed(v) ? v : w, left = removed == v ? w : v;
  const Index added = table.split_edge(table.halfedge(left));
  ASSERT_EQ(added, removed);
  remeshed.put_new(added, spots[0]);
  EXPECT_TRUE(remeshed.is_free(added));
  EXPECT_FALSE(remeshed.is_free(left));
  remeshed.undo_to(mark);
  EXPECT_FALSE(remeshed.is_free(removed));
  EXPECT_EQ(remeshed.spot(v).point, spots[0].point);
  EXPECT_EQ(remeshed.spot(w).point, spots[1].point);
  remeshed.forget();
}

// Two sheets on each other, which nothing parts: asked again, as many pairs intersect.
TEST(Intersection_repair, what_is_given_up_is_not_forgotten)
{
  Mesh surface = plane(12);
  const auto vertices = static_cast<Mesh::size_type>(surface.number_of_vertices());
  for(Mesh::size_type v = 0; v < vertices; ++v)
  {
    const Point p = surface.point(Vertex(v)); // which moves
    surface.add_vertex(p);
  }
  const auto faces = static_cast<Mesh::size_type>(surface.number_of_faces());
  for(Mesh::size_type f = 0; f < faces; ++f)
  {
    const auto v = vertices_of(surface, Face(f));
    const auto copy = [&](const int i) { return Vertex(static_cast<Mesh::size_type>(v[i]) + vertices); };
    surface.add_face(copy(0), copy(1), copy(2));
  }
  Start start;
  spoil(surface, 0., start);
  const Surface_walker walker(surface);
  Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained);
  Intersection_repair repair(remeshed);
  const std::size_t number = repair.run(badness_of_angle(36.));
  EXPECT_GT(number, surface.number_of_vertices());
  EXPECT_EQ(repair.run(badness_of_angle(30.), true), number);
}

// A turned face that a flip mends, beside a fold that it does not: that stays, and so do faces that intersect.
TEST(Polish, turned_face_beside_a_fold_is_mended_if_intersections_may_be_left)
{
  const Mesh surface = plane(8);
  const Surface_walker walker(surface);
  Start start;
  spoil(surface, 0., start);
  const auto move = [&](const Index i, const Index j, const Vector& way) {
    const Vertex v(j * 9 + i);
    start.place[v] = walker.walk(start.place[v], way);
    start.mesh.point(v) = walker.point(start.place[v]);
  };
  move(4, 3, Vector(-.7, .7, 0.));
  move(5, 5, Vector(-1.4, 1.6, 0.));
  for(const Vertex v : start.mesh.vertices())
    start.pinned[v] = true;
  Remeshed_surface remeshed(walker, Constraints(), start.mesh, start.place, start.pinned, start.constrained);
  const auto turned = [&] { return find_turned_faces(remeshed).size(); };
  const auto intersections = [&] { return Intersection_search(remeshed).run().size(); };
  Polish(remeshed).run(2. * worst_badness, false);
  const std::size_t turned_before = turned(), intersections_before = intersections();
  EXPECT_GT(turned_before, 1);
  EXPECT_GT(intersections_before, 0);
  Polish(remeshed, false, true).run(2. * worst_badness, false);
  EXPECT_LT(turned(), turned_before);
  EXPECT_LE(intersections(), intersections_before);
}
