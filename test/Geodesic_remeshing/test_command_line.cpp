// The promises of geodesic_remesh to scripts and users: exit status, one line about an error, output whole or not at
// all.

#include "command_line_support.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace command_line_support;

const char* const tetrahedron_points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

std::vector<std::array<double, 3>> points_of_off(const std::string& name)
{
  std::vector<std::array<double, 3>> points(vertices_and_faces_of_off(name)[0]);
  std::ifstream in(name);
  std::string skipped;
  for(int i = 0; i < 4; ++i)
    in >> skipped;
  for(auto& p : points)
    in >> p[0] >> p[1] >> p[2];
  return points;
}

// As many as there are edges with one face, where every loop is simple
int boundary_vertices_of_off(const std::string& name)
{
  std::ifstream in(name);
  std::string word;
  std::size_t vertices = 0, faces = 0, edges = 0;
  in >> word >> vertices >> faces >> edges;
  for(std::size_t i = 0; i < 3 * vertices; ++i)
    in >> word;
  std::map<std::pair<std::size_t, std::size_t>, int> faces_at;
  for(std::size_t f = 0; f < faces; ++f)
  {
    std::size_t size = 0;
    std::array<std::size_t, 3> v{};
    in >> size >> v[0] >> v[1] >> v[2];
    for(int i = 0; i < 3; ++i)
      ++faces_at[std::minmax(v[i], v[(i + 1) % 3])];
  }
  return static_cast<int>(std::count_if(faces_at.begin(), faces_at.end(), [](const auto& e) { return e.second == 1; }));
}

double mean_edge_length_of_off(const std::string& name)
{
  std::ifstream in(name);
  std::string word;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  in >> word >> vertices >> faces >> edges;
  std::vector<std::array<double, 3>> points(vertices);
  for(auto& p : points)
    in >> p[0] >> p[1] >> p[2];
  double sum = 0.;
  for(std::size_t f = 0; f < faces; ++f)
  {
    std::size_t size = 0;
    std::array<std::size_t, 3> v{};
    in >> size >> v[0] >> v[1] >> v[2];
    for(int i = 0; i < 3; ++i)
    {
      const auto& p = points.at(v[i]);
      const auto& q = points.at(v[(i + 1) % 3]);
      sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  }
  return sum / (3. * static_cast<double>(faces)); // every edge counts twice in both
}

// A binary PLY of an OFF, with every bit of the coordinates
std::string ply_of_off(const std::string& name)
{
  std::ifstream in(name);
  std::string word;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  in >> word >> vertices >> faces >> edges;
  std::ostringstream out;
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << vertices
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << faces
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t i = 0; i < 3 * vertices; ++i)
  {
    double coordinate = 0.;
    in >> coordinate;
    out.write(reinterpret_cast<const char*>(&coordinate), sizeof(coordinate));
  }
  for(std::size_t f = 0; f < faces; ++f)
  {
    int size = 0;
    in >> size;
    out.put(static_cast<char>(size));
    for(int i = 0; i < size; ++i)
    {
      int vertex = 0;
      in >> vertex;
      out.write(reinterpret_cast<const char*>(&vertex), sizeof(vertex));
    }
  }
  return out.str();
}

} // namespace

TEST_F(Command_line, exact_number_of_vertices)
{
  const Outcome outcome = run(mesh("eight") + " " + output() + " --vertices 1000");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("Hausdorff"), std::string::npos);
  const auto counts = vertices_and_faces_of_off(output());
  EXPECT_EQ(counts[0], 1000u);
  EXPECT_EQ(counts[1], 2 * (1000u + 2u)); // genus 2
}

TEST_F(Command_line, exact_number_of_faces)
{
  EXPECT_EQ(run(mesh("eight") + " " + output() + " --faces 2000").status, 0);
  EXPECT_EQ(vertices_and_faces_of_off(output())[1], 2000u);
}

TEST_F(Command_line, edge_length_is_kept_on_average)
{
  EXPECT_EQ(run(mesh("eight") + " " + output() + " --edge-length 0.02 --report " + output("r.json")).status, 0);
  const auto report = nlohmann::json::parse(contents(output("r.json")));
  EXPECT_NEAR(report["edge_length"].get<double>(), 0.02, 2e-4); // up to rounding to a whole number of vertices
  EXPECT_NEAR(mean_edge_length_of_off(output()), 0.02, 1e-3);
}

TEST_F(Command_line, report_has_all_keys)
{
  ASSERT_EQ(run(mesh("eight") + " " + output() + " --vertices 1000 --quiet --report " + output("r.json")).status, 0);
  const auto report = nlohmann::json::parse(contents(output("r.json")));
  for(const char* side : {"input", "output"})
  {
    for(const char* key : {"vertices", "faces", "components", "genus", "boundary_loops", "min_angle", "mean_min_angle",
                           "percent_below_30", "percent_irregular"})
      EXPECT_TRUE(report[side].contains(key)) << side << " " << key;
    EXPECT_EQ(report[side]["genus"], 2);
    EXPECT_EQ(report[side]["components"], 1);
    EXPECT_EQ(report[side]["boundary_loops"], 0);
  }
  EXPECT_EQ(report["output"]["vertices"], 1000);
  EXPECT_GT(report["output"]["hausdorff_percent"].get<double>(), 0.);
  EXPECT_GE(report["output"]["hausdorff_percent"].get<double>(), report["output"]["rms_percent"].get<double>());
  for(const char* key : {"edge_length", "regions", "curves", "strips"})
    EXPECT_GT(report[key].get<double>(), 0.) << key;
  EXPECT_TRUE(report["seconds"].contains("total"));
  EXPECT_GE(report["seconds"].size(), 2u);
}

