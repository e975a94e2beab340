// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_LABEL_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_LABEL_COMPONENTS_H

#include <CGAL/Region_segmentation/internal/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected components of the faces across edges that are neither marked nor closed by a
/// degenerate face. O(F) in practice (inverse Ackermann is replaced by a logarithm at worst).
template <typename ConcurrencyTag>
Region_labels label_components(const Flat_mesh& flat, const Edge_marks& is_feature)
{
  using Index = Flat_mesh::Index;
  const auto is_way = [&](std::size_t e) { return !is_feature[e] && !flat.has_flag(e, Flat_mesh::CLOSED); };
  Lowest_root_forest<ConcurrencyTag> forest(flat.number_of_faces());
  if constexpr (is_parallel<ConcurrencyTag>)
    for_each_block<ConcurrencyTag>(
      flat.number_of_edges(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
          if (is_way(e))
            forest.unite(flat.lower_face(e), flat.higher_face(e));
      });
  else {
    // Edges follow their higher face: it is its own root at the first one, and its root is at hand then.
    Index face = 0, root = 0;
    for (std::size_t e = 0; e < flat.number_of_edges(); ++e) {
      const Index higher = flat.higher_face(e);
      root = higher == face ? root : higher;
      face = higher;
      if (is_way(e))
        root = forest.unite_with_root(root, flat.lower_face(e));
    }
  }
  return forest.take_labels();
}

/// Clears the marks of edges between two faces of one region, unless they are constrained.
template <typename ConcurrencyTag>
void clear_marks_within_regions(const Flat_mesh& flat, const Region_labels& regions, Edge_marks& is_feature)
{
  for_each_block<ConcurrencyTag>(
    flat.number_of_edges(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
        if (is_feature[e] && !flat.has_flag(e, Flat_mesh::CONSTRAINED) &&
            regions.of_face[flat.lower_face(e)] == regions.of_face[flat.higher_face(e)])
          is_feature[e] = 0;
    });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_LABEL_COMPONENTS_H
