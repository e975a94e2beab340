// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H

#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>
#include <CGAL/Region_segmentation/internal/surface/mark_constraints.h>
#include <CGAL/Region_segmentation/make_surface.h>

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
  void check(const FaceMap&, std::size_t n, const char* what = "labels") const
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

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H
