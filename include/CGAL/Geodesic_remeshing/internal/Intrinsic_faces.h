// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INTRINSIC_FACES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INTRINSIC_FACES_H

#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Faces that know their edge lengths and nothing of the space around them, glued along halfedges: halfedge 3 f + k
// leaves vertex k of face f. What is flipped in it may end with loops and multiple edges, hence the halfedges.
class Intrinsic_faces
{
public:
  using Index = std::uint32_t;

  static constexpr Index none = (std::numeric_limits<Index>::max)();

  struct Triangle
  {
    std::array<Index, 3> vertex = {{none, none, none}};   // vertex[0] == none: no face has this index
    std::array<Index, 3> opposite = {{none, none, none}}; // the halfedge on the other side, none on the boundary
    std::array<double, 3> length = {{0., 0., 0.}};
  };

  Intrinsic_faces(std::size_t number_of_vertices, std::size_t number_of_faces)
    : m_number_of_vertices(number_of_vertices), m_triangles(number_of_faces)
  {
    CGAL_precondition(3 * number_of_faces < none && number_of_vertices < none);
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  std::size_t number_of_faces() const { return m_triangles.size(); }
  bool is_face(Index f) const { return m_triangles[f].vertex[0] != none; }
  const Triangle& triangle(Index f) const { return m_triangles[f]; }
  Triangle& triangle(Index f) { return m_triangles[f]; }

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index source(Index h) const { return m_triangles[h / 3].vertex[h % 3]; }
  Index opposite(Index h) const { return m_triangles[h / 3].opposite[h % 3]; }
  double length(Index h) const { return m_triangles[h / 3].length[h % 3]; }

  // A length given by weights may be longer than the way around by the third vertex, which then is the shortest path
  // along these edges: it becomes the length. Nothing but lengths that fall: the shortest paths stay what they were.
  void enforce_triangle_inequality(Concurrency concurrency = Concurrency());

  // Keeps a face as it is: its edges are not flipped.
  void freeze(Index f)
  {
    m_is_frozen.resize(m_triangles.size(), false);
    m_is_frozen[f] = true;
  }

  // Flips to the intrinsic Delaunay triangulation of the same piecewise flat surface.
  void make_Delaunay(Concurrency concurrency = Concurrency());

  // Zero where the face is a point or so thin that the angle is lost.
  double angle_opposite_to(Index h) const { return std::atan2(sine_of_opposite_angle(h), opposite_angle(h).cosine); }

private:
  // Of the angle opposite to a halfedge in its face: the cosine times the product of the angle's sides, and that
  // product.
  struct Opposite_angle
  {
    double cosine;
    double product;
  };

  Opposite_angle opposite_angle(Index h) const
  {
    const double a = length(h);
    const double b = length(next(h));
    const double c = length(previous(h));
    return {0.5 * (b * b + c * c - a * a), b * c};
  }

  // Times the product as well; by Heron's formula, as accurate as the lengths are.
  double sine_of_opposite_angle(Index h) const
  {
    const double a = length(h);
    const double b = length(next(h));
    const double c = length(previous(h));
    return 0.5 * std::sqrt((std::max)(0., (a + (b - c)) * (a - (b - c)) * ((b + c) - a) * ((b + c) + a)));
  }

  bool is_frozen(Index f) const { return !m_is_frozen.empty() && m_is_frozen[f]; }
  bool violates_triangle_inequality(Index f) const;
  bool must_flip(Index h) const;
  double length_after_flip(Index h) const;
  void flip(Index h);

  void set_opposite(Index h, Index o)
  {
    m_triangles[h / 3].opposite[h % 3] = o;
    if(o != none)
      m_triangles[o / 3].opposite[o % 3] = h;
  }

  std::size_t m_number_of_vertices;
  std::vector<Triangle> m_triangles;
  std::vector<bool> m_is_frozen; // empty if none is
};

// The sum of the angles opposite to the edge exceeds pi: its sine is negative. One of the angles must then be obtuse,
// which is seen without a root, and is false for nearly all edges of a usual mesh. Where a face is nearly flat, its
// sine has an error of the root of the machine's precision, 1.5e-8; so small an excess over pi is not worth a flip, nor
// could it be told from a deficit.
inline bool Intrinsic_faces::must_flip(Index h) const
{
  const Index o = opposite(h);
  if(o == none || o / 3 == h / 3)
    return false;
  const Opposite_angle p = opposite_angle(h);
  const Opposite_angle q = opposite_angle(o);
  if((p.cosine >= 0. && q.cosine >= 0.) || is_frozen(h / 3) || is_frozen(o / 3))
    return false;
  return sine_of_opposite_angle(h) * q.cosine + sine_of_opposite_angle(o) * p.cosine < -1e-7 * p.product * q.product;
}

// The distance of the two apexes, unfolded over the edge.
inline double Intrinsic_faces::length_after_flip(Index h) const
{
  const Index o = opposite(h);
  const double base = length(h);
  const double left = length(previous(h)), left_far = length(next(h));
  const double right = length(next(o)), right_far = length(previous(o));
  const double left_x = ((left - left_far) * (left + left_far) + base * base) / (2. * base);
  const double right_x = ((right - right_far) * (right + right_far) + base * base) / (2. * base);
  const double left_y = std::sqrt((std::max)(0., (left - left_x) * (left + left_x)));
  const double right_y = std::sqrt((std::max)(0., (right - right_x) * (right + right_x)));
  const double x = left_x - right_x;
  const double y = left_y + right_y;
  return std::sqrt(x * x + y * y);
}

// The edge from a to b with the apexes c (left) and d (right) becomes the edge from c to d. Each of the two faces keeps
// the edge after the flipped one and takes over the edge before the flipped one from the other face.
inline void Intrinsic_faces::flip(Index h)
{
  const Index o = opposite(h);
  const double new_length = length_after_flip(h);
  const Index before_h = previous(h), before_o = previous(o);
  const Index c = source(before_h), d = source(before_o);
  const double length_h = length(before_h), length_o = length(before_o);
  Index across_h = opposite(before_h), across_o = opposite(before_o);

  // the slots move: what was glued to a slot of this very pair of faces must be followed
  const auto moved = [&](Index x) { return x == before_h ? o : x == before_o ? h : x; };
  across_h = moved(across_h);
  across_o = moved(across_o);

  m_triangles[h / 3].vertex[h % 3] = d;
  m_triangles[o / 3].vertex[o % 3] = c;
  m_triangles[h / 3].length[h % 3] = length_o;
  m_triangles[o / 3].length[o % 3] = length_h;
  m_triangles[before_h / 3].length[before_h % 3] = new_length;
  m_triangles[before_o / 3].length[before_o % 3] = new_length;
  set_opposite(h, across_o);
  set_opposite(o, across_h);
  set_opposite(before_h, before_o);
}

// In exact arithmetic flipping ends by itself, as each flip lowers the Dirichlet energy of every function on the
// vertices. Rounding could make it turn in a circle, hence a bound; a triangulation that is not quite Delaunay serves
// as well.
inline void Intrinsic_faces::make_Delaunay(const Concurrency concurrency)
{
  const auto find = [&](const std::size_t begin, const std::size_t end) {
    std::vector<Index> found;
    for(Index h = static_cast<Index>(begin); h < end; ++h)
      if(is_face(h / 3) && h < opposite(h) && must_flip(h))
        found.push_back(h);
    return found;
  };
  const auto append = [](std::vector<Index> all, const std::vector<Index>& found) {
    all.insert(all.end(), found.begin(), found.end());
    return all;
  };
  std::vector<Index> pending = parallel_reduce(concurrency, 3 * m_triangles.size(), std::vector<Index>(), find, append);

  for(std::size_t flips_left = 100 * m_triangles.size(); !pending.empty() && flips_left > 0;)
  {
    const Index h = pending.back();
    pending.pop_back();
    if(!must_flip(h)) // another edge may have come to lie here; it is pending at its own slot, too
      continue;
    const Index o = opposite(h);
    flip(h);
    --flips_left;
    for(const Index around : {h, next(h), o, next(o)})
      pending.push_back(around);
  }
}

inline bool Intrinsic_faces::violates_triangle_inequality(const Index f) const
{
  const auto& length = m_triangles[f].length;
  return length[0] > length[1] + length[2] || length[1] > length[2] + length[0] || length[2] > length[0] + length[1];
}

inline void Intrinsic_faces::enforce_triangle_inequality(const Concurrency concurrency)
{
  const auto violate = [&](const std::size_t begin, const std::size_t end) {
    for(Index f = static_cast<Index>(begin); f < end; ++f)
      if(violates_triangle_inequality(f))
        return char(1);
    return char(0);
  };
  if(!parallel_reduce(concurrency, m_triangles.size(), char(0), violate, std::bit_or<>()))
    return;
  std::vector<Index> pending;
  const auto repair = [&](Index f) {
    Triangle& t = m_triangles[f];
    for(Index k = 0; k < 3; ++k)
    {
      const double around = t.length[(k + 1) % 3] + t.length[(k + 2) % 3];
      if(t.length[k] <= around)
        continue;
      t.length[k] = around;
      const Index o = t.opposite[k];
      if(o == none)
        continue;
      m_triangles[o / 3].length[o % 3] = around;
      pending.push_back(o / 3);
    }
  };
  for(Index f = 0; f < m_triangles.size(); ++f)
    repair(f);
  while(!pending.empty())
  {
    const Index f = pending.back();
    pending.pop_back();
    repair(f);
  }
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INTRINSIC_FACES_H
