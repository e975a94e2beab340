// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_CONSISTENCY_ERROR_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_CONSISTENCY_ERROR_H

#include <CGAL/Region_segmentation/internal/measures/Contingency_table.h>
#include <CGAL/Region_segmentation/internal/support/read_face_labels.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationEvaluation
/// What `consistency_error()` returns: means over the faces, in [0, 1), with `local <= global`.
struct Consistency_error
{
  /// GCE: all faces refine in one direction. By number of faces.
  double global = 0;
  /// LCE: each face refines in the direction that suits it. By number of faces.
  double local = 0;
  /// GCE with the areas of segments in place of their numbers of faces.
  double global_by_area = 0;
  /// LCE with the areas of segments in place of their numbers of faces.
  double local_by_area = 0;
};

namespace internal {

/// The sums of refinement errors over the faces, in both directions and in the better of the two.
struct Refinement_error_sums
{
  double a_in_b = 0, b_in_a = 0, better = 0;

  void add(double weight, double error_ab, double error_ba)
  {
    a_in_b += weight * error_ab;
    b_in_a += weight * error_ba;
    better += weight * (std::min)(error_ab, error_ba);
  }
  double global() const { return (std::min)(a_in_b, b_in_a); }
  double local() const { return better; }
};

/// 1 - part / whole, without rounding where it is 0; 0 for a whole without area.
inline double refinement_error(double part, double whole)
{
  return whole > 0 ? (whole - part) / whole : 0;
}

inline Consistency_error consistency_error(const Contingency_table& table, double number_of_faces)
{
  Refinement_error_sums by_count, by_area;
  for (const auto& [i, j, cell] : table.cells) {
    const Face_total &row = table.rows[i], &column = table.columns[j];
    const double n = double(cell.count);
    by_count.add(n, refinement_error(n, double(row.count)),
                 refinement_error(n, double(column.count)));
    by_area.add(n, refinement_error(cell.area, row.area), refinement_error(cell.area, column.area));
  }
  Consistency_error result;
  result.global = by_count.global() / number_of_faces;
  result.local = by_count.local() / number_of_faces;
  result.global_by_area = by_area.global() / number_of_faces;
  result.local_by_area = by_area.local() / number_of_faces;
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationEvaluation
/// computes the consistency error of two segmentations: how far they are from one being a
/// refinement of the other. It tolerates differences of detail.
///
/// A face whose segments are i in `a` and j in `b` has the refinement errors
/// \f$E^{ab}_{ij} = 1 - n_{ij} / n_{i.}\f$ and \f$E^{ba}_{ij} = 1 - n_{ij} / n_{.j}\f$, where
/// \f$n_{ij}\f$ is the number of faces with these labels and \f$n_{i.}\f$, \f$n_{.j}\f$ are its
/// sums. With F the number of faces,
///
/// \f[ GCE = \frac{1}{F} \min\Big(\sum_{ij} n_{ij} E^{ab}_{ij}, \sum_{ij} n_{ij} E^{ba}_{ij}\Big),
///     \quad LCE = \frac{1}{F} \sum_{ij} n_{ij} \min(E^{ab}_{ij}, E^{ba}_{ij}) \f]
///
/// In the versions by area the errors E are made of areas, \f$1 - a_{ij} / a_{i.}\f$ (0 for a
/// segment without area); the weight of a face in the mean stays 1, as in the benchmark's
/// evaluator.
///
/// All are in [0, 1) and LCE <= GCE. GCE is 0 if one segmentation is a refinement of the other: so
/// always when one of them is a single segment, or a segment for each face; such a score is
/// meaningless. LCE is 0 if and only if of any two segments that share a face, one contains the
/// other. Symmetric up to rounding. A mesh without faces: 0.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceLabelMapA a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam FaceLabelMapB the same
/// \param mesh a mesh, with or without boundary, of faces of any size; the area of a face that is
///        not planar is the length of its area vector (Newell)
/// \param a the first segmentation; labels may be sparse or negative
/// \param b the second one; its labels need not be those of `a`
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the global and the local error, by number of faces and by area
/// \pre the mesh has fewer than 2^32 - 1 faces
/// \throws Invalid_input if a point is not finite
///
/// Complexity: O(F) expected time (labels are hashed) and O(F) memory, for any number of segments.
/// Invariant under scaling by powers of two to the bit; areas do not overflow. Deterministic: sums
/// run in an order determined by the faces. Read-only; concurrent calls are safe if reading the
/// maps is.
///
/// Source: \cgalCite{CGF09}, \cgalCite{MFTM01}.
template <typename FaceGraph, typename FaceLabelMapA, typename FaceLabelMapB,
          typename NamedParameters = parameters::Default_named_parameters>
Consistency_error consistency_error(const FaceGraph& mesh, const FaceLabelMapA& a,
                                    const FaceLabelMapB& b,
                                    const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const Surface flat = internal::make_surface_of_neighbors(mesh, pack);
  const internal::Contingency_table table(internal::read_face_labels(mesh, a),
                                          internal::read_face_labels(mesh, b),
                                          [&](std::size_t f) { return flat.area(f); });
  return internal::consistency_error(table,
                                     double((std::max<std::size_t>)(1, flat.number_of_faces())));
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_CONSISTENCY_ERROR_H
