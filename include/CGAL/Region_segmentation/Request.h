// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_REQUEST_H
#define CGAL_REGION_SEGMENTATION_REQUEST_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/number_labels.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// The seeds of faces or regions: elements with the same seed belong to one segment, elements with
/// different seeds to different ones.
struct Seeds
{
  using Index = Partition::Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::vector<Index> of;           ///< by element: 0 .. number() - 1, or none
  std::vector<std::size_t> values; ///< of the user's map, by seed

  std::size_t number() const { return values.size(); }
  bool empty() const { return values.empty(); }

  /// From the values of a map; -1 of their type stands for none.
  template <typename Value>
  static Seeds from_values(const std::vector<Value>& values)
  {
    Seeds seeds;
    seeds.of = internal::number_labels(values, seeds.values);
    return seeds;
  }
};

/// \ingroup PkgRegionSegmentationData
/// What a user wants of a segmentation, beyond the method.
struct Request
{
  /// The numbers of segments for which labels will be asked.
  enum class Numbers { ALL, ONE };

  std::size_t number_of_segments = 0; ///< 0: chosen by the method
  Numbers numbers = Numbers::ALL; ///< `ONE`: a method may leave out what only other numbers need
  Seeds seeds;                    ///< of the faces
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_REQUEST_H
