// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_SEARCH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_SEARCH_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

inline Kernel::Triangle_3 triangle_of(const Remeshed_surface& remeshed, const Lean_triangulation::Index f)
{
  const Lean_triangulation& table = remeshed.connectivity();
  return {remeshed.spot(table.source(4 * f)).point, remeshed.spot(table.source(4 * f + 1)).point,
          remeshed.spot(table.source(4 * f + 2)).point};
}

struct Face_box
{
  std::array<double, 3> low = {{infinity, infinity, infinity}}, high = {{-infinity, -infinity, -infinity}};
};

inline Face_box box_of(const Remeshed_surface& remeshed, const Lean_triangulation::Index f)
{
  Face_box box;
  for(Lean_triangulation::Index h = 4 * f; h < 4 * f + 3; ++h)
    for(int i = 0; i < 3; ++i)
    {
      const double x = remeshed.spot(remeshed.connectivity().source(h)).point[i];
      box.low[i] = (std::min)(box.low[i], x);
      box.high[i] = (std::max)(box.high[i], x);
    }
  return box;
}

inline bool do_overlap(const Face_box& a, const Face_box& b)
{
  for(int i = 0; i < 3; ++i)
    if(a.low[i] > b.high[i] || b.low[i] > a.high[i])
      return false;
  return true;
}

// By a plane across the way between the centers, with a distance far above the rounding.
inline bool are_apart(const Remeshed_surface& remeshed, const Lean_triangulation::Index f,
                      const Lean_triangulation::Index g)
{
  using Index = Lean_triangulation::Index;
  const auto point = [&](const Index h) -> const Point& {
    return remeshed.spot(remeshed.connectivity().source(h)).point;
  };
  const Point& origin = point(4 * f);
  Vector way(0., 0., 0.);
  for(Index i = 0; i < 3; ++i)
    way = way + (point(4 * g + i) - point(4 * f + i));
  double end = -infinity, start = infinity;
  for(Index i = 0; i < 3; ++i)
  {
    end = (std::max)(end, (point(4 * f + i) - origin) * way);
    start = (std::min)(start, (point(4 * g + i) - origin) * way);
  }
  return start - end > 1e-3 * way.squared_length();
}

// The same for the sides of two faces across from a corner that they share, by a plane through it.
inline bool are_apart_at_corner(const Remeshed_surface& remeshed, const Lean_triangulation::Index h,
                                const Lean_triangulation::Index k)
{
  const Lean_triangulation& table = remeshed.connectivity();
  const Point& corner = remeshed.spot(table.source(h)).point;
  const auto way_to = [&](const Lean_triangulation::Index v) { return remeshed.spot(v).point - corner; };
  const Vector a = way_to(table.target(h)), b = way_to(table.apex(h)), c = way_to(table.target(k)),
               d = way_to(table.apex(k));
  const Vector way = c + d - a - b;
  const double far = 1e-3 * way.squared_length();
  return (std::max)(a * way, b * way) < -far && (std::min)(c * way, d * way) > far;
}

// Whether two faces have more in common than their vertices. Two that share an edge do so only if one lies on the
// other, which is a turned face.
inline bool do_faces_intersect(const Remeshed_surface& remeshed, const Lean_triangulation::Index f,
                               const Lean_triangulation::Index g)
{
  const Lean_triangulation& table = remeshed.connectivity();
  Lean_triangulation::Index h = Lean_triangulation::none, k = h;
  int shared = 0;
  for(Lean_triangulation::Index i = 4 * f; i < 4 * f + 3; ++i)
    for(Lean_triangulation::Index j = 4 * g; j < 4 * g + 3; ++j)
      if(table.source(i) == table.source(j))
      {
        ++shared;
        h = i;
        k = j;
      }
  if(shared > 1 || (shared == 1 ? are_apart_at_corner(remeshed, h, k) : are_apart(remeshed, f, g)))
    return false;
  const Kernel::Triangle_3 s = triangle_of(remeshed, f), t = triangle_of(remeshed, g);
  if(s.is_degenerate() || t.is_degenerate())
    return false; // the predicates do not take faces of no area, and parting them from others would not mend them
  if(shared == 0)
    return do_intersect(s, t);
  const auto opposite = [&](const Lean_triangulation::Index i) {
    return Kernel::Segment_3(remeshed.spot(table.target(i)).point, remeshed.spot(table.apex(i)).point);
  };
  return do_intersect(opposite(h), t) || do_intersect(opposite(k), s);
}

