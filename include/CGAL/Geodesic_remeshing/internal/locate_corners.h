// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_LOCATE_CORNERS_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_LOCATE_CORNERS_H

#include <CGAL/Geodesic_remeshing/internal/Input_surface.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/walk_into.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/interpolate.h>
#include <CGAL/Geodesic_remeshing/internal/known_parameters.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Of the way from corner i of a face to its centre: where this part of it leads
inline Place towards_centre(const Surface_walker& walker, const std::array<Place, 3>& corners, int i, double part)
{
  const Point p = walker.point(corners[i]);
  const Vector to_centre = ((walker.point(corners[(i + 1) % 3]) - p) + (walker.point(corners[(i + 2) % 3]) - p)) / 3.;
  return walk_into(walker, corners[i], part * to_centre);
}

// Finds the input faces that an output face lies over, by walking on the input surface from its corners, whose places
// are known.
template <class TriangleMesh>
class Corner_locator
{
  using Traits = boost::graph_traits<TriangleMesh>;

public:
  template <class NamedParameters>
  Corner_locator(const TriangleMesh& tmesh, const NamedParameters& np)
    : m_input(copy(tmesh, np)), m_walker(m_input->mesh, Constraints())
  {
    const auto index = get_initialized_face_index_map(tmesh, np);
    m_face.resize(largest_index(faces(tmesh), index) + 1);
    m_index = [index](typename Traits::face_descriptor f) { return static_cast<std::size_t>(get(index, f)); };
    for(std::size_t i = 0; i < m_input->face_of.size(); ++i)
      m_face[m_index(m_input->face_of[i])] = Face(static_cast<Face::size_type>(i));
  }

  typename Traits::face_descriptor face_of(Face f) const { return m_input->face_of[f]; }

  // The places of the sources of the halfedges of f, from halfedge(f) on
  template <class OutputMesh, class LocationMap>
  std::array<Place, 3> corners(typename boost::graph_traits<OutputMesh>::face_descriptor f, const OutputMesh& remeshed,
                               const LocationMap& locations) const
  {
    std::array<Place, 3> result;
    auto h = halfedge(f, remeshed);
    for(Place& place : result)
    {
      const auto location = get(locations, source(h, remeshed));
      place = Place{m_face[m_index(location.first)], in_doubles(location.second)};
      h = next(h, remeshed);
    }
    return result;
  }

  // Of the way from corner i to the centre: where this part of it leads
  Place towards_centre(const std::array<Place, 3>& corners, int i, double part) const
  {
    return internal::towards_centre(m_walker, corners, i, part);
  }

  // The place of corner i in the input face that the output face begins in
  Place beside(const std::array<Place, 3>& corners, int i) const
  {
    const auto& c = corners[i].coordinates;
    if(c[0] > 0. && c[1] > 0. && c[2] > 0.)
      return corners[i];
    constexpr double a_little = 1e-6;
    const Place near = towards_centre(corners, i, a_little);
    if(is_of(near.face, corners[i]))
      return Place{near.face, coordinates_in(m_input->mesh, corners[i], near.face)};
    return near; // beyond a face smaller than that
  }

private:
  template <class NamedParameters>
  static std::unique_ptr<Input_surface<TriangleMesh>> copy(const TriangleMesh& tmesh, const NamedParameters& np)
  {
    check_parameters<NamedParameters, Parameters_of_mesh>();
    auto result = std::make_unique<Input_surface<TriangleMesh>>();
    copy_input(tmesh, np, *result);
    return result;
  }

  // Are all vertices that carry weight in the place vertices of the face?
  bool is_of(Face f, const Place& place) const
  {
    const auto from = vertices_of(m_input->mesh, place.face), to = vertices_of(m_input->mesh, f);
    for(int i = 0; i < 3; ++i)
      if(place.coordinates[i] > 0. && std::find(to.begin(), to.end(), from[i]) == to.end())
        return false;
    return true;
  }

  std::unique_ptr<const Input_surface<TriangleMesh>> m_input; // at a fixed place, since the walker refers to its mesh
  Surface_walker m_walker;
  std::vector<Face> m_face;
  std::function<std::size_t(typename Traits::face_descriptor)> m_index;
};

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_LOCATE_CORNERS_H
