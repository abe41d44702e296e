// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LINE_DENSITIES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LINE_DENSITIES_H

#include <CGAL/Geodesic_remeshing/internal/Line_gaps.h>
#include <CGAL/Geodesic_remeshing/internal/Metric.h>
#include <CGAL/Geodesic_remeshing/internal/trace_lines.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Two lines beside each other have only triangles from one to the other between them. With samples s apart, opposite
// each other's middles, across a gap of the width w, these have the angles atan(2 w / s): so in a gap narrower than an
// edge is long the samples have to be nearer to each other. Before the samples are made this costs fewer vertices than
// dividing edges afterwards, and those of both lines come to lie opposite each other's middles.
class Line_densities
{
public:
  Line_densities(const Mesh& mesh, const double edge_length, std::vector<Line_piece>& pieces)
    : m_mesh(mesh), m_metric(mesh), m_edge_length(edge_length), m_gaps(mesh, widest_gap() * edge_length),
      m_pieces(pieces)
  {}

  // With so many vertices for all lines at the most, unless they take more by themselves
  void run(const double most_vertices)
  {
    for(Line_piece& piece : m_pieces)
      if(!piece.is_kept)
        set_densities(piece);
    forgo_dearest(most_vertices);
  }

private:
  // In edge lengths. Half the usual spacing at the least, as the triangles on the other sides of the lines have those
  // edges too. The angle aimed at is that at the ends of evenly spaced edges; rounding and bends take up to ten degrees
  // of it. Where even half the spacing would leave angles below 30 degrees nothing is spent.
  static constexpr double least_spacing = .5;
  static double widest_gap() { return .5 * std::tan(35. * CGAL_PI / 180.); }
  static double narrowest_gap() { return .5 * least_spacing * std::tan(30. * CGAL_PI / 180.); }

  double density(const double gap) const
  {
    const double width = gap / m_edge_length;
    if(!(width > narrowest_gap() && width < widest_gap()))
      return 1.;
    return 1. / (std::max)(least_spacing, width / widest_gap());
  }

  void set_densities(Line_piece& piece) const
  {
    std::vector<double> densities;
    for(const Halfedge h : piece.halfedges)
      densities.push_back(density((std::min)(m_gaps.beside(h), m_gaps.beside(m_mesh.opposite(h)))));
    forget_short_runs(piece, densities);
    if(*std::max_element(densities.begin(), densities.end()) > 1.)
      piece.densities = std::move(densities);
  }

  // Lines pass each other by along a few edges at least. Towards a corner where two meet a gap is of such a width for
  // less, and the angle there is what it is; on noisy surfaces sharp edges are near to others everywhere.
  void forget_short_runs(const Line_piece& piece, std::vector<double>& densities) const
  {
    constexpr double shortest = 3.; // edge lengths
    const std::size_t n = densities.size();
    const auto is_dense = [&](const std::size_t i) { return densities[i % n] > 1.; };
    std::size_t first = 0; // of a run; a ring begins anywhere
    if(piece.is_ring)
    {
      while(first < n && is_dense(first) == is_dense(first + n - 1))
        ++first;
      if(first == n) // all the way around
        return;
    }
    for(std::size_t begin = first, end; begin < first + n; begin = end)
    {
      double length = 0.;
      for(end = begin; end < first + n && is_dense(end) == is_dense(begin); ++end)
        length += m_metric.length(piece.halfedges[end % n]);
      if(length < shortest * m_edge_length)
        for(std::size_t i = begin; i < end; ++i)
          densities[i % n] = 1.;
    }
  }

  // The pieces that take the fewest vertices more for their length go first.
  void forgo_dearest(const double most_vertices)
  {
    double number = 0.;
    std::vector<std::pair<double, std::size_t>> pieces; // by the mean density
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
    {
      const double even = even_length_of(m_metric, m_pieces[i]);
      number += even / m_edge_length;
      if(!m_pieces[i].densities.empty())
        pieces.emplace_back(length_of(m_metric, m_pieces[i]) / even, i);
    }
    std::sort(pieces.begin(), pieces.end());
    for(const std::pair<double, std::size_t>& p : pieces)
    {
      Line_piece& piece = m_pieces[p.second];
      const double more = (length_of(m_metric, piece) - even_length_of(m_metric, piece)) / m_edge_length;
      if(number + more > most_vertices)
        piece.densities.clear();
      else
        number += more;
    }
  }

  const Mesh& m_mesh;
  const Metric m_metric;
  const double m_edge_length;
  const Line_gaps m_gaps;
  std::vector<Line_piece>& m_pieces;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LINE_DENSITIES_H
