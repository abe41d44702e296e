// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_POLISH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_POLISH_H

#include <CGAL/Geodesic_remeshing/internal/Remeshed_surface.h>
#include <CGAL/Geodesic_remeshing/internal/do_faces_intersect.h>
#include <CGAL/Geodesic_remeshing/internal/find_middle.h>
#include <CGAL/Geodesic_remeshing/internal/has_intersections_anywhere.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Betters the worst triangles, one by one: by moving their vertices to wherever the smallest angle around is largest,
// and where that is not enough by flips, and by collapses and splits (of which the number of vertices tells; others are
// put in or taken out elsewhere). Whatever makes the worst triangle around better is kept, whatever the valences;
// everything else taken back.
class Polish
{
public:
  using Index = Lean_triangulation::Index;

  // If valences shall be kept regular, flips that make them less so are left to angles below 30 degrees, and more
  // vertices are moved instead. Flips that leave faces intersecting nearby are taken back, unless as many as before may
  // be left: one of two turned faces beside each other, and what lies where sheets intersect, cannot be mended else.
  explicit Polish(Remeshed_surface& remeshed, const bool keep_regular = false, const bool do_leave_as_many = false)
    : m_remeshed(remeshed), m_table(remeshed.connectivity()), m_keep_regular(keep_regular),
      m_do_leave_as_many(do_leave_as_many)
  {}

  // Treats every triangle worse than the given badness once, the worst first, but of very many no more than `most()`.
  // Returns the number of them.
  std::size_t run(double badness, bool do_collapse);

  // Whether to go on after runs with these results, the last two: not where a large part of the triangles stays bad, on
  // limbs and spikes thinner than edges are long, to which no run makes a difference but that of its time.
  bool is_worth_going_on(const std::size_t number, const std::size_t number_before) const
  {
    return number > 0 && (number <= most() || (number <= 2 * most() && number <= number_before - number_before / 5));
  }

  // Moves vertices around such triangles only, and not where triangles come to intersect, of whatever sheet.
  void run_apart(double badness);

  // Moves a vertex so that the worst triangle around it gets better.
  bool better_vertex(Index v);

private:
  using Zone = boost::container::small_vector<Index, 16>;
  struct Bad
  {
    double badness;
    Index f;
  };

  std::vector<Bad> worse_than(double badness) const;
  template <class Do_intersect>
  bool better_around(Index f, const Do_intersect& do_intersect);
  bool better_by_flip(Index h);
  bool better_by_collapse(Index h);
  bool better_by_split(Index h);
  template <class Vertices>
  double badness_around(const Vertices& vertices) const;
  template <class Vertices>
  bool keep_if_better(const Vertices& vertices, const double before)
  {
    return keep_if_better(vertices, before, [&](const Vertices& v) { return has_intersections_near(m_remeshed, v); });
  }
  template <class Vertices, class Do_intersect>
  bool keep_if_better(const Vertices& vertices, double before, const Do_intersect& do_intersect);
  double face_badness(Index f) const;
  std::size_t most() const
  {
    return (std::max)(std::size_t(200), std::size_t(m_table.number_of_vertices()) / 4); // an eighth of the faces
  }

  Remeshed_surface& m_remeshed;
  Lean_triangulation& m_table;
  bool m_keep_regular, m_do_leave_as_many;
};

inline double Polish::face_badness(const Index f) const
{
  return m_remeshed.badness(m_table.source(4 * f), m_table.source(4 * f + 1), m_table.source(4 * f + 2));
}

inline std::vector<Polish::Bad> Polish::worse_than(const double badness) const
{
  std::vector<Bad> bad;
  const auto is_bad = [&](const Index f) { return !m_table.is_removed_face(f) && face_badness(f) > badness; };
  for(const Index f : parallel_list(m_remeshed.block_size().concurrency, m_table.face_slots(), is_bad))
    bad.push_back({face_badness(f), f});
  std::sort(bad.begin(), bad.end(),
            [](const Bad& x, const Bad& y) { return std::tie(y.badness, x.f) < std::tie(x.badness, y.f); });
  return bad;
}

inline void Polish::run_apart(const double badness)
{
  // Each looks at all faces: a hundred of up to 20,000 vertices, then fewer, for no more time than a pass takes.
  const std::size_t most = (std::min)(std::size_t(100), 1 + 4000000 / std::size_t(m_table.face_slots()));
  const std::vector<Bad> bad = worse_than(badness);
  const auto do_intersect = [&](const Zone& zone) { return has_intersections_anywhere(m_remeshed, zone); };
  for(std::size_t i = 0; i < (std::min)(bad.size(), most); ++i)
    for(int round = 0; round < 3 && face_badness(bad[i].f) > badness; ++round)
      if(!better_around(bad[i].f, do_intersect))
        break;
}

inline std::size_t Polish::run(const double badness, const bool do_collapse)
{
  static const double poor = badness_of_angle(30.);
  const std::vector<Bad> bad = worse_than(badness);
  for(std::size_t i = 0; i < (std::min)(bad.size(), most()); ++i)
  {
    const Bad& x = bad[i];
    const auto is_mended = [&] { return m_table.is_removed_face(x.f) || face_badness(x.f) <= badness; };
    const auto try_each = [&](auto&& better) {
      for(Index h = 4 * x.f; h < 4 * x.f + 3 && !is_mended(); ++h)
        better(h);
    };
    try_each([&](const Index h) { better_vertex(m_table.source(h)); });
    try_each([&](const Index h) {
      if(!m_keep_regular || face_badness(x.f) > poor ||
         (m_table.is_flip_legal(h) && m_remeshed.energy().of_flip(h) <= 0))
        better_by_flip(h);
    });
    if(m_keep_regular && !is_mended())
      better_around(x.f, [&](const Zone& zone) { return has_intersections_near(m_remeshed, zone); });
    if(do_collapse)
      try_each([&](const Index h) {
        if(!better_by_collapse(h) && m_table.opposite(h) != Lean_triangulation::none)
          better_by_collapse(m_table.opposite(h));
      });
    if(do_collapse)
      try_each([&](const Index h) { better_by_split(h); });
  }
  return bad.size();
}

