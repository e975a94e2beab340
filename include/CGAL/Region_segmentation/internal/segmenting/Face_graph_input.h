// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTING_FACE_GRAPH_INPUT_H

#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/internal/surface/edges_of_adjacencies.h>
#include <CGAL/Region_segmentation/internal/surface/mark_constraints.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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

  /// Adds the constraints of a map of the edges.
  template <typename EdgeMap, typename Pack>
  void add_constraints(const Surface& surface, const EdgeMap& map, const Pack& np,
                       Constraints& constraints) const
  {
    static_assert(check_edge_map<EdgeMap, FaceGraph>());
    const Mesh_order<FaceGraph, Pack> order(*m_mesh, np);
    add_constraints_of_edges(order, surface, map, constraints);
    std::vector<Vertex_pair> borders; // border edges may coincide
    if (component_links(np))
      for (const edge_descriptor e : edges(*m_mesh))
        if (get(map, e) && CGAL::is_border(e, *m_mesh))
          borders.push_back(
            {order.vertex_rank(source(e, *m_mesh)), order.vertex_rank(target(e, *m_mesh))});
    mark_constraints(surface, std::move(borders), constraints);
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
