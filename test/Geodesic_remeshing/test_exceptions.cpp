#include "made_surfaces.h"

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/Geodesic_remeshing/equidistant_curves.h>
#include <CGAL/Geodesic_remeshing/geodesic_diameter.h>
#include <CGAL/Geodesic_remeshing/geodesic_distances.h>
#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/Geodesic_remeshing/region_segmentation.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/geodesic_remeshing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <vector>

// Whatever is thrown, wherever: the caller's mesh and maps are as they were, and no memory is lost. Memory runs out
// here at every allocation in turn (at some of them only, evenly spread, where there are many), by an operator new of
// our own.

namespace {

struct Memory
{
  long allocations = 0;   // since the last start()
  long blocks = 0;        // in use
  long failing = -1;      // the number of the allocation that fails; -1: none
  bool stays_out = false; // all allocations after that one fail as well

  bool fails()
  {
    const long number = allocations++;
    return failing >= 0 && (stays_out ? number >= failing : number == failing);
  }
};

Memory memory;

void* take_if_possible(std::size_t size)
{
  void* const block = memory.fails() ? nullptr : std::malloc(size == 0 ? 1 : size);
  memory.blocks += block != nullptr;
  return block;
}

void* take(std::size_t size)
{
  if(void* const block = take_if_possible(size))
    return block;
  throw std::bad_alloc();
}

void give_back(void* block)
{
  if(block == nullptr)
    return;
  --memory.blocks;
  std::free(block);
}

} // namespace

