// Writes what the stages of CGAL::geodesic_remeshing() make of a mesh as VTK files, for the figures of the manual:
//
//   geodesic_remeshing_stages INPUT.off NUMBER_OF_VERTICES FOLDER yes|no CONTRAST
//
// The fourth argument tells whether to segment, the last one how much the lengths differ by curvature. The files in FOLDER are input, distances, regions, curves, samples, strips and
// output, all with the extension vtk.

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/geodesic_remeshing.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Stage_results = CGAL::Geodesic_remeshing::Stage_results;
using Point = Stage_results::Point;
using Mesh = Stage_results::Mesh;
using Polylines = std::vector<std::vector<Point>>;

class Vtk_file
{
public:
  Vtk_file(const std::string& name, const std::vector<Point>& points) : m_out(name)
  {
    m_out.exceptions(std::ios::failbit | std::ios::badbit);
    m_out.precision(10);
    m_out << "# vtk DataFile Version 3.0\n"
          << name << "\nASCII\nDATASET POLYDATA\nPOINTS " << points.size() << " double\n";
    for(const Point& p : points)
      m_out << p << "\n";
  }

  // kind: POLYGONS, LINES or VERTICES
  void write_cells(const std::string& kind, const std::vector<std::vector<std::size_t>>& cells)
  {
    std::size_t size = cells.size();
    for(const auto& cell : cells)
      size += cell.size();
    m_out << kind << " " << cells.size() << " " << size << "\n";
    for(const auto& cell : cells)
    {
      m_out << cell.size();
      for(const std::size_t i : cell)
        m_out << " " << i;
      m_out << "\n";
    }
  }

  // where: POINT_DATA or CELL_DATA
  void write_values(const std::string& where, const std::vector<double>& values)
  {
    m_out << where << " " << values.size() << "\nSCALARS value double 1\nLOOKUP_TABLE default\n";
    for(const double value : values)
      m_out << value << "\n";
  }

private:
  std::ofstream m_out;
};

std::vector<Point> points_of(const Mesh& mesh)
{
  std::vector<Point> result;
  for(const auto v : mesh.vertices())
    result.push_back(mesh.point(v));
  return result;
}

std::vector<std::vector<std::size_t>> faces_of(const Mesh& mesh)
{
  std::vector<std::vector<std::size_t>> result;
  for(const auto f : mesh.faces())
  {
    result.emplace_back();
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      result.back().push_back(v);
  }
  return result;
}

void write_mesh(const std::string& name, const Mesh& mesh)
{
  Vtk_file(name, points_of(mesh)).write_cells("POLYGONS", faces_of(mesh));
}

void write_distances(const std::string& name, const Mesh& mesh)
{
  const auto distance = mesh.property_map<Mesh::Vertex_index, double>("v:distance").value();
  Vtk_file file(name, points_of(mesh));
  file.write_cells("POLYGONS", faces_of(mesh));
  file.write_values("POINT_DATA", {distance.begin(), distance.end()});
}

// For each region, in their order, the color least used so far that none of its neighbors has
std::vector<double> color_regions(const Mesh& mesh, const Mesh::Property_map<Mesh::Face_index, int>& region)
{
  constexpr std::size_t number_of_colors = 8;
  std::vector<std::set<int>> earlier_neighbors(1 + *std::max_element(region.begin(), region.end()));
  for(const auto h : mesh.halfedges())
    if(region[mesh.face(mesh.opposite(h))] < region[mesh.face(h)])
      earlier_neighbors[region[mesh.face(h)]].insert(region[mesh.face(mesh.opposite(h))]);
  std::vector<double> colors;
  std::vector<std::size_t> uses(number_of_colors, 0);
  for(const auto& neighbors : earlier_neighbors)
  {
    std::vector<std::size_t> cost = uses;
    for(const int i : neighbors)
      cost[static_cast<std::size_t>(colors[i])] += mesh.number_of_faces();
    const auto color = std::min_element(cost.begin(), cost.end()) - cost.begin();
    ++uses[color];
    colors.push_back(static_cast<double>(color));
  }
  return colors;
}

void write_regions(const std::string& name, const Mesh& mesh)
{
  const auto region = mesh.property_map<Mesh::Face_index, int>("f:region").value();
  const std::vector<double> colors = color_regions(mesh, region);
  std::vector<double> color_of_face;
  for(const auto f : mesh.faces())
    color_of_face.push_back(colors[region[f]]);
  Vtk_file file(name, points_of(mesh));
  file.write_cells("POLYGONS", faces_of(mesh));
  file.write_values("CELL_DATA", color_of_face);
}

void write_polylines(const std::string& name, const Polylines& polylines)
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> cells;
  for(const auto& polyline : polylines)
  {
    cells.emplace_back();
    for(const Point& p : polyline)
    {
      cells.back().push_back(points.size());
      points.push_back(p);
    }
  }
  Vtk_file(name, points).write_cells("LINES", cells);
}

void write_points(const std::string& name, const std::vector<Point>& points)
{
  std::vector<std::vector<std::size_t>> cells;
  for(std::size_t i = 0; i < points.size(); ++i)
    cells.push_back({i});
  Vtk_file(name, points).write_cells("VERTICES", cells);
}

void write_stages(const std::string& file_name, int number_of_vertices, const std::string& folder,
                  bool use_segmentation, double contrast)
{
  namespace parameters = CGAL::Geodesic_remeshing::parameters;
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(file_name, mesh))
    throw std::runtime_error("cannot read " + file_name);
  Stage_results results;
  const auto options = parameters::use_segmentation(use_segmentation).stage_results(std::ref(results));
  if(contrast == 0.)
    CGAL::geodesic_remeshing(mesh, number_of_vertices, out, options);
  else
  {
    const CGAL::Geodesic_remeshing::Curvature_sizing_field<Mesh> sizing(mesh, parameters::contrast(contrast));
    CGAL::geodesic_remeshing(mesh, number_of_vertices, out, options.sizing_field(sizing));
  }
  write_mesh(folder + "/input.vtk", mesh);
  write_distances(folder + "/distances.vtk", results.working_surface);
  write_regions(folder + "/regions.vtk", results.regions);
  write_polylines(folder + "/curves.vtk", results.curves);
  write_points(folder + "/samples.vtk", results.samples);
  write_mesh(folder + "/strips.vtk", results.strips);
  write_mesh(folder + "/output.vtk", out);
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    if(argc != 6)
      throw std::invalid_argument("usage: geodesic_remeshing_stages INPUT.off NUMBER_OF_VERTICES FOLDER yes|no CONTRAST");
    write_stages(argv[1], std::stoi(argv[2]), argv[3], std::string(argv[4]) == "yes", std::stod(argv[5]));
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
