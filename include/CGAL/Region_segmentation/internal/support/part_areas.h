// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_PART_AREAS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_PART_AREAS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// By part of the faces: the sum of their areas, in their order.
inline std::vector<double> part_areas(const Surface& surface, const Partition& parts)
{
  std::vector<double> areas(parts.number_of_parts());
  for (std::size_t f = 0; f < parts.size(); ++f)
    areas[parts[f]] += surface.area(f);
  return areas;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_PART_AREAS_H
