// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SELF_INTERSECTIONS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SELF_INTERSECTIONS_H

#include <CGAL/Geodesic_remeshing/internal/Component_numbers.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Faces without area, and what is near to them: of faces that meet at one, those that share no edge but lie on the same
// segment count as intersecting, though no sheet goes through another one.
class Degenerate_faces
{
public:
  using Pair = std::pair<Face, Face>;

  // `Polygon_mesh_processing` lists such a face as a pair of that face and itself.
  Degenerate_faces(const Mesh& mesh, const std::vector<Pair>& pairs) : m_mesh(mesh), m_is_at_one(mesh.num_vertices(), 0)
  {
    Component_numbers groups(mesh.num_vertices());
    for(const Pair& pair : pairs)
      if(pair.first == pair.second)
        for(const Vertex v : vertices_of(mesh, pair.first))
        {
          m_is_at_one[v] = 1;
          groups.join(v, vertices_of(mesh, pair.first)[0]);
        }
    std::size_t number;
    m_group = groups.take(number);
  }

  // Whether both faces are at one group of them
  bool are_at_one(const Pair& pair) const
  {
    for(const Vertex v : vertices_of(m_mesh, pair.first))
      for(const Vertex w : vertices_of(m_mesh, pair.second))
        if(m_is_at_one[v] && m_is_at_one[w] && m_group[v] == m_group[w])
          return true;
    return false;
  }

private:
  const Mesh& m_mesh;
  std::vector<char> m_is_at_one;
  std::vector<std::uint32_t> m_group; // of vertices
};

// The pairs of faces that intersect elsewhere than in what they share, but for those of degenerate faces
template <class Concurrency_tag = Sequential_tag, class Faces>
std::vector<std::pair<Face, Face>> self_intersections(const Faces& faces, const Mesh& mesh)
{
  using Pair = Degenerate_faces::Pair;
  std::vector<Pair> pairs;
  Polygon_mesh_processing::self_intersections<Concurrency_tag>(faces, mesh, std::back_inserter(pairs));
  if(std::none_of(pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.first == pair.second; }))
    return pairs;
  const Degenerate_faces degenerate(mesh, pairs);
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [&](const Pair& pair) { return degenerate.are_at_one(pair); }),
              pairs.end());
  return pairs;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SELF_INTERSECTIONS_H