TEST_F(Command_line, regions_and_curves)
{
  const Outcome outcome = run(mesh("eight") + " " + output() + " --vertices 1000 --report " + output("r.json") +
                              " --regions " + output("r.ply") + " --curves " + output("c.obj"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string regions = contents(output("r.ply"));
  EXPECT_NE(regions.find("property int region"), std::string::npos);
  EXPECT_NE(regions.find("property uchar red"), std::string::npos);

  std::ifstream curves(output("c.obj"));
  std::size_t number_of_points = 0;
  std::size_t number_of_curves = 0;
  for(std::string line; std::getline(curves, line);)
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    number_of_points += kind == "v";
    number_of_curves += kind == "l";
    for(std::size_t index = 0; kind == "l" && words >> index;)
      EXPECT_LE(index, number_of_points);
  }
  const auto report = nlohmann::json::parse(contents(output("r.json")));
  EXPECT_EQ(report["curves"], number_of_curves);
}

TEST_F(Command_line, without_segmentation_there_is_one_region)
{
  ASSERT_EQ(
      run(mesh("eight") + " " + output() + " --vertices 1000 --no-segmentation --report " + output("r.json")).status,
      0);
  const auto report = nlohmann::json::parse(contents(output("r.json")));
  EXPECT_EQ(report["regions"], 1);
  EXPECT_EQ(report["output"]["vertices"], 1000);
}

TEST_F(Command_line, quiet_says_nothing)
{
  const Outcome outcome = run(mesh("eight") + " " + output() + " --vertices 500 --quiet");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(Command_line, every_format_is_written)
{
  for(const char* name : {"out.off", "out.obj", "out.ply", "out.stl", "out.ts"})
  {
    EXPECT_EQ(run(mesh("eight") + " " + output(name) + " --vertices 500 --quiet").status, 0);
    EXPECT_GT(fs::file_size(output(name)), 500u);
    // and read again
    EXPECT_EQ(run(output(name) + " " + output("again.off") + " --vertices 400 --quiet").status, 0) << name;
    EXPECT_EQ(vertices_and_faces_of_off(output("again.off"))[0], 400u);
  }
}

TEST_F(Command_line, same_bytes_again_and_from_another_format)
{
  const std::string as_ply = file("eight.ply", ply_of_off(mesh("eight")));
  EXPECT_EQ(run(mesh("eight") + " " + output("a.off") + " --vertices 1000 --quiet").status, 0);
  EXPECT_EQ(run(mesh("eight") + " " + output("b.off") + " --vertices 1000 --quiet").status, 0);
  EXPECT_EQ(run(as_ply + " " + output("c.off") + " --vertices 1000 --quiet").status, 0);
  EXPECT_EQ(contents(output("a.off")), contents(output("b.off")));
  EXPECT_EQ(contents(output("a.off")), contents(output("c.off")));
}

TEST_F(Command_line, output_may_be_the_input)
{
  fs::copy_file(mesh("eight"), output("eight.off"));
  EXPECT_EQ(run(output("eight.off") + " " + output("eight.off") + " --vertices 600 --quiet").status, 0);
  EXPECT_EQ(vertices_and_faces_of_off(output("eight.off"))[0], 600u);
}

TEST_F(Command_line, wrong_usage)
{
  const std::string files = mesh("eight") + " " + output();
  expect_failure("", 1, "INPUT and OUTPUT");
  expect_failure(mesh("eight") + " --vertices 100", 1, "INPUT and OUTPUT");
  expect_failure(files, 1, "exactly one");
  expect_failure(files + " --vertices 100 --faces 100", 1, "exactly one");
  expect_failure(files + " --vertices -5", 1, "vertices");
  expect_failure(files + " --vertices 3", 1, "at least 4");
  expect_failure(files + " --vertices 1e3", 1, "vertices");
  expect_failure(files + " --vertices many", 1, "vertices");
  expect_failure(files + " --vertices 99999999999999999999999", 1, "vertices");
  expect_failure(files + " --vertices", 1, "vertices");
  expect_failure(files + " --edge-length 0", 1, "positive");
  expect_failure(files + " --edge-length nan", 1, "positive");
  expect_failure(files + " --iterations=-1 --vertices 100", 1, "iterations");
  expect_failure(files + " --vert 100", 1, "vert");
  expect_failure(files + " more.off --vertices 100", 1, "too many");
}

TEST_F(Command_line, option_that_does_not_exist_is_refused)
{
  const std::string usual = mesh("eight") + " " + output() + " --vertices 100 ";
  expect_failure(usual + "--colour red", 1, "unrecognised option");
}

TEST_F(Command_line, number_of_threads_changes_nothing)
{
  const std::string usual = mesh("dino") + " --vertices 5000 ";
  for(const char* wrong : {"0", "-1", "many"})
    expect_failure(usual + output() + " --threads " + wrong, 1, "threads");
  ASSERT_EQ(run(usual + output("all.off")).status, 0);
  ASSERT_EQ(run(usual + output("one.off") + " --threads 1").status, 0);
  EXPECT_EQ(contents(output("all.off")), contents(output("one.off")));
}

TEST_F(Command_line, wrong_sizing_options)
{
  const std::string usual = mesh("eight") + " " + output() + " --vertices 100 ";
  for(const char* wrong : {"--contrast -1", "--contrast 2.1", "--contrast nan", "--contrast high"})
    expect_failure(usual + wrong, 1, "contrast");
  expect_failure(usual + "--gaussian-weight 1", 1, "needs --contrast");
  expect_failure(usual + "--mean-weight 1", 1, "needs --contrast");
  expect_failure(usual + "--gradation 1", 1, "needs --contrast or --sizing");
  expect_failure(usual + "--min-length 1", 1, "needs --contrast or --sizing");
  expect_failure(usual + "--max-length 1", 1, "needs --contrast or --sizing");
  expect_failure(usual + "--contrast 1 --sizing a.txt", 1, "exclude each other");
  expect_failure(usual + "--contrast 1 --gaussian-weight 0 --mean-weight 0", 1, "must be positive");
  expect_failure(usual + "--contrast 1 --mean-weight -1", 1, "must not be negative");
  expect_failure(usual + "--contrast 1 --gradation 0", 1, "positive");
  expect_failure(usual + "--contrast 1 --min-length inf", 1, "positive");
  expect_failure(usual + "--contrast 1 --min-length 2 --max-length 1", 1, "above");
  expect_failure(usual + "--contrast 1 --min-length 1", 3, "no more than");
}

TEST_F(Command_line, sizing_by_curvature)
{
  const std::string usual =
      mesh("eight") + " " + output() + " --vertices 1000 --report " + output("r.json") + " --contrast 0.6";
  EXPECT_EQ(run(usual).status, 0);
  EXPECT_EQ(vertices_and_faces_of_off(output())[0], 1000u);
  const std::string first = contents(output());
  EXPECT_EQ(run(usual + " --gaussian-weight 1 --mean-weight 0 --gradation 0.3").status, 0);
  EXPECT_NE(contents(output()), first);
}

// As with the field itself, which also brings vertices nearer: .57 of it. By the lengths alone it is .69.
TEST_F(Command_line, sizing_by_curvature_is_nearer_to_the_surface)
{
  const auto rms = [&](const std::string& options) {
    EXPECT_EQ(run(mesh("homer") + " " + output() + " --vertices 5000 --report " + output("r.json") + options).status,
              0);
    return nlohmann::json::parse(contents(output("r.json")))["output"]["rms_percent"].get<double>();
  };
  EXPECT_LT(rms(" --contrast 0.5"), .63 * rms(""));
}

// Sizes as text and as PLY, the latter in both precisions: four times as long on one side as on the other
TEST_F(Command_line, sizing_from_a_file)
{
  const auto input = points_of_off(mesh("eight"));
  std::string text, ply, faces;
  for(const auto& p : input)
  {
    const std::string size = p[0] > 0. ? "4" : "1";
    text += size + "\n";
    ply += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + " " + size + "\n";
  }
  const auto header = [&](const std::string& type, const std::string& name) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(input.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nproperty " + type + " " + name +
           "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  };
  const std::string usual = mesh("eight") + " " + output() + " --vertices 1000 --quiet --gradation 10 --sizing ";
  EXPECT_EQ(run(usual + file("sizes.txt", text)).status, 0);
  const std::string by_text = contents(output());
  const auto result = points_of_off(output());
  EXPECT_EQ(result.size(), 1000u);
  std::size_t fine = 0;
  for(const auto& p : result)
    fine += p[0] <= 0.;
  EXPECT_GT(fine, 800u);
  for(const char* type : {"double", "float"})
  {
    EXPECT_EQ(run(usual + file("sizes.ply", header(type, "sizing") + ply + "3 0 1 2\n")).status, 0);
    EXPECT_EQ(contents(output()), by_text);
  }
  fs::remove(output());
  expect_failure(usual + (folder / "missing.txt").string(), 2, "cannot be opened");
  expect_failure(usual + file("short.txt", "1 1 1"), 2, "has 3 numbers for " + std::to_string(input.size()));
  expect_failure(usual + file("word.txt", "1 2 three"), 2, "\"three\" for number 2");
  expect_failure(usual + file("zero.txt", "0" + text.substr(1)), 2, "vertex 0");
  expect_failure(usual + file("nan.txt", "nan" + text.substr(1)), 2, "vertex 0");
  expect_failure(usual + file("other.ply", header("double", "height") + ply + "3 0 1 2\n"), 2, "no vertex property");
  expect_failure(usual + file("broken.ply", "ply\n"), 2, "broken.ply");
}

// A tetrahedron: as PLY with a number and a colour at each vertex and a label at each face
TEST_F(Command_line, properties_of_a_ply_arrive)
{
  const std::string ply =
      file("t.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float heat\n"
                    "element face 4\nproperty list uchar int vertex_indices\nproperty int label\nend_header\n"
                    "0 0 0 9 9 9 0.5\n1 0 0 9 9 9 0.5\n0 1 0 9 9 9 0.5\n0 0 1 9 9 9 0.5\n"
                    "3 0 2 1 77\n3 0 1 3 77\n3 1 2 3 77\n3 2 0 3 77\n");
  ASSERT_EQ(run(ply + " " + output("o.ply") + " --vertices 50 --quiet --transfer").status, 0);
  const std::string text = contents(output("o.ply"));
  const std::size_t body = text.find("end_header\n") + std::strlen("end_header\n");
  for(const char* property : {"property float heat", "property uchar red", "property int label"})
    EXPECT_LT(text.find(property), body) << property;
  // coordinates, colour, number: every vertex has what all vertices of the input have
  const std::size_t size = 3 * sizeof(double) + 4 + sizeof(float);
  for(std::size_t v = 0; v < 50; ++v)
  {
    const char* const record = &text[body + v * size + 3 * sizeof(double)];
    float heat = 0.f;
    std::memcpy(&heat, record + 4, sizeof(heat));
    EXPECT_EQ(static_cast<int>(record[0]), 9);
    EXPECT_EQ(heat, .5f);
  }
  fs::remove(output("o.ply"));
  expect_failure(ply + " " + output() + " --vertices 50 --transfer", 1, "from .ply to .ply");
}

// Those that maps of the program or of CGAL might be called
TEST_F(Command_line, properties_of_a_ply_with_any_name_arrive_once)
{
  const std::string ply =
      file("t.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                    "property double location\nproperty int point\nproperty int index_in_file\n"
                    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                    "0 0 0 .5 7 8\n1 0 0 .5 7 8\n0 1 0 .5 7 8\n0 0 1 .5 7 8\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  ASSERT_EQ(run(ply + " " + output("o.ply") + " --vertices 50 --quiet --transfer").status, 0);
  std::istringstream header(contents(output("o.ply")));
  std::map<std::string, int> count;
  for(std::string line; std::getline(header, line) && line != "end_header";)
    ++count[line];
  for(const char* property : {"property double x", "property double y", "property double z", "property double location",
                              "property int point_in_file", "property int index_in_file"})
    EXPECT_EQ(count[property], 1) << property;
}

// The four faces of a tetrahedron beside each other in the texture: every edge is a seam
TEST_F(Command_line, texture_coordinates_of_an_obj_arrive_with_their_seams)
{
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for(int face = 0; face < 4; ++face)
    for(const char* corner : {" 0\n", ".25 0\n", ".5 1\n"})
      obj += "vt " + std::to_string(face) + corner;
  const std::string start = file("t.obj", obj + "f 1/1 3/2 2/3\nf 1/4 2/5 4/6\nf 2/7 3/8 4/9\nf 3/10 1/11 4/12\n");
  ASSERT_EQ(
      run(start + " " + output("o.obj") + " --vertices 200 --transfer --check --report " + output("r.json")).status, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(output("r.json")))["check"]["valid"], true);
  std::ifstream in(output("o.obj"));
  std::vector<double> u;
  std::size_t faces = 0;
  for(std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    double number = 0.;
    if(word == "vt" && words >> number)
      u.push_back(number);
    if(word != "f")
      continue;
    ++faces;
    std::array<int, 3> part{};
    for(int& p : part)
    {
      words >> word;
      p = static_cast<int>(u.at(std::stoul(word.substr(word.find('/') + 1)) - 1) + 1e-6);
    }
    EXPECT_TRUE(part[0] == part[1] && part[1] == part[2]) << line; // no face reaches over a seam
  }
  EXPECT_EQ(faces, 396u);
  fs::remove(output("o.obj"));
  fs::remove(output("r.json"));
  expect_failure(file("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n") + " " +
                     output("o.obj") + " --vertices 50 --transfer",
                 2, "without texture coordinates");
}

// Behind the coordinates, as many programs write them: with a colour that is linear in the coordinates, on each vertex
TEST_F(Command_line, colors_of_an_obj_arrive)
{
  const std::string start = file("c.obj", "v 0 0 0 .5 0 0\nv 1 0 0 1 0 0\nv 0 1 0 .5 1 0\nv 0 0 1 .5 0 1\n"
                                          "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  ASSERT_EQ(run(start + " " + output("o.obj") + " --vertices 60 --quiet --transfer").status, 0);
  std::ifstream in(output("o.obj"));
  std::size_t vertices = 0, faces = 0;
  for(std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    faces += word == "f";
    if(word != "v")
      continue;
    ++vertices;
    std::array<double, 6> x{};
    for(double& number : x)
      ASSERT_TRUE(words >> number) << line;
    EXPECT_NEAR(x[3], .5 + .5 * x[0], 1e-9);
    EXPECT_NEAR(x[4], x[1], 1e-9);
    EXPECT_NEAR(x[5], x[2], 1e-9);
  }
  EXPECT_EQ(vertices, 60u);
  EXPECT_EQ(faces, 116u);
}

TEST_F(Command_line, unreadable_input)
{
  expect_bad_input((folder / "missing.off").string(), "cannot be opened");
  expect_bad_input(folder.string(), "cannot be read");
  expect_bad_input(file("a.xyz", "0 0 0\n"), "cannot be read");
  expect_bad_input(file("a.off", "this is no mesh\n"), "cannot be read");
  expect_bad_input(file("truncated.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n"), "truncated.off");
  expect_bad_input(file("of_none.ply", "ply\nformat ascii 1.0\nproperty double x\nelement vertex 1\nend_header\n0\n"),
                   "of_none.ply");
  expect_bad_input(file("huge.ply", "ply\nformat ascii 1.0\nelement vertex 43333333333\nend_header\n"), "huge.ply");
  expect_bad_input(file("huge.off", "OFF\n4000000000000 4 0\n0 0 0\n1 0 0\n"), "huge.off");
  expect_bad_input(file("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "a.ply");
}

TEST_F(Command_line, empty_input)
{
  expect_bad_input(file("empty.off", ""), "empty.off");
  expect_bad_input(file("nothing.off", "OFF\n0 0 0\n"), "nothing.off");
  expect_bad_input(file("points.off", std::string("OFF\n4 0 0\n") + tetrahedron_points), "points.off");
}

TEST_F(Command_line, input_that_is_not_triangulated)
{
  const std::string pyramid = file("quad.off", "OFF\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n"
                                               "4 3 2 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n");
  const auto outcome = run(pyramid + " " + output() + " --vertices 200");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("triangulated 1 face with more than three vertices"), std::string::npos);
  EXPECT_NE(outcome.out.find("output         200       396      0      1"), std::string::npos);
  fs::remove(output());
  expect_failure(pyramid + " " + output() + " --vertices 200 --no-repair", 2, "face 0 has 4 vertices");
  expect_bad_input(file("twice.off", "OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n6 0 1 2 0 1 4\n"),
                   "face 0 has 6 vertices");
}

// The texture of a pyramid seen from above: its coordinates are those of the points, also where the base is divided.
TEST_F(Command_line, texture_coordinates_of_a_quadrilateral_arrive)
{
  const std::string start =
      file("p.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                    "f 1/1 2/2 5/1\nf 4/4 3/3 2/2 1/1\nf 2/2 3/3 5/1\nf 3/3 4/4 5/1\nf 4/4 1/1 5/1\n");
  ASSERT_EQ(run(start + " " + output("o.obj") + " --vertices 100 --quiet --transfer").status, 0);
  std::ifstream in(output("o.obj"));
  std::vector<std::array<double, 2>> points, texture;
  std::size_t corners = 0;
  for(std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    std::array<double, 2> at{};
    if(word == "v" || word == "vt")
    {
      words >> at[0] >> at[1];
      (word == "v" ? points : texture).push_back(at);
    }
    else if(word == "f")
      for(; words >> word; ++corners)
      {
        const auto& p = points.at(std::stoul(word) - 1);
        const auto& t = texture.at(std::stoul(word.substr(word.find('/') + 1)) - 1);
        EXPECT_NEAR(p[0], t[0], 1e-5) << line;
        EXPECT_NEAR(p[1], t[1], 1e-5) << line;
      }
  }
  EXPECT_EQ(corners, 3 * 196u);
}

TEST_F(Command_line, input_with_a_boundary)
{
  const std::string open =
      file("open.off", std::string("OFF\n4 3 0\n") + tetrahedron_points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n");
  EXPECT_EQ(run(open + " " + output() + " --vertices 200 --check --report " + output("r.json")).status, 0);
  const auto report = nlohmann::json::parse(contents(output("r.json")));
  EXPECT_EQ(report["input"]["boundary_loops"], 1);
  EXPECT_EQ(report["output"]["boundary_loops"], 1);
  EXPECT_EQ(report["check"]["valid"], true);
}

TEST_F(Command_line, protected_boundary_is_kept_exactly)
{
  const std::string open = mesh("nefertiti");
  ASSERT_EQ(run(open + " " + output() + " --vertices 500 --protect --quiet").status, 0);
  std::map<std::array<double, 3>, int> found;
  for(const auto& p : points_of_off(output()))
    ++found[p];
  int kept = 0;
  for(const auto& p : points_of_off(open))
    kept += found.count(p) != 0;
  EXPECT_GE(kept, boundary_vertices_of_off(open));
  fs::remove(output());
  expect_failure(open + " " + output() + " --vertices 30 --protect", 3,
                 "the corners and lines of the input need " + std::to_string(boundary_vertices_of_off(open)));
}

TEST_F(Command_line, fitted_mesh_is_nearer_and_said_to_be_fitted)
{
  const std::string input = mesh("eight");
  double rms[2];
  for(const bool fit : {false, true})
  {
    const Outcome outcome =
        run(input + " " + output() + " --vertices 500 --check --report " + output("r.json") + (fit ? " --fit" : ""));
    ASSERT_EQ(outcome.status, 0);
    const auto report = nlohmann::json::parse(contents(output("r.json")));
    EXPECT_EQ(report["fitted"], fit);
    EXPECT_EQ(report["check"]["valid"], true);
    EXPECT_EQ(report["seconds"].contains("fitting"), fit);
    EXPECT_EQ(outcome.out.find("fitted") != std::string::npos, fit);
    rms[fit] = report["output"]["rms_percent"];
  }
  EXPECT_LT(rms[1], .6 * rms[0]);
}

TEST_F(Command_line, features_are_kept)
{
  const std::string cube = mesh("cube");
  EXPECT_EQ(
      run(cube + " " + output() + " --vertices 500 --feature-angle 60 --check --report " + output("r.json")).status, 0);
  const auto report = nlohmann::json::parse(contents(output("r.json")));
  EXPECT_EQ(report["output"]["vertices"], 500);
  EXPECT_LT(report["output"]["hausdorff_percent"], 1e-6); // with all edges kept the surface is the same
  const std::string usual = cube + " " + output("other.off") + " --vertices 500 ";
  for(const char* wrong : {"--feature-angle 0", "--feature-angle 181", "--feature-angle nan", "--feature-angle sharp"})
    EXPECT_EQ(run(usual + wrong).status, 1) << wrong;
  EXPECT_EQ(run(usual + "--feature-angle 180").status, 0); // none are kept
  EXPECT_NE(contents(output("other.off")), contents(output()));
}

// The edges of its ends meet at 8.5 degrees.
TEST_F(Command_line, small_angles_of_a_wedge_are_told_apart)
{
  const std::string wedge = output("wedge.off");
  std::ofstream(wedge) << "OFF 6 8 0\n0 0 0\n1 0 0\n1 .15 0\n0 0 1\n1 0 1\n1 .15 1\n3 0 2 1\n3 3 4 5\n3 0 1 4\n"
                          "3 0 4 3\n3 1 2 5\n3 1 5 4\n3 2 0 3\n3 2 3 5\n";
  const Outcome outcome =
      run(wedge + " " + output() + " --vertices 300 --feature-angle 60 --report " + output("r.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto quality = nlohmann::json::parse(contents(output("r.json")))["output"];
  EXPECT_GE(quality["faces_below_20_between_lines"], 2);
  EXPECT_EQ(quality["faces_below_20"], quality["faces_below_20_between_lines"]);
  EXPECT_LT(quality["min_angle"], 9.);
  EXPECT_GT(quality["min_angle_elsewhere"], 20.);
  EXPECT_NE(outcome.out.find("between lines that meet"), std::string::npos);
}

TEST_F(Command_line, input_with_a_coordinate_that_is_not_finite)
{
  std::string ply = ply_of_off(
      file("t.off", std::string("OFF\n4 4 0\n") + tetrahedron_points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::size_t body = ply.find("end_header\n") + std::strlen("end_header\n");
  std::memcpy(&ply[body + 3 * sizeof(double)], &nan, sizeof(nan));
  expect_bad_input(file("nan.ply", ply), "vertex 1");
  expect_bad_input(file("nan.off", "OFF\n4 4 0\n0 0 0\nnan 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
                   "nan.off");
}

// Refused as it is, or repaired, which is told
TEST_F(Command_line, input_that_is_no_mesh_is_repaired_or_refused)
{
  const auto expect_repair = [&](const std::string& input, const std::string& fault, const std::string& repair) {
    expect_failure(input + " " + output() + " --vertices 100 --no-repair", 2, fault);
    const Outcome outcome = run(input + " " + output() + " --vertices 100 --check");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("repaired the input: " + repair), std::string::npos) << outcome.out;
    EXPECT_EQ(vertices_and_faces_of_off(output())[0], 100u);
    EXPECT_EQ(run(input + " " + output() + " --vertices 100 --quiet").out, "");
    fs::remove(output());
  };
  // two tetrahedra that share the vertex 0 only
  expect_repair(file("bowtie.off", "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
                                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 5 6 0\n"),
                "vertex 0", "duplicated 1 vertex");
  // two triangles that share it
  expect_repair(file("touching.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n"), "vertex 0",
                "duplicated 1 vertex");
  expect_repair(file("fin.off", "OFF\n5 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n"
                                "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 1 4\n"),
                "edge (0, 1) has 3 faces", "duplicated");
  expect_repair(
      file("turned.off", std::string("OFF\n4 4 0\n") + tetrahedron_points + "3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
      "not oriented", "turned");
  expect_repair(file("degenerate.off", std::string("OFF\n4 5 0\n") + tetrahedron_points +
                                           "3 0 2 1\n3 0 1 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"),
                "uses a vertex twice", "dropped 1 face with a vertex twice");
  expect_repair(file("twice.off", std::string("OFF\n4 5 0\n") + tetrahedron_points +
                                      "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 2 0 3\n"),
                "faces", "dropped 1 duplicate face");
  const std::string index =
      file("index.off", std::string("OFF\n4 4 0\n") + tetrahedron_points + "3 0 2 1\n3 0 1 7\n3 1 2 3\n3 2 0 3\n");
  expect_bad_input(index, "index.off");
}

namespace {

// The surface of cubes of a raster, a character each
std::string off_of_cubes(const std::array<const char*, 3>& layers, int width)
{
  const auto is_solid = [&](int x, int y, int z) {
    return x >= 0 && x < width && y >= 0 && y < width && z >= 0 && z < 3 && layers[z][x + width * y] == '#';
  };
  const int n = width + 1;
  std::ostringstream points, faces;
  int number = 0;
  for(int i = 0; i < n * n * 4; ++i)
    points << i % n << " " << i / n % n << " " << i / (n * n) << "\n";
  for(int i = 0; i < width * width * 3; ++i)
    for(int axis = 0; axis < 3; ++axis)
      for(const int side : {0, 1})
      {
        const std::array<int, 3> cube = {{i % width, i / width % width, i / (width * width)}};
        std::array<int, 3> other = cube, corner = cube;
        other[axis] += 2 * side - 1;
        corner[axis] += side;
        if(!is_solid(cube[0], cube[1], cube[2]) || is_solid(other[0], other[1], other[2]))
          continue;
        const std::array<int, 3> step = {{1, n, n * n}};
        const int v = corner[0] + n * (corner[1] + n * corner[2]);
        const int a = step[(axis + (side ? 1 : 2)) % 3], b = step[(axis + (side ? 2 : 1)) % 3];
        faces << "4 " << v << " " << v + a << " " << v + a + b << " " << v + b << "\n";
        ++number;
      }
  return "OFF\n" + std::to_string(n * n * 4) + " " + std::to_string(number) + " 0\n" + points.str() + faces.str();
}

} // namespace

// Cubes that touch along an edge stay solids: two of them, or one where others join them, with a handle
TEST_F(Command_line, solids_that_touch_along_an_edge_are_parted)
{
  const auto of_output = [&](const std::array<const char*, 3>& layers, int width) {
    const Outcome outcome = run(file("cubes.off", off_of_cubes(layers, width)) + " " + output() +
                                " --vertices 400 --check --report " + output("r.json"));
    EXPECT_NE(outcome.out.find("repaired the input: parted"), std::string::npos) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.find("NO"), std::string::npos) << outcome.out;
    const auto result = nlohmann::json::parse(contents(output("r.json")))["output"];
    return std::array<int, 3>{{result["components"], result["genus"], result["boundary_loops"]}};
  };
  using Shape = std::array<int, 3>;
  EXPECT_EQ(of_output({{"#..#", "....", "...."}}, 2), (Shape{{2, 0, 0}}));
  EXPECT_EQ(of_output({{"####", "#..#", "####"}}, 2), (Shape{{1, 1, 0}}));
  // around a vertex at which edges meet, along three of which cubes touch
  EXPECT_EQ(of_output({{"#..#", ".##.", "...."}}, 2), (Shape{{4, 0, 0}}));
  EXPECT_EQ(of_output({{"#########", "#.#.#.#.#", "#########"}}, 3), (Shape{{1, 4, 0}}));
}

// From a model of a robot's hip: two solids with walls in the same plane. Both halves of the edge between them must be
// parted alike, or they are halved again and again.
TEST_F(Command_line, an_edge_of_walls_in_one_plane_is_halved_once)
{
  const std::string walls =
      file("walls.off",
           "OFF\n11 11 0\n.101202 .00029 .013733\n.093 .00029 -.01\n.093 .00029 .01\n.093 -.00221 .01\n"
           ".0902 .00029 -.01\n.101402 .00029 -.013733\n.101402 .00029 .013733\n.0902 .00029 .01\n"
           ".0902 -.00171 -.01\n.093 -.00171 -.01\n.093 -.00171 .01\n"
           "3 0 1 2\n3 1 3 2\n3 4 5 1\n3 1 5 6\n3 1 6 2\n3 2 6 7\n3 4 1 8\n3 8 1 9\n3 2 7 10\n3 1 2 9\n3 9 2 10\n");
  const Outcome outcome = run(walls + " " + output() + " --vertices 100 --check --report " + output("r.json"));
  EXPECT_NE(outcome.out.find("parted 1 edge with four faces or more"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("NO"), std::string::npos) << outcome.out;
  EXPECT_EQ(nlohmann::json::parse(contents(output("r.json")))["input"]["vertices"], 13);
}

TEST_F(Command_line, branching_surface_is_cut_open)
{
  const std::string fin = file("fin.off", "OFF\n6 4 0\n0 0 0\n0 1 0\n1 0 0\n-1 0 0\n0 0 1\n0 1 1\n"
                                          "3 0 2 1\n3 0 1 3\n3 0 4 1\n3 1 4 5\n");
  const Outcome outcome = run(fin + " " + output() + " --vertices 100 --check --report " + output("r.json"));
  EXPECT_NE(outcome.out.find("cut open 1 edge with three faces or more"), std::string::npos) << outcome.out;
  EXPECT_EQ(nlohmann::json::parse(contents(output("r.json")))["output"]["components"], 3);
}

namespace {

// The faces of an OFF file of triangles, each with vertices of its own, which are moved a little
std::string as_soup(const std::string& off, double distance)
{
  std::istringstream in(off);
  std::string word;
  std::size_t vertices, faces, edges, n;
  in >> word >> vertices >> faces >> edges;
  std::vector<std::array<double, 3>> points(vertices);
  for(auto& p : points)
    in >> p[0] >> p[1] >> p[2];
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << 3 * faces << " " << faces << " 0\n";
  for(std::size_t i = 0; i < 3 * faces; ++i)
  {
    std::size_t v;
    in >> (i % 3 == 0 ? n : v);
    if(i % 3 == 0)
      in >> v;
    out << points[v][0] + distance * std::sin(double(i)) << " " << points[v][1] << " " << points[v][2] << "\n";
  }
  for(std::size_t i = 0; i < faces; ++i)
    out << "3 " << 3 * i << " " << 3 * i + 1 << " " << 3 * i + 2 << "\n";
  return out.str();
}

} // namespace

// Two cubes, each face with points of its own, that have a wall in common: both go, and the rest is one solid. Of a
// solid that is there twice one is left.
TEST_F(Command_line, walls_between_solids_are_dropped)
{
  const std::string faces = "3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4\n3 2 6 3\n3 3 6 7\n"
                            "3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5\n";
  std::ostringstream points, mirrored;
  for(const int sign : {1, -1})
    for(int i = 0; i < 8; ++i)
      points << sign * (i >> 2) << " " << (i >> 1) % 2 << " " << i % 2 << "\n";
  std::istringstream in(faces);
  for(int n, a, b, c; in >> n >> a >> b >> c;)
    mirrored << "3 " << a + 8 << " " << c + 8 << " " << b + 8 << "\n";
  const auto length_of = [&](const std::string& second) {
    const std::string soup = as_soup("OFF\n16 24 0\n" + points.str() + faces + second, 0.);
    const Outcome outcome = run(file("soup.off", soup) + " " + output() +
                                " --vertices 500 --feature-angle 60 --check --report " + output("r.json"));
    EXPECT_EQ(outcome.out.find("NO"), std::string::npos) << outcome.out;
    const auto result = nlohmann::json::parse(contents(output("r.json")))["output"];
    EXPECT_EQ(result["components"], 1);
    EXPECT_EQ(result["genus"], 0);
    EXPECT_EQ(result["boundary_loops"], 0);
    double low = 0., high = 0.;
    for(const auto& p : points_of_off(output()))
    {
      low = (std::min)(low, p[0]);
      high = (std::max)(high, p[0]);
    }
    return high - low;
  };
  EXPECT_NEAR(length_of(mirrored.str()), 2., 1e-9);
  EXPECT_NEAR(length_of(faces), 1., 1e-9);
}

TEST_F(Command_line, faces_with_points_of_their_own_are_joined)
{
  const std::string soup =
      file("soup.off", "OFF\n12 4 0\n0 0 0\n0 1 0\n1 0 0\n0 0 0\n1 0 0\n0 0 1\n1 0 0\n0 1 0\n0 0 1\n"
                       "0 1 0\n0 0 0\n0 0 1\n3 0 1 2\n3 3 4 5\n3 6 7 8\n3 9 10 11\n");
  const Outcome outcome = run(soup + " " + output() + " --vertices 100 --report " + output("r.json"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("merged 8 duplicate points"), std::string::npos) << outcome.out;
  EXPECT_EQ(nlohmann::json::parse(contents(output("r.json")))["output"]["boundary_loops"], 0);
  // as they are, four pieces
  EXPECT_EQ(run(soup + " " + output() + " --vertices 100 --no-repair --report " + output("r.json")).status, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(output("r.json")))["output"]["boundary_loops"], 4);
}

TEST_F(Command_line, one_sided_surface_is_refused)
{
  // a strip of five triangles with half a turn
  expect_bad_input(file("moebius.off", "OFF\n5 5 0\n1 0 0\n0 1 1\n-1 0 0\n0 -1 1\n1 1 2\n"
                                       "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n"),
                   "one side only");
}

TEST_F(Command_line, fewer_vertices_than_the_topology_needs)
{
  expect_failure(mesh("eight") + " " + output() + " --vertices 4", 3, "");
}

TEST_F(Command_line, output_that_cannot_be_written)
{
  const std::string input = mesh("eight");
  expect_failure(input + " " + output("no/such/folder/out.off") + " --vertices 100", 3, "cannot be written");
  expect_failure(input + " " + output("out.xyz") + " --vertices 100", 3, "cannot be written");
  expect_failure(input + " " + output("out") + " --vertices 100", 3, "cannot be written");
  expect_failure(input + " " + output() + " --vertices 100 --report " + output("no/r.json"), 3, "cannot be written");
  expect_failure(input + " " + output() + " --vertices 100 --report " + output(), 1, "twice");
  fs::create_directory(folder / "folder.off");
  expect_failure(input + " " + (folder / "folder.off").string() + " --vertices 100", 3, "not a regular file");
}

TEST_F(Command_line, output_of_before_survives_a_failure)
{
  const std::string kept = file("kept.off", "something");
  EXPECT_EQ(run(mesh("eight") + " " + kept + " --vertices 4").status, 3);
  EXPECT_EQ(contents(kept), "something");
}

// Two halves of a box, a little apart: nothing but --stitch joins them
TEST_F(Command_line, boundaries_are_stitched_within_a_tolerance)
{
  const std::string halves =
      file("halves.off", "OFF\n8 8 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 .01\n1 0 .01\n1 1 .01\n0.5 .5 1\n"
                         "3 0 2 1\n3 0 3 2\n3 4 5 7\n3 5 6 7\n3 6 2 7\n3 2 3 7\n3 3 4 7\n3 2 6 1\n");
  const auto loops = [&](const std::string& options) {
    const Outcome outcome =
        run(halves + " " + output() + " --vertices 100 --check --report " + output("r.json") + options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(contents(output("r.json")))["output"]["boundary_loops"].get<int>();
  };
  EXPECT_GT(loops(""), 0);
  EXPECT_GT(loops(" --stitch 0.009"), 0);
  EXPECT_EQ(loops(" --stitch 0.011"), 0);
  EXPECT_NE(run(halves + " " + output() + " --vertices 100 --stitch 0.011").out.find("stitched 2 vertices"),
            std::string::npos);
  const std::string triangle = file("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Outcome nothing = run(triangle + " " + output() + " --vertices 100 --stitch 10");
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE(nothing.err.find("has no face left after stitching"), std::string::npos) << nothing.err;
  for(const char* wrong : {" --stitch 0", " --stitch -1", " --stitch nan", " --stitch 1 --no-repair"})
    EXPECT_EQ(run(halves + " " + output() + " --vertices 100" + wrong).status, 1) << wrong;
}

// Two squares side by side, the side between them divided into twenty edges of one and a single edge of the other; and
// the other way around, with both sides of the second one
TEST_F(Command_line, edges_are_divided_where_vertices_of_other_pieces_are)
{
  const int n = 20;
  std::ostringstream points, faces;
  points << "0 0 0\n0 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n";
  for(const double x : {1., 2.}) // vertices 6 to 26 and 27 to 47
    for(int i = 0; i <= n; ++i)
      points << x << " " << i / double(n) << " 0\n";
  points << "3 0 0\n3 1 0\n";
  faces << "3 2 3 4\n3 2 4 5\n3 0 26 1\n3 48 49 47\n";
  for(int i = 0; i < n; ++i)
    faces << "3 0 " << 6 + i << " " << 7 + i << "\n3 48 " << 28 + i << " " << 27 + i << "\n";
  const std::string pieces =
      file("pieces.off", "OFF\n50 " + std::to_string(4 + 2 * n) + " 0\n" + points.str() + faces.str());
  const auto parts = [&](const std::string& options) {
    const Outcome outcome =
        run(pieces + " " + output() + " --vertices 300 --check --report " + output("r.json") + options);
    EXPECT_EQ(outcome.out.find("NO"), std::string::npos) << outcome.out << outcome.err;
    const auto result = nlohmann::json::parse(contents(output("r.json")))["output"];
    return std::make_pair(result["components"].get<int>(), result["boundary_loops"].get<int>());
  };
  EXPECT_EQ(parts(""), std::make_pair(3, 3));
  EXPECT_EQ(parts(" --stitch .001"), std::make_pair(1, 1));
  const std::string command = pieces + " " + output() + " --vertices 300";
  EXPECT_NE(run(command).err.find("hint: 38 of the 50 vertices of the boundary are on edges of it (--stitch "),
            std::string::npos)
      << run(command).err;
  const Outcome stitched = run(command + " --stitch .001");
  EXPECT_EQ(stitched.err, "");
  EXPECT_NE(stitched.out.find("divided edges of the boundary at 38 vertices of others"), std::string::npos);
}

// A tetrahedron without its base, a thousandth of the area beside it: a hole and a splinter, as scans have them
TEST_F(Command_line, holes_are_filled_and_small_parts_dropped)
{
  const std::string scan = file("scan.off", "OFF\n7 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 0 0\n2.05 0 0\n2 .05 0\n"
                                            "3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 5 6\n");
  const auto of_output = [&](const std::string& options) {
    const Outcome outcome = run(scan + " " + output() + " --vertices 100 --report " + output("r.json") + options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto result = nlohmann::json::parse(contents(output("r.json")))["output"];
    return std::make_pair(result["components"].get<int>(), result["boundary_loops"].get<int>());
  };
  EXPECT_EQ(of_output(""), std::make_pair(2, 2));
  EXPECT_EQ(of_output(" --drop-parts 0.01"), std::make_pair(2, 2)); // the splinter is larger
  EXPECT_EQ(of_output(" --drop-parts 1"), std::make_pair(1, 1));
  EXPECT_EQ(of_output(" --drop-parts 99.9"), std::make_pair(1, 1)); // the largest stays
  EXPECT_EQ(of_output(" --drop-parts 1 --fill-holes 3"), std::make_pair(1, 0));
  const std::string told = run(scan + " " + output() + " --vertices 100 --drop-parts 1 --fill-holes 3").out;
  EXPECT_NE(told.find("dropped 1 small part"), std::string::npos) << told;
  EXPECT_NE(told.find("filled 1 hole"), std::string::npos) << told;
  for(const char* wrong : {" --drop-parts 0", " --drop-parts 100", " --drop-parts nan", " --fill-holes 2",
                           " --fill-holes 3 --no-repair", " --drop-parts 1 --no-repair"})
    EXPECT_EQ(run(scan + " " + output() + " --vertices 100" + wrong).status, 1) << wrong;
  // an edge without length in the boundary: such a hole once became a face with four vertices
  const std::string slit = file("slit.off", "OFF\n5 4 0\n0 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                            "3 1 0 4\n3 0 2 4\n3 2 3 4\n3 3 1 4\n");
  EXPECT_EQ(run(slit + " " + output() + " --vertices 60 --fill-holes 4").status, 0);
}

namespace {

// A rectangle of 30 x 30 pieces, one of its points elsewhere
std::string off_of_sheet(double length, double height)
{
  std::ostringstream points, faces;
  for(int i = 0; i <= 30; ++i)
    for(int j = 0; j <= 30; ++j)
      points << length * i / 30. << " " << j / 30. << " " << (i == 12 && j == 17 ? height : 0.) << "\n";
  for(int v = 0; v < 30 * 31; ++v)
    if(v % 31 < 30)
      faces << "4 " << v << " " << v + 31 << " " << v + 32 << " " << v + 1 << "\n";
  return "OFF\n961 900 0\n" + points.str() + faces.str();
}

// A sheet of 30 x 15 pieces, folded in the middle to two layers nearly on each other
std::string off_of_folded_cloth()
{
  std::ostringstream points, faces;
  for(int i = 0; i <= 30; ++i)
    for(int j = 0; j <= 15; ++j)
      points << std::abs(i - 15) / 15. << " " << j / 15. << " " << (i < 15 ? 0. : .005) << "\n";
  for(int v = 0; v < 30 * 16; ++v)
    if(v % 16 < 15)
      faces << "4 " << v << " " << v + 16 << " " << v + 17 << " " << v + 1 << "\n";
  return "OFF\n496 450 0\n" + points.str() + faces.str();
}

} // namespace

// What a scan or another program has left is seen, and the option that is named mends it.
TEST_F(Command_line, hints_at_options_that_mend_the_input)
{
  const auto hint = [&](const std::string& input, const std::string& options) {
    return run(input + " " + output() + " --vertices 300" + options).err;
  };
  const std::string whole = contents(MESHES_FOLDER "/eight.off");
  const std::string soup = file("soup.off", as_soup(whole, 1e-6));
  const std::string scan = file("scan.off", "OFF\n7 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 0 0\n2.01 0 0\n2 .01 0\n"
                                            "3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 5 6\n");
  std::string pierced = whole.substr(0, whole.find_last_not_of(" \r\n") + 1); // without the last face
  const std::size_t last = pierced.find_last_of("\n");
  std::string header;
  std::size_t vertices, faces, edges;
  std::istringstream(pierced) >> header >> vertices >> faces >> edges;
  const std::string numbers = std::to_string(vertices) + " " + std::to_string(faces) + " ";
  ASSERT_NE(pierced.find(numbers), std::string::npos);
  pierced = pierced.substr(0, last + 1)
                .replace(pierced.find(numbers), numbers.size(),
                         std::to_string(vertices) + " " + std::to_string(faces - 1) + " ");
  const std::string hole = file("hole.off", pierced);
  EXPECT_EQ(hint(mesh("eight"), ""), "");
  EXPECT_NE(hint(soup, "").find("hint: 1902 of the 1902 vertices of the boundary"), std::string::npos)
      << hint(soup, "");
  EXPECT_EQ(hint(soup, " --stitch 2.1e-06"), "");
  EXPECT_EQ(hint(scan, ""), "geodesic_remesh: hint: 1 of the 2 parts is smaller than four of the new triangles "
                            "(--drop-parts 0.0027 leaves it out)\n");
  EXPECT_EQ(hint(scan, " --drop-parts 0.0027"), "");
  EXPECT_EQ(hint(hole, ""), "geodesic_remesh: hint: 1 hole is no longer around than four of the new edges "
                            "(--fill-holes 3 closes it)\n");
  EXPECT_EQ(hint(hole, " --fill-holes 3"), "");
  EXPECT_EQ(hint(hole, " --quiet"), "");
  EXPECT_EQ(hint(file("cloth.off", off_of_folded_cloth()), ""), ""); // whose layers are near to each other
  EXPECT_EQ(hint(file("band.off", off_of_sheet(1e3, 0.)), ""), "");  // whose sides are near to each other for its edges
  // a point far away makes the new edges so long that four would go around the sheet
  EXPECT_EQ(hint(file("spike.off", off_of_sheet(1., 1e4)), "").find("hint"), std::string::npos);
  EXPECT_EQ(hint(mesh("rotor"), ""),
            "geodesic_remesh: hint: sharp edges of the input are cut off (--feature-angle 60 keeps them)\n");
  EXPECT_EQ(hint(mesh("rotor"), " --feature-angle 60"), "");
  EXPECT_EQ(hint(mesh("nefertiti"), ""), ""); // a long boundary is kept anyway
}

namespace {

// Two pieces of round walls, the outer one higher
std::string off_of_walls(double gap, double shift)
{
  std::ostringstream points, faces;
  for(const double radius : {.3, .3 + gap})
    for(int i = 0; i <= 40; ++i)
      for(int j = 0; j <= 10; ++j)
        points << radius * std::cos(.05 * i) + (radius > .3 ? shift : 0.) << " " << radius * std::sin(.05 * i) << " "
               << (radius > .3 ? .2 : .1) * j << "\n";
  for(int f = 0; f < 800; ++f)
  {
    const int v = f / 400 * 451 + f % 400 / 10 * 11 + f % 10;
    faces << "4 " << v << " " << v + 11 << " " << v + 12 << " " << v + 1 << "\n";
  }
  return "OFF\n902 800 0\n" + points.str() + faces.str();
}

} // namespace

// As the improvement finds a way where there is one, without it. The number that is named is one that does.
// The exit status tells it, too: also where nothing else is told.
TEST_F(Command_line, check_that_finds_a_fault)
{
  const std::string walls =
      file("walls.off", off_of_walls(.015, 0.)) + " " + output() + " --vertices 40 --iterations 0";
  EXPECT_EQ(run(walls).status, 0);
  const Outcome outcome = run(walls + " --check");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.out.find("no self-intersection  NO"), std::string::npos) << outcome.out;
  EXPECT_EQ(run(walls + " --check --quiet").status, 4);
  EXPECT_EQ(vertices_and_faces_of_off(output())[0], 40u);
}

// Vertices are on the surface up to the rounding of coordinates that are large.
TEST_F(Command_line, check_far_from_the_origin)
{
  std::istringstream eight(contents(MESHES_FOLDER "/eight.off"));
  std::ostringstream far;
  std::string header;
  std::size_t vertices, faces, edges;
  eight >> header >> vertices >> faces >> edges;
  far << "OFF\n" << vertices << " " << faces << " 0\n" << std::setprecision(17);
  for(std::size_t i = 0; i < vertices; ++i)
  {
    double x, y, z;
    eight >> x >> y >> z;
    far << 1e8 + x << " " << 1e8 + y << " " << 1e8 + z << "\n";
  }
  far << eight.rdbuf();
  const std::string input = file("far.off", far.str());
  EXPECT_EQ(run(input + " " + output() + " --vertices 500 --check --report " + output("r.json")).status, 0);
  const auto check = nlohmann::json::parse(contents(output("r.json")))["check"];
  EXPECT_EQ(check["on_surface"], true);
  EXPECT_EQ(check["lines_covered"], true);
  EXPECT_GT(check["distance"].get<double>(), 1e-9);
}

// A sheet, two of whose sides are divided a hundred times as finely as it is to be
TEST_F(Command_line, hints_at_short_edges_that_are_kept)
{
  std::ostringstream points, faces;
  constexpr int n = 200;
  for(int i = 0; i <= n; ++i)
    points << i << " 0 0\n" << i << " 200 0\n";
  for(int i = 0; i < n; ++i)
    faces << "3 " << 2 * i << " " << 2 * i + 2 << " " << 2 * i + 1 << "\n3 " << 2 * i + 1 << " " << 2 * i + 2 << " "
          << 2 * i + 3 << "\n";
  const std::string sheet = file("sheet.off", "OFF\n402 400 0\n" + points.str() + faces.str()) + " " + output();
  EXPECT_NE(run(sheet + " --vertices 900 --protect").err.find("400 of the edges kept are shorter than a fifth"),
            std::string::npos);
  EXPECT_EQ(run(sheet + " --vertices 900").err.find("edges kept"), std::string::npos);
}

// A comb of plates with sharp edges, and a few vertices
TEST_F(Command_line, hints_at_more_lines_than_vertices_can_follow)
{
  std::ostringstream points, faces;
  constexpr int n = 60;
  for(int i = 0; i <= n; ++i)
    points << i << " 0 " << i % 2 << "\n" << i << " 60 " << i % 2 << "\n";
  for(int i = 0; i < n; ++i)
    faces << "4 " << 2 * i << " " << 2 * i + 2 << " " << 2 * i + 3 << " " << 2 * i + 1 << "\n";
  const std::string folds = file("folds.off", "OFF\n122 60 0\n" + points.str() + faces.str()) + " " + output();
  const auto is_told = [&](const std::string& options) {
    return run(folds + options).err.find("vertices lie on lines, which leaves few") != std::string::npos;
  };
  EXPECT_TRUE(is_told(" --vertices 400 --feature-angle 60"));
  EXPECT_FALSE(is_told(" --vertices 400 --feature-angle 100"));
  EXPECT_FALSE(is_told(" --vertices 40000 --feature-angle 60"));
  EXPECT_FALSE(is_told(" --vertices 400 --feature-angle 60 --quiet"));
}

TEST_F(Command_line, hints_at_thin_places)
{
  const auto hint = [&](const std::string& off, const std::string& target) {
    return run(file("walls.off", off) + " " + output() + target + " --iterations 0").err;
  };
  const std::string thin = off_of_walls(.015, 0.), said = hint(thin, " --vertices 40");
  const std::size_t number = said.find(" --vertices"), end = said.find(", with");
  ASSERT_NE(end, std::string::npos) << said;
  EXPECT_NE(said.find("pairs of faces intersect: walls or gaps are thinner than edges are long there (about --ver"),
            std::string::npos)
      << said;
  EXPECT_EQ(hint(thin, said.substr(number, end - number)), "");
  EXPECT_NE(hint(thin, " --edge-length .25").find("(about --edge-length 0.0"), std::string::npos);
  EXPECT_NE(hint(off_of_walls(1e-5, 0.), " --vertices 400").find("which no number of vertices parts"),
            std::string::npos);
  EXPECT_NE(hint(off_of_walls(.015, .05), " --vertices 400").find("the input intersects itself there"),
            std::string::npos);
  // Two hundred pages of a book along one edge, where each new face meets hundreds of others
  std::ostringstream points, faces;
  for(int i = 0; i < 200; ++i)
  {
    points << std::cos(.03 * i) << " " << std::sin(.03 * i) << " .5\n";
    faces << "3 0 1 " << i + 2 << "\n";
  }
  EXPECT_NE(hint("OFF\n202 200 0\n0 0 0\n0 0 1\n" + points.str() + faces.str(), " --vertices 2000")
                .find("the input intersects itself there"),
            std::string::npos);
}

// Cut off anywhere or with a bit turned over anywhere: a mesh, or one line that says what is wrong
TEST_F(Command_line, damaged_files)
{
  EXPECT_EQ(run(mesh("eight") + " '" + (folder / "small.off").string() + "' --vertices 40").status, 0);
  for(const std::string ending : {"off", "obj", "ply", "stl", "ts"})
  {
    const std::string whole = (folder / ("whole." + ending)).string();
    ASSERT_EQ(run((folder / "small.off").string() + " '" + whole + "' --vertices 40 --iterations 0").status, 0);
    const std::string bytes = contents(whole);
    std::vector<std::string> damaged;
    for(const double part : {.01, .1, .5, .9, .99})
      damaged.push_back(bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
    for(const std::size_t at : {0, 5, 10, 83})
      (damaged.emplace_back(bytes), damaged.back()[at] ^= 4);
    for(const double part : {.25, .5, .75, .95})
      (damaged.emplace_back(bytes),
       damaged.back()[static_cast<std::size_t>(part * static_cast<double>(bytes.size()))] ^= 64);
    for(std::size_t i = 0; i < damaged.size(); ++i)
    {
      const std::string name = file("damaged." + ending, damaged[i]);
      const Outcome outcome = run("'" + name + "' '" + output() + "' --vertices 60 --quiet");
      EXPECT_TRUE(outcome.status == 0 || outcome.status == 2 || outcome.status == 3)
          << name << " " << i << ": " << outcome.status << outcome.err;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), outcome.status == 0 ? 0 : 1) << outcome.err;
      EXPECT_EQ(fs::is_empty(folder / "written"), outcome.status != 0) << name << " " << i;
      fs::remove(output());
    }
  }
}

TEST_F(Command_line, input_without_permission)
{
  if(geteuid() == 0)
    GTEST_SKIP() << "root may read everything";
  const std::string secret = file("secret.off", "OFF\n0 0 0\n");
  fs::permissions(secret, fs::perms::none);
  expect_bad_input(secret, "cannot be opened");
}

// No more than a few blocks may be written: what a full disk looks like, without one. The old file stays, and nothing
// beside it.
TEST_F(Command_line, output_that_does_not_fit)
{
  const std::string kept = (folder / "written" / "kept.off").string();
  std::ofstream(kept) << "something";
  const std::string command = std::string("ulimit -f 1; '") + GEODESIC_REMESH_PROGRAM + "' " + mesh("eight") + " '" +
                              kept + "' --vertices 5000 --iterations 0 --quiet 2>&1 | cat >'" +
                              (folder / "stderr").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_NE(contents(folder / "stderr").find("cannot be written: File too large"), std::string::npos)
      << contents(folder / "stderr");
  EXPECT_EQ(contents(kept), "something");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "written"), fs::directory_iterator()), 1);
}

TEST_F(Command_line, standard_output_that_is_full)
{
  if(!fs::exists("/dev/full"))
    GTEST_SKIP() << "no /dev/full";
  const std::string command = std::string("'") + GEODESIC_REMESH_PROGRAM + "' " + mesh("eight") + " '" + output() +
                              "' --vertices 100 >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 3);
}

TEST_F(Command_line, output_through_a_link_keeps_the_link_and_the_permissions)
{
  const std::string target = file("target.off", "something");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(target, output());
  EXPECT_EQ(run(mesh("eight") + " " + output() + " --vertices 100").status, 0);
  EXPECT_TRUE(fs::is_symlink(output()));
  EXPECT_EQ(vertices_and_faces_of_off(target)[0], 100u);
  EXPECT_EQ(fs::status(target).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Command_line, output_through_a_link_to_nothing)
{
  fs::create_directory(folder / "there");
  fs::create_symlink(folder / "there" / "new.off", folder / "link.off");
  EXPECT_EQ(run(mesh("eight") + " " + (folder / "link.off").string() + " --vertices 100").status, 0);
  EXPECT_EQ(vertices_and_faces_of_off((folder / "there" / "new.off").string())[0], 100u);
  fs::create_symlink(folder / "nowhere" / "new.off", folder / "lost.off");
  expect_failure(mesh("eight") + " " + (folder / "lost.off").string() + " --vertices 100000000", 3,
                 "cannot be written");
}

TEST_F(Command_line, one_file_for_two_results_is_refused)
{
  const std::string kept = file("kept.off", "something");
  fs::create_symlink(kept, folder / "link.off");
  for(const std::string& other : {kept, folder.string() + "/./kept.off", (folder / "link.off").string(),
                                  (folder / "written" / ".." / "kept.off").string()})
  {
    const std::string target = mesh("eight") + " " + kept;
    expect_failure(target + " --vertices 100 --report " + other, 1, "is asked for twice");
    EXPECT_EQ(contents(kept), "something");
  }
  EXPECT_EQ(run(mesh("eight") + " " + kept + " --vertices 100 --report " + (folder / "kept.json").string()).status, 0);
}

TEST_F(Command_line, input_through_a_pipe)
{
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string feed = "cat " + mesh("eight") + " >" + pipe + " &";
  ASSERT_EQ(std::system(feed.c_str()), 0);
  EXPECT_EQ(run(pipe + " " + output() + " --vertices 100 --input-format off").status, 0);
  EXPECT_EQ(vertices_and_faces_of_off(output())[0], 100u);
}

TEST_F(Command_line, stl_in_capital_letters)
{
  ASSERT_EQ(run(mesh("eight") + " " + output("o.off") + " --vertices 100").status, 0);
  std::ostringstream stl;
  stl << "SOLID EIGHT\n";
  std::ifstream off(output("o.off"));
  std::string word;
  std::size_t vertices, faces, edges;
  off >> word >> vertices >> faces >> edges;
  std::vector<std::array<std::string, 3>> points(vertices);
  for(auto& p : points)
    off >> p[0] >> p[1] >> p[2];
  for(std::size_t f = 0; f < faces; ++f)
  {
    std::size_t three, v;
    off >> three;
    stl << "  FACET NORMAL 0 0 1\n    OUTER LOOP\n";
    for(int i = 0; i < 3; ++i)
    {
      off >> v;
      stl << "      VERTEX " << points[v][0] << " " << points[v][1] << " " << points[v][2] << "\n";
    }
    stl << "    ENDLOOP\n  ENDFACET\n";
  }
  stl << "ENDSOLID\n";
  const std::string report = output("r.json");
  EXPECT_EQ(run(file("capital.stl", stl.str()) + " " + output() + " --vertices 200 --report " + report).status, 0);
  EXPECT_EQ(nlohmann::json::parse(contents(report))["input"]["vertices"], 100);
  EXPECT_EQ(nlohmann::json::parse(contents(report))["input"]["boundary_loops"], 0);
}

TEST_F(Command_line, more_threads_than_anyone_has)
{
  const Outcome outcome = run(mesh("eight") + " " + output() + " --vertices 100 --threads 9223372036854775807");
  EXPECT_EQ(outcome.status, outcome.err.find("without TBB") == std::string::npos ? 0 : 1) << outcome.err;
}

// The signal comes while the temporary file of the output is there and the remeshing, of some seconds, goes on.
TEST_F(Command_line, interruption_leaves_nothing)
{
  const std::string input = mesh("eight"), target = (folder / "written" / "kept.off").string();
  for(const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    std::ofstream(target) << "something";
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if(child == 0)
    {
      ::signal(signal, SIG_DFL);
      execl(GEODESIC_REMESH_PROGRAM, "geodesic_remesh", input.c_str(), target.c_str(), "--vertices", "300000",
            "--quiet", nullptr);
      _exit(127);
    }
    const auto files = [&] {
      return std::distance(fs::directory_iterator(folder / "written"), fs::directory_iterator());
    };
    while(files() < 2 && waitpid(child, nullptr, WNOHANG) == 0)
      usleep(1000);
    EXPECT_EQ(files(), 2);
    kill(child, signal);
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(contents(target), "something");
    EXPECT_EQ(files(), 1);
  }
}
