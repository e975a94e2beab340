// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_HAMMING_DISTANCE_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_HAMMING_DISTANCE_H

#include <CGAL/Region_segmentation/internal/measures/Contingency_table.h>
#include <CGAL/Region_segmentation/internal/support/read_face_labels.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationEvaluation
/// What `hamming_distance()` returns: parts of the area, in [0, 1).
struct Hamming_distance
{
  /// The mean of the two rates.
  double distance = 0;
  /// Area of the truth's segments that their best matches miss.
  double missing_rate = 0;
  /// Area of the result's segments outside of their best matches.
  double false_alarm_rate = 0;
};

namespace internal {

/// sum_i (a_i. - max_j a_ij) / sum_i a_i. : no term is negative.
inline double unmatched_part(const std::vector<Face_total>& segments,
                             const std::vector<double>& largest_cell)
{
  double unmatched = 0, total = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    unmatched += segments[i].area - largest_cell[i];
    total += segments[i].area;
  }
  return total > 0 ? unmatched / total : 0;
}

inline Hamming_distance hamming_distance(const Contingency_table& table)
{
  std::vector<double> largest_in_row(table.rows.size()), largest_in_column(table.columns.size());
  for (const auto& [row, column, total] : table.cells) {
    largest_in_row[row] = (std::max)(largest_in_row[row], total.area);
    largest_in_column[column] = (std::max)(largest_in_column[column], total.area);
  }
  Hamming_distance result;
  result.missing_rate = unmatched_part(table.columns, largest_in_column);
  result.false_alarm_rate = unmatched_part(table.rows, largest_in_row);
  result.distance = (result.missing_rate + result.false_alarm_rate) / 2;
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationEvaluation
/// computes the Hamming distance of two segmentations: the part of the area that remains uncovered
/// when every segment of one is matched with the segment of the other that covers most of it.
///
/// \f[ R_m = 1 - \frac{1}{A} \sum_j \max_i a_{ij}, \quad
///     R_f = 1 - \frac{1}{A} \sum_i \max_j a_{ij}, \quad
///     \mathit{distance} = (R_m + R_f) / 2 \f]
///
/// where \f$a_{ij}\f$ is the area of the faces with label i in `a` and label j in `b`, and A that
/// of all faces. With a result as `a` and the truth as `b`, \f$R_m\f$ is the *missing rate* (high
/// for a result too fine) and \f$R_f\f$ the *false alarm rate* (high for a result too coarse).
///
/// All are in [0, 1), and 0 if the segments are the same. The false alarm rate alone is 0 if `a` is
/// a refinement of `b`, the missing rate if `b` is one of `a`. The distance is symmetric to the
/// bit; the rates swap with the arguments. A mesh without faces or without area: 0.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceLabelMapA a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam FaceLabelMapB the same
/// \param mesh a mesh, with or without boundary, of faces of any size; the area of a face that is
///        not planar is the length of its area vector (Newell)
/// \param a the first segmentation, e.g. the result; labels may be sparse or negative
/// \param b the second one, e.g. the truth; its labels need not be those of `a`
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the distance, and the two rates whose mean it is
/// \pre the mesh has fewer than 2^32 - 1 faces
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F) expected time (labels are hashed) and O(F) memory, for any number of segments.
/// Invariant under scaling by powers of two to the bit; areas do not overflow. Deterministic: sums
/// run in the order of the faces. Read-only; concurrent calls are safe if reading the maps is.
///
/// Source: \cgalCite{CGF09}, \cgalCite{HD95}.
template <typename FaceGraph, typename FaceLabelMapA, typename FaceLabelMapB,
          typename NamedParameters = parameters::Default_named_parameters>
Hamming_distance hamming_distance(const FaceGraph& mesh, const FaceLabelMapA& a,
                                  const FaceLabelMapB& b,
                                  const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const Surface flat = internal::make_surface_of_neighbors(mesh, pack);
  const internal::Contingency_table table(internal::read_face_labels(mesh, a),
                                          internal::read_face_labels(mesh, b),
                                          [&](std::size_t f) { return flat.area(f); });
  return internal::hamming_distance(table);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_HAMMING_DISTANCE_H
