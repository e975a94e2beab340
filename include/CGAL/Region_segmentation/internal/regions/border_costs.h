// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H

#include <CGAL/Region_segmentation/Border_cost.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>

#include <CGAL/number_type_config.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// The costs of the borders between adjacent patches across edges.
inline Dual_graph border_costs_of_edges(const Surface& surface, const Patches& patches,
                                        const Border_cost& cost)
{
  const double unit = surface.length_unit();
  return Dual_graph(patches, [&](std::size_t i) {
    return cost(patches.adjacencies()[i].length / unit, patches.concave_deviation(i));
  });
}

/// The same, and across seams and links, where there is a valley.
inline Dual_graph border_costs(const Surface& surface, const Patches& patches,
                               const Border_cost& cost)
{
  const double unit = surface.length_unit();
  return Dual_graph(
    patches,
    [&](std::size_t i) {
      return cost(patches.adjacencies()[i].length / unit, patches.concave_deviation(i));
    },
    [&](const Patches::Adjacency& contact) { return cost(contact.length / unit, CGAL_PI / 2); });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H
