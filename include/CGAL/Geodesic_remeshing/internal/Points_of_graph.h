// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_POINTS_OF_GRAPH_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_POINTS_OF_GRAPH_H

#include <CGAL/Geodesic_remeshing/internal/types.h>
#include <CGAL/Geodesic_remeshing/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

namespace CGAL {

template <class ET>
class Lazy_exact_nt;

namespace Geodesic_remeshing {
namespace internal {

// The nearest double, or one beside it. That of a lazily exact number must not depend on who has asked for its exact
// value before, and may be as far from it as five digits if nobody has.
template <class FT>
double to_nearest_double(const FT& x)
{
  return CGAL::to_double(x);
}

template <class ET>
double to_nearest_double(const Lazy_exact_nt<ET>& x)
{
  return CGAL::to_double(x.exact());
}

// The one place where the points of users meet those of the stages. It asks nothing of the former but what the
// geometric traits tell of them, so that they may be of any type, and rounds coordinates to doubles.
template <class Traits, class User_point>
Point to_point(const Traits traits,
               const User_point& p) // a traits class is mostly empty, and g++ warns of references to such
{
  return Point(to_nearest_double(traits.compute_x_3_object()(p)), to_nearest_double(traits.compute_y_3_object()(p)),
               to_nearest_double(traits.compute_z_3_object()(p)));
}

template <class Traits>
auto from_point(const Traits& traits, const Point& p)
{
  using FT = typename Traits::FT;
  return traits.construct_point_3_object()(static_cast<FT>(p.x()), static_cast<FT>(p.y()), static_cast<FT>(p.z()));
}

template <class Graph, class NamedParameters>
auto geom_traits_of(const NamedParameters& np)
{
  using Traits = typename GetGeomTraits<Graph, NamedParameters>::type;
  return Traits(
      CGAL::parameters::choose_parameter<Traits>(CGAL::parameters::get_parameter(np, internal_np::geom_traits)));
}

// The points of the vertices of a mesh of the user
template <class Graph, class NamedParameters>
class Points_of_graph
{
  using Traits = typename GetGeomTraits<Graph, NamedParameters>::type;
  using Map = typename GetVertexPointMap<Graph, NamedParameters>::const_type;

public:
  Points_of_graph(const Graph& graph, const NamedParameters& np)
    : m_map(CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::vertex_point),
                                               get_const_property_map(vertex_point, graph))),
      m_traits(geom_traits_of<Graph>(np))
  {}

  Point operator()(typename boost::graph_traits<Graph>::vertex_descriptor v) const
  {
    return to_point(m_traits, get(m_map, v));
  }

private:
  Map m_map;
  Traits m_traits;
};

// Takes the points of a result and puts them into the map of the user.
template <class Map, class Traits>
struct Converting_point_map
{
  using key_type = typename boost::property_traits<Map>::key_type;
  using value_type = Point;
  using reference = Point;
  using category = boost::writable_property_map_tag;

  friend void put(const Converting_point_map& points, const key_type& v, const Point& p)
  {
    put(points.map, v, from_point(points.traits, p));
  }

  Map map;
  Traits traits;
};

template <class OutputMesh, class NamedParameters>
auto output_points_of(OutputMesh& out, const NamedParameters& np)
{
  using Map = typename GetVertexPointMap<OutputMesh, NamedParameters>::type;
  Map map = CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::vertex_point),
                                               get_property_map(vertex_point, out));
  return Converting_point_map<Map, typename GetGeomTraits<OutputMesh, NamedParameters>::type>{
      map, geom_traits_of<OutputMesh>(np)};
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_POINTS_OF_GRAPH_H
