// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef GEODESIC_REMESHING_TEST_SEGMENTED_SURFACE_H
#define GEODESIC_REMESHING_TEST_SEGMENTED_SURFACE_H

#include <CGAL/Geodesic_remeshing/internal/Target.h>
#include <CGAL/Geodesic_remeshing/internal/stages.h>

#include <cmath>
#include <memory>
#include <vector>

namespace support {

using namespace CGAL::Geodesic_remeshing::internal;

// A surface and its stages up to the regions
struct Segmented_surface
{
  explicit Segmented_surface(const Mesh& mesh, double curve_distance) : surface(mesh), curve_distance(curve_distance)
  {
    make_working_surface(surface, longest_working_edge * curve_distance / std::sqrt(.75), working);
    triangulation = std::make_unique<Intrinsic_triangulation>(working.mesh);
    marching = std::make_unique<Fast_marching>(*triangulation);
    roots = march_from_roots_and_lines(working.mesh, {}, *marching).roots;
    distance = distances_in(*marching, working.mesh);
    segment_again();
  }

  // instead of the roots that were found
  void march_from(Vertex root)
  {
    roots.assign(1, root);
    marching->clear();
    marching->add_source(root);
    marching->march(Front_shape::circular);
    distance = distances_in(*marching, working.mesh);
    segment_again();
  }

  // after a change of the distance or the curve distance
  void segment_again()
  {
    order = order_vertices(working.mesh, distance, roots);
    segmentation = segment(working.mesh, *marching, distance, order, curve_distance);
  }

  Segmented_surface(const Segmented_surface&) = delete;
  Segmented_surface& operator=(const Segmented_surface&) = delete;

  Mesh surface;
  double curve_distance;
  std::vector<Vertex> roots;
  Working_surface working;
  std::unique_ptr<Intrinsic_triangulation> triangulation;
  std::unique_ptr<Fast_marching> marching;
  std::vector<double> distance;
  Vertex_order order;
  Segmentation segmentation;
};

} // namespace support

#endif // GEODESIC_REMESHING_TEST_SEGMENTED_SURFACE_H
