// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_SEGMENTATION_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_SEGMENTATION_H

#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Notation of the paper, section 5. Fronts start at the maxima of the distance D from the root and sweep down. A region
// is what one front covers between two events: from its *top* (a centre, or the spectacles of its children's fronts) to
// its *bottom*, a whole number of curve distances further on but in the last region of each component.
struct Region
{
  Region_kind kind = Region_kind::interior;
  std::vector<std::size_t> parents;  // the regions below: one, or two below the saddle where a front splits at a handle
  std::vector<std::size_t> children; // the regions above: none for a leaf
  Vertex centre;                     // the maximum of a leaf, the root, or the saddle where the fronts above meet
  double height = 0.;                // from top to bottom; zero for a region that degenerates to its top
  double spacing = 0.;               // of its curves: C_d, or a little less or more in the root region
  int number_of_levels = 0;          // curves at spacing, 2 * spacing, ..., number_of_levels * spacing from the top,
  std::vector<double> values;        // or at these distances, if there are any
  std::size_t top = 0, bottom = 0;   // the junctions where the region begins and ends
  int part_of = -1;                  // of a leaf that degenerates to its centre: the region that this counts to, if any

  double value(int level) const { return values.empty() ? level * spacing : values[level - 1]; }
};

// The regions as a graph: junctions are points (a maximum, a saddle, the root), regions are arcs between them. On a
// surface of genus 0 it is the paper's tree; each handle adds a front that splits and later meets itself.
struct Segmentation
{
  std::vector<Region> regions; // children before their parents
  std::size_t number_of_junctions = 0;

  // Of each vertex:
  std::vector<int> region;         // the region that took it; these sets are discs and annuli
  std::vector<int> field_region;   // the region that `field` counts in; differs from `region` only where a front folds
  std::vector<double> field;       // the distance from the top of `field_region`
  std::vector<std::uint32_t> time; // the number of junctions there were when it was taken
  std::vector<int> level;          // it lies inside the curves number `level`, `level + 1`, ... of `field_region`

  std::vector<std::vector<Vertex>> bridges; // the spectacles' middles: from front to front through a saddle
  std::vector<Vertex> tips;                 // the maxima that are not noise: horns, ears, fingers
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_SEGMENTATION_H
