// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_REPORT_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_REPORT_H

#include "../include/mesh_quality.h"

#include <CGAL/Geodesic_remeshing/is_valid_remeshing.h>
#include <CGAL/geodesic_remeshing.h>

#include <nlohmann/json.hpp>

#include <iomanip>
#include <optional>
#include <ostream>
#include <string>

namespace command_line {

// What is told about one remeshing
struct Report
{
  mesh_quality::Quality input;
  mesh_quality::Quality output;
  mesh_quality::Small_angles small_angles; // of the output
  mesh_quality::Distance distance;
  CGAL::Geodesic_remeshing::Summary summary;
  bool is_fitted = false;                                               // whether vertices could leave the surface
  double seconds = 0.;                                                  // of the remeshing as a whole
  std::optional<CGAL::Geodesic_remeshing::Remeshing_validity> validity; // if it was asked for
};

namespace internal {

inline nlohmann::ordered_json to_json(const mesh_quality::Quality& quality)
{
  return {{"vertices", quality.vertices},
          {"faces", quality.faces},
          {"components", quality.components},
          {"genus", quality.genus},
          {"boundary_loops", quality.boundary_loops},
          {"min_angle", quality.min_angle},
          {"mean_min_angle", quality.mean_min_angle},
          {"percent_below_30", quality.percent_below_30},
          {"percent_irregular", quality.percent_irregular}};
}

inline nlohmann::ordered_json to_json(const CGAL::Geodesic_remeshing::Remeshing_validity& validity)
{
  return {{"valid", static_cast<bool>(validity)},
          {"manifold", validity.is_manifold},
          {"same_components", validity.has_same_components},
          {"same_genus", validity.has_same_genus},
          {"same_boundary_loops", validity.has_same_boundary_loops},
          {"number_of_vertices", validity.has_number_of_vertices},
          {"on_surface", validity.is_on_surface},
          {"distance", validity.distance},
          {"degenerate_faces", validity.degenerate_faces},
          {"flipped_faces", validity.flipped_faces},
          {"self_intersections", validity.self_intersections},
          {"input_intersects_itself", validity.input_intersects_itself},
          {"lines_covered", validity.covers_lines},
          {"line_distance", validity.line_distance}};
}

inline void write_row(std::ostream& out, const std::string& name, const mesh_quality::Quality& quality)
{
  const auto number = [&out](int width, int digits, double value) {
    out << std::setw(width) << std::fixed << std::setprecision(digits) << value;
  };
  out << std::left << std::setw(8) << name << std::right << std::setw(10) << quality.vertices << std::setw(10)
      << quality.faces << std::setw(7) << quality.genus << std::setw(7) << quality.components;
  number(9, 2, quality.min_angle);
  number(10, 2, quality.mean_min_angle);
  number(9, 3, quality.percent_below_30);
  number(11, 2, quality.percent_irregular);
}

// Which small angles come from the model matters to who is going to simulate with the mesh.
inline void write_small_angles(std::ostream& out, const mesh_quality::Small_angles& angles)
{
  if(angles.below_20_between_lines == 0)
    return;
  out << angles.below_20_between_lines << " of " << angles.below_20
      << " faces with an angle below 20 degrees lie between lines that meet at a small angle or are nearer to each "
         "other than edges are long";
  if(angles.min_angle_elsewhere < 180.)
    out << "; smallest angle elsewhere " << std::fixed << std::setprecision(2) << angles.min_angle_elsewhere;
  out << "\n";
}

} // namespace internal

// As report.schema.json says
inline nlohmann::ordered_json report_as_json(const Report& report)
{
  nlohmann::ordered_json json;
  json["version"] = GEODESIC_REMESHING_VERSION;
  json["input"] = internal::to_json(report.input);
  json["output"] = internal::to_json(report.output);
  json["output"]["faces_below_20"] = report.small_angles.below_20;
  json["output"]["faces_below_20_between_lines"] = report.small_angles.below_20_between_lines;
  json["output"]["min_angle_elsewhere"] = report.small_angles.min_angle_elsewhere;
  json["output"]["hausdorff_percent"] = report.distance.hausdorff_percent;
  json["output"]["rms_percent"] = report.distance.rms_percent;
  json["fitted"] = report.is_fitted;
  json["edge_length"] = report.summary.edge_length;
  json["regions"] = report.summary.number_of_regions;
  json["curves"] = report.summary.number_of_curves;
  json["strips"] = report.summary.number_of_strips;
  for(const auto& [stage, seconds] : report.summary.seconds)
    json["seconds"][stage] = seconds;
  json["seconds"]["total"] = report.seconds;
  if(report.validity)
    json["check"] = internal::to_json(*report.validity);
  return json;
}

inline void write_json(std::ostream& out, const Report& report)
{
  out << report_as_json(report).dump(2) << "\n";
}

// The statistics of the paper's Table 1 (size, smallest angles, approximation error), and the valences
inline void write_table(std::ostream& out, const Report& report)
{
  out << "          vertices     faces  genus  parts  min ang  mean min   % < 30  % irreg.  Hausdorff %    RMS %\n";
  internal::write_row(out, "input", report.input);
  out << "\n";
  internal::write_row(out, "output", report.output);
  out << std::setw(13) << std::setprecision(4) << report.distance.hausdorff_percent << std::setw(9)
      << report.distance.rms_percent << "\n"
      << "edge length " << std::defaultfloat << std::setprecision(6) << report.summary.edge_length << "; "
      << report.summary.number_of_regions << " regions, " << report.summary.number_of_curves << " curves, "
      << report.summary.number_of_strips << " strips; " << std::fixed << std::setprecision(2) << report.seconds << " s"
      << (report.is_fitted ? "; fitted: vertices off the surface" : "") << "\n";
  internal::write_small_angles(out, report.small_angles);
  if(report.validity)
    out << *report.validity;
}

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_REPORT_H
