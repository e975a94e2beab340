// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_OVERLAP_MEASURES_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_OVERLAP_MEASURES_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
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

/// The number and the area of a set of faces.
struct Face_total
{
  std::uint64_t count = 0;
  double area = 0;

  void add(double face_area)
  {
    ++count;
    area += face_area;
  }
};

/// The table of two partitions of the faces: n_ij faces, of area a_ij, are in part i of the first
/// and part j of the second; n_i. and a_i. are the totals of row i, n_.j and a_.j of column j.
///
/// Areas are added by faces in order everywhere. Rounding is monotone, so a cell is never above its
/// row or its column, and equal to it where it has all of its faces: a_i. - a_ij is never negative,
/// and 0 where it should be.
struct Contingency_table
{
  struct Cell
  {
    Partition::Index row, column;
    Face_total total;
  };
  std::vector<Face_total> rows, columns;
  std::vector<Cell> cells; // those that are not empty, by their first faces

  /// `area(face)`: of each face. O(F) time and memory.
  template <typename Area>
  Contingency_table(const Partition& a, const Partition& b, const Area& area)
    : rows(a.number_of_parts())
    , columns(b.number_of_parts())
  {
    Key_numbering number(2 * a.size() + 1024);
    for (std::size_t f = 0; f < a.size(); ++f) {
      const std::size_t cell = number(a[f] * std::uint64_t(columns.size()) + b[f]);
      if (cell == cells.size())
        cells.push_back({a[f], b[f], {}});
      for (Face_total* total : {&rows[a[f]], &columns[b[f]], &cells[cell].total})
        total->add(area(f));
    }
  }
};

/// The table of two property maps of the labels of faces, with the areas of the faces.
template <typename FaceGraph, typename FaceLabelMapA, typename FaceLabelMapB,
          typename NamedParameters>
Contingency_table table_of_areas(const FaceGraph& mesh, const FaceLabelMapA& a,
                                 const FaceLabelMapB& b, const NamedParameters& np)
{
  const auto& pack = internal::pack(np);
  check_parameters<std::decay_t<decltype(pack)>, Tag_list<>>();
  const Surface surface = surface_as_given(mesh, pack);
  return {read_face_labels(mesh, a), read_face_labels(mesh, b),
          [&](std::size_t f) { return surface.area(f); }};
}

/// C(n) = n (n - 1) / 2, exact for n < 2^32.
inline std::uint64_t number_of_pairs(std::uint64_t n)
{
  return n == 0 ? 0 : n * (n - 1) / 2;
}

/// All sums are exact integers, since they are at most 2 C(F) < 2^64; one division follows.
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

/// sum_i (a_i. - max_j a_ij) / sum_i a_i., in which no term is negative.
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

/// Sets GCE and LCE, with `size(Face_total)` as the size of a set of faces in the errors.
template <typename Size>
void set_refinement_errors(const Contingency_table& table, const Size& size, double& global,
                           double& local)
{
  // 1 - part / whole, without rounding where it is 0; 0 for a whole without area.
  const auto error = [](double part, double whole) {
    return whole > 0 ? (whole - part) / whole : 0;
  };
  double a_in_b = 0, b_in_a = 0, smaller = 0, faces = 0;
  for (const auto& [i, j, cell] : table.cells) {
    const double n = double(cell.count), error_ab = error(size(cell), size(table.rows[i])),
                 error_ba = error(size(cell), size(table.columns[j]));
    faces += n;
    a_in_b += n * error_ab;
    b_in_a += n * error_ba;
    smaller += n * (std::min)(error_ab, error_ba);
  }
  global = faces > 0 ? (std::min)(a_in_b, b_in_a) / faces : 0;
  local = faces > 0 ? smaller / faces : 0;
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
/// The value is that for property maps with these labels.
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
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
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
  return internal::hamming_distance(internal::table_of_areas(mesh, a, b, np));
}

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
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
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
  const internal::Contingency_table table = internal::table_of_areas(mesh, a, b, np);
  Consistency_error result;
  internal::set_refinement_errors(
    table, [](const auto& total) { return double(total.count); }, result.global, result.local);
  internal::set_refinement_errors(
    table, [](const auto& total) { return total.area; }, result.global_by_area,
    result.local_by_area);
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_OVERLAP_MEASURES_H
