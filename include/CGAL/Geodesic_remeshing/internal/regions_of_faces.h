// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REGIONS_OF_FACES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REGIONS_OF_FACES_H

#include <CGAL/Geodesic_remeshing/internal/Segmentation.h>
#include <CGAL/Geodesic_remeshing/internal/Surface_walker.h>
#include <CGAL/Geodesic_remeshing/internal/Working_surface.h>
#include <CGAL/Geodesic_remeshing/internal/locate_corners.h>
#include <CGAL/Geodesic_remeshing/internal/triangulate_strips.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The region that most of a working face's vertices are in
inline int region_of_face(const Mesh& mesh, const Segmentation& segmentation, Face f)
{
  const auto v = vertices_of(mesh, f);
  const int a = segmentation.region[v[0]], b = segmentation.region[v[1]], c = segmentation.region[v[2]];
  return b == c ? b : a;
}

// Finds the face of the working surface that a place on the input is in. Those in one input face divide it, so the way
// there goes from face to face within it, from the one that was found there last.
class Working_face_finder
{
public:
  Working_face_finder(const Mesh& surface, const Working_surface& working)
    : m_surface(surface), m_working(working), m_last(surface.number_of_faces()), m_parts(surface.number_of_faces(), 0)
  {
    for(Face f : working.mesh.faces())
    {
      m_last[working.input_face[f]] = f;
      ++m_parts[working.input_face[f]];
    }
  }

  Face face_at(const Place& place)
  {
    Face& f = m_last[place.face];
    for(std::uint32_t steps = 1; steps < m_parts[place.face]; ++steps) // by rounding a way may lead in circles
    {
      const Halfedge h = side_facing(f, place);
      if(!h.is_valid())
        break;
      f = m_working.mesh.face(m_working.mesh.opposite(h));
    }
    return f;
  }

private:
  using Coordinates = std::array<double, 3>;

  // The side of a working face that the place is farthest beyond, in the coordinates of the input face; none if it is
  // inside, or beyond the input face by rounding
  Halfedge side_facing(Face f, const Place& place) const
  {
    const Mesh& mesh = m_working.mesh;
    Halfedge h = mesh.halfedge(f), result;
    double farthest = -1e-12;
    for(int i = 0; i < 3; ++i, h = mesh.next(h))
    {
      const double side = turn(at(mesh.source(h), place.face), at(mesh.target(h), place.face), place.coordinates);
      const Face beyond = mesh.face(mesh.opposite(h));
      if(!(side < farthest) || beyond == Mesh::null_face() || m_working.input_face[beyond] != place.face)
        continue;
      farthest = side;
      result = h;
    }
    return result;
  }

  Coordinates at(Vertex v, Face input_face) const { return coordinates_in(m_surface, m_working.place[v], input_face); }

  static double turn(const Coordinates& a, const Coordinates& b, const Coordinates& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  const Mesh& m_surface;
  const Working_surface& m_working;
  std::vector<Face> m_last;           // found, by input face
  std::vector<std::uint32_t> m_parts; // their number, by input face
};

// The region that each face of the output has its centre in. `working` is the surface that was segmented.
inline std::vector<int> regions_of_faces(const Mesh& surface, const Working_surface& working,
                                         const Segmentation& segmentation, const Placed_mesh& remeshed)
{
  const Surface_walker walker(surface, Constraints());
  Working_face_finder finder(surface, working);
  std::vector<int> result;
  result.reserve(remeshed.mesh.number_of_faces());
  for(Face f : remeshed.mesh.faces())
  {
    std::array<Place, 3> corners;
    for(int i = 0; i < 3; ++i)
      corners[i] = remeshed.place[vertices_of(remeshed.mesh, f)[i]];
    const Place centre = towards_centre(walker, corners, 0, 1.);
    result.push_back(region_of_face(working.mesh, segmentation, finder.face_at(centre)));
  }
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REGIONS_OF_FACES_H
