// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FACE_GRAPH_INPUT_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FACE_GRAPH_INPUT_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>
#include <CGAL/Region_segmentation/Surface/internal/read_surface.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Returns a surface with the constraints that a pack of named parameters has.
template <typename Input, typename Pack>
Surface constrained([[maybe_unused]] const Input& input, Surface surface,
                    [[maybe_unused]] const Pack& np)
{
  if constexpr (has_parameter<Pack, std::decay_t<decltype(Input::constraints)>>)
    input.add_constraints(surface, CGAL::parameters::get_parameter(np, Input::constraints), np);
  return surface;
}

/// A face graph as input of a segmentation: what is read from its property maps, and where labels
/// are written.
template <typename FaceGraph>
class Face_graph_input
{
  using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;

public:
  /// The named parameter of constraints.
  static constexpr auto constraints = CGAL::internal_np::edge_is_constrained;

  explicit Face_graph_input(const FaceGraph& mesh)
    : m_mesh(&mesh)
  {}

  const FaceGraph& mesh() const { return *m_mesh; }

  /// Constrains the edges for which a map has the value `true`.
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

/// The input of a stage that has edge maps: a face graph, and its surface without links, since no
/// stage crosses links.
template <typename FaceGraph, typename Pack>
class Stage_input
{
public:
  Stage_input(const FaceGraph& mesh, const Pack& np, const Execution& execution)
    : m_order(mesh, np)
    , m_surface(constrained(
        Face_graph_input<FaceGraph>(mesh),
        make_surface(m_order, np,
                     component_links(np) ? Adjacency_of::COINCIDING_SIDES : Adjacency_of::NEIGHBORS,
                     execution.stage("reading")),
        np))
  {}

  const FaceGraph& mesh() const { return m_order.mesh(); }
  const Surface& surface() const { return m_surface; }
  /// The vertices of the mesh in the order of those of the surface.
  const auto& vertices() const { return m_order.ordered_vertices(); }

  /// Reads an edge map. Returns for each adjacency whether its edge has the value `true`: 1 or 0.
  template <typename EdgeMap>
  std::vector<std::uint8_t> read(const EdgeMap& map) const
  {
    std::vector<std::uint8_t> marks(m_surface.number_of_adjacencies());
    for_each_edge([&](auto e, Surface::Index a) {
      if (a != Surface::none)
        marks[a] |= bool(get(map, e)); // coinciding edges have one adjacency
    });
    return marks;
  }

  /// Writes an edge map: `true` for the edges whose adjacency is marked or constrained, and for
  /// borders of the surface. Returns the number of edges with `true`.
  template <typename EdgeMap>
  std::size_t write(const std::vector<std::uint8_t>& marks, EdgeMap& map) const
  {
    using Mapped = typename boost::property_traits<EdgeMap>::value_type;
    std::size_t number = 0;
    for_each_edge([&](auto e, Surface::Index a) {
      const bool is_true = a == Surface::none
                             ? CGAL::is_border(e, mesh())
                             : marks[a] || m_surface.has_flag(a, Surface::CONSTRAINED);
      put(map, e, Mapped(is_true));
      number += is_true;
    });
    return number;
  }

private:
  /// Calls `f(edge, adjacency)` for each edge; `Surface::none` for a border, and for an edge with
  /// the same face on both sides. Edges are visited in the order of the higher of their faces.
  template <typename F>
  void for_each_edge(const F& f) const
  {
    for (Surface::Index face = 0; face < m_order.number_of_faces(); ++face) {
      const auto first = halfedge(m_order.ordered_faces()[face], mesh());
      const std::size_t n = m_surface.number_of_corners(face);
      auto [side, step] = side_of(face, first);
      for (auto h : CGAL::halfedges_around_face(first, mesh())) {
        const Surface::Index across = m_order.face_rank(opposite(h, mesh()));
        if (across <= face || across == m_order.none)
          f(edge(h, mesh()), m_surface.adjacency(face, side));
        side = side + step < n ? side + step : side + step - n;
      }
    }
  }

  /// The side of a face at one of its halfedges, and the step to the side at the next one, modulo
  /// the number n of corners: 1, or n - 1 where the surface has turned the face.
  template <typename Halfedge>
  std::pair<std::size_t, std::size_t> side_of(Surface::Index face, const Halfedge& h) const
  {
    const std::size_t n = m_surface.number_of_corners(face);
    const auto is_at = [&](std::size_t i, const Halfedge& leaving) {
      const Surface::Index v = m_order.vertex_rank(source(leaving, mesh()));
      return m_surface.corner(face, i % n) == merged_vertex(m_surface, v);
    };
    const Halfedge second = next(h, mesh()), third = next(second, mesh());
    for (const std::size_t step : {std::size_t(1), n - 1})
      for (std::size_t i = 0; i < n; ++i)
        if (is_at(i, h) && is_at(i + step, second) && is_at(i + 2 * step, third))
          return {step == 1 ? i : (i + step) % n, step};
    CGAL_assertion_msg(false, "a face of the surface has the corners of that of the mesh");
    return {0, 1};
  }

  Mesh_order<FaceGraph, Pack> m_order;
  Surface m_surface;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FACE_GRAPH_INPUT_H
