// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>
#include <CGAL/Region_segmentation/internal/surface/read_surface.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Constrains what a pack says.
template <typename Input, typename Pack>
void constrain([[maybe_unused]] const Input& input, [[maybe_unused]] Surface& surface,
               [[maybe_unused]] const Pack& np)
{
  if constexpr (has_parameter<Pack, CGAL::internal_np::edge_is_constrained_t>)
    input.add_constraints(
      surface, CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained), np);
}

/// A face graph as input of a segmentation: what is read from its property maps, and where labels
/// are written.
template <typename FaceGraph>
class Face_graph_input
{
  using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;

public:
  explicit Face_graph_input(const FaceGraph& mesh)
    : m_mesh(&mesh)
  {}

  const FaceGraph& mesh() const { return *m_mesh; }

  /// Constrains the edges of a map.
  template <typename EdgeMap, typename Pack>
  void add_constraints(Surface& surface, const EdgeMap& map, const Pack& np) const
  {
    static_assert(check_edge_map<EdgeMap, FaceGraph>());
    const Mesh_order<FaceGraph, Pack> order(*m_mesh, np);
    std::vector<Vertex_pair> constrained;
    for (const edge_descriptor e : edges(*m_mesh))
      if (get(map, e))
        constrained.push_back(
          {order.vertex_rank(source(e, *m_mesh)), order.vertex_rank(target(e, *m_mesh))});
    mark_constraints(surface, constrained);
  }

  /// \throws Invalid_input if a map does not hold labels below `n`
  template <typename FaceMap>
  void check(const FaceMap&, std::size_t n, const char* what = "label") const
  {
    check_labels<typename boost::property_traits<FaceMap>::value_type>(n, what);
  }

  template <typename FaceMap>
  auto values(const FaceMap& map) const
  {
    return face_values(*m_mesh, map);
  }

  template <typename Values, typename FaceMap>
  void write(const Values& values, FaceMap& map) const
  {
    write_face_values(*m_mesh, values, map);
  }

private:
  const FaceGraph* m_mesh;
};

/// A face graph as the input of a single stage, whose maps have edges as keys: its surface, without
/// links, which no stage crosses.
template <typename FaceGraph, typename Pack>
class Stage_input
{
public:
  Stage_input(const FaceGraph& mesh, const Pack& np, const Execution& execution)
    : m_order(mesh, np)
    , m_surface(make_surface(
        m_order, np, component_links(np) ? Adjacency_of::COINCIDING_SIDES : Adjacency_of::NEIGHBORS,
        execution.stage("reading")))
  {
    constrain(Face_graph_input<FaceGraph>(mesh), m_surface, np);
  }

  const FaceGraph& mesh() const { return m_order.mesh(); }
  const Surface& surface() const { return m_surface; }
  bool is_constrained(std::size_t adjacency) const
  {
    return m_surface.has_flag(adjacency, Surface::CONSTRAINED);
  }

  /// Calls `f(halfedge, adjacency)` for each edge, with the adjacency across it: `Surface::none`
  /// for a border, and for an edge with the same face on both sides. In the order of the higher
  /// faces.
  template <typename F>
  void for_each_edge(const F& f) const
  {
    for (Surface::Index face = 0; face < m_order.number_of_faces(); ++face) {
      const auto first = m_order.first_halfedge(m_order.ordered_faces()[face]);
      for (auto h : CGAL::halfedges_around_face(first, mesh())) {
        const Surface::Index across = m_order.face_rank(opposite(h, mesh()));
        if (across <= face || across == m_order.none)
          f(h, adjacency(face, h));
      }
    }
  }

  /// The number of a vertex, by iteration.
  template <typename Vertex>
  Surface::Index rank(const Vertex& v) const
  {
    return m_order.vertex_rank(v);
  }

  /// Writes `value(adjacency)` for the edges with an adjacency, `true` for the other border edges,
  /// `false` for the rest. Returns the number of edges with `true`.
  template <typename EdgeMap, typename Value>
  std::size_t write(EdgeMap& map, const Value& value) const
  {
    using Mapped = typename boost::property_traits<EdgeMap>::value_type;
    std::size_t number = 0;
    for_each_edge([&](auto h, Surface::Index a) {
      const auto e = edge(h, mesh());
      const bool is_true = a == Surface::none ? CGAL::is_border(e, mesh()) : value(a);
      put(map, e, Mapped(is_true));
      number += is_true;
    });
    return number;
  }

private:
  /// Across the side of a face at a halfedge.
  template <typename Halfedge>
  Surface::Index adjacency(Surface::Index face, const Halfedge& h) const
  {
    return arrays_of(m_surface)
      .adjacencies[side_between(m_surface, face, merged_vertex(m_surface, rank(source(h, mesh()))),
                                merged_vertex(m_surface, rank(target(h, mesh()))))];
  }

  Mesh_order<FaceGraph, Pack> m_order;
  Surface m_surface;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H