// Whether a face at one of the vertices intersects one near them: no farther than two faces beyond.
template <class Vertices>
bool has_intersections_near(const Remeshed_surface& remeshed, const Vertices& vertices)
{
  using Index = Lean_triangulation::Index;
  const Lean_triangulation& table = remeshed.connectivity();
  std::vector<Index> around(vertices.begin(), vertices.end()), faces;
  const auto add_faces = [&] {
    for(const Index v : around)
      table.for_each_outgoing(v, [&](const Index h) { faces.push_back(Lean_triangulation::face(h)); });
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  };
  add_faces();
  const std::vector<Index> changed = faces;
  for(int ring = 0; ring < 2; ++ring)
  {
    around.clear();
    for(const Index f : faces)
      for(Index h = 4 * f; h < 4 * f + 3; ++h)
        around.push_back(table.source(h));
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    add_faces();
  }
  std::vector<Face_box> boxes;
  for(const Index f : faces)
    boxes.push_back(box_of(remeshed, f));
  for(const Index f : changed)
  {
    const Face_box box = box_of(remeshed, f);
    for(std::size_t i = 0; i < faces.size(); ++i)
      if(f != faces[i] && do_overlap(box, boxes[i]) && do_faces_intersect(remeshed, f, faces[i]))
        return true;
  }
  return false;
}

// Finds the pairs of faces that intersect. Nearly all faces are near none but their neighbours, and of those that share
// no vertex with them nearly all are parted by a plane between the two. So what is fast is to halve space where the
// faces are until few are left in each part, and there to try the plane before asking for the exact answer.
class Intersection_search
{
public:
  using Index = Lean_triangulation::Index;
  using Pair = std::pair<Index, Index>;

  explicit Intersection_search(const Remeshed_surface& remeshed)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_concurrency(remeshed.block_size().concurrency),
      m_boxes(m_table.face_slots())
  {}

  std::vector<Pair> run(); // sorted
  // Only the pairs with at least one of these faces: after a search whatever else has not changed need not be asked.
  std::vector<Pair> run(const std::vector<Index>& suspects);

private:
  using Box = Face_box;
  // What a thread does by itself
  struct Share
  {
    std::vector<Index> faces; // of a part, after those of the parts it is in
    std::vector<Pair> pairs;
  };

  Box bounds(const Share& share, std::size_t begin, std::size_t end) const;
  void divide(Share& share, std::size_t begin, std::size_t end, const Box& part) const;
  void test_all(Share& share, std::size_t begin, std::size_t end, const Box& part) const;
  bool do_boxes_overlap(Index f, Index g, const Box& part) const;
  bool is_in_half(const Index f, const int side, const std::ptrdiff_t axis, const double middle) const
  {
    return side == 0 ? m_boxes[f].low[axis] < middle : m_boxes[f].high[axis] >= middle;
  }
  bool is_suspect(const Index f) const { return m_suspects.empty() || m_suspects[f]; }

  const Remeshed_surface& m_remeshed;
  const Lean_triangulation& m_table;
  const Concurrency m_concurrency;
  std::vector<Box> m_boxes;     // by face
  std::vector<char> m_suspects; // by face; empty if all are
};

inline Intersection_search::Box Intersection_search::bounds(const Share& share, const std::size_t begin,
                                                            const std::size_t end) const
{
  Box all;
  for(std::size_t k = begin; k < end; ++k)
    for(int i = 0; i < 3; ++i)
    {
      all.low[i] = (std::min)(all.low[i], m_boxes[share.faces[k]].low[i]);
      all.high[i] = (std::max)(all.high[i], m_boxes[share.faces[k]].high[i]);
    }
  return all;
}

