// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_RELAXATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_RELAXATION_H

#include <CGAL/Geodesic_remeshing/internal/Nested_blocks.h>
#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Steps that make no angle smaller than this one need not ask whether they make one smaller than it was: angles up to
// here may be spent on evenness, which pays back in the mean.
inline double tolerated_badness()
{
  static const double badness = badness_of_angle(36.);
  return badness;
}

// On a mesh of many vertices limbs are many edges around, and few places need more steps than the others: there longer
// and fewer steps lead to the same angles and distances.
inline bool takes_long_steps(const Remeshed_surface& remeshed)
{
  return remeshed.connectivity().number_of_vertices() > 8000 && remeshed.metric().is_uniform() && !remeshed.has_lines();
}

// Moves the vertex of a ring the given way, or if this spoils the ring by .4 or .16 of it. Most steps leave the ring
// good, so what it was is asked last. The way is made 1.3 or 1.5 times as long, which evens a mesh out in fewer rounds;
// but not with a sizing or on lines: there what the steps lead to when nothing moves any more is not quite the lengths
// wished.
inline void try_way(Remeshed_surface& remeshed, const Lean_triangulation::Index v, const Vertex_ring& ring, Vector way)
{
  double limit = tolerated_badness();
  if(remeshed.metric().is_uniform() && !remeshed.has_lines())
    way = (takes_long_steps(remeshed) ? 1.5 : 1.3) * way;
  for(int trial = 0; trial < 3; ++trial, way = .4 * way)
  {
    const Remeshed_surface::Spot spot = remeshed.spot_after(v, way);
    bool is_good = ring.is_below(tolerated_badness(), spot);
    if(!is_good && trial == 0)
      limit = (std::max)(limit, ring.badness());
    if(!is_good && limit > tolerated_badness())
      is_good = ring.badness(spot, limit) <= limit;
    if(is_good)
    {
      remeshed.put(v, spot);
      return;
    }
  }
}

inline void relax_vertex(Remeshed_surface& remeshed, const Lean_triangulation::Index v)
{
  const Vertex_ring ring(remeshed, v);
  try_way(remeshed, v, ring, ring.way_to_center());
}

// Calls `step(v, ring)` for the vertices that may move: steps that ask for nothing but the ring, and change nothing but
// where v is.
template <class Step>
void for_each_ring(const Remeshed_surface& remeshed, const Step& step)
{
  using Index = Lean_triangulation::Index;
  const Lean_triangulation& table = remeshed.connectivity();
  for_each_in_blocks(remeshed.block_size(), table.vertex_slots(), table.vertex_slots(), 1,
                     [&](const Index v, const Block block) {
                       if(table.is_removed(v) || remeshed.is_fixed(v))
                         return Index(0);
                       const Vertex_ring ring(remeshed, v);
                       const Index differing_bits = ring.bits_beyond(block);
                       if(differing_bits == 0)
                         step(v, ring);
                       return differing_bits;
                     });
}

inline void relax(Remeshed_surface& remeshed)
{
  for_each_ring(remeshed, [&](const Lean_triangulation::Index v, const Vertex_ring& ring) {
    try_way(remeshed, v, ring, ring.way_to_center());
  });
}

// Whether the flip lowers the energy of the valences and makes no angle smaller than what relaxation mends, and turns
// no face; or leaves the energy as it is and betters the angles.
inline bool is_flip_better(const Remeshed_surface& remeshed, const Lean_triangulation::Index h)
{
  static const double mendable = badness_of_angle(15.);
  const Lean_triangulation& table = remeshed.connectivity();
  const int energy = remeshed.energy().of_flip(h);
  if(energy > 0 || !table.is_flip_legal(h))
    return false;
  const auto a = table.source(h), b = table.target(h), c = table.apex(h), d = table.apex(table.opposite(h));
  const double before = add_badness(remeshed.badness(a, b, c), remeshed.badness(b, a, d));
  const double after = add_badness(remeshed.badness(a, d, c), remeshed.badness(b, c, d));
  return energy < 0 ? after <= (std::max)(before, mendable) : after < before;
}

// Makes all such flips. Those within a block ask and change only what is at its vertices: of the faces around these
// that are not the block's no other block changes anything but which halfedges are opposite to others.
inline void flip_to_regular_valences(Remeshed_surface& remeshed)
{
  using Index = Lean_triangulation::Index;
  constexpr Index faces_a_vertex = 2;
  Lean_triangulation& table = remeshed.connectivity();
  const auto flip_edges = [&](const Index f, const Block block) {
    // The corners of a face whose place is in another block may just be changing.
    const auto bits_beyond = [&](const Index g) {
      Index bits = block.bits_beyond(g / faces_a_vertex, f / faces_a_vertex);
      for(Index h = 4 * g; h < 4 * g + 3 && bits == 0 && !table.is_removed_face(g); ++h)
        bits = block.bits_beyond(table.source(h), f / faces_a_vertex);
      return bits;
    };
    Index bits = bits_beyond(f);
    for(Index h = 4 * f; h < 4 * f + 3 && bits == 0 && !table.is_removed_face(f); ++h)
    {
      const Index o = table.opposite(h);
      if(table.is_constrained(h) || o < h)
        continue;
      bits = bits_beyond(Lean_triangulation::face(o));
      if(bits == 0 && is_flip_better(remeshed, h))
        table.flip(h);
    }
    return bits;
  };
  for_each_in_blocks(remeshed.block_size(), table.vertex_slots(), table.face_slots(), faces_a_vertex, flip_edges);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_RELAXATION_H
