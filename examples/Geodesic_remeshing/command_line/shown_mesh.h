// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHOWN_MESH_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHOWN_MESH_H

#include "../include/mesh_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace command_line {

using mesh_quality::Mesh;
using mesh_quality::Point;

// Moves the input's bounding box into the unit ball around the origin
struct Frame
{
  CGAL::Bbox_3 box;

  std::array<float, 3> operator()(const Point& p) const
  {
    const double radius = std::hypot(box.x_span(), box.y_span(), box.z_span()) / 2.;
    const double scale = radius > 0. ? 1. / radius : 1.;
    return {{static_cast<float>(scale * (p.x() - (box.xmin() + box.xmax()) / 2.)),
             static_cast<float>(scale * (p.y() - (box.ymin() + box.ymax()) / 2.)),
             static_cast<float>(scale * (p.z() - (box.zmin() + box.zmax()) / 2.))}};
  }
};

// A mesh for looking at: indexed triangles, and for each of them the face that it stands for
struct Shown_mesh
{
  std::vector<Point> points;
  std::vector<std::uint32_t> indices;
  std::vector<Mesh::Face_index> faces;
  std::vector<std::uint8_t> valences; // of the vertices; 0 on the boundary
};

namespace internal {

// The cell of a grid that each vertex lies in; the vertices of a cell become one. A cell so small that each vertex has
// its own changes nothing.
class Vertex_cells
{
public:
  Vertex_cells(const Mesh& mesh, const CGAL::Bbox_3& box, std::size_t cells_along_diagonal) : m_box(box)
  {
    m_size = std::hypot(box.x_span(), box.y_span(), box.z_span()) / static_cast<double>(cells_along_diagonal);
    m_cell_of.resize(mesh.num_vertices());
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    for(const auto v : mesh.vertices())
    {
      const auto found = numbers.emplace(key(mesh.point(v)), static_cast<std::uint32_t>(numbers.size()));
      m_cell_of[v.idx()] = found.first->second;
      if(found.second)
        m_first.push_back(v);
    }
  }

  std::uint32_t cell(Mesh::Vertex_index v) const { return m_cell_of[v.idx()]; }
  const std::vector<Mesh::Vertex_index>& first_vertices() const { return m_first; }

private:
  std::uint64_t key(const Point& p) const
  {
    const auto at = [this](double x, double low) {
      return static_cast<std::uint64_t>(m_size > 0. ? (x - low) / m_size : 0.);
    };
    return (at(p.x(), m_box.xmin()) << 42) | (at(p.y(), m_box.ymin()) << 21) | at(p.z(), m_box.zmin());
  }

  CGAL::Bbox_3 m_box;
  double m_size = 0.;
  std::vector<std::uint32_t> m_cell_of;
  std::vector<Mesh::Vertex_index> m_first; // of each cell
};

inline std::array<Mesh::Vertex_index, 3> vertices_of(const Mesh& mesh, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}};
}

inline std::uint8_t shown_valence(const Mesh& mesh, Mesh::Vertex_index v)
{
  return mesh.is_isolated(v) || mesh.is_border(v) ? 0 : static_cast<std::uint8_t>((std::min)(mesh.degree(v), 255u));
}

inline Shown_mesh with_one_vertex_a_cell(const Mesh& mesh, const Vertex_cells& cells)
{
  Shown_mesh shown;
  for(const auto v : cells.first_vertices())
  {
    shown.points.push_back(mesh.point(v));
    shown.valences.push_back(shown_valence(mesh, v));
  }
  for(const auto f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    const std::array<std::uint32_t, 3> corner = {{cells.cell(v[0]), cells.cell(v[1]), cells.cell(v[2])}};
    if(corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0])
      continue;
    shown.indices.insert(shown.indices.end(), corner.begin(), corner.end());
    shown.faces.push_back(f);
  }
  return shown;
}

inline Shown_mesh whole(const Mesh& mesh)
{
  Shown_mesh shown;
  std::vector<std::uint32_t> number(mesh.num_vertices());
  for(const auto v : mesh.vertices())
  {
    number[v.idx()] = static_cast<std::uint32_t>(shown.points.size());
    shown.points.push_back(mesh.point(v));
    shown.valences.push_back(shown_valence(mesh, v));
  }
  for(const auto f : mesh.faces())
  {
    for(const auto v : vertices_of(mesh, f))
      shown.indices.push_back(number[v.idx()]);
    shown.faces.push_back(f);
  }
  return shown;
}

} // namespace internal

// All faces if there are no more than the largest number, or as many as are left when near vertices are joined, on the
// coarsest grid but one that leaves too many
inline Shown_mesh shown_mesh(const Mesh& mesh, std::size_t largest_number_of_faces)
{
  if(mesh.number_of_faces() <= largest_number_of_faces)
    return internal::whole(mesh);
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  Shown_mesh shown;
  for(std::size_t cells = std::size_t(1) << 20; cells > 1; cells = cells * 3 / 4)
  {
    // a surface has about as many cells as the square of those along the diagonal: begin near the answer
    if(cells * cells / 16 > largest_number_of_faces)
      continue;
    shown = internal::with_one_vertex_a_cell(mesh, internal::Vertex_cells(mesh, box, cells));
    if(shown.faces.size() <= largest_number_of_faces)
      break;
  }
  return shown;
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHOWN_MESH_H
