// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_NESTED_BLOCKS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_NESTED_BLOCKS_H

#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// How a mesh is divided among threads: into blocks of 2^bits vertices with successive indices. Where the indices follow
// an order in space, blocks are patches of the surface with short borders.
struct Block_size
{
  static constexpr unsigned one_block = 31;

  Concurrency concurrency;
  unsigned bits = one_block;
};

// One of the blocks, or some that follow one another
struct Block
{
  using Index = std::uint32_t;

  Index begin, end; // vertices

  bool has(const Index v) const { return begin <= v && v < end; }
  // 0 if it has the vertex; else in which bits that differs from another
  Index bits_beyond(const Index v, const Index other) const { return has(v) ? 0 : v ^ other; }
};

// Calls `step(i, block)` for each i of [0, steps), of which as many as `steps_a_vertex` are near each vertex, in an
// order that several threads can keep: first, at the same time, for all blocks, in each for the steps near its
// vertices. A step that would read or write what is at vertices beyond `block` does nothing but tell in which bits the
// numbers of its vertices differ; one that is done returns 0. What was not done is tried again when blocks are as large
// as it needs: they are doubled until one block has everything. Nothing in that depends on threads, so one thread makes
// the same steps, in an order with the same result; and with one block in that of i.
template <class Step>
void for_each_in_blocks(const Block_size size, const Block::Index vertices, const Block::Index steps,
                        const Block::Index steps_a_vertex, const Step& step)
{
  using Index = Block::Index;
  struct Left
  {
    Index step, differing_bits;
  };
  std::vector<std::vector<std::vector<Index>>> waiting(1); // for a level of blocks, there for a block
  waiting[0].resize(vertices == 0 ? 1 : ((vertices - 1) >> size.bits) + 1);
  while(waiting.back().size() > 1)
    waiting.emplace_back((waiting.back().size() + 1) / 2);
  std::vector<std::vector<Left>> left(waiting[0].size());
  for(std::size_t level = 0; level < waiting.size(); ++level)
  {
    const Index bits = size.bits + static_cast<Index>(level), blocks = static_cast<Index>(waiting[level].size());
    const auto run = [&](const std::size_t b) {
      const Index begin = static_cast<Index>(b) << bits;
      const Block block{begin, b + 1 < blocks ? begin + (Index(1) << bits) : static_cast<Index>(-1)};
      const auto try_step = [&](const Index i) {
        const Index differing_bits = step(i, block);
        if(differing_bits != 0)
          left[b].push_back({i, differing_bits});
      };
      if(level == 0)
        for(Index i = steps_a_vertex * begin; i < steps && (b + 1 == blocks || i < steps_a_vertex * block.end); ++i)
          try_step(i);
      std::for_each(waiting[level][b].begin(), waiting[level][b].end(), try_step);
    };
    parallel_for(size.concurrency, blocks, run, 1);
    for(Index b = 0; b < blocks; ++b)
    {
      for(const Left& l : left[b])
      {
        std::size_t next = level + 1;
        while(next + 1 < waiting.size() && l.differing_bits >> (size.bits + next) != 0)
          ++next;
        waiting[next][b >> (next - level)].push_back(l.step);
      }
      left[b].clear();
    }
  }
}

// Calls `step(i, block)` for each i of [0, steps) and for each block with one of the vertices that `vertices_of(i)`
// lists, at the same time for different blocks, in a block in the order of i. A vertex that does not exist is in no
// block.
template <class Vertices_of, class Step>
void for_each_by_vertices(const Block_size size, const Block::Index vertices, const Block::Index steps,
                          const Vertices_of& vertices_of, const Step& step)
{
  using Index = Block::Index;
  const std::size_t blocks = size.concurrency.is_parallel() ? (vertices >> size.bits) + 1 : 1;
  if(blocks == 1)
  {
    for(Index i = 0; i < steps; ++i)
      step(i, Block{0, vertices});
    return;
  }
  constexpr std::size_t runs = 64; // each lists its steps by block
  const std::size_t steps_a_run = steps / runs + 1;
  std::vector<std::vector<Index>> lists(runs * blocks);
  const auto list = [&](const std::size_t begin, const std::size_t end) {
    const auto list_of = [&](const Index v) -> std::vector<Index>& {
      return lists[begin / steps_a_run * blocks + (v >> size.bits)];
    };
    for(std::size_t i = begin; i < end; ++i)
      for(const Index v : vertices_of(static_cast<Index>(i)))
        if(v < vertices && (list_of(v).empty() || list_of(v).back() != i))
          list_of(v).push_back(static_cast<Index>(i));
  };
  for_each_block(size.concurrency, steps, steps_a_run, list);
  const auto run = [&](const std::size_t b) {
    const Index begin = static_cast<Index>(b << size.bits);
    const Block block{begin, (std::min)(vertices, begin + (Index(1) << size.bits))};
    for(std::size_t k = b; k < lists.size(); k += blocks)
      for(const Index i : lists[k])
        step(i, block);
  };
  parallel_for(size.concurrency, blocks, run, 1);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_NESTED_BLOCKS_H
