// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_KNOWN_PARAMETERS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_KNOWN_PARAMETERS_H

#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// A named parameter that a function does not know would be ignored: `contrast(1)` given to the remeshing and not to the
// sizing field, a map of the output given for the input. All that can be known when compiling, so it is an error there.

template <class... Tags>
struct Known_parameters
{
  template <class Tag>
  static constexpr bool contain = (std::is_same<Tag, Tags>::value || ...);

  template <class... More>
  using And = Known_parameters<Tags..., More...>;
};

// An instantiation for each parameter given, so that the compiler names the one that is wrong.
template <class Tag, class Known>
struct Named_parameter_of_this_function
{
  static_assert(Known::template contain<Tag>,
                "this function has no such named parameter: see its documentation for those it has");
  static constexpr bool value = true;
};

template <class Known>
constexpr bool are_known(const CGAL::internal_np::No_property*)
{
  return true;
}

template <class Known, class T, class Tag, class Base>
constexpr bool are_known(const CGAL::Named_function_parameters<T, Tag, Base>*)
{
  if constexpr(!std::is_same<Tag, CGAL::internal_np::all_default_t>::value)
    static_assert(Named_parameter_of_this_function<Tag, Known>::value, "");
  return are_known<Known>(static_cast<const Base*>(nullptr));
}

template <class NamedParameters, class Known>
constexpr void check_parameters()
{
  static_assert(are_known<Known>(static_cast<const NamedParameters*>(nullptr)), "");
}

// Those of every mesh
using Parameters_of_mesh =
    Known_parameters<internal_np::vertex_point_t, internal_np::geom_traits_t, internal_np::vertex_index_t,
                     internal_np::halfedge_index_t, internal_np::face_index_t>;

// Those of the remeshing, which are most, have their list here; other functions name what they have beside those of a
// mesh. A new parameter is added where it belongs.
using Parameters_of_remeshing =
    Parameters_of_mesh::And<internal_np::edge_is_constrained_t, internal_np::vertex_is_constrained_t,
                            internal_np::face_patch_t, internal_np::features_angle_bound_t, internal_np::sizing_field_t,
                            internal_np::gradation_t, internal_np::minimum_length_t, internal_np::maximum_length_t,
                            internal_np::use_segmentation_t, internal_np::number_of_iterations_t,
                            internal_np::use_defect_moves_t, internal_np::visitor_t, internal_np::stage_results_t,
                            internal_np::protect_constraints_t, internal_np::do_project_t,
                            internal_np::concurrency_tag_t>;

// Says of the pack of an output that this takes the input's place, so that the one pack of the user is that of both.
struct in_place_t
{};

using Parameters_of_output = Known_parameters<in_place_t, internal_np::vertex_point_t, internal_np::geom_traits_t,
                                              internal_np::vertex_location_map_t, internal_np::edge_is_constrained_t,
                                              internal_np::face_patch_t, internal_np::face_region_map_t>;

template <class NamedParametersOut>
using Parameters_of_input =
    std::conditional_t<CGAL::parameters::is_default_parameter<NamedParametersOut, in_place_t>::value,
                       Parameters_of_remeshing, Parameters_of_remeshing::And<internal_np::face_region_map_t>>;

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_KNOWN_PARAMETERS_H
