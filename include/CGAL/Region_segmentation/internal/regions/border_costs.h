// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H

#include <CGAL/Region_segmentation/Border_cost.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// The costs of the borders between adjacent patches.
inline Dual_graph border_costs(const Surface& surface, const Patches& patches,
                               const Border_cost& cost, Dual_graph::Across across)
{
  const double unit = surface.length_unit();
  return Dual_graph(patches, across, [&](const Patches::Adjacency& a, double deviation) {
    return cost(a.length / unit, deviation);
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H
