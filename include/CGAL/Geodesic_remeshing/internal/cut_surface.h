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

#include <CGAL/Geodesic_remeshing/internal/Level_curves.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How curves divide the faces. Within a face every piece of a curve cuts off one corner, so the numbers of crossings on the
// three edges tell all: pieces around corner i, innermost first, then the piece in the middle ("normal curves").
//
// An edge with k crossings has k + 1 intervals; the pieces of a face join intervals of its edges.
class Face_division
{
public:
  Face_division(const Mesh& mesh, const Level_curves& curves, Face f) : m_mesh(mesh), m_curves(curves)
  {
    Halfedge h = mesh.halfedge(f);
    for(int i = 0; i < 3; ++i, h = mesh.next(h))
      m_halfedge[i] = h;
    for(int i = 0; i < 3; ++i)
      m_arcs[i] = (crossings(i) + crossings(i + 2) - crossings(i + 1)) / 2;
  }

  Halfedge halfedge(int i) const { return m_halfedge[i % 3]; } // from corner i to corner i + 1
  Vertex corner(int i) const { return m_mesh.source(halfedge(i)); }
  std::ptrdiff_t arcs(int corner) const { return m_arcs[corner % 3]; }

  std::ptrdiff_t crossings(int i) const
  {
    const std::size_t e = m_mesh.edge(halfedge(i)).idx();
    return m_curves.crossing_begin[e + 1] - m_curves.crossing_begin[e];
  }

  // The j-th crossing from corner i on its outgoing edge, or on its incoming one
  std::size_t outgoing(int i, std::ptrdiff_t j) const { return crossing(i, j, true); }
  std::size_t incoming(int i, std::ptrdiff_t j) const { return crossing(i + 2, j, false); }

  // The j-th interval from corner i on its outgoing edge, or on its incoming one, numbered over all edges
  std::size_t outgoing_interval(int i, std::ptrdiff_t j) const { return interval(i, j, true); }
  std::size_t incoming_interval(int i, std::ptrdiff_t j) const { return interval(i + 2, j, false); }

private:
  bool counts_forward(int i, bool from_source) const
  { return (m_mesh.halfedge(m_mesh.edge(halfedge(i)), 0) == halfedge(i)) == from_source; }

  std::size_t crossing(int i, std::ptrdiff_t j, bool from_source) const
  {
    const std::size_t e = m_mesh.edge(halfedge(i)).idx();
    return counts_forward(i, from_source) ? m_curves.crossing_begin[e] + j : m_curves.crossing_begin[e + 1] - 1 - j;
  }

  std::size_t interval(int i, std::ptrdiff_t j, bool from_source) const
  {
    const std::size_t e = m_mesh.edge(halfedge(i)).idx();
    return counts_forward(i, from_source) ? m_curves.crossing_begin[e] + e + j : m_curves.crossing_begin[e + 1] + e - j;
  }

  const Mesh& m_mesh;
  const Level_curves& m_curves;
  std::array<Halfedge, 3> m_halfedge;
  std::array<std::ptrdiff_t, 3> m_arcs;
};

// The strips: what the curves divide the surface into. The strip of each interval, and their number.
inline std::pair<std::vector<std::size_t>, std::size_t> find_strips(const Mesh& mesh, const Level_curves& curves)
{
  std::vector<std::size_t> strip(curves.crossings.size() + mesh.number_of_edges());
  std::iota(strip.begin(), strip.end(), std::size_t(0));
  const auto find = [&](std::size_t i)
  {
    while(strip[i] != i)
      i = strip[i] = strip[strip[i]];
    return i;
  };
  const auto unite = [&](std::size_t i, std::size_t j)
  {
    i = find(i);
    j = find(j);
    strip[(std::max)(i, j)] = (std::min)(i, j);
  };
  for(Face f : mesh.faces())
  {
    const Face_division division(mesh, curves, f);
    for(int i = 0; i < 3; ++i)
    {
      for(std::ptrdiff_t j = 0; j <= division.arcs(i); ++j)
        unite(division.outgoing_interval(i, j), division.incoming_interval(i, j));
      unite(division.outgoing_interval(i, division.arcs(i)), division.outgoing_interval(0, division.arcs(0)));
    }
  }
  std::size_t number = 0;
  for(std::size_t i = 0; i < strip.size(); ++i)
    strip[i] = strip[i] == i ? number++ : strip[strip[i]]; // a representative comes before the rest of its set
  return std::make_pair(std::move(strip), number);
}

