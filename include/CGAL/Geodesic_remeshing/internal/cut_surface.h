// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CUT_SURFACE_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CUT_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Face_division.h>
#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>
#include <CGAL/Geodesic_remeshing/internal/Region_boundaries.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Cuts the surface along curves. `label(interval)` tells the region of an interval of an edge, which the faces get in
// "f:region". Where it tells another region by -1 - region, that one is to have a passage along the edge: the piece on
// either side of the interval is cut in two, between the middles of the curves there.
template <class Label>
class Surface_cutter
{
public:
  Surface_cutter(const Mesh& mesh, const Level_curves& curves, const Label& label)
    : m_mesh(mesh), m_curves(curves), m_label(label),
      m_region(m_result.add_property_map<Face, int>("f:region", -1).first)
  {}

  Mesh run()
  {
    for(Vertex v : m_mesh.vertices())
      m_result.add_vertex(m_mesh.point(v));
    for(Edge e : m_mesh.edges())
      for(std::size_t c = m_curves.crossing_begin[e.idx()]; c < m_curves.crossing_begin[e.idx() + 1]; ++c)
        m_result.add_vertex(point_at(m_mesh, Curve_point{m_mesh.halfedge(e), m_curves.crossings[c].position}));
    for(Face f : m_mesh.faces())
    {
      const Face_division division(m_mesh, m_curves, f);
      if(division.is_possible())
        cut(division);
      else
        cut_around_center(division);
    }
    return std::move(m_result);
  }

private:
  // One curve in a face, cutting off a corner: from the outgoing edge of the corner to the incoming one
  struct Arc
  {
    Vertex outgoing, incoming, middle; // the middle only where a passage needs it
  };

  Vertex vertex(std::size_t crossing) const
  {
    return Vertex(static_cast<Mesh::size_type>(m_mesh.number_of_vertices() + crossing));
  }

  void cut(const Face_division& d)
  {
    for(int i = 0; i < 3; ++i)
    {
      m_arcs[i].clear();
      for(std::ptrdiff_t j = 0; j < d.arcs(i); ++j)
        m_arcs[i].push_back(Arc{vertex(d.outgoing(i, j)), vertex(d.incoming(i, j)), Vertex()});
    }
    for(int i = 0; i < 3; ++i)
      for(std::ptrdiff_t j = 1; j <= d.arcs(i); ++j)
        if(m_label(d.outgoing_interval(i, j)) < 0 || m_label(d.incoming_interval(i, j)) < 0)
          for(Arc* arc : {&m_arcs[i][j - 1], j < d.arcs(i) ? &m_arcs[i][j] : last_arc_facing(d, i, j)})
            if(arc != nullptr && !arc->middle.is_valid())
              arc->middle = m_result.add_vertex(midpoint(m_result.point(arc->outgoing), m_result.point(arc->incoming)));
    for(int i = 0; i < 3; ++i)
      for(std::ptrdiff_t j = 0; j < d.arcs(i); ++j)
      {
        m_polygon.clear();
        if(j == 0)
          m_polygon.push_back(d.corner(i));
        else
          append(m_arcs[i][j - 1], false);
        append(m_arcs[i][j], true);
        const int outgoing = m_label(d.outgoing_interval(i, j)), incoming = m_label(d.incoming_interval(i, j));
        add_piece(outgoing < 0 ? incoming : outgoing, (std::min)(outgoing, incoming), outgoing < 0);
      }
    add_middle(d);
  }

  // Around a handle smaller than the face curves may take different ways along two of its edges, so that they do not
  // meet: then each interval of its edges gets a face of its own.
  void cut_around_center(const Face_division& d)
  {
    const auto center = m_result.add_vertex(
        CGAL::centroid(m_mesh.point(d.corner(0)), m_mesh.point(d.corner(1)), m_mesh.point(d.corner(2))));
    for(int i = 0; i < 3; ++i)
      for(std::ptrdiff_t j = 0; j <= d.crossings(i); ++j)
      {
        const Vertex start = j == 0 ? d.corner(i) : vertex(d.outgoing(i, j - 1));
        const Vertex end = j == d.crossings(i) ? d.corner(i + 1) : vertex(d.outgoing(i, j));
        const int value = m_label(d.outgoing_interval(i, j));
        add_polygon({center, start, end}, value >= 0 ? value : -1 - value);
      }
  }

  // The arc around the other end of the edge along which the middle piece has a passage
  Arc* last_arc_facing(const Face_division& d, int i, std::ptrdiff_t j)
  {
    const int other = m_label(d.outgoing_interval(i, j)) < 0 ? (i + 1) % 3 : (i + 2) % 3;
    return m_arcs[other].empty() ? nullptr : &m_arcs[other].back();
  }

  // An arc as part of the border of the piece beyond it (from its corner) or before it
  void append(const Arc& arc, bool forward)
  {
    m_polygon.push_back(forward ? arc.outgoing : arc.incoming);
    if(arc.middle.is_valid())
      m_polygon.push_back(arc.middle);
    m_polygon.push_back(forward ? arc.incoming : arc.outgoing);
  }

