// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_NAMED_PARAMETERS_H
#define CGAL_GEODESIC_REMESHING_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/version.h>

#ifndef DOXYGEN_RUNNING // doxygen cannot follow the X-macro lists

// A named parameter of CGAL is found by the type of its tag, so a package may have tags of its own; but what may follow
// the dot in `parameters::a(x).b(y)` are the members of CGAL's class, that is the names of CGAL only. The pack
// below derives from CGAL's and has the members for both, so that
// `Geodesic_remeshing::parameters::vertex_point_map(m).use_segmentation(false)` works, in any order.
// Algorithms only call `get_parameter(np, internal_np::tag)` and know nothing of it.

namespace CGAL {
namespace Geodesic_remeshing {

namespace internal_np {

// the tags of the package beside those of CGAL
using namespace CGAL::internal_np;

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Geodesic_remeshing/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace internal_np

template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  typedef CGAL::Named_function_parameters<T, Tag, Base> Cgal_pack;

  Named_parameters(const Cgal_pack& pack) : Cgal_pack(pack) {}

  const Cgal_pack& cgal_pack() const { return *this; }

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, internal_np::X, Cgal_pack> Z(const K& k) const                                                   \
  {                                                                                                                    \
    return {CGAL::Named_function_parameters<K, internal_np::X, Cgal_pack>(k, cgal_pack())};                            \
  }
#include <CGAL/Geodesic_remeshing/internal/all_parameters_interface.h>
};

namespace parameters {

// this namespace hides CGAL::parameters inside CGAL::Geodesic_remeshing
using CGAL::parameters::choose_parameter;
using CGAL::parameters::Default_named_parameters;
using CGAL::parameters::default_values;
using CGAL::parameters::get_parameter;
using CGAL::parameters::get_parameter_reference;
using CGAL::parameters::is_default_parameter;

// the head of a chain
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, internal_np::X> Z(const K& k)                                                                    \
  {                                                                                                                    \
    return {CGAL::Named_function_parameters<K, internal_np::X>(k)};                                                    \
  }
#include <CGAL/Geodesic_remeshing/internal/all_parameters_interface.h>

// a pack of CGAL becomes one of ours, so that names of the package can follow those of CGAL
template <typename T, typename Tag, typename Base>
Named_parameters<T, Tag, Base> from(const CGAL::Named_function_parameters<T, Tag, Base>& pack)
{
  return {pack};
}

} // namespace parameters

namespace internal {

// What to hand to functions of CGAL: overloads such as those of PMP::area() match CGAL's class only, not one derived.
template <typename T, typename Tag, typename Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
cgal_pack(const CGAL::Named_function_parameters<T, Tag, Base>& pack)
{
  return pack;
}

} // namespace internal

} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // DOXYGEN_RUNNING

#endif // CGAL_GEODESIC_REMESHING_NAMED_PARAMETERS_H
