// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_STAGE_FILES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_STAGE_FILES_H

#include <CGAL/Geodesic_remeshing/remeshing_types.h>
#include <CGAL/IO/Color.h>
#include <CGAL/IO/io.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <array>
#include <cstddef>
#include <ostream>

namespace command_line {

using CGAL::Geodesic_remeshing::Stage_results;

// Twelve colours that are easily told apart, over and over
constexpr int number_of_region_colors = 12;

inline CGAL::IO::Color region_color(int region)
{
  static const std::array<CGAL::IO::Color, number_of_region_colors> colors = {{{166, 206, 227},
                                                                               {31, 120, 180},
                                                                               {178, 223, 138},
                                                                               {51, 160, 44},
                                                                               {251, 154, 153},
                                                                               {227, 26, 28},
                                                                               {253, 191, 111},
                                                                               {255, 127, 0},
                                                                               {202, 178, 214},
                                                                               {106, 61, 154},
                                                                               {255, 255, 153},
                                                                               {177, 89, 40}}};
  return colors[static_cast<std::size_t>(region) % colors.size()];
}

// The working surface as PLY, with `region` and a colour at each face
inline void write_regions(std::ostream& out, const Stage_results& results)
{
  Stage_results::Mesh mesh = results.regions;
  const auto region = mesh.property_map<Stage_results::Mesh::Face_index, int>("f:region").value();
  auto color = mesh.add_property_map<Stage_results::Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for(const auto f : mesh.faces())
    color[f] = region_color(region[f]);
  CGAL::IO::set_binary_mode(out);
  CGAL::IO::write_PLY(out, mesh);
}

// The curves as polylines of an OBJ file; a closed one ends with the number of its first point
inline void write_curves(std::ostream& out, const Stage_results& results)
{
  std::size_t points_before = 0;
  for(const auto& curve : results.curves)
  {
    const bool is_closed = curve.size() > 1 && curve.front() == curve.back();
    const std::size_t size = curve.size() - (is_closed ? 1 : 0);
    for(std::size_t i = 0; i < size; ++i)
      out << "v " << curve[i].x() << " " << curve[i].y() << " " << curve[i].z() << "\n";
    out << "l";
    for(std::size_t i = 1; i <= size; ++i)
      out << " " << points_before + i;
    if(is_closed)
      out << " " << points_before + 1;
    out << "\n";
    points_before += size;
  }
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_STAGE_FILES_H
