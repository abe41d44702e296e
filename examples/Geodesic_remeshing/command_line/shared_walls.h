// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHARED_WALLS_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHARED_WALLS_H

#include "soup.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace command_line {
namespace internal {

// Solids that touch in faces, as the parts of an assembly and blocks do, have each face of the wall between them twice,
// once from either side. To drop one of the two, as of faces that are there twice by mistake, leaves three faces at the
// rim of the wall, and cuts the solids open there; without both the solids are one.
class Shared_walls
{
public:
  explicit Shared_walls(Soup& soup) : m_soup(soup), m_twin(soup.polygons.size(), none), m_patches(soup.polygons.size())
  {}

  // Returns the number of faces that went.
  std::size_t drop()
  {
    find_twins();
    find_patches();
    std::size_t number = 0;
    for(std::size_t f = 0; f < m_twin.size(); ++f)
      if(is_wall(f))
        ++number;
      else
        m_soup.polygons[f - number].swap(m_soup.polygons[f]);
    m_soup.polygons.resize(m_soup.polygons.size() - number);
    return number;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  using Face = std::array<std::size_t, 3>;

  // From the smallest vertex on
  Face turned_to_start(const std::size_t f) const
  {
    Face face{{m_soup.polygons[f][0], m_soup.polygons[f][1], m_soup.polygons[f][2]}};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }

  // Pairs of faces with the same vertices in opposite order, of which there are no more than the two
  void find_twins()
  {
    std::vector<std::pair<Face, std::size_t>> faces;
    for(std::size_t f = 0; f < m_soup.polygons.size(); ++f)
    {
      Face face = turned_to_start(f);
      std::sort(face.begin(), face.end());
      faces.emplace_back(face, f);
    }
    std::sort(faces.begin(), faces.end());
    for(std::size_t i = 0, j = 0; i < faces.size(); i = j)
    {
      for(j = i; j < faces.size() && faces[j].first == faces[i].first;)
        ++j;
      const std::size_t f = faces[i].second, g = faces[j - 1].second;
      if(j - i == 2 && turned_to_start(f) != turned_to_start(g))
      {
        m_twin[f] = g;
        m_twin[g] = f;
      }
    }
  }

  // The faces that hang together by edges at which there are no others. At each edge of its rim a wall has an even
  // number of others, one of each solid; a sheet that is there twice has one.
  void find_patches()
  {
    m_has_even_rim.assign(m_twin.size(), 0);
    m_has_odd_rim.assign(m_twin.size(), 0);
    const std::vector<Side> sides = sorted_sides(m_soup);
    const auto number_of_others = [&](auto first, auto last) {
      return std::count_if(first, last, [&](const Side& s) { return m_twin[s.face] == none; });
    };
    for_each_edge(sides, [&](auto first, auto last) {
      const bool is_inside = number_of_others(first, last) == 0;
      for(auto s = first; s != last; ++s)
        if(m_twin[s->face] != none)
          m_patches.union_set(s->face, is_inside ? first->face : m_twin[s->face]);
    });
    for_each_edge(sides, [&](auto first, auto last) {
      const auto others = number_of_others(first, last);
      for(auto s = first; s != last; ++s)
        if(others > 0 && m_twin[s->face] != none)
          (others % 2 == 0 ? m_has_even_rim : m_has_odd_rim)[m_patches.find_set(s->face)] = 1;
    });
  }

  bool is_wall(const std::size_t f)
  {
    const std::size_t patch = m_patches.find_set(f);
    return m_twin[f] != none && m_has_even_rim[patch] && !m_has_odd_rim[patch];
  }

  Soup& m_soup;
  std::vector<std::size_t> m_twin; // of each face
  Disjoint_sets m_patches;
  std::vector<char> m_has_even_rim, m_has_odd_rim; // of a patch, by the face that stands for it
};

} // namespace internal
} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_SHARED_WALLS_H
