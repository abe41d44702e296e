// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_REGION_SWEEP_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_REGION_SWEEP_H

#include <CGAL/Geodesic_remeshing/internal/Region_builder.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// The paper's "Tree structure construction" (section 5): fronts start at the maxima of D and sweep down in the total
// order of the vertices; union-find tells which meet. A vertex whose higher neighbours form several arcs is a saddle:
// there fronts of different components join, or, at a handle, a component meets itself.
//
// A maximum that is joined less than C_d / 2 below its height is noise and begins no region.
class Region_sweep
{
public:
  Region_sweep(const Mesh& mesh, const std::vector<double>& distance, const Vertex_order& order, double curve_distance)
    : m_mesh(mesh), m_distance(distance), m_order(order), m_noise(.5 * curve_distance),
      m_parent(mesh.number_of_vertices()), m_component(mesh.number_of_vertices(), -1)
  {}

  // `builder` gets the events; without one only the tips are found.
  std::vector<Vertex> run(Region_builder* builder)
  {
    for(std::size_t i = m_order.ascending.size(); i-- > 0;)
      visit(m_order.ascending[i], builder);
    if(builder != nullptr)
      for(Vertex v : m_order.ascending)
        if(find(v) == v)
          finish(v, *builder);
    return m_tips;
  }

private:
  // A component of the part of the surface that is swept already
  struct Component
  {
    Vertex peak;
    std::vector<int> open; // its open regions: none as long as it is nothing but a hill
    bool is_hill = true;
  };

  Vertex find(Vertex v)
  {
    while(m_parent[v] != v)
      v = m_parent[v] = m_parent[m_parent[v]];
    return v;
  }

  bool is_above(Vertex w, Vertex v) const { return m_order.rank[w] > m_order.rank[v]; }

  // The neighbours above v, as maximal runs around it
  void collect_arcs(Vertex v)
  {
    m_arcs.clear();
    Halfedge start = m_mesh.halfedge(v);
    Halfedge h = start;
    do // begin where a run begins, if there is more than one
    {
      const Halfedge before = m_mesh.prev(m_mesh.opposite(h));
      if(is_above(m_mesh.source(h), v) && !is_above(m_mesh.source(before), v))
      {
        start = h;
        break;
      }
      h = m_mesh.opposite(m_mesh.next(h));
    } while(h != start);
    h = start;
    bool in_run = false;
    do
    {
      const bool above = is_above(m_mesh.source(h), v);
      if(above && !in_run)
        m_arcs.emplace_back();
      if(above)
        m_arcs.back().push_back(m_mesh.source(h));
      in_run = above;
      h = m_mesh.opposite(m_mesh.next(h));
    } while(h != start);
  }

