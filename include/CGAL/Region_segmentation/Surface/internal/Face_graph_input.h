// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FACE_GRAPH_INPUT_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FACE_GRAPH_INPUT_H

#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/Mesh_order.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Constrains the edges and seams between pairs of vertices of the input.
inline void constrain(Surface& surface, std::vector<Vertex_pair> pairs)
{
  Surface_builder builder(std::move(surface));
  builder.mark_constraints(std::move(pairs));
  surface = builder.finish();
}

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
    constrain(surface, std::move(constrained));
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
  void write(const Values& values, FaceMap&& map) const
  {
    write_face_values(*m_mesh, values, map);
  }

private:
  const FaceGraph* m_mesh;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_FACE_GRAPH_INPUT_H
