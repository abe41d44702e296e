// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INTRINSIC_TRIANGULATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INTRINSIC_TRIANGULATION_H

#include <CGAL/Geodesic_remeshing/internal/Intrinsic_faces.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The intrinsic Delaunay triangulation of a surface, in the form that fast marching reads: for each vertex the lengths
// of its spokes and of the rims between them, in one run of memory. A loop is a spoke that leads back, a multiple edge
// occurs as often as it is there.
class Intrinsic_triangulation
{
public:
  using Index = std::uint32_t;

  struct Spoke
  {
    double length;
    double rim;   // length of the side from this neighbor to that of the next spoke; negative: no face between them
    double angle; // from the first spoke of the vertex, counterclockwise
    Index neighbor;
    Index reverse; // the spoke of the neighbor that is the same edge
  };

  // The surface as it lies in space, or in the metric of its density.
  explicit Intrinsic_triangulation(const Mesh& mesh)
    : Intrinsic_triangulation(mesh, [metric = Metric(mesh)](Halfedge h) { return metric.length(h); })
  {}

  // The surface in a metric of its own: a length for every edge, by index.
  Intrinsic_triangulation(const Mesh& mesh, const std::vector<double>& length_of_edge)
    : Intrinsic_triangulation(mesh, [&](Halfedge h) { return length_of_edge[mesh.edge(h)]; })
  {}

  // Any triangulated `FaceListGraph`, its indices possibly with gaps. A halfedge and its opposite must have the same
  // length.
  template <typename Graph, typename VertexIndexMap, typename FaceIndexMap, typename Length_of_halfedge>
  Intrinsic_triangulation(const Graph& graph, VertexIndexMap vertex_index, FaceIndexMap face_index,
                          const Length_of_halfedge& length_of_halfedge,
                          const std::vector<std::size_t>& frozen_faces = {})
  {
    Intrinsic_faces copy(index_bound(vertices(graph), vertex_index), index_bound(faces(graph), face_index));
    copy_faces(graph, vertex_index, face_index, length_of_halfedge, copy);
    copy.enforce_triangle_inequality();
    for(const std::size_t f : frozen_faces)
      copy.freeze(static_cast<Index>(f));
    copy.make_Delaunay();
    collect_spokes(copy);
  }

  std::size_t number_of_vertices() const { return m_rings.size() - 1; }

  // The spokes counterclockwise. Where faces close around the vertex, the first spoke stands at the end again; where
  // they do not (boundary, several fans at one vertex), a negative rim separates.
  const Spoke* begin(Index v) const { return m_spokes.data() + m_rings[v].first; }
  const Spoke* end(Index v) const { return m_spokes.data() + m_rings[v + 1].first; }
  const Spoke& reverse(const Spoke& spoke) const { return m_spokes[spoke.reverse]; }

  // The sum of the angles at the vertex, infinite on the boundary, where turning on does not lead back.
  double full_angle(Index v) const { return m_rings[v].full_angle; }

private:
  template <typename Length_of_halfedge>
  Intrinsic_triangulation(const Mesh& mesh, const Length_of_halfedge& length_of_halfedge)
    : Intrinsic_triangulation(mesh, get(boost::vertex_index, mesh), get(boost::face_index, mesh), length_of_halfedge)
  {}

  template <typename Range, typename IndexMap>
  static std::size_t index_bound(const Range& range, IndexMap index)
  {
    std::size_t bound = 0;
    for(const auto& x : range)
      bound = (std::max)(bound, static_cast<std::size_t>(get(index, x)) + 1);
    return bound;
  }

  template <typename Graph, typename VertexIndexMap, typename FaceIndexMap, typename Length_of_halfedge>
  static void copy_faces(const Graph& graph, VertexIndexMap vertex_index, FaceIndexMap face_index,
                         const Length_of_halfedge& length_of_halfedge, Intrinsic_faces& copy);
  struct Ring
  {
    double full_angle;
    Index first;
  };

  struct Open_end // the last spoke of a fan that does not close, and the halfedge that leads along it to the vertex
  {
    Index spoke;
    Index halfedge;
  };

  void collect_spokes(const Intrinsic_faces& faces);
  void collect_fan(const Intrinsic_faces& faces, Index start, std::vector<Index>& spoke_of,
                   std::vector<Open_end>& ends);
  void link_spokes(const Intrinsic_faces& faces, const std::vector<Index>& spoke_of, const std::vector<Open_end>& ends);

  std::vector<Ring> m_rings; // one more than there are vertices
  std::vector<Spoke> m_spokes;
};