  // Regular vertices, nearly all, have one run: found without storing it.
  int number_of_arcs(Vertex v, Vertex& one_above) const
  {
    int arcs = 0;
    for(Halfedge h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
    {
      const Vertex w = m_mesh.source(h);
      if(!is_above(w, v))
        continue;
      one_above = w;
      arcs += !is_above(m_mesh.source(m_mesh.opposite(m_mesh.next(h))), v);
    }
    return arcs;
  }

  void visit(Vertex v, Region_builder* builder)
  {
    m_parent[v] = v;
    Vertex above;
    const int arcs = number_of_arcs(v, above);
    if(arcs == 1 || (arcs == 0 && above.is_valid()))
    {
      m_parent[v] = find(above);
      return;
    }
    if(arcs == 0)
    {
      m_component[v] = static_cast<int>(m_components.size());
      m_components.push_back(Component{v, {}, true});
      return;
    }
    collect_arcs(v);
    merge_at(v, builder);
  }

  Component& component(Vertex v) { return m_components[m_component[find(v)]]; }

  double height_above(const Component& c, Vertex v) const { return m_distance[c.peak] - m_distance[v]; }

  // Arcs of hills that are noise drop out, but for the highest hill if there is nothing else.
  void merge_at(Vertex saddle, Region_builder* builder)
  {
    const auto comp = [this](const std::vector<Vertex>& arc) { return m_component[find(arc.front())]; };
    std::vector<int> of_arc;
    for(const auto& arc : m_arcs)
      of_arc.push_back(comp(arc));
    std::vector<int> distinct(of_arc);
    std::sort(distinct.begin(), distinct.end());
    std::vector<std::size_t> taking_part;
    for(std::size_t i = 0; i < m_arcs.size(); ++i)
    {
      const Component& c = m_components[of_arc[i]];
      const auto same = std::equal_range(distinct.begin(), distinct.end(), of_arc[i]);
      const bool meets_itself = same.second - same.first > 1;
      if(!c.is_hill || meets_itself || height_above(c, saddle) >= m_noise)
        taking_part.push_back(i);
    }
    Component merged;
    merged.is_hill = taking_part.size() < 2;
    for(int i : of_arc)
      if(!merged.peak.is_valid() || is_above(m_components[i].peak, merged.peak))
        merged.peak = m_components[i].peak;
    for(int i : of_arc)
      merged.is_hill = merged.is_hill && m_components[i].is_hill;
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if(taking_part.size() >= 2)
      open_leaves(taking_part, of_arc, builder);
    for(int i : distinct)
      merged.open.insert(merged.open.end(), m_components[i].open.begin(), m_components[i].open.end());
    if(taking_part.size() >= 2 && builder != nullptr)
      meet(saddle, taking_part, of_arc, *builder, merged);
    unite(saddle, std::move(merged));
  }

  void open_leaves(const std::vector<std::size_t>& taking_part, const std::vector<int>& of_arc, Region_builder* builder)
  {
    for(std::size_t i : taking_part)
    {
      Component& c = m_components[of_arc[i]];
      if(!c.is_hill)
        continue;
      c.is_hill = false;
      m_tips.push_back(c.peak);
      if(builder != nullptr)
        c.open.push_back(builder->open_leaf(c.peak));
    }
  }

  void meet(Vertex saddle, const std::vector<std::size_t>& taking_part, const std::vector<int>& of_arc,
            Region_builder& builder, Component& merged)
  {
    std::vector<std::vector<Vertex>> arcs;
    std::vector<int> regions;
    for(std::size_t i : taking_part)
    {
      arcs.push_back(m_arcs[i]);
      regions.push_back(builder.region_above(saddle, m_arcs[i].front(), m_components[of_arc[i]].open));
    }
    const std::vector<int> opened = builder.meet(saddle, arcs, regions);
    auto& open = merged.open;
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](int r) { return std::find(regions.begin(), regions.end(), r) != regions.end(); }),
               open.end());
    open.insert(open.end(), opened.begin(), opened.end());
  }

  void unite(Vertex saddle, Component merged)
  {
    Vertex root = find(m_arcs.front().front());
    for(const auto& arc : m_arcs)
      m_parent[find(arc.front())] = root;
    m_parent[saddle] = root;
    m_components[m_component[root]] = std::move(merged);
  }

  // `last` is the union-find representative of a whole connected component of the surface
  void finish(Vertex last, Region_builder& builder)
  {
    Component& c = m_components[m_component[last]];
    if(c.is_hill)
    {
      m_tips.push_back(c.peak);
      c.open.assign(1, builder.open_root_below_leaf(builder.open_leaf(c.peak)));
    }
    builder.finish(lowest(last), c.open);
  }

  Vertex lowest(Vertex representative)
  {
    if(m_lowest.empty())
    {
      m_lowest.resize(m_mesh.number_of_vertices());
      for(std::size_t i = m_order.ascending.size(); i-- > 0;)
        m_lowest[find(m_order.ascending[i])] = m_order.ascending[i];
    }
    return m_lowest[representative];
  }

  const Mesh& m_mesh;
  const std::vector<double>& m_distance;
  const Vertex_order& m_order;
  const double m_noise;
  std::vector<Vertex> m_parent; // union-find
  std::vector<int> m_component; // of a representative: index into m_components
  std::vector<Component> m_components;
  std::vector<std::vector<Vertex>> m_arcs;
  std::vector<Vertex> m_tips, m_lowest;
};

// The regions of a surface whose vertices have the given distance from the root (one of `roots` in each component).
inline Segmentation segment(const Mesh& mesh, Fast_marching& marching, const std::vector<double>& distance,
                            const Vertex_order& order, double curve_distance)
{
  Region_builder builder(mesh, marching, distance, order, curve_distance);
  Region_sweep(mesh, distance, order, curve_distance).run(&builder);
  return builder.take_result();
}

// Without segmentation (the paper's Figures 2(b) and 8(b)) all is one region, and its curves are those of D itself.
inline Segmentation one_region(const Mesh& mesh, const std::vector<double>& distance, const Vertex_order& order,
                               Vertex root, double curve_distance)
{
  const double height = distance[order.ascending.back()];
  Region region;
  region.kind = Region_kind::root;
  region.centre = root;
  region.height = height;
  region.number_of_levels = static_cast<int>((std::max)(1., std::round(height / curve_distance)));
  region.spacing = height / region.number_of_levels;
  region.bottom = 1;
  Segmentation result;
  result.number_of_junctions = 2;
  result.regions.push_back(region);
  result.region.assign(mesh.number_of_vertices(), 0);
  result.field_region = result.region;
  result.time.assign(mesh.number_of_vertices(), 1);
  result.field = distance;
  for(double d : distance)
    result.level.push_back((std::max)(1, static_cast<int>(std::ceil(d / region.spacing - 1e-9))));
  result.tips = Region_sweep(mesh, distance, order, curve_distance).run(nullptr);
  return result;
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_REGION_SWEEP_H