// A face is in every part that its box meets. Where halving does not help, faces are all near to each other.
inline void Intersection_search::divide(Share& share, const std::size_t begin, const std::size_t end,
                                        const Box& part) const
{
  constexpr std::size_t few = 24, many = 8192;
  std::vector<Index>& faces = share.faces;
  if(end - begin <= few)
    return test_all(share, begin, end, part);
  if(std::none_of(faces.begin() + begin, faces.begin() + end, [&](const Index f) { return is_suspect(f); }))
    return;
  const Box all = bounds(share, begin, end);
  std::array<double, 3> low, length;
  for(int i = 0; i < 3; ++i)
  {
    low[i] = (std::max)(all.low[i], part.low[i]);
    length[i] = (std::min)(all.high[i], part.high[i]) - low[i];
  }
  const auto axis = std::max_element(length.begin(), length.end()) - length.begin();
  const double middle = low[axis] + length[axis] / 2.;
  if(!(low[axis] < middle)) // all meet at one point, to the last bit: these nothing parts
    return test_all(share, begin, end, part);
  std::array<Box, 2> half = {{part, part}};
  half[0].high[axis] = half[1].low[axis] = middle;
  std::size_t number = 0;
  for(std::size_t k = begin; k < end; ++k)
    number += std::size_t(is_in_half(faces[k], 0, axis, middle)) + std::size_t(is_in_half(faces[k], 1, axis, middle));
  if(2 * number > 3 * (end - begin))
    return test_all(share, begin, end, part);
  const auto divide_half = [&](Share& other, const int side) {
    const std::size_t first = other.faces.size();
    for(std::size_t k = begin; k < end; ++k)
      if(is_in_half(faces[k], side, axis, middle))
        other.faces.push_back(faces[k]);
    divide(other, first, other.faces.size(), half[side]);
    other.faces.resize(first);
  };
  if(!m_concurrency.is_parallel() || end - begin < many)
  {
    divide_half(share, 0);
    divide_half(share, 1);
    return;
  }
  std::array<Share, 2> shares;
  parallel_invoke(
      m_concurrency, [&] { divide_half(shares[0], 0); }, [&] { divide_half(shares[1], 1); });
  for(const Share& s : shares)
    share.pairs.insert(share.pairs.end(), s.pairs.begin(), s.pairs.end());
}

// Two boxes that overlap do so in several parts; they count in that with the lowest corner of what they have in common.
inline bool Intersection_search::do_boxes_overlap(const Index f, const Index g, const Box& part) const
{
  const Box &a = m_boxes[f], &b = m_boxes[g];
  for(int i = 0; i < 3; ++i)
  {
    const double low = (std::max)(a.low[i], b.low[i]);
    if(low > (std::min)(a.high[i], b.high[i]) || low < part.low[i] || !(low < part.high[i]))
      return false;
  }
  return true;
}

inline void Intersection_search::test_all(Share& share, const std::size_t begin, const std::size_t end,
                                          const Box& part) const
{
  for(std::size_t k = begin; k < end; ++k)
    for(std::size_t l = begin; l < k; ++l)
    {
      const Index f = share.faces[l], g = share.faces[k];
      if((is_suspect(f) || is_suspect(g)) && do_boxes_overlap(f, g, part) && do_faces_intersect(m_remeshed, f, g))
        share.pairs.push_back(std::minmax(f, g));
    }
}

inline std::vector<Intersection_search::Pair> Intersection_search::run(const std::vector<Index>& suspects)
{
  if(suspects.empty())
    return {};
  m_suspects.assign(m_table.face_slots(), 0);
  for(const Index f : suspects)
    m_suspects[f] = 1;
  return run();
}

inline std::vector<Intersection_search::Pair> Intersection_search::run()
{
  Share all;
  all.faces =
      parallel_list(m_concurrency, m_table.face_slots(), [&](const Index f) { return !m_table.is_removed_face(f); });
  parallel_for(m_concurrency, all.faces.size(),
               [&](const std::size_t i) { m_boxes[all.faces[i]] = box_of(m_remeshed, all.faces[i]); });
  divide(all, 0, all.faces.size(), {{{-infinity, -infinity, -infinity}}, {{infinity, infinity, infinity}}});
  std::sort(all.pairs.begin(), all.pairs.end());
  return std::move(all.pairs);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_INTERSECTION_SEARCH_H
