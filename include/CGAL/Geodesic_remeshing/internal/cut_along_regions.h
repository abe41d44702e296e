// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_CUT_ALONG_REGIONS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_CUT_ALONG_REGIONS_H

#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Cuts the working surface along the boundaries of the regions, with the region of each face in "f:region". The regions
// are sets of vertices that are discs and annuli, so each edge between two of them is cut once and each face in as many
// pieces as it has regions: every region, as a set of faces, is a neighborhood of its vertices, of the same topology.
class Region_cutter
{
public:
  Region_cutter(const Mesh& mesh, const Segmentation& segmentation) : m_mesh(mesh), m_segmentation(segmentation)
  {
    find_regions();
  }

  Mesh run()
  {
    m_region = m_result.add_property_map<Face, int>("f:region", -1).first;
    for(Vertex v : m_mesh.vertices())
      m_result.add_vertex(m_mesh.point(v));
    m_cut.resize(m_mesh.number_of_edges());
    for(Edge e : m_mesh.edges())
    {
      const Vertex a = m_mesh.source(m_mesh.halfedge(e)), b = m_mesh.target(m_mesh.halfedge(e));
      if(m_region_of[a] != m_region_of[b])
        m_cut[e.idx()] = m_result.add_vertex(m_mesh.point(a) + position(a, b) * (m_mesh.point(b) - m_mesh.point(a)));
    }
    for(Face f : m_mesh.faces())
      cut(f);
    return std::move(m_result);
  }

private:
  // Regions that degenerate to their tops are part of the region below, and a leaf on a bridge of one beside it.
  void find_regions()
  {
    const std::vector<Region>& regions = m_segmentation.regions;
    std::vector<std::size_t> whole(regions.size());
    for(std::size_t r = whole.size(); r-- > 0;) // parents come after their children
      whole[r] = regions[r].parents.empty() || regions[r].number_of_levels > 0 ? r : whole[regions[r].parents.front()];
    m_region_of.resize(m_mesh.number_of_vertices(), -1);
    for(Vertex v : m_mesh.vertices())
    {
      int r = m_segmentation.region[v];
      while(r >= 0 && regions[r].part_of >= 0)
        r = regions[r].part_of;
      m_region_of[v] = r < 0 ? r : static_cast<int>(whole[r]);
    }
  }

  // How far a vertex is from where its region ends
  double distance_to_end(const Vertex v) const
  {
    const Region& region = m_segmentation.regions[m_segmentation.field_region[v]];
    const double below_top = (std::max)(0., m_segmentation.field[v]);
    const double above_bottom = (std::max)(0., region.height - m_segmentation.field[v]);
    return region.parents.empty()              ? below_top
           : region.kind == Region_kind::leaf ? above_bottom
                                              : (std::min)(below_top, above_bottom);
  }

  // Of the cut on an edge: strictly inside, so that no new face is degenerate
  double position(const Vertex a, const Vertex b) const
  {
    constexpr double least = .1;
    const double to_a = distance_to_end(a), sum = to_a + distance_to_end(b);
    return sum > 0. ? (std::min)((std::max)(to_a / sum, least), 1. - least) : .5;
  }

  void cut(const Face f)
  {
    std::array<Vertex, 3> corner, between; // the second from the first to the next
    Halfedge h = m_mesh.halfedge(f);
    for(int i = 0; i < 3; ++i, h = m_mesh.next(h))
    {
      corner[i] = m_mesh.source(h);
      between[i] = m_cut[m_mesh.edge(h).idx()];
    }
    const auto number_of_cuts = std::count_if(between.begin(), between.end(), [](Vertex v) { return v.is_valid(); });
    if(number_of_cuts == 3)
    {
      const Vertex center = m_result.add_vertex(
          CGAL::centroid(m_result.point(between[0]), m_result.point(between[1]), m_result.point(between[2])));
      for(int i = 0; i < 3; ++i)
        add_quadrilateral(corner[i], between[i], center, between[(i + 2) % 3]);
      return;
    }
    if(number_of_cuts == 0)
    {
      add_triangle(corner[0], corner[1], corner[2]);
      return;
    }
    const int single = !between[0].is_valid() ? 2 : !between[1].is_valid() ? 0 : 1; // opposite to the edge not cut
    const int next = (single + 1) % 3, last = (single + 2) % 3;
    add_triangle(corner[single], between[single], between[last]);
    add_quadrilateral(corner[next], corner[last], between[last], between[single]);
  }

  // Of the region of the first vertex
  void add_quadrilateral(const Vertex a, const Vertex b, const Vertex c, const Vertex d)
  {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }
  void add_triangle(const Vertex a, const Vertex b, const Vertex c)
  {
    m_region[m_result.add_face(a, b, c)] = m_region_of[a];
  }

  const Mesh& m_mesh;
  const Segmentation& m_segmentation;
  std::vector<int> m_region_of; // of each vertex
  std::vector<Vertex> m_cut;    // of each edge, where there is one
  Mesh m_result;
  Mesh::Property_map<Face, int> m_region;
};

inline Mesh cut_along_regions(const Mesh& mesh, const Segmentation& segmentation)
{
  return Region_cutter(mesh, segmentation).run();
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_CUT_ALONG_REGIONS_H
