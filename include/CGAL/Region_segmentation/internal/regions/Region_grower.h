// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_GROWER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_GROWER_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/reading/Degenerate_faces.h>
#include <CGAL/Region_segmentation/internal/reading/Edge_constraints.h>
#include <CGAL/Region_segmentation/internal/reading/Joining_edges.h>
#include <CGAL/Region_segmentation/internal/reading/for_each_edge.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Grows regions on the edges of a mesh in their order: the components that `label_components()` finds on the dual edges of a
/// `Flat_mesh`. O(F) in practice.
///
/// Bytes: 4 per face.
template <typename FaceGraph, typename Pack, typename EdgeMap>
class Region_grower
{
  using Traversal = Mesh_traversal<FaceGraph, Pack>;
  using Degenerate = Degenerate_faces<FaceGraph, Pack>;
  using Edge = Mesh_edge<FaceGraph>;
  using Index = Flat_mesh::Index;
  using halfedge_descriptor = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;

public:
  /// `is_feature`: the edges that are marked, not changed
  Region_grower(const Traversal& traversal, const Degenerate& degenerate, const Pack& np, const EdgeMap& is_feature)
    : m_traversal(traversal)
    , m_degenerate(degenerate)
    , m_is_constrained(np)
    , m_is_feature(is_feature)
    , m_forest(traversal.number_of_faces())
  {}

  /// Can be called once.
  template <typename ConcurrencyTag>
  Partition grow(const Execution<ConcurrencyTag>& execution)
  {
    bool has_closed_edges = false;
    for_each_edge(m_traversal, execution, [&](const Edge& e) {
      if (!e.has_two_faces())
        return;
      if (is_beside_degenerate_face(e.face, e.other_face))
        has_closed_edges = true;
      else if (barrier_of(e) == Barrier::NONE)
        m_forest.unite(Index(e.face), Index(e.other_face));
    });
    if (has_closed_edges)
      join_degenerate_faces();
    return m_forest.take_partition();
  }

  /// Calls `f(edge, is_feature)` for the edges in their order: whether they are still feature edges between these regions.
  template <typename F>
  void for_each_edge_between(const Partition& regions, const F& f) const
  {
    for_each_edge(m_traversal, Execution<>(), [&](const Edge& e) {
      const Barrier barrier = barrier_of(e);
      f(e, barrier == Barrier::PERMANENT ||
             (barrier == Barrier::FEATURE && regions[e.face] != regions[e.other_face]));
    });
  }

private:
  /// `FEATURE`: until its faces are in one region; `PERMANENT`: borders of the mesh and constrained edges.
  enum class Barrier { NONE, FEATURE, PERMANENT };

  Barrier barrier_of(const Edge& e) const
  {
    if (e.is_border())
      return Barrier::PERMANENT;
    if (!e.has_two_faces())
      return Barrier::NONE;
    if (m_is_constrained(e.descriptor))
      return Barrier::PERMANENT;
    return bool(get(m_is_feature, e.descriptor)) ? Barrier::FEATURE : Barrier::NONE;
  }

  bool is_beside_degenerate_face(std::size_t face, std::size_t other_face) const
  {
    return m_degenerate.is_degenerate(face) || m_degenerate.is_degenerate(other_face);
  }

  /// Each of them joins across one edge, unless that is marked.
  void join_degenerate_faces()
  {
    const FaceGraph& mesh = m_traversal.mesh();
    const auto rank = [&](halfedge_descriptor h) { return m_traversal.opposite_face_rank(opposite(h, mesh)); };
    const auto is_candidate = [&](const auto& e) {
      const halfedge_descriptor h = halfedge(e, mesh);
      return !CGAL::is_border(e, mesh) && is_beside_degenerate_face(rank(h), rank(opposite(h, mesh))) &&
             !m_is_constrained(e);
    };
    std::vector<halfedge_descriptor> candidates;
    Joining_edges joining;
    const auto add_candidate = [&](halfedge_descriptor h, std::size_t number) {
      for (const halfedge_descriptor side : {h, opposite(h, mesh)})
        if (m_degenerate.is_degenerate(rank(side)))
          joining.add(Index(rank(side)), Index(rank(opposite(side, mesh))), m_degenerate.length(side), Index(number));
    };
    m_traversal.for_each_dual_edge_if(is_candidate, [](std::size_t) { return std::size_t(0); },
                                      [&](halfedge_descriptor h, std::size_t) {
                                        add_candidate(h, candidates.size());
                                        candidates.push_back(h);
                                      });
    joining.for_each([&](Index number) {
      const halfedge_descriptor h = candidates[number];
      if (!bool(get(m_is_feature, edge(h, mesh))))
        m_forest.unite(Index(rank(h)), Index(rank(opposite(h, mesh))));
    });
  }

  const Traversal& m_traversal;
  const Degenerate& m_degenerate;
  const Edge_constraints<FaceGraph, Pack> m_is_constrained;
  const EdgeMap m_is_feature;
  Lowest_root_forest m_forest;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_GROWER_H
