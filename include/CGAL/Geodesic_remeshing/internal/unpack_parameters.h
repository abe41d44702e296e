// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_UNPACK_PARAMETERS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_UNPACK_PARAMETERS_H

#include <CGAL/Geodesic_remeshing/internal/Points_of_graph.h>
#include <CGAL/Geodesic_remeshing/internal/improve.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>
#include <CGAL/Geodesic_remeshing/internal/parallel_for.h>
#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>
#include <CGAL/Geodesic_remeshing/remeshing_types.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>
#include <boost/property_map/shared_array_property_map.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Is this type a pack of named parameters, of CGAL or of ours? Tells `f(mesh, target, np)` from `f(mesh, target, out)`.
struct Is_named_parameters_test
{
  template <class T, class Tag, class Base>
  static std::true_type test(const CGAL::Named_function_parameters<T, Tag, Base>*);
  static std::false_type test(const void*);
};
template <class T>
struct is_named_parameters : decltype(Is_named_parameters_test::test(static_cast<T*>(nullptr)))
{};

struct Options
{
  bool use_segmentation;
  std::size_t number_of_iterations;
  bool use_defect_moves;
  bool do_project;
  double nearness;
  Concurrency concurrency;

  Improvement_parameters improvement(std::size_t number_of_vertices, double edge_length) const
  {
    Improvement_parameters result{number_of_vertices, edge_length};
    result.number_of_iterations = number_of_iterations;
    result.use_defect_moves = use_defect_moves;
    result.nearness = do_project ? nearness : 0.; // a fit brings all near
    result.block_size = block_size_for(number_of_vertices, concurrency);
    return result;
  }
};

template <class NamedParameters, class Tag>
constexpr bool is_given = !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

template <class T, class = void>
struct has_nearness : std::false_type
{};
template <class T>
struct has_nearness<T, std::void_t<decltype(std::declval<const T&>().nearness())>> : std::true_type
{};

// What the sizing field says of it, if it says anything
template <class NamedParameters>
double nearness_of(const NamedParameters& np)
{
  double nearness = 0.;
  if constexpr(is_given<NamedParameters, internal_np::sizing_field_t>)
  {
    const auto& field = CGAL::parameters::get_parameter_reference(np, internal_np::sizing_field);
    if constexpr(has_nearness<std::decay_t<decltype(field)>>::value)
      nearness = CGAL::to_double(field.nearness());
    if(!(nearness >= 0. && nearness <= 10.))
      throw std::invalid_argument("geodesic remeshing: the nearness of the sizing field must be between 0 and 10");
  }
  return nearness;
}

// A signed number below zero would become a large one.
template <class NamedParameters>
std::size_t number_of_iterations_of(const NamedParameters& np)
{
  const auto number =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::number_of_iterations), 3u);
  static_assert(std::is_integral<std::remove_const_t<decltype(number)>>::value,
                "number_of_iterations() takes an integer");
  if constexpr(std::is_signed<decltype(number)>::value)
    if(number < 0)
      throw std::invalid_argument("geodesic remeshing: the number of iterations must not be negative");
  return static_cast<std::size_t>(number);
}

template <class NamedParameters>
Options unpack_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return Options{choose_parameter(get_parameter(np, internal_np::use_segmentation), true),
                 number_of_iterations_of(np),
                 choose_parameter(get_parameter(np, internal_np::use_defect_moves), true),
                 choose_parameter(get_parameter(np, internal_np::do_project), true),
                 nearness_of(np),
                 concurrency_of(np)};
}

template <class TriangleMesh, class NamedParameters>
auto vertex_indices_of(const TriangleMesh& tmesh, const NamedParameters& np)
{
  typename GetInitializedVertexIndexMap<TriangleMesh, NamedParameters>::const_type indices =
      get_initialized_vertex_index_map(tmesh, np);
  return indices;
}

template <class T, class = void>
struct has_limits : std::false_type
{};
template <class T>
struct has_limits<T, std::void_t<decltype(std::declval<const T&>().limits())>> : std::true_type
{};

// The limits given by name come before those that the sizing field has itself.
template <class NamedParameters>
Sizing_limits sizing_limits_of(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Sizing_limits limits;
  if constexpr(is_given<NamedParameters, internal_np::sizing_field_t>)
  {
    const auto& field = CGAL::parameters::get_parameter_reference(np, internal_np::sizing_field);
    if constexpr(has_limits<std::decay_t<decltype(field)>>::value)
      limits = field.limits();
  }
  limits.minimum_length = choose_parameter(get_parameter(np, internal_np::minimum_length), limits.minimum_length);
  limits.maximum_length = choose_parameter(get_parameter(np, internal_np::maximum_length), limits.maximum_length);
  limits.gradation = choose_parameter(get_parameter(np, internal_np::gradation), limits.gradation);
  return limits;
}

// A sizing field tells a length by `at(v)`; those of PMP by `at(v, mesh)`; a property map by `get()`.
template <class Field, class TriangleMesh, class = void>
struct has_at_with_mesh : std::false_type
{};
template <class Field, class TriangleMesh>
struct has_at_with_mesh<Field, TriangleMesh,
                        std::void_t<decltype(std::declval<const Field&>().at(
                            std::declval<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>(),
                            std::declval<const TriangleMesh&>()))>> : std::true_type
{};
template <class Field, class Key, class = void>
struct has_at : std::false_type
{};
template <class Field, class Key>
struct has_at<Field, Key, std::void_t<decltype(std::declval<const Field&>().at(std::declval<Key>()))>> : std::true_type
{};

