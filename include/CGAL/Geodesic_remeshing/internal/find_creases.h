// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CREASES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CREASES_H

#include <CGAL/Geodesic_remeshing/internal/Constraints.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/bounding_box.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Gives these faces the normals of those across their longest sides, or of the ones beyond; where such ways lead in
// circles, as between two faces with the same longest side, of any neighbours that have one.
inline void borrow_normals(const Mesh& mesh, const Metric& metric, const std::vector<Face>& flat,
                           std::vector<Vector>& normal)
{
  const auto across_longest = [&](const Face f) {
    Halfedge longest = mesh.halfedge(f);
    for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      if(metric.length(h) > metric.length(longest))
        longest = h;
    return mesh.face(mesh.opposite(longest));
  };
  std::vector<char> is_left(mesh.number_of_faces(), 0); // to be looked at
  for(const Face f : flat)
    is_left[f] = 1;
  std::vector<Face> way;
  for(const Face start : flat)
  {
    Face f = start;
    for(way.clear(); f != Mesh::null_face() && is_left[f]; f = across_longest(f))
    {
      is_left[f] = 0;
      way.push_back(f);
    }
    if(f != Mesh::null_face())
      for(const Face g : way)
        normal[g] = normal[f];
  }
  std::vector<Face> lenders;
  const auto for_each_neighbor = [&](const Face f, const auto& visit) {
    for(Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
      if(!mesh.is_border(mesh.opposite(h)))
        visit(mesh.face(mesh.opposite(h)));
  };
  for(const Face f : flat)
    if(normal[f] == NULL_VECTOR)
      for_each_neighbor(f, [&](const Face g) {
        if(normal[g] != NULL_VECTOR)
          lenders.push_back(g);
      });
  for(std::size_t i = 0; i < lenders.size(); ++i)
    for_each_neighbor(lenders[i], [&](const Face g) {
      if(normal[g] == NULL_VECTOR)
      {
        normal[g] = normal[lenders[i]];
        lenders.push_back(g);
      }
    });
}

// Normals of the faces. A face without area, but for the seven digits that files have, has that of the neighbour across
// its longest side, so that a crease beside it is found where its other sides are.
inline std::vector<Vector> normals_of_faces(const Mesh& mesh)
{
  constexpr double rounding = 1e-6; // of the diagonal
  const Metric metric(mesh);
  const Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const Vector diagonal(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const double least_height = rounding * std::sqrt(diagonal.squared_length());
  std::vector<Vector> normal(mesh.number_of_faces(), Vector(0., 0., 0.));
  std::vector<Face> flat;
  for(Face f : mesh.faces())
  {
    const auto v = vertices_of(mesh, f);
    const Vector a(mesh.point(v[0]), mesh.point(v[1])), b(mesh.point(v[0]), mesh.point(v[2]));
    const Vector n = cross_product(a, b);
    const double length = std::sqrt(n.squared_length());
    const double side = std::sqrt((std::max)({a.squared_length(), b.squared_length(), (b - a).squared_length()}));
    if(length > least_height * side)
      normal[f] = n / length;
    else
      flat.push_back(f);
  }
  borrow_normals(mesh, metric, flat, normal);
  return normal;
}

// The edges at which the surface turns by at least this angle, as `Polygon_mesh_processing::detect_sharp_edges()` has
// it, but that a face too thin to have a normal has that of its neighbor
inline std::vector<char> find_sharp_edges(const Mesh& mesh, double angle_in_degrees)
{
  const double bound = std::cos(angle_in_degrees * CGAL_PI / 180.);
  const std::vector<Vector> normal = normals_of_faces(mesh);
  std::vector<char> is_sharp(mesh.number_of_edges(), 0);
  for(Edge e : mesh.edges())
  {
    if(mesh.is_border(e))
      continue;
    const Vector& n = normal[mesh.face(mesh.halfedge(e, 0))];
    const Vector& m = normal[mesh.face(mesh.halfedge(e, 1))];
    is_sharp[e.idx()] = n.squared_length() > 0. && m.squared_length() > 0. && n * m <= bound;
  }
  return is_sharp;
}

// The least height of the faces beside an edge, over it
inline double height_beside(const Mesh& mesh, const Metric& metric, Edge e)
{
  double least = infinity;
  for(Halfedge h : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)})
  {
    if(mesh.is_border(h))
      continue;
    const Vertex apex = mesh.target(mesh.next(h));
    const Vector along = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    const Vector up = mesh.point(apex) - mesh.point(mesh.source(h));
    least = (std::min)(least, metric.density(apex) *
                                  std::sqrt(cross_product(along, up).squared_length() / along.squared_length()));
  }
  return least;
}

