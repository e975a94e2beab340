// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/mark_feature_edges.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>
#include <CGAL/Region_segmentation/internal/surface/collect_adjacencies.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The connected components of the faces across edges that are neither features nor constrained. A
/// degenerate face joins the component across its longest edge that is not constrained.
inline Partition grow(const Surface& surface, const Edge_marks& is_feature,
                      const Constraints& constraints, const Execution& execution)
{
  // The longest edges that are not constrained: where none is, the adjacencies that join.
  std::vector<Surface::Index> joining;
  if (!constraints.empty())
    joining = longest_edges_of_degenerate_faces(surface, [&](std::size_t a) {
      return surface.has_flag(a, Surface::CLOSED | Surface::JOINING) && !constraints[a];
    });
  const auto joins = [&](std::size_t a) {
    if (is_feature[a] || constraints[a] || surface.has_flag(a, Surface::SEAM | Surface::LINK))
      return false;
    return !surface.has_flag(a, Surface::CLOSED) ||
           std::binary_search(joining.begin(), joining.end(), a);
  };
  return label_components(surface, joins, execution);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H
