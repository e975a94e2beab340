// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NAMED_DATA_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NAMED_DATA_H

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The types `RegionData` and `SectionData` of a cost or a policy; empty if it does not name them.
template <typename T, typename = void>
struct Data_named_by
{};

template <typename T>
struct Data_named_by<T, std::void_t<typename T::RegionData, typename T::SectionData>>
{
  using RegionData = typename T::RegionData;
  using SectionData = typename T::SectionData;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_NAMED_DATA_H
