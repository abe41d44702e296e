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
#include <CGAL/Geodesic_remeshing/internal/copy_faces.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/boost/graph/properties.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
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
  explicit Intrinsic_triangulation(const Mesh& mesh, const Concurrency concurrency = Concurrency())
    : Intrinsic_triangulation(
          mesh, [metric = Metric(mesh)](Halfedge h) { return metric.length(h); }, concurrency)
  {}

  // The surface in a metric of its own: a length for every edge, by index.
  Intrinsic_triangulation(const Mesh& mesh, const std::vector<double>& length_of_edge)
    : Intrinsic_triangulation(
          mesh, [&](Halfedge h) { return length_of_edge[mesh.edge(h)]; }, Concurrency())
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
    collect_spokes(copy, Concurrency());
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
  Intrinsic_triangulation(const Mesh& mesh, const Length_of_halfedge& length_of_halfedge, const Concurrency concurrency)
  {
    CGAL_precondition(!mesh.has_garbage());
    Intrinsic_faces copy(mesh.num_vertices(), mesh.num_faces());
    copy_faces(mesh, length_of_halfedge, concurrency, copy);
    copy.enforce_triangle_inequality(concurrency);
    copy.make_Delaunay(concurrency);
    collect_spokes(copy, concurrency);
  }

  template <typename Range, typename IndexMap>
  static std::size_t index_bound(const Range& range, IndexMap index)
  {
    std::size_t bound = 0;
    for(const auto& x : range)
      bound = (std::max)(bound, static_cast<std::size_t>(get(index, x)) + 1);
    return bound;
  }

  struct Fans;
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

  void collect_spokes(const Intrinsic_faces& faces, Concurrency concurrency);
  Index collect_fan(const Intrinsic_faces& faces, Index v, Index start, Index spoke, std::vector<Index>& spoke_of,
                    std::vector<Open_end>& ends);
  void link_spokes(const Intrinsic_faces& faces, const std::vector<Index>& spoke_of, const std::vector<Open_end>& ends,
                   Concurrency concurrency);

  std::vector<Ring> m_rings; // one more than there are vertices
  std::vector<Spoke> m_spokes;
};

// A fan of faces is walked from its first halfedge, the one with no face at its right, or from any one where it closes.
struct Intrinsic_triangulation::Fans
{
  explicit Fans(const Intrinsic_faces& faces);

  static constexpr Index none = Intrinsic_faces::none;
  std::vector<Index> start;                         // of a vertex
  std::vector<std::pair<Index, Index>> more_starts; // vertices at which several fans meet have more than one
  std::vector<Index> number_of_spokes;              // of a vertex: one more than halfedges for each fan
};

inline Intrinsic_triangulation::Fans::Fans(const Intrinsic_faces& faces)
  : start(faces.number_of_vertices(), none), number_of_spokes(faces.number_of_vertices(), 0)
{
  const Index number_of_halfedges = static_cast<Index>(3 * faces.number_of_faces());
  for(Index h = 0; h < number_of_halfedges; ++h)
  {
    if(!faces.is_face(h / 3))
      continue;
    const Index v = faces.source(h);
    number_of_spokes[v] += start[v] == none ? 2 : 1;
    if(faces.opposite(h) != none)
      start[v] = start[v] == none ? h : start[v];
    else if(start[v] == none || faces.opposite(start[v]) != none)
      start[v] = h;
    else
    {
      more_starts.emplace_back(v, h);
      ++number_of_spokes[v];
    }
  }
  std::sort(more_starts.begin(), more_starts.end());
}

inline void Intrinsic_triangulation::collect_spokes(const Intrinsic_faces& faces, const Concurrency concurrency)
{
  const Fans fans(faces);
  const Index n = static_cast<Index>(fans.start.size());
  m_rings.resize(n + 1);
  Index first = 0;
  for(Index v = 0; v < n; first += fans.number_of_spokes[v++])
    m_rings[v] = Ring{infinity, first};
  m_rings[n] = Ring{infinity, first};
  m_spokes.resize(first);
  std::vector<Index> spoke_of(3 * faces.number_of_faces()); // the spoke that a halfedge became
  const auto collect = [&](const std::size_t begin, const std::size_t end) {
    std::vector<Open_end> ends;
    auto more = std::lower_bound(fans.more_starts.begin(), fans.more_starts.end(),
                                 std::make_pair(static_cast<Index>(begin), Index(0)));
    for(Index v = static_cast<Index>(begin); v < end; ++v)
    {
      if(fans.start[v] == Fans::none)
        continue;
      Index spoke = collect_fan(faces, v, fans.start[v], m_rings[v].first, spoke_of, ends);
      for(; more != fans.more_starts.end() && more->first == v; ++more)
        spoke = collect_fan(faces, v, more->second, spoke, spoke_of, ends);
      if(spoke != m_rings[v + 1].first)
        throw std::invalid_argument("geodesic remeshing: vertex " + std::to_string(v) +
                                    " is not manifold: faces all around it touch others there");
    }
    return ends;
  };
  const auto append = [](std::vector<Open_end> ends, const std::vector<Open_end>& more) {
    ends.insert(ends.end(), more.begin(), more.end());
    return ends;
  };
  link_spokes(faces, spoke_of, parallel_reduce(concurrency, n, std::vector<Open_end>(), collect, append), concurrency);
}

// Returns the next spoke.
inline Intrinsic_triangulation::Index Intrinsic_triangulation::collect_fan(const Intrinsic_faces& faces, const Index v,
                                                                           const Index start, Index spoke,
                                                                           std::vector<Index>& spoke_of,
                                                                           std::vector<Open_end>& ends)
{
  // what comes from one fan into another comes through the vertex: half a turn or more
  double angle = spoke > m_rings[v].first ? m_spokes[spoke - 1].angle + CGAL_PI : 0.;
  // until the spokes are linked, `reverse` holds the halfedge
  const auto add = [&](double length, double rim, Index neighbor, Index halfedge) {
    m_spokes[spoke++] = Spoke{length, rim, angle, neighbor, halfedge};
  };

  for(Index h = start;;)
  {
    const Index rim = Intrinsic_faces::next(h);
    const Index left = Intrinsic_faces::previous(h);
    spoke_of[h] = spoke;
    add(faces.length(h), faces.length(rim), faces.source(rim), h);
    angle += faces.angle_opposite_to(rim);
    h = faces.opposite(left);
    if(h == Intrinsic_faces::none)
    {
      ends.push_back(Open_end{spoke, left});
      add(faces.length(left), -1., faces.source(left), left);
      return spoke;
    }
    if(h == start)
    {
      m_rings[v].full_angle = angle;
      add(faces.length(start), -1., faces.source(Intrinsic_faces::next(start)), start);
      return spoke;
    }
  }
}

inline void Intrinsic_triangulation::link_spokes(const Intrinsic_faces& faces, const std::vector<Index>& spoke_of,
                                                 const std::vector<Open_end>& ends, const Concurrency concurrency)
{
  parallel_for(concurrency, m_spokes.size(), [&](const std::size_t i) {
    const Index o = faces.opposite(m_spokes[i].reverse);
    if(o != Intrinsic_faces::none)
      m_spokes[i].reverse = spoke_of[o];
  });
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
