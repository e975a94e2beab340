// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/grid.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The costs of the borders between adjacent patches: l / (sqrt(A) (1 + g min(delta, m))), l the length, A the area of
/// the surface, g `concave_gain`, delta the deviation if the patches face each other, else 0, m `maximum_deviation`; multiples of 2^-24.
inline Dual_graph border_costs(const Flat_mesh& mesh, const Patches& patches, double concave_gain,
                               double maximum_deviation)
{
  return Dual_graph(patches, [&](std::size_t i) {
    const double concavity = (std::min)(patches.concave_deviation(i), maximum_deviation);
    return on_grid(16 * patches.adjacencies()[i].length / mesh.relative_unit() / (1 + concave_gain * concavity)) / 16;
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_COSTS_H
