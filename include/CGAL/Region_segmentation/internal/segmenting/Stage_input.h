// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_STAGE_INPUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_STAGE_INPUT_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/surface/edges_of_adjacencies.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A face graph as the input of a single stage, whose maps have edges as keys: a surface with the
/// adjacencies across edges of the graph alone, and the constraints.
template <typename FaceGraph, typename Pack>
class Stage_input
{
public:
  Stage_input(const FaceGraph& mesh, const Pack& np, const Execution& execution)
    : m_order(mesh, np)
    , m_surface(make_surface_of_neighbors(m_order, np, execution.stage("reading")))
  {
    if constexpr (has_parameter<Pack, CGAL::internal_np::edge_is_constrained_t>)
      add_constraints_of_edges(
        m_order, m_surface,
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained), m_constraints);
  }

  const FaceGraph& mesh() const { return m_order.mesh(); }
  const Surface& surface() const { return m_surface; }
  const Constraints& constraints() const { return m_constraints; }

  /// Calls `f(halfedge, adjacency)` for the edges with two different faces, each with the halfedge
  /// of the lower face.
  template <typename F>
  void for_each_adjacency(const F& f) const
  {
    for_each_edge_with_adjacency(
      m_order, m_surface, [](const auto&) { return true; }, f);
  }

  /// The number of a vertex, by iteration.
  template <typename Vertex>
  std::size_t rank(const Vertex& v) const
  {
    return m_order.vertex_rank(v);
  }

  /// Writes `value(adjacency)` for the edges with two different faces, `true` for border edges,
  /// `false` for the others. Returns the number of edges with `true`.
  template <typename EdgeMap, typename Value>
  std::size_t write(EdgeMap& map, const Value& value) const
  {
    using Mapped = typename boost::property_traits<EdgeMap>::value_type;
    std::size_t number = 0;
    for_each_adjacency([&](auto h, std::size_t a) {
      const bool is_true = value(a);
      put(map, edge(h, mesh()), Mapped(is_true));
      number += is_true;
    });
    for (auto e : edges(mesh())) {
      const auto h = halfedge(e, mesh());
      const bool is_border = CGAL::is_border(e, mesh());
      if (is_border || face(h, mesh()) == face(opposite(h, mesh()), mesh()))
        put(map, e, Mapped(is_border));
      number += is_border;
    }
    return number;
  }

private:
  Mesh_order<FaceGraph, Pack> m_order;
  Surface m_surface;
  Constraints m_constraints;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_STAGE_INPUT_H
