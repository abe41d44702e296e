// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_COMPONENT_NUMBERS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_COMPONENT_NUMBERS_H

#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Numbers connected components, of vertices or of anything else with an index, in the order of their first vertices: by
// union and find, one pass over the pairs of neighbors in the order in which they lie in memory, where a flood would
// run to and fro.
class Component_numbers
{
public:
  explicit Component_numbers(const std::size_t number_of_vertices) : m_parent(number_of_vertices)
  {
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      m_parent[v] = static_cast<std::uint32_t>(v);
  }

  void join(const std::size_t v, const std::size_t w)
  {
    const std::uint32_t a = find(v), b = find(w);
    (a < b ? m_parent[b] : m_parent[a]) = a < b ? a : b;
  }

  // The numbers of the vertices' components; `none` for the vertices of those whose first vertex is not `is_one(v)`.
  template <class Is_one>
  std::vector<std::uint32_t> take(std::size_t& number, const std::uint32_t none, const Is_one& is_one)
  {
    number = 0;
    for(std::size_t v = 0; v < m_parent.size(); ++v)
      if(m_parent[v] != v) // the parent comes before and has its number
        m_parent[v] = m_parent[m_parent[v]];
      else
        m_parent[v] = is_one(v) ? static_cast<std::uint32_t>(number++) : none;
    return std::move(m_parent);
  }

  std::vector<std::uint32_t> take(std::size_t& number)
  {
    return take(number, 0, [](std::size_t) { return true; });
  }

private:
  std::uint32_t find(std::size_t v)
  {
    while(m_parent[v] != v)
      v = m_parent[v] = m_parent[m_parent[v]];
    return static_cast<std::uint32_t>(v);
  }

  std::vector<std::uint32_t> m_parent; // none is larger than its vertex
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_COMPONENT_NUMBERS_H
