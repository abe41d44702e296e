// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VALENCE_ENERGY_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VALENCE_ENERGY_H

#include <CGAL/Geodesic_remeshing/internal/Lean_triangulation.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How far the valences are from the regular ones. The squares of this excess summed over the vertices are the energy
// that flips, collapses and splits lower; what one of them would add to it needs no trial. Two vertices of valence 5
// have less of it than one of valence 4; where the irregular vertices cannot vanish, flips merge them if their number
// counts rather than the squares. Lines divide the ring of a vertex into sectors, each with a regular number of faces
// and an excess of its own.
class Valence_energy
{
public:
  using Index = Lean_triangulation::Index;

  // Without lines in the triangulation nothing is asked about them.
  Valence_energy(const Lean_triangulation& table, const bool has_lines) : m_table(table), m_has_lines(has_lines) {}

  // A vertex that stays where it is, with lines that need not go on straight. `point(v)` is asked for the angles around
  // it.
  template <class Point_of>
  void add_corner(Index v, const Point_of& point);
  void let_numbers_count(const bool value) { m_do_numbers_count = value; }

  int excess_at(const Index h) const // of the sector of face(h) at source(h)
  {
    const Index v = m_table.source(h);
    return is_on_line(v) ? excess_in_sector(h) : static_cast<int>(m_table.valence(v)) - 6;
  }
  bool is_irregular(Index v) const;
  int of_flip(Index h) const;
  int of_collapse(Index h) const;
  int of_edge_split(Index h) const;

private:
  bool is_on_line(const Index v) const { return m_has_lines && m_table.is_on_line(v); }
  int energy(int excess) const;
  int of_half_collapse(Index h) const;
  int excess_in_sector(Index h) const;

  const Lean_triangulation& m_table;
  const bool m_has_lines;
  bool m_do_numbers_count = false;
  std::vector<Index> m_first_sector; // of a vertex: the first of its entries in `m_regular_faces`, or `none`
  std::vector<int> m_regular_faces;  // a sector, counterclockwise from the vertex' first halfedge
};

// As many faces are regular in a sector as make the parts of its angle nearest to 60 degrees.
template <class Point_of>
void Valence_energy::add_corner(const Index v, const Point_of& point)
{
  const Index first = m_table.halfedge(v);
  m_first_sector.resize((std::max)(m_first_sector.size(), std::size_t(v) + 1), Lean_triangulation::none);
  m_first_sector[v] = static_cast<Index>(m_regular_faces.size());
  std::vector<double> angles;
  m_table.for_each_outgoing(v, [&](const Index h) {
    if(h == first || m_table.is_constrained(h))
      angles.push_back(0.);
    const Vector a = point(m_table.target(h)) - point(v), b = point(m_table.apex(h)) - point(v);
    angles.back() += std::atan2(std::sqrt(cross_product(a, b).squared_length()), a * b);
  });
  // Right angles are common and as good in one part as in two; two it is, whatever the rounding.
  for(const double angle : angles)
    m_regular_faces.push_back((std::max)(1, static_cast<int>(angle * 3. / CGAL_PI + .51)));
}

inline int Valence_energy::energy(const int excess) const
{
  // A vertex of valence 4 counts less than two of valence 5, one of valence 8 as much as two of valence 7.
  constexpr std::array<int, 5> counting = {{7, 4, 0, 4, 8}};
  return m_do_numbers_count && std::abs(excess) <= 2 ? counting[excess + 2] : 3 * excess * excess;
}

inline int Valence_energy::of_flip(const Index h) const
{
  const Index o = m_table.opposite(h);
  const int a = excess_at(h), b = excess_at(o);
  const int c = excess_at(Lean_triangulation::previous(h)), d = excess_at(Lean_triangulation::previous(o));
  return energy(a - 1) - energy(a) + energy(b - 1) - energy(b) + energy(c + 1) - energy(c) + energy(d + 1) - energy(d);
}

inline int Valence_energy::of_collapse(const Index h) const
{
  const Index o = m_table.opposite(h);
  if(m_table.is_constrained(h))
    return of_half_collapse(h) + (o == Lean_triangulation::none ? 0 : of_half_collapse(o));
  const int a = excess_at(h), b = excess_at(o);
  const int c = excess_at(Lean_triangulation::previous(h)), d = excess_at(Lean_triangulation::previous(o));
  return (a + b + 2) * (a + b + 2) - a * a - b * b + 2 - 2 * c - 2 * d;
}

// That of one side of a line
inline int Valence_energy::of_half_collapse(const Index h) const
{
  const int a = excess_at(h), b = excess_at(Lean_triangulation::next(h));
  const int c = excess_at(Lean_triangulation::previous(h));
  return (a + b + 1) * (a + b + 1) - a * a - b * b + 1 - 2 * c;
}

// A new vertex on a line has two faces on each side where three are regular; another has four where six are.
inline int Valence_energy::of_edge_split(const Index h) const
{
  const Index o = m_table.opposite(h);
  const int c = 1 + 2 * excess_at(Lean_triangulation::previous(h));
  const int d = o == Lean_triangulation::none ? 0 : 1 + 2 * excess_at(Lean_triangulation::previous(o));
  return c + d + (!m_table.is_constrained(h) ? 4 : o == Lean_triangulation::none ? 1 : 2);
}

inline int Valence_energy::excess_in_sector(const Index h) const
{
  const Index v = m_table.source(h), first = m_table.halfedge(v);
  Index sector = 0;
  int faces = 0;
  bool is_found = false;
  Index g = first;
  do
  {
    if(m_table.is_constrained(g) && g != first)
    {
      if(is_found)
        break;
      ++sector;
      faces = 0;
    }
    ++faces;
    is_found = is_found || g == h;
    g = m_table.rotate(g);
  } while(g != first && g != Lean_triangulation::none);
  const bool is_corner = v < m_first_sector.size() && m_first_sector[v] != Lean_triangulation::none;
  return faces - (is_corner ? m_regular_faces[m_first_sector[v] + sector] : 3);
}

inline bool Valence_energy::is_irregular(const Index v) const
{
  bool result = false;
  if(!is_on_line(v))
    return excess_at(m_table.halfedge(v)) != 0;
  m_table.for_each_outgoing(v, [&](const Index h) { result = result || excess_in_sector(h) != 0; });
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VALENCE_ENERGY_H