  void add_middle(const Face_division& d)
  {
    m_polygon.clear();
    int passage = 0, value = -1, edge = 0;
    for(int i = 0; i < 3; ++i)
    {
      if(m_arcs[i].empty())
        m_polygon.push_back(d.corner(i));
      else
        append(m_arcs[i].back(), false);
      const int label = m_label(d.outgoing_interval(i, d.arcs(i)));
      value = (std::max)(value, label);
      passage = (std::min)(passage, label);
      edge = label < 0 ? i : edge;
    }
    add_piece(value, passage, edge != 2);
  }

  // A piece of a face with this value, but for a passage of another region between the middles of two arcs: in the
  // order of the polygon that is what lies from the first to the second of them, or the rest.
  void add_piece(int value, int passage, bool passage_is_inner)
  {
    const auto is_middle = [this](Vertex v) {
      return v.idx() >= m_mesh.number_of_vertices() + m_curves.crossings.size();
    };
    const auto first = std::find_if(m_polygon.begin(), m_polygon.end(), is_middle);
    const auto second = first == m_polygon.end() ? first : std::find_if(std::next(first), m_polygon.end(), is_middle);
    if(passage >= 0 || second == m_polygon.end())
    {
      add_polygon(m_polygon, value >= 0 ? value : -1 - passage);
      return;
    }
    const std::vector<Vertex> inner(first, std::next(second));
    std::vector<Vertex> outer(second, m_polygon.end());
    outer.insert(outer.end(), m_polygon.begin(), std::next(first));
    add_polygon(inner, passage_is_inner || value < 0 ? -1 - passage : value);
    add_polygon(outer, !passage_is_inner || value < 0 ? -1 - passage : value);
  }

  void add_polygon(const std::vector<Vertex>& polygon, int value)
  {
    for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      const Face f = m_result.add_face(polygon[0], polygon[i], polygon[i + 1]);
      CGAL_assertion(f.is_valid());
      m_region[f] = value;
    }
  }

  const Mesh& m_mesh;
  const Level_curves& m_curves;
  const Label& m_label;
  Mesh m_result;
  Mesh::Property_map<Face, int> m_region;
  std::array<std::vector<Arc>, 3> m_arcs;
  std::vector<Vertex> m_polygon;
};

// The region of each interval of the edges
inline std::vector<int> regions_of_intervals(const Mesh& mesh, const Segmentation& segmentation,
                                             const Region_boundaries& boundaries, const Level_curves& curves)
{
  std::vector<int> region(curves.crossings.size() + mesh.number_of_edges());
  for(Edge e : mesh.edges())
  {
    const std::size_t begin = curves.crossing_begin[e.idx()], end = curves.crossing_begin[e.idx() + 1];
    int here = boundaries.region_of(mesh.source(mesh.halfedge(e)));
    for(std::size_t c = begin; c < end; ++c)
    {
      const Crossing& crossing = curves.crossings[c];
      region[c + e.idx()] = here;
      if(!crossing.descends)
        here = crossing.region; // up through its bottom
      else if(c + 1 < end && curves.crossings[c + 1].descends)
        here = curves.crossings[c + 1].region;
      else
        here = boundaries.below(crossing.region);
    }
    region[end + e.idx()] = boundaries.region_of(mesh.target(mesh.halfedge(e)));
  }
  // The region that a bridge belongs to reaches to the one at its other end, so that the two touch and the region
  // below, which goes around both, is an annulus.
  for(const auto& bridge : segmentation.bridges)
    for(std::size_t i = 0; i + 1 < bridge.size(); ++i)
    {
      const std::size_t e = mesh.edge(mesh.halfedge(bridge[i], bridge[i + 1])).idx();
      const int label = (std::min)(boundaries.region_of(bridge[i]), boundaries.region_of(bridge[i + 1]));
      for(std::size_t c = curves.crossing_begin[e] + 1; c < curves.crossing_begin[e + 1]; ++c)
        region[c + e] = -1 - label; // marked: holds for the whole pieces beside the edge
    }
  return region;
}

// The working surface cut along the boundaries of the regions, with the region of each face in "f:region": every
// region, as a set of faces, is a disc or an annulus.
inline Mesh cut_along_regions(const Mesh& mesh, const Segmentation& segmentation)
{
  const Region_boundaries boundaries(mesh, segmentation);
  Level_curves curves = boundaries.crossings();
  for(Edge e : mesh.edges())
  {
    // strictly apart and inside, so that no new face is degenerate
    const std::size_t begin = curves.crossing_begin[e.idx()], end = curves.crossing_begin[e.idx() + 1];
    const double step = 1. / static_cast<double>(end - begin + 1);
    for(std::size_t c = begin; c < end; ++c)
    {
      const double i = static_cast<double>(c - begin + 1);
      double& position = curves.crossings[c].position;
      position = (std::min)((std::max)(position, (i - .4) * step), (i + .4) * step);
    }
  }
  const std::vector<int> region = regions_of_intervals(mesh, segmentation, boundaries, curves);
  const auto label = [&](std::size_t interval) { return region[interval]; };
  return Surface_cutter<decltype(label)>(mesh, curves, label).run();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CUT_SURFACE_H
