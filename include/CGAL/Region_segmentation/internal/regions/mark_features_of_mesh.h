// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURES_OF_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURES_OF_MESH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Edge_constraints.h>
#include <CGAL/Region_segmentation/internal/reading/Face_normals.h>
#include <CGAL/Region_segmentation/internal/reading/for_each_edge.h>
#include <CGAL/Region_segmentation/internal/regions/Feature_criterion.h>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(edge, is_feature)` for the edges of a mesh in their order: the feature edges are those whose dual edges in a
/// `Flat_mesh` `mark_feature_edges()` marks, and the borders. O(F).
template <typename ConcurrencyTag, typename FaceGraph, typename Pack, typename F>
void mark_features_of_mesh(const Mesh_traversal<FaceGraph, Pack>& traversal, const Face_normals<FaceGraph, Pack>& normals,
                           const Pack& np, const Feature_criterion& criterion,
                           const Execution<ConcurrencyTag>& execution, F f)
{
  const Edge_constraints<FaceGraph, Pack> is_constrained(np);
  const auto mark = [&](const auto& is_wanted) {
    for_each_edge(traversal, execution, [&is_constrained, is_wanted, f](const Mesh_edge<FaceGraph>& e) {
      f(e, e.is_border() || (e.has_two_faces() && (is_constrained(e.descriptor) || is_wanted(e))));
    });
  };
  if (criterion.wants_every_sign())
    mark([&normals, criterion](const auto& e) { return criterion.is_sharp(normals.cosine(e)); });
  else // in this order: whether an edge is sharp is unpredictable
    mark([&normals, criterion](const auto& e) {
      return criterion.is_sharp(normals.cosine(e)) && criterion.has_wanted_sign(normals.sign(e));
    });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURES_OF_MESH_H