template <class Field, class TriangleMesh>
double wished_length(const Field& field, typename boost::graph_traits<TriangleMesh>::vertex_descriptor v,
                     const TriangleMesh& tmesh)
{
  if constexpr(has_at_with_mesh<Field, TriangleMesh>::value)
    return CGAL::to_double(field.at(v, tmesh));
  else if constexpr(has_at<Field, decltype(v)>::value)
    return CGAL::to_double(field.at(v));
  else
    return CGAL::to_double(get(field, v));
}

// The lengths that the sizing field tells, up to a factor, by internal vertex; none if there is no such field.
template <class TriangleMesh, class NamedParameters>
std::vector<double>
wished_lengths(const TriangleMesh& tmesh,
               const std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertex_of,
               const NamedParameters& np)
{
  std::vector<double> result;
  if constexpr(is_given<NamedParameters, internal_np::sizing_field_t>)
  {
    const auto& field = CGAL::parameters::get_parameter_reference(np, internal_np::sizing_field);
    const auto index = vertex_indices_of(tmesh, np);
    result.reserve(vertex_of.size());
    for(const auto v : vertex_of)
    {
      result.push_back(wished_length(field, v, tmesh));
      if(!(result.back() > 0.) || !std::isfinite(result.back()))
        throw std::invalid_argument("geodesic remeshing: the size of vertex " + std::to_string(get(index, v)) +
                                    " is not positive and finite");
    }
  }
  else
    static_assert(
        !is_given<NamedParameters, internal_np::gradation_t> &&
            !is_given<NamedParameters, internal_np::minimum_length_t> &&
            !is_given<NamedParameters, internal_np::maximum_length_t>,
        "geodesic_remeshing: gradation, minimum_length and maximum_length limit a sizing_field, and there is none");
  return result;
}

template <class NamedParameters>
decltype(auto) visitor_of(const NamedParameters& np)
{
  using CGAL::parameters::get_parameter_reference;
  if constexpr(CGAL::parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value)
    return Default_visitor();
  else
    return get_parameter_reference(np, internal_np::visitor);
}

template <class NamedParameters>
Stage_results* stage_results_of(const NamedParameters& np)
{
  using CGAL::parameters::get_parameter_reference;
  if constexpr(CGAL::parameters::is_default_parameter<NamedParameters, internal_np::stage_results_t>::value)
    return nullptr;
  else
  {
    static_assert(
        std::is_convertible<decltype(get_parameter_reference(np, internal_np::stage_results)), Stage_results&>::value,
        "geodesic_remeshing: pass the stage results by std::ref(), a copy would be lost");
    return &static_cast<Stage_results&>(get_parameter_reference(np, internal_np::stage_results));
  }
}

inline void check_count(const Mesh& mesh, std::size_t wanted)
{
  const std::size_t number = mesh.number_of_vertices();
  if(number == wanted)
    return;
  const std::string what =
      "geodesic remeshing: could not reach " + std::to_string(wanted) + " vertices, only " + std::to_string(number);
  if(number > wanted) // half as many more were seen to be enough
    throw Remeshing_error(what + ": the handles, thin places and lines of the input need more; try " +
                          std::to_string(number + number / 2 + 1) + " vertices");
  if(number < wanted / 2)
    throw Remeshing_error(what +
                          ": the surface is far thinner than the edges are long; more vertices make them shorter");
  throw Remeshing_error(what + ": no face can be divided without one of no area; try " + std::to_string(number) +
                        " vertices");
}

// Over a range of fixed size, made for the elements of the input
template <class Map>
constexpr bool is_of_fixed_size = false;
template <class Iterator, class IndexMap, class Value, class Reference>
constexpr bool is_of_fixed_size<boost::iterator_property_map<Iterator, IndexMap, Value, Reference>> = true;
template <class Iterator, class IndexMap, class Value, class Reference>
constexpr bool is_of_fixed_size<boost::safe_iterator_property_map<Iterator, IndexMap, Value, Reference>> = true;
template <class Value, class IndexMap>
constexpr bool is_of_fixed_size<boost::shared_array_property_map<Value, IndexMap>> = true;

// For other elements than it was made for
template <class Map>
constexpr bool is_writable =
    !is_of_fixed_size<Map> &&
    std::is_convertible<typename boost::property_traits<Map>::category, boost::writable_property_map_tag>::value;

// A pack that has one parameter more, if the other pack has it and it can be written to
template <class Tag, class Pack, class NamedParameters>
auto with_map_of(const Pack& pack, const NamedParameters& np)
{
  if constexpr(is_given<NamedParameters, Tag>)
  {
    const auto map = CGAL::parameters::get_parameter(np, Tag());
    if constexpr(is_writable<std::decay_t<decltype(map)>>)
      return CGAL::Named_function_parameters<std::decay_t<decltype(map)>, Tag, Pack>(map, pack);
    else
      return pack;
  }
  else
    return pack;
}

// Of the parameters of the input those that hold for the output too, when it takes the input's place
template <class TriangleMesh, class NamedParameters>
auto of_output_in_place(const NamedParameters& np)
{
  const CGAL::Named_function_parameters<bool, in_place_t> in_place(true);
  const auto with_traits = in_place.geom_traits(geom_traits_of<TriangleMesh>(np));
  const auto with_points = with_map_of<internal_np::vertex_point_t>(with_traits, np);
  const auto with_edges = with_map_of<internal_np::edge_is_constrained_t>(with_points, np);
  const auto with_patches = with_map_of<internal_np::face_patch_t>(with_edges, np);
  return with_map_of<internal_np::face_region_map_t>(with_patches, np);
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_UNPACK_PARAMETERS_H
