// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_KERNEL_OF_POINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_KERNEL_OF_POINTS_H

#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename Kernel>
using Has_points_and_vectors = std::pair<typename Kernel::Point_3, typename Kernel::Vector_3>;

/// The kernel of the points of a map; `Simple_cartesian<double>` if they are not of a kernel.
template <typename PointMap>
using Kernel_of_points = std::conditional_t<
  satisfies<Has_points_and_vectors,
            typename Kernel_traits<typename boost::property_traits<PointMap>::value_type>::Kernel>,
  typename Kernel_traits<typename boost::property_traits<PointMap>::value_type>::Kernel,
  Simple_cartesian<double>>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_KERNEL_OF_POINTS_H