void* operator new(std::size_t size)
{
  return take(size);
}
void* operator new[](std::size_t size)
{
  return take(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  return take_if_possible(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
  return take_if_possible(size);
}
void operator delete(void* block) noexcept
{
  give_back(block);
}
void operator delete[](void* block) noexcept
{
  give_back(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept
{
  give_back(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept
{
  give_back(block);
}
void operator delete(void* block, std::size_t) noexcept
{
  give_back(block);
}
void operator delete[](void* block, std::size_t) noexcept
{
  give_back(block);
}

// A `Surface_mesh` that runs out of memory while it adds a property map, or is copied, loses the array of that map: the
// array, its name, its values; and so does an `AABB_tree` with the root of the `Kd_tree` that it makes. Where there is
// a sanitizer that knows who lost what, nothing else may be lost; elsewhere nothing more.
constexpr long lost_by_surface_mesh = 3;
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:CGAL::Properties::\nleak:CGAL::Kd_tree\n";
}

namespace {

namespace GR = CGAL::Geodesic_remeshing;
namespace gp = CGAL::Geodesic_remeshing::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using made::Mesh;
using made::Point;
using made::Vertex;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;
using Location = PMP::Face_location<Mesh, double>;
using Polyhedron =
    CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Polyhedron_items_with_id_3>;

// `most` places from the first allocation to the last one, evenly spread, and each of the last ones: there the output
// is written.
std::vector<long> places_of_failure(long all, long most, long last)
{
  std::vector<long> result;
  for(long i = 0; i < most; ++i)
    result.push_back(i * all / most);
  for(long place = (std::max)(all - last, 0L); place < all; ++place)
    result.push_back(place);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Calls `work` again and again, running out of memory at one place after the other. Before each call `prepare` makes
// what is worked on, and after each that fails `state` tells what it has become.
template <class Prepare, class Work, class State>
void run_out_of_memory(long most, const Prepare& prepare, const Work& work, const State& state, long last = 40)
{
  prepare();
  const std::string before = state();
  memory.allocations = 0;
  work();
  const std::vector<long> places = places_of_failure(memory.allocations, most, last);
  std::size_t failed = 0;
  for(const long place : places)
  {
    prepare();
    const long blocks = memory.blocks;
    memory.allocations = 0;
    memory.stays_out = failed % 2 == 0;
    memory.failing = place;
    bool has_failed = false;
    try
    {
      work();
    }
    catch(const std::bad_alloc&)
    {
      has_failed = true;
    }
    memory.failing = -1;
    if(!has_failed) // a sort of the standard library makes do without its buffer
      continue;
    ++failed;
    ASSERT_LE(memory.blocks - blocks, lost_by_surface_mesh) << "allocation " << place << " of " << places.back() + 1;
    ASSERT_EQ(state(), before) << "allocation " << place << " of " << places.back() + 1;
  }
  EXPECT_GT(2 * failed, places.size());
}

template <class M>
std::string description(const M& mesh)
{
  std::ostringstream out;
  out.precision(17);
  out << mesh;
  return out.str();
}

std::string description(const Mesh& mesh)
{
  std::ostringstream out;
  out.precision(17);
  out << mesh << mesh.has_garbage() << mesh.num_vertices() << " " << mesh.num_edges() << " " << mesh.num_faces();
  for(const auto& names : {mesh.properties<Vertex>(), mesh.properties<Mesh::Halfedge_index>(), mesh.properties<Edge>(),
                           mesh.properties<Face>()})
    for(const std::string& name : names)
      out << " " << name;
  return out.str();
}

// A box with a hole in its side, features, patches and a mark of the caller on each vertex
struct Open_box
{
  Mesh mesh = made::box(5, 4, 3);
  Mesh::Property_map<Face, int> patch = mesh.add_property_map<Face, int>("f:patch", 0).first;
  Mesh::Property_map<Vertex, double> size = mesh.add_property_map<Vertex, double>("v:size", 1.).first;

  Open_box()
  {
    for(Face f : mesh.faces())
      patch[f] = mesh.point(mesh.target(mesh.halfedge(f))).x() > 2.;
    for(Vertex v : mesh.vertices())
      size[v] = 1. + .3 * mesh.point(v).z();
    CGAL::Euler::remove_face(mesh.halfedge(*mesh.faces().begin()), mesh);
  }

  auto parameters() const { return gp::features_angle_bound(60.).face_patch_map(patch).sizing_field(size); }
};

// An output that has been in use: with elements, removed ones among them, and maps
struct Used_output
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Location> location = mesh.add_property_map<Vertex, Location>("v:location").first;
  Mesh::Property_map<Edge, bool> constrained = mesh.add_property_map<Edge, bool>("e:constrained", true).first;
  Mesh::Property_map<Face, int> patch = mesh.add_property_map<Face, int>("f:patch", -1).first;

  Used_output()
  {
    mesh.add_face(mesh.add_vertex(Point(0, 0, 0)), mesh.add_vertex(Point(1, 0, 0)), mesh.add_vertex(Point(0, 1, 0)));
    mesh.remove_vertex(mesh.add_vertex(Point(9, 9, 9)));
    patch[*mesh.faces().begin()] = 7;
  }

  auto parameters() const
  {
    return gp::vertex_location_map(location).edge_is_constrained_map(constrained).face_patch_map(patch);
  }

  std::string state() const
  {
    std::string result = description(mesh);
    for(Edge e : mesh.edges())
      result += constrained[e] ? "+" : "-";
    for(Face f : mesh.faces())
      result += std::to_string(patch[f]);
    return result;
  }
};

// Calls the visitor's functions, the last time with an exception
struct Interrupted
{};
struct Throwing_visitor : GR::Default_visitor
{
  int calls_left;
  int calls = 0;

  explicit Throwing_visitor(int calls_left) : calls_left(calls_left) {}
  void stage(const std::string&) { call(); }
  bool progress(double) { return call(), true; }
  void call()
  {
    ++calls;
    if(calls_left-- == 0)
      throw Interrupted();
  }
};

} // namespace

TEST(Out_of_memory, open_surface_with_features_patches_sizes_and_maps)
{
  const Open_box input;
  std::unique_ptr<Used_output> out;
  run_out_of_memory(
      100, [&] { out = std::make_unique<Used_output>(); },
      [&] { CGAL::geodesic_remeshing(input.mesh, 70, out->mesh, input.parameters(), out->parameters()); },
      [&] { return out->state() + description(input.mesh); });
}

TEST(Out_of_memory, polyhedron_in_and_out)
{
  Polyhedron input;
  CGAL::copy_face_graph(made::box(2, 2, 1), input);
  std::unique_ptr<Polyhedron> out;
  run_out_of_memory(
      15, [&] { out = std::make_unique<Polyhedron>(), CGAL::copy_face_graph(made::octahedron(), *out); },
      [&] { CGAL::geodesic_remeshing(input, 30, *out); }, [&] { return description(*out) + description(input); });
}

// The vertices leave the surface, edges and a vertex are constrained, and the map of the edges is written to.
TEST(Out_of_memory, in_place_with_constraints_and_fitting)
{
  struct Constrained_box : Open_box
  {
    Mesh::Property_map<Edge, bool> edge = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
    Mesh::Property_map<Vertex, bool> vertex = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;

    Constrained_box()
    {
      for(Edge e : mesh.edges())
        edge[e] = mesh.point(mesh.vertex(e, 0)).z() + mesh.point(mesh.vertex(e, 1)).z() < .1;
      vertex[*mesh.vertices().begin()] = true;
    }
  };
  std::unique_ptr<Constrained_box> box;
  run_out_of_memory(
      20, [&] { box = std::make_unique<Constrained_box>(); },
      [&] {
        CGAL::geodesic_remeshing(box->mesh, 70,
                                 box->parameters()
                                     .edge_is_constrained_map(box->edge)
                                     .vertex_is_constrained_map(box->vertex)
                                     .do_project(false));
      },
      [&] {
        std::string result = description(box->mesh);
        for(Edge e : box->mesh.edges())
          result += box->edge[e] ? "+" : "-";
        return result;
      });
}

// Where faces are in conflict, here on tubes pressed flat, all stages are run again and the better mesh is kept.
TEST(Out_of_memory, stages_that_are_repeated)
{
  Mesh input = made::branching_tubes({4, 3, 2}, 1);
  for(Vertex v : input.vertices())
    input.point(v) = Point(input.point(v).x(), input.point(v).y(), .02 * input.point(v).z());
  Throwing_visitor once(-1), again(-1);
  Mesh other;
  CGAL::geodesic_remeshing(made::torus(3, 1, 30, 14), 60, other, gp::visitor(std::ref(once)));
  CGAL::geodesic_remeshing(input, 12, other, gp::visitor(std::ref(again)));
  EXPECT_GT(again.calls, once.calls + 5);
  std::unique_ptr<Used_output> out;
  run_out_of_memory(
      25, [&] { out = std::make_unique<Used_output>(); },
      [&] { CGAL::geodesic_remeshing(input, 12, out->mesh, gp::default_values(), out->parameters()); },
      [&] { return out->state() + description(input); }, 5);
}

TEST(Out_of_memory, functions_that_fill_a_map)
{
  Mesh mesh = made::torus(2, 1, 12, 8);
  const Vertex source(0);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance", -1.).first;
  auto region = mesh.add_property_map<Face, std::size_t>("f:region", 77).first;
  const auto state = [&] {
    std::string result = description(mesh);
    for(Vertex v : mesh.vertices())
      result += std::to_string(distance[v]) + " ";
    for(Face f : mesh.faces())
      result += std::to_string(region[f]) + " ";
    return result;
  };
  const auto prepare = [&] {
    for(Vertex v : mesh.vertices())
      distance[v] = -1.;
    for(Face f : mesh.faces())
      region[f] = 77;
  };
  run_out_of_memory(
      40, prepare, [&] { GR::geodesic_distances(mesh, distance, source); }, state);
  const std::vector<Vertex> curve{mesh.source(mesh.halfedge(source)), source};
  run_out_of_memory(
      40, prepare, [&] { GR::geodesic_distances_from_curve(mesh, distance, curve); }, state);
  run_out_of_memory(
      60, prepare, [&] { GR::geodesic_diameter(mesh, gp::vertex_distance_map(distance)); }, state);
  run_out_of_memory(
      100, prepare, [&] { GR::region_segmentation(mesh, .5, region); }, state);
}

TEST(Out_of_memory, functions_that_only_look)
{
  Mesh mesh = made::torus(2, 1, 12, 8);
  auto height = mesh.add_property_map<Vertex, double>("v:height", 0.).first;
  for(Vertex v : mesh.vertices())
    height[v] = mesh.point(v).x();
  std::vector<GR::Equidistant_curve<Mesh, Point>> curves;
  const auto prepare = [&] { curves.clear(), curves.reserve(100); }; // the caller's memory is not our business
  const auto state = [&] { return description(mesh) + std::to_string(curves.size()); };
  const std::vector<double> values{-1.5, 0., 1.5};
  run_out_of_memory(
      100, prepare, [&] { GR::equidistant_curves(mesh, height, values, std::back_inserter(curves)); }, state);
  run_out_of_memory(
      60, prepare, [&] { GR::Curvature_sizing_field<Mesh> field(mesh); }, state);
  run_out_of_memory(
      60, prepare, [&] { GR::is_valid_remeshing(mesh, mesh); }, state);
}

TEST(Out_of_memory, transfer_of_attributes)
{
  Mesh input = made::octahedron();
  const auto numbers = input.add_property_map<Vertex, double>("v:number", 5.).first;
  const auto words = input.add_property_map<Face, int>("f:number", 5).first;
  const auto corners = input.add_property_map<Mesh::Halfedge_index, double>("h:number", 5.).first;
  Used_output out;
  CGAL::geodesic_remeshing(input, 20, out.mesh, gp::default_values(), out.parameters());
  auto number = out.mesh.add_property_map<Vertex, double>("v:number", 3.).first;
  auto corner = out.mesh.add_property_map<Mesh::Halfedge_index, double>("h:number", 3.).first;
  const auto state = [&] {
    std::string result = description(out.mesh);
    for(Vertex v : out.mesh.vertices())
      result += std::to_string(number[v]);
    for(auto h : out.mesh.halfedges())
      result += std::to_string(corner[h]);
    for(Face f : out.mesh.faces())
      result += std::to_string(out.patch[f]);
    return result;
  };
  const auto prepare = [&] {
    std::fill(number.begin(), number.end(), 3.);
    std::fill(corner.begin(), corner.end(), 3.);
    std::fill(out.patch.begin(), out.patch.end(), 3);
  };
  run_out_of_memory(
      60, prepare, [&] { GR::transfer_vertex_property(input, numbers, out.mesh, out.location, number); }, state);
  run_out_of_memory(
      60, prepare, [&] { GR::transfer_face_property(input, words, out.mesh, out.location, out.patch); }, state);
  run_out_of_memory(
      60, prepare, [&] { GR::transfer_corner_property(input, corners, out.mesh, out.location, corner); }, state);
}

TEST(Throwing_visitor, leaves_everything_as_it_was)
{
  const Open_box input;
  const std::string before = description(input.mesh);
  for(int calls = 0;; ++calls)
  {
    Used_output out;
    const std::string state = out.state();
    Throwing_visitor visitor(calls);
    const long blocks = memory.blocks;
    try
    {
      CGAL::geodesic_remeshing(input.mesh, 70, out.mesh, input.parameters().visitor(std::ref(visitor)),
                               out.parameters());
      EXPECT_GE(calls, 20); // ten stages, and the progress of each
      EXPECT_EQ(out.mesh.number_of_vertices(), 70u);
      return;
    }
    catch(const Interrupted&)
    {}
    ASSERT_EQ(memory.blocks, blocks) << "call " << calls;
    ASSERT_EQ(out.state(), state) << "call " << calls;
    ASSERT_EQ(description(input.mesh), before) << "call " << calls;
  }
}

TEST(Throwing_map, leaves_everything_as_it_was)
{
  struct Throwing_sizing
  {
    Vertex last;
    double at(Vertex v) const { return v == last ? throw Interrupted() : 1.; }
  };
  const Open_box input;
  Used_output out;
  const std::string state = out.state();
  EXPECT_THROW(CGAL::geodesic_remeshing(input.mesh, 70, out.mesh, gp::sizing_field(Throwing_sizing{Vertex(9)}),
                                        out.parameters()),
               Interrupted);
  EXPECT_EQ(out.state(), state);
}
