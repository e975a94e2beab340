// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_RAND_INDEX_DISTANCE_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_RAND_INDEX_DISTANCE_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/measures/Contingency_table.h>
#include <CGAL/Region_segmentation/internal/support/read_face_labels.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// C(n) = n (n - 1) / 2, exact for n < 2^32.
inline std::uint64_t number_of_pairs(std::uint64_t n)
{
  return n == 0 ? 0 : n * (n - 1) / 2;
}

/// Exact integers up to the one division: every sum is at most 2 C(F) < 2^64.
inline double rand_index_distance(const Partition& a, const Partition& b)
{
  if (a.size() < 2)
    return 0;
  const Contingency_table table(a, b, [](std::size_t) { return 0.; });
  std::uint64_t only_in_one = 0;
  for (const auto* segments : {&table.rows, &table.columns})
    for (const Face_total& segment : *segments)
      only_in_one += number_of_pairs(segment.count);
  for (const Contingency_table::Cell& cell : table.cells)
    only_in_one -= 2 * number_of_pairs(cell.total.count);
  return double(only_in_one) / double(number_of_pairs(a.size()));
}

} // namespace internal

/// \ingroup PkgRegionSegmentationEvaluation
/// computes the Rand index *distance* 1 - RI of two segmentations: the fraction of all pairs of
/// faces that share a segment in one of them, but not in the other.
///
/// \f[ 1 - RI = \frac{\sum_i C(n_{i.}) + \sum_j C(n_{.j}) - 2 \sum_{ij} C(n_{ij})}{C(F)},
///     \quad C(n) = n (n - 1) / 2 \f]
///
/// where \f$n_{ij}\f$ is the number of faces with label i in the first and label j in the second
/// map, \f$n_{i.}\f$ and \f$n_{.j}\f$ are its sums, and F is the number of faces. Faces are
/// counted, not weighted by area.
///
/// The range is [0, 1]: 0 if and only if the segments are the same, 1 if and only if one map has a
/// single segment and the other a segment for each face (and F > 1). Symmetric, to the bit. A mesh
/// with no face or one has no pair: 0.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam FaceLabelMapA a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam FaceLabelMapB the same
/// \param mesh a mesh, of faces of any size
/// \param a the first segmentation; labels may be sparse or negative
/// \param b the second one; its labels need not be those of `a`
///
/// \returns 1 - RI
/// \pre the mesh has fewer than 2^32 - 1 faces
///
/// Complexity: O(F) expected time (labels are hashed) and O(F) memory, for any number of segments.
/// The sums are exact integers, so the value of the formula is rounded once. Deterministic.
/// Read-only; concurrent calls are safe if reading the maps is.
///
/// \note The evaluator of the Princeton benchmark halves F - 1 as an integer and so prints values
/// larger by the factor ((F - 1) / 2) / floor((F - 1) / 2) where F is even. This function does not.
///
/// Source: \cgalCite{CGF09}, \cgalCite{R71}.
template <typename FaceGraph, typename FaceLabelMapA, typename FaceLabelMapB>
double rand_index_distance(const FaceGraph& mesh, const FaceLabelMapA& a, const FaceLabelMapB& b)
{
  return internal::rand_index_distance(internal::read_face_labels(mesh, a),
                                       internal::read_face_labels(mesh, b));
}

/// \ingroup PkgRegionSegmentationEvaluation
/// computes the Rand index distance 1 - RI of two labelings that are given as ranges, one label for
/// each face in the same order: no mesh is needed.
///
/// \tparam LabelRangeA a range of forward iterators with an integral value type of at most 64 bits
/// \tparam LabelRangeB the same
///
/// \throws Invalid_input if the ranges differ in length
///
/// Otherwise as for property maps.
template <typename LabelRangeA, typename LabelRangeB>
double rand_index_distance(const LabelRangeA& a, const LabelRangeB& b)
{
  const Partition labels_a = Partition::from_labels(a);
  const Partition labels_b = Partition::from_labels(b);
  if (labels_a.size() != labels_b.size())
    throw Invalid_input("two labelings have " + std::to_string(labels_a.size()) + " and " +
                        std::to_string(labels_b.size()) + " labels");
  return internal::rand_index_distance(labels_a, labels_b);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_RAND_INDEX_DISTANCE_H
