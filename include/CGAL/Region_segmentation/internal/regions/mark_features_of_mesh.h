// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURES_OF_MESH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURES_OF_MESH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Edge_constraints.h>
#include <CGAL/Region_segmentation/internal/reading/Face_normals.h>
#include <CGAL/Region_segmentation/internal/reading/for_each_edge.h>
#include <CGAL/Region_segmentation/internal/regions/Feature_criterion.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks the edges of a mesh, by their rank, whose dual edges in a `Flat_mesh` `mark_feature_edges()` marks, and its borders.
/// O(F).
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
Edge_marks mark_features_of_mesh(const Mesh_traversal<FaceGraph, Pack>& traversal,
                                 const Face_normals<FaceGraph, Pack>& normals, const Pack& np,
                                 const Feature_criterion& criterion, const Execution<ConcurrencyTag>& execution)
{
  const Edge_constraints<FaceGraph, Pack> is_constrained(np);
  Edge_marks is_feature(num_edges(traversal.mesh()));
  for_each_edge(traversal, execution, [&](const auto& e) {
    bool is_wanted = e.is_border();
    if (e.has_two_faces()) {
      is_wanted = criterion.is_sharp(normals.cosine(e));
      if (!criterion.wants_every_sign() && is_wanted) // in this order: whether an edge is sharp is unpredictable
        is_wanted = criterion.has_wanted_sign(normals.sign(e));
      if (Edge_constraints<FaceGraph, Pack>::are_possible && is_constrained(e.descriptor))
        is_wanted = true;
    }
    is_feature[e.rank] = is_wanted;
  });
  return is_feature;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURES_OF_MESH_H
