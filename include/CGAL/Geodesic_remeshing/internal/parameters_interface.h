// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

// No include guard on purpose: an X-macro list in the form of CGAL's own, included several times by named_parameters.h.
// One line for each name that the package adds to those of CGAL: type of the tag, tag, name for the user.

CGAL_add_named_parameter(use_segmentation_t, use_segmentation, use_segmentation)
CGAL_add_named_parameter(vertex_weight_map_t, vertex_weight_map, vertex_weight_map)
CGAL_add_named_parameter(vertex_distance_map_t, vertex_distance_map, vertex_distance_map)
CGAL_add_named_parameter(use_defect_moves_t, use_defect_moves, use_defect_moves)
CGAL_add_named_parameter(stage_results_t, stage_results, stage_results)
CGAL_add_named_parameter(vertex_location_map_t, vertex_location_map, vertex_location_map)
CGAL_add_named_parameter(face_region_map_t, face_region_map, face_region_map)
CGAL_add_named_parameter(sizing_field_t, sizing_field, sizing_field)
CGAL_add_named_parameter(gradation_t, gradation, gradation)
CGAL_add_named_parameter(maximum_length_t, maximum_length, maximum_length)
CGAL_add_named_parameter(contrast_t, contrast, contrast)
CGAL_add_named_parameter(gaussian_weight_t, gaussian_weight, gaussian_weight)
CGAL_add_named_parameter(mean_weight_t, mean_weight, mean_weight)
CGAL_add_named_parameter(expected_number_of_vertices_t, expected_number_of_vertices, expected_number_of_vertices)
CGAL_add_named_parameter(surface_tolerance_t, surface_tolerance, surface_tolerance)
CGAL_add_named_parameter(line_tolerance_t, line_tolerance, line_tolerance)
