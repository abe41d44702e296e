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
#include <CGAL/Geodesic_remeshing/internal/do_faces_intersect.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

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