template <typename Graph, typename VertexIndexMap, typename FaceIndexMap, typename Length_of_halfedge>
void Intrinsic_triangulation::copy_faces(const Graph& graph, VertexIndexMap vertex_index, FaceIndexMap face_index,
                                         const Length_of_halfedge& length_of_halfedge, Intrinsic_faces& copy)
{
  for(const auto f : faces(graph))
  {
    const Index i = static_cast<Index>(get(face_index, f));
    auto& triangle = copy.triangle(i);
    auto h = halfedge(f, graph);
    for(Index k = 0; k < 3; ++k, h = next(h, graph))
    {
      triangle.vertex[k] = static_cast<Index>(get(vertex_index, source(h, graph)));
      const auto o = opposite(h, graph);
      const bool seen = !is_border(o, graph) && copy.is_face(static_cast<Index>(get(face_index, face(o, graph))));
      if(!seen || face(o, graph) == f)
      {
        triangle.length[k] = length_of_halfedge(h);
        continue;
      }
      const Index j = static_cast<Index>(get(face_index, face(o, graph)));
      const auto first = halfedge(face(o, graph), graph);
      const Index slot = o == first ? 0 : o == next(first, graph) ? 1 : 2;
      triangle.opposite[k] = 3 * j + slot;
      triangle.length[k] = copy.triangle(j).length[slot];
      copy.triangle(j).opposite[slot] = 3 * i + k;
    }
  }
}

// A fan of faces is walked from its first halfedge, the one with no face at its right, or from any one where it closes.
inline void Intrinsic_triangulation::collect_spokes(const Intrinsic_faces& faces)
{
  const Index none = Intrinsic_faces::none;
  const Index number_of_halfedges = static_cast<Index>(3 * faces.number_of_faces());
  std::vector<Index> start(faces.number_of_vertices(), none);
  std::vector<std::pair<Index, Index>> more_starts; // vertices at which several fans meet have more than one
  for(Index h = 0; h < number_of_halfedges; ++h)
  {
    if(!faces.is_face(h / 3))
      continue;
    const Index v = faces.source(h);
    if(faces.opposite(h) != none)
      start[v] = start[v] == none ? h : start[v];
    else if(start[v] == none || faces.opposite(start[v]) != none)
      start[v] = h;
    else
      more_starts.emplace_back(v, h);
  }
  std::sort(more_starts.begin(), more_starts.end());

  std::vector<Index> spoke_of(number_of_halfedges); // the spoke that a halfedge became
  std::vector<Open_end> ends;
  m_rings.reserve(start.size() + 1);
  m_spokes.reserve(number_of_halfedges + start.size() + more_starts.size());
  auto more = more_starts.begin();
  for(Index v = 0; v < start.size(); ++v)
  {
    m_rings.push_back(Ring{infinity, static_cast<Index>(m_spokes.size())});
    if(start[v] != none)
      collect_fan(faces, start[v], spoke_of, ends);
    for(; more != more_starts.end() && more->first == v; ++more)
      collect_fan(faces, more->second, spoke_of, ends);
  }
  m_rings.push_back(Ring{infinity, static_cast<Index>(m_spokes.size())});
  link_spokes(faces, spoke_of, ends);
}

inline void Intrinsic_triangulation::collect_fan(const Intrinsic_faces& faces, Index start,
                                                 std::vector<Index>& spoke_of, std::vector<Open_end>& ends)
{
  // what comes from one fan into another comes through the vertex: half a turn or more
  double angle = m_spokes.size() > m_rings.back().first ? m_spokes.back().angle + CGAL_PI : 0.;
  // until the spokes are linked, `reverse` holds the halfedge
  const auto add = [&](double length, double rim, Index neighbor, Index halfedge) {
    m_spokes.push_back(Spoke{length, rim, angle, neighbor, halfedge});
  };

  for(Index h = start;;)
  {
    const Index rim = Intrinsic_faces::next(h);
    const Index left = Intrinsic_faces::previous(h);
    spoke_of[h] = static_cast<Index>(m_spokes.size());
    add(faces.length(h), faces.length(rim), faces.source(rim), h);
    angle += faces.angle_opposite_to(rim);
    h = faces.opposite(left);
    if(h == Intrinsic_faces::none)
    {
      ends.push_back(Open_end{static_cast<Index>(m_spokes.size()), left});
      return add(faces.length(left), -1., faces.source(left), left);
    }
    if(h == start)
    {
      m_rings.back().full_angle = angle;
      return add(faces.length(start), -1., faces.source(Intrinsic_faces::next(start)), start);
    }
  }
}

inline void Intrinsic_triangulation::link_spokes(const Intrinsic_faces& faces, const std::vector<Index>& spoke_of,
                                                 const std::vector<Open_end>& ends)
{
  for(Spoke& spoke : m_spokes)
  {
    const Index o = faces.opposite(spoke.reverse);
    if(o != Intrinsic_faces::none)
      spoke.reverse = spoke_of[o];
  }
  for(const Open_end& end : ends)
  {
    m_spokes[end.spoke].reverse = spoke_of[end.halfedge];
    m_spokes[spoke_of[end.halfedge]].reverse = end.spoke;
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INTRINSIC_TRIANGULATION_H
