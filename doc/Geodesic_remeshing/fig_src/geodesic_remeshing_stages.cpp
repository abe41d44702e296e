// Writes what the stages of CGAL::geodesic_remeshing() make of a mesh as VTK files, for the figures of the manual:
//
//   geodesic_remeshing_stages INPUT.off NUMBER_OF_VERTICES FOLDER yes|no CONTRAST FEATURE_ANGLE PARTS
//
// The fourth argument tells whether to segment, the next how much the lengths differ by curvature, from what angle on
// features are kept (180: none), and into how many parts, one above the other, the faces of the input are sorted, whose
// borders are kept. The files in FOLDER are input, distances, regions, curves, samples, strips, output, lines (the
// constrained edges of the output), input_parts and output_parts, all with the extension vtk.

#include <CGAL/Geodesic_remeshing/Curvature_sizing_field.h>
#include <CGAL/Geodesic_remeshing/attribute_transfer.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
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
    if(!mesh.is_border(h) && !mesh.is_border(mesh.opposite(h)) &&
       region[mesh.face(mesh.opposite(h))] < region[mesh.face(h)])
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

struct Job
{
  std::string input, folder;
  int number_of_vertices;
  bool use_segmentation;
  double contrast, feature_angle;
  int parts;
};

void sort_into_parts(Mesh& mesh, int parts)
{
  const auto box = CGAL::Polygon_mesh_processing::bbox(mesh);
  auto part = mesh.add_property_map<Mesh::Face_index, int>("f:region", 0).first;
  for(const auto f : mesh.faces())
  {
    const double height = (mesh.point(mesh.target(mesh.halfedge(f))).y() - box.ymin()) / box.y_span();
    part[f] = (std::min)(static_cast<int>(height * parts), parts - 1);
  }
}

Polylines marked_edges(const Mesh& mesh, const Mesh::Property_map<Mesh::Edge_index, bool>& is_marked)
{
  Polylines result;
  for(const auto e : mesh.edges())
    if(is_marked[e] || mesh.is_border(e))
      result.push_back({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});
  return result;
}

template <class NamedParameters, class NamedParametersOut>
void remesh(Mesh& mesh, Mesh& out, const Job& job, const NamedParameters& np, const NamedParametersOut& np_out)
{
  namespace parameters = CGAL::Geodesic_remeshing::parameters;
  if(job.contrast > 0.)
  {
    const CGAL::Geodesic_remeshing::Curvature_sizing_field<Mesh> sizing(mesh, parameters::contrast(job.contrast));
    CGAL::geodesic_remeshing(mesh, job.number_of_vertices, out, np.sizing_field(sizing), np_out);
  }
  else if(job.feature_angle < 180.)
    CGAL::geodesic_remeshing(mesh, job.number_of_vertices, out, np.features_angle_bound(job.feature_angle), np_out);
  else
    CGAL::geodesic_remeshing(mesh, job.number_of_vertices, out, np, np_out);
}

void write_stages(const Job& job)
{
  namespace parameters = CGAL::Geodesic_remeshing::parameters;
  using Location = CGAL::Polygon_mesh_processing::Face_location<Mesh, double>;
  Mesh mesh, out;
  if(!CGAL::IO::read_OFF(job.input, mesh))
    throw std::runtime_error("cannot read " + job.input);
  sort_into_parts(mesh, job.parts);
  const auto part = mesh.property_map<Mesh::Face_index, int>("f:region").value();
  const auto location = out.add_property_map<Mesh::Vertex_index, Location>("v:location").first;
  const auto is_line = out.add_property_map<Mesh::Edge_index, bool>("e:line", false).first;
  Stage_results results;
  remesh(mesh, out, job,
         parameters::use_segmentation(job.use_segmentation).face_patch_map(part).stage_results(std::ref(results)),
         parameters::vertex_location_map(location).edge_is_constrained_map(is_line));
  CGAL::Geodesic_remeshing::transfer_face_property(mesh, part, out, location,
                                                   out.add_property_map<Mesh::Face_index, int>("f:region", 0).first);
  write_mesh(job.folder + "/input.vtk", mesh);
  write_distances(job.folder + "/distances.vtk", results.working_surface);
  write_regions(job.folder + "/regions.vtk", results.regions);
  write_polylines(job.folder + "/curves.vtk", results.curves);
  write_points(job.folder + "/samples.vtk", results.samples);
  write_mesh(job.folder + "/strips.vtk", results.strips);
  write_mesh(job.folder + "/output.vtk", out);
  write_polylines(job.folder + "/lines.vtk", marked_edges(out, is_line));
  write_regions(job.folder + "/input_parts.vtk", mesh);
  write_regions(job.folder + "/output_parts.vtk", out);
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    if(argc != 8)
      throw std::invalid_argument(
          "usage: geodesic_remeshing_stages INPUT.off NUMBER_OF_VERTICES FOLDER yes|no CONTRAST FEATURE_ANGLE PARTS");
    write_stages({argv[1], argv[3], std::stoi(argv[2]), std::string(argv[4]) == "yes", std::stod(argv[5]),
                  std::stod(argv[6]), std::stoi(argv[7])});
    return EXIT_SUCCESS;
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
