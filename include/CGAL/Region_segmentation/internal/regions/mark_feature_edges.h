// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/regions/Feature_criterion.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks the dual edges that are feature edges by their angle and sign, and the constrained ones; most are compared by their
/// flags. O(F).
template <typename ConcurrencyTag>
Edge_marks mark_feature_edges(const Flat_mesh& flat, const Feature_criterion& criterion,
                              const Execution<ConcurrencyTag>& execution)
{
  const double bound = criterion.bound();
  // The result for an edge if the flags alone decide it.
  enum Answer : std::uint8_t { NO, YES, ASK };
  std::array<Answer, 1 << Flat_mesh::number_of_flags> answers;
  for (std::size_t flags = 0; flags < answers.size(); ++flags) {
    const Answer is_sharp = flags & Flat_mesh::NEARLY_FLAT ? (bound <= Flat_mesh::nearly_flat ? NO : ASK)
                            : flags & Flat_mesh::NOT_FLAT  ? (bound >= Flat_mesh::not_flat ? YES : ASK)
                            : bound > Flat_mesh::nearly_flat ? YES
                            : bound <= Flat_mesh::not_flat   ? NO
                                                             : ASK;
    const bool has_sign = criterion.has_wanted_sign(std::uint8_t(flags));
    const bool has_angle = (flags & (Flat_mesh::JOINING | Flat_mesh::CLOSED)) == 0;
    answers[flags] = flags & Flat_mesh::CONSTRAINED ? YES : has_sign && has_angle ? is_sharp : NO;
  }

  Edge_marks is_feature(flat.number_of_edges());
  for_each_block(
    execution, flat.number_of_edges(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        const Answer answer = answers[flat.flags(e)];
        is_feature[e] = answer == ASK ? criterion.is_sharp(flat.cosine(flat.lower_face(e), e)) : answer == YES;
      }
    });
  return is_feature;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_MARK_FEATURE_EDGES_H