// Tries steps along the edges, forth and back, long ones first, as long as one of them helps.
inline bool Polish::better_vertex(const Index v)
{
  if(m_remeshed.is_fixed(v))
    return false;
  constexpr std::array<double, 6> steps = {{.3, -.3, .1, -.1, .03, -.03}};
  const Vertex_ring ring(m_remeshed, v);
  const double start = ring.badness();
  double best = start;
  bool has_moved = true;
  for(int round = 0; round < 4 && has_moved; ++round)
  {
    has_moved = false;
    for(const double step : steps)
      for(std::size_t i = 0; i < ring.size(); ++i)
      {
        const Remeshed_surface::Spot spot = m_remeshed.spot_after(v, step * (ring[i].point - m_remeshed.spot(v).point));
        const double badness = ring.badness(spot, best);
        if(badness < best)
        {
          best = badness;
          has_moved = true;
          m_remeshed.put(v, spot);
        }
      }
  }
  return best < start;
}

template <class Vertices>
double Polish::badness_around(const Vertices& vertices) const
{
  double sum = 0.;
  for(const Index v : vertices)
    sum = add_badness(sum, m_remeshed.ring_badness(v));
  return sum;
}

// Ends a trial that began with `record()`.
template <class Vertices, class Do_intersect>
bool Polish::keep_if_better(const Vertices& vertices, const double before, const Do_intersect& do_intersect)
{
  for(int round = 0; round < 2; ++round)
    for(const Index v : vertices)
      better_vertex(v);
  const bool is_better = badness_around(vertices) < before && !do_intersect(vertices);
  if(!is_better)
    m_remeshed.undo_to({0, 0});
  m_remeshed.forget();
  return is_better;
}

// Where its own vertices cannot better a triangle, their neighbours may have to make room first.
template <class Do_intersect>
bool Polish::better_around(const Index f, const Do_intersect& do_intersect)
{
  Zone zone;
  for(Index h = 4 * f; h < 4 * f + 3; ++h)
    zone.push_back(m_table.source(h));
  for(Index h = 4 * f; h < 4 * f + 3; ++h)
    m_table.for_each_neighbor(m_table.source(h), [&](const Index v) {
      if(std::find(zone.begin(), zone.end(), v) == zone.end())
        zone.push_back(v);
    });
  std::reverse(zone.begin(), zone.end());
  const double before = badness_around(zone);
  m_remeshed.record();
  return keep_if_better(zone, before, do_intersect);
}

inline bool Polish::better_by_flip(const Index h)
{
  if(!m_table.is_flip_legal(h))
    return false;
  const Index o = m_table.opposite(h);
  const std::array<Index, 4> vertices = {{m_table.source(h), m_table.target(h), m_table.apex(h), m_table.apex(o)}};
  const double before = badness_around(vertices);
  const auto intersections = [&](const std::size_t most) {
    return number_of_intersections_near(m_remeshed, vertices, most);
  };
  const std::size_t left = m_do_leave_as_many ? intersections((std::numeric_limits<std::size_t>::max)()) : 0;
  m_remeshed.record();
  m_table.flip(h);
  return keep_if_better(vertices, before, [&](const auto&) { return intersections(left + 1) > left; });
}

inline bool Polish::better_by_collapse(const Index h)
{
  if(m_remeshed.is_fixed(m_table.target(h)) || !m_table.is_collapse_legal(h))
    return false;
  const Index o = m_table.opposite(h), a = m_table.source(h), b = m_table.target(h), c = m_table.apex(h);
  const Index d = o == Lean_triangulation::none ? a : m_table.apex(o);
  const double before = badness_around(std::array<Index, 4>{{a, b, c, d}});
  m_remeshed.record();
  m_table.collapse(h);
  return keep_if_better(std::array<Index, 4>{{a, a, c, d}}, before);
}

// Between lines that are nearer to each other than their vertices there have to be more of these; and around a thin
// limb, where three vertices are nearer to each other than the others, more of them along it.
inline bool Polish::better_by_split(const Index h)
{
  Remeshed_surface::Spot middle;
  if((m_remeshed.has_lines() && !m_table.is_constrained(h)) || !find_middle(m_remeshed, h, middle))
    return false;
  const Index o = m_table.opposite(h), a = m_table.source(h), b = m_table.target(h), c = m_table.apex(h);
  const Index d = o == Lean_triangulation::none ? a : m_table.apex(o);
  // It must be worth a vertex: between lines, where there cannot be good triangles, each split would ask for the next.
  // Along a limb of three vertices around each betters the angles by little, until there are enough.
  static const double good = badness_of_angle(25.);
  const double least_gain = m_remeshed.has_lines() ? .6 : .9;
  const double before = badness_around(std::array<Index, 4>{{a, b, c, d}});
  m_remeshed.reserve_free(1);
  m_remeshed.record();
  const Index w = m_table.split_edge(h);
  m_remeshed.put_new(w, middle);
  return keep_if_better(std::array<Index, 5>{{w, a, b, c, d}},
                        (std::max)(least_gain * before, (std::min)(before, good)));
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_POLISH_H