// Takes away the lines of `is_loose` edges that end somewhere else than at other lines.
inline void remove_loose_ends(const Mesh& mesh, const std::vector<char>& is_loose, std::vector<char>& is_line)
{
  std::vector<int> degree = degrees_on_lines(mesh, [&](Edge e) { return is_line[e.idx()] != 0; });
  std::vector<Vertex> ends;
  for(Vertex v : mesh.vertices())
    if(degree[v] == 1)
      ends.push_back(v);
  while(!ends.empty())
  {
    const Vertex v = ends.back();
    ends.pop_back();
    for(Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      const Edge e = mesh.edge(h);
      if(!is_line[e.idx()] || !is_loose[e.idx()])
        continue;
      is_line[e.idx()] = 0;
      --degree[v];
      if(--degree[mesh.source(h)] == 1)
        ends.push_back(mesh.source(h));
    }
  }
}

// Takes away the lines of `is_loose` edges between which the surface has no room for good triangles.
inline void remove_narrow_corners(const Mesh& mesh, double least_angle, const std::vector<char>& is_loose,
                                  std::vector<char>& is_line)
{
  std::vector<Edge> narrow;
  for(Halfedge start : mesh.halfedges())
  {
    if(!is_loose[mesh.edge(start).idx()] || mesh.is_border(start))
      continue;
    double angle = 0.;
    Halfedge h = start; // they all point to the corner
    do
    {
      const Point& p = mesh.point(mesh.target(h));
      angle += CGAL::approximate_angle(mesh.point(mesh.source(h)), p, mesh.point(mesh.target(mesh.next(h))));
      h = mesh.opposite(mesh.next(h));
    } while(!is_line[mesh.edge(h).idx()]);
    if(angle < least_angle)
      narrow.insert(narrow.end(), {mesh.edge(start), mesh.edge(h)});
  }
  for(Edge e : narrow)
    is_line[e.idx()] = is_line[e.idx()] && !is_loose[e.idx()];
}

// An input of few faces bends at its edges alone. Where these are long beside the new edges, have room beside them and
// bound whole sides, as those of a cube, a mesh that does not follow them cuts off what the input is. A single sharp
// edge in a smooth coarse surface is nothing of the kind; nor are the edges of an octagonal prism, which may well stand
// for something round.
inline void add_long_creases(const Mesh& mesh, double edge_length, Constraints& constraints)
{
  constexpr double angle = 50., least_length = 3., least_height = 1.5, least_angle = 30.;
  const Metric metric(mesh);
  const auto is_long = [&](Edge e) { return metric.length(e) > least_length * edge_length; };
  if(std::none_of(mesh.edges().begin(), mesh.edges().end(), is_long))
    return;
  std::vector<char>& is_line = constraints.is_line;
  std::vector<char> is_crease = find_sharp_edges(mesh, angle);
  for(Edge e : mesh.edges())
  {
    is_crease[e.idx()] = is_crease[e.idx()] && !is_line[e.idx()] && is_long(e) &&
                         height_beside(mesh, metric, e) > least_height * edge_length;
    is_line[e.idx()] |= is_crease[e.idx()];
  }
  remove_narrow_corners(mesh, least_angle, is_crease, is_line);
  remove_loose_ends(mesh, is_crease, is_line);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_FIND_CREASES_H