// Cuts the surface along curves. `label(intervals)` is called for each piece of a face with the intervals on its border, and its
// result stored as "f:region".
template <class Label>
Mesh cut_along(const Mesh& mesh, const Level_curves& curves, const Label& label)
{
  Mesh result;
  result.reserve(mesh.number_of_vertices() + curves.crossings.size(), 0, 0);
  for(Vertex v : mesh.vertices())
    result.add_vertex(mesh.point(v));
  for(Edge e : mesh.edges())
    for(std::size_t c = curves.crossing_begin[e.idx()]; c < curves.crossing_begin[e.idx() + 1]; ++c)
      result.add_vertex(point_at(mesh, Curve_point{mesh.halfedge(e), curves.crossings[c].position}));
  auto region = result.add_property_map<Face, int>("f:region", -1).first;
  const std::size_t n = mesh.number_of_vertices();
  std::vector<Vertex> polygon;
  const auto add = [&](int value)
  {
    for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
      region[result.add_face(polygon[0], polygon[i], polygon[i + 1])] = value;
  };
  const auto vertex = [n](std::size_t crossing) { return Vertex(static_cast<Mesh::size_type>(n + crossing)); };
  for(Face f : mesh.faces())
  {
    const Face_division d(mesh, curves, f);
    std::vector<Vertex> middle;
    for(int i = 0; i < 3; ++i)
    {
      for(std::ptrdiff_t j = 0; j < d.arcs(i); ++j)
      {
        if(j == 0)
          polygon = {d.corner(i), vertex(d.outgoing(i, 0)), vertex(d.incoming(i, 0))};
        else
          polygon = {vertex(d.outgoing(i, j - 1)), vertex(d.outgoing(i, j)), vertex(d.incoming(i, j)),
                     vertex(d.incoming(i, j - 1))};
        add(label({d.outgoing_interval(i, j), d.incoming_interval(i, j)}));
      }
      if(d.arcs(i) == 0)
        middle.push_back(d.corner(i));
      else
        middle.insert(middle.end(), {vertex(d.incoming(i, d.arcs(i) - 1)), vertex(d.outgoing(i, d.arcs(i) - 1))});
    }
    polygon = middle;
    add(label({d.outgoing_interval(0, d.arcs(0)), d.outgoing_interval(1, d.arcs(1)), d.outgoing_interval(2, d.arcs(2))}));
  }
  return result;
}

// The segmentation with nothing left in it but the bottoms of the regions that have a height: regions that degenerate to
// their tops are part of the region below.
inline Segmentation region_boundaries(const Segmentation& segmentation)
{
  Segmentation result = segmentation;
  std::vector<int> resolved(segmentation.regions.size());
  for(std::size_t r = resolved.size(); r-- > 0;) // parents come after their children
  {
    Region& region = result.regions[r];
    const bool is_last = region.parents.empty();
    resolved[r] = is_last || region.number_of_levels > 0 ? static_cast<int>(r) : resolved[region.parents.front()];
    region.number_of_levels = is_last ? 0 : (std::min)(region.number_of_levels, 1);
    region.spacing = region.height > 0. ? region.height : 1.;
  }
  for(std::size_t v = 0; v < result.region.size(); ++v)
  {
    const int r = resolved[segmentation.region[v]];
    if(segmentation.field_region[v] != r)
      result.field[v] = segmentation.field_region[v] < r ? 0. : .99 * result.regions[r].height;
    result.field[v] = (std::min)(result.field[v], .99 * result.regions[r].height);
    result.field_region[v] = result.region[v] = r;
    result.level[v] = 1;
  }
  return result;
}

// The region of each interval of the edges
inline std::vector<int> regions_of_intervals(const Mesh& mesh, const Segmentation& boundaries, const Level_curves& curves)
{
  std::vector<int> region(curves.crossings.size() + mesh.number_of_edges());
  for(Edge e : mesh.edges())
  {
    const std::size_t begin = curves.crossing_begin[e.idx()], end = curves.crossing_begin[e.idx() + 1];
    int here = boundaries.region[mesh.source(mesh.halfedge(e))];
    for(std::size_t c = begin; c < end; ++c)
    {
      const Crossing& crossing = curves.crossings[c];
      region[c + e.idx()] = here;
      if(!crossing.descends)
        here = crossing.region; // up through its bottom
      else if(c + 1 < end && curves.crossings[c + 1].descends)
        here = curves.crossings[c + 1].region;
      else
        here = static_cast<int>(boundaries.regions[crossing.region].parents.front());
    }
    region[end + e.idx()] = boundaries.region[mesh.target(mesh.halfedge(e))];
  }
  // The region that a bridge belongs to reaches to the one at its other end, so that the two touch and the region
  // below, which goes around both, is an annulus.
  for(const auto& bridge : boundaries.bridges)
    for(std::size_t i = 0; i + 1 < bridge.size(); ++i)
    {
      const std::size_t e = mesh.edge(mesh.halfedge(bridge[i], bridge[i + 1])).idx();
      const int label = boundaries.region[(std::min)(bridge[i], bridge[i + 1], [&](Vertex a, Vertex b)
                                                     { return boundaries.region[a] < boundaries.region[b]; })];
      for(std::size_t c = curves.crossing_begin[e] + 1; c < curves.crossing_begin[e + 1]; ++c)
        region[c + e] = -1 - label; // marked: holds for the whole pieces beside the edge
    }
  return region;
}

// The working surface cut along the boundaries of the regions, with the region of each face in "f:region": every
// region, as a set of faces, is a disc or an annulus.
inline Mesh cut_along_regions(const Mesh& mesh, const Segmentation& segmentation)
{
  const Segmentation boundaries = region_boundaries(segmentation);
  Level_curves curves = Curve_tracer(mesh, boundaries).trace();
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
  const std::vector<int> region = regions_of_intervals(mesh, boundaries, curves);
  return cut_along(mesh, curves, [&](const std::vector<std::size_t>& intervals)
  {
    for(std::size_t i : intervals)
      if(region[i] < 0)
        return -1 - region[i];
    return region[intervals.front()];
  });
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CUT_SURFACE_H
