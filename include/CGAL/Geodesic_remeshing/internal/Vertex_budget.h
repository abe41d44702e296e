// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_BUDGET_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_BUDGET_H

#include <CGAL/Geodesic_remeshing/internal/Component_extent.h>
#include <CGAL/Geodesic_remeshing/internal/Target.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The samples on lines: corners, and what lies inside the pieces. In numbers only
class Line_budget
{
public:
  Line_budget(const Mesh& mesh, const std::vector<Line_piece>& pieces, std::size_t corners)
    : m_pieces(pieces), m_fewest(fewest_intervals(mesh, pieces)), m_corners(corners)
  {
    const Metric metric(mesh);
    for(const Line_piece& piece : pieces)
    {
      m_length.push_back(length_of(metric, piece));
      m_even_length.push_back(even_length_of(metric, piece));
      m_is_boundary.push_back(mesh.is_border(mesh.edge(piece.halfedges.front())));
    }
  }

  std::size_t fewest() const { return number(infinity); }

  std::size_t number(double spacing) const
  {
    std::size_t sum = m_corners;
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      sum += number_inside(m_pieces[i], intervals(i, spacing));
    return sum;
  }

  std::size_t edges_on_boundary(double spacing) const
  {
    std::size_t sum = 0;
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      if(m_is_boundary[i])
        sum += intervals(i, spacing);
    return sum;
  }

  // The spacing itself, or a wider one where so many samples would be more than this
  double spacing_for(double spacing, std::size_t most) const
  {
    if(number(spacing) <= most)
      return spacing;
    double low = spacing, high = 2. * spacing;
    while(number(high) > most && number(high) > fewest())
      high *= 2.;
    for(int i = 0; i < 40; ++i)
    {
      const double middle = .5 * (low + high);
      (number(middle) > most ? low : high) = middle;
    }
    return high;
  }

  // Whether edges are kept, or samples denser than elsewhere
  bool is_uneven() const
  {
    return std::any_of(m_pieces.begin(), m_pieces.end(),
                       [](const Line_piece& piece) { return piece.is_kept || !piece.densities.empty(); });
  }

  // How many more there are at this spacing than if the pieces were divided evenly
  double surplus(double spacing) const
  {
    double sum = 0.;
    for(std::size_t i = 0; i < m_pieces.size(); ++i)
      sum += m_pieces[i].is_kept ? 1. - m_length[i] / spacing : (m_length[i] - m_even_length[i]) / spacing;
    return sum;
  }

private:
  std::size_t intervals(std::size_t i, double spacing) const
  {
    return number_of_intervals(m_pieces[i], m_length[i], spacing, m_fewest[i]);
  }

  const std::vector<Line_piece>& m_pieces;
  const std::vector<int> m_fewest;
  const std::size_t m_corners;
  std::vector<double> m_length, m_even_length;
  std::vector<char> m_is_boundary;
};

// The numbers to work with
struct Vertex_budget
{
  std::size_t number_of_vertices;
  double edge_length;
  double spacing_on_lines;
  double curve_edge_length; // that of rows of triangles at the distance of the curves
};

// What is needed are bounds from below: a number that can be reached is named with them. Of a hundred models all did
// with three times as many, and those in very many parts with `enough` for their topology.
inline void check_not_too_few(std::size_t number, std::size_t topology, std::size_t enough, std::size_t lines)
{
  const auto reject_number = [&](std::size_t needed, const std::string& what) {
    if(number < needed)
      throw Remeshing_error("geodesic remeshing: " + std::to_string(number) + " vertices are too few: " + what + " " +
                            std::to_string(needed) + " at the least; try " +
                            std::to_string((std::max)(enough, 3 * lines)) + " vertices");
  };
  reject_number(lines, "the corners and lines of the input need");
  reject_number(topology, "the topology of the input needs");
}

// So many vertices would there be, were the lines divided evenly, if there are `number` as they are.
inline std::size_t number_if_even(const std::vector<Extent>& extents, const Line_budget& lines, std::size_t number)
{
  const double most = static_cast<double>(number);
  std::size_t even = number;
  for(int i = 0; i < 3; ++i)
  {
    const double edge_length =
        edge_length_for(extents, even, [](const Extent& e, double length) { return e.wanted(length); });
    even = static_cast<std::size_t>((std::max)(.25 * most, most - lines.surplus(edge_length)));
  }
  return (std::max)(even, std::size_t(4));
}

// `number` is that of the target if it is a number, else what follows from the area alone.
inline Vertex_budget make_budget(const Any_target& target, const Mesh& mesh, std::size_t number,
                                 const std::vector<Line_piece>& pieces, const Constraints& constraints)
{
  const auto wanted = [](const Extent& e, double edge_length) { return e.wanted(edge_length); };
  std::vector<Extent> extents = extents_of_components(mesh, constraints);
  const Line_budget lines(mesh, pieces, sum_over(extents, [](const Extent& e) { return e.corners; }));
  const std::size_t fewest = sum_over(extents, [](const Extent& e) { return e.fewest(); });
  const std::size_t enough = enough_vertices(extents);
  if(constraints.are_kept)
    for(Extent& e : extents)
      e.corners = 0; // they are what `Line_budget::surplus()` counts
  double spacing = edge_length_for(sum_over(extents, [](const Extent& e) { return e.area; }), number);
  const Number_of_faces* const faces = std::get_if<Number_of_faces>(&target);
  if(std::holds_alternative<Edge_length>(target))
  {
    const double all =
        lines.surplus(spacing) + sum_of_wanted(extents, [&](const Extent& e) { return e.wanted(spacing); });
    check_not_too_many(all, "the edge length is too small: it");
    number = (std::max)(fewest, static_cast<std::size_t>(std::llround((std::max)(0., all))));
  }
  else if(faces != nullptr)
    number += (faces->value + lines.edges_on_boundary(spacing)) / 2 - faces->value / 2; // F = 2 V - 2 chi - B
  check_not_too_few(number, fewest, enough, lines.fewest());
  const std::size_t even = lines.is_uneven() ? number_if_even(extents, lines, number) : number;
  const double edge_length = edge_length_for(extents, even, wanted);
  if(faces == nullptr)
    spacing = edge_length;
  const auto wanted_of_curves = [](const Extent& e, double edge_length) { return e.wanted_of_curves(edge_length); };
  return Vertex_budget{number, edge_length, lines.spacing_for(spacing, number),
                       edge_length_for(extents, even, wanted_of_curves)};
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_VERTEX_BUDGET_H
