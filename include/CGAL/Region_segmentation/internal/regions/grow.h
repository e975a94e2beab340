// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_GROW_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/mark_feature_edges.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The edges that join degenerate faces with constrained edges: the longest that is not
/// constrained, of equal ones that to the lowest face.
inline std::vector<std::size_t> joining_edges_beside(const Surface& surface,
                                                     const Constraints& constraints)
{
  std::vector<std::size_t> result;
  if (constraints.empty())
    return result;
  std::vector<bool> has_constraint(surface.number_of_faces());
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (constraints[a])
      for (const auto face : {surface.lower_face(a), surface.higher_face(a)})
        has_constraint[face] = surface.is_degenerate(face);
  std::vector<std::tuple<Surface::Index, double, Surface::Index, std::size_t>> candidates;
  const auto add = [&](Surface::Index face, Surface::Index other, std::size_t a) {
    if (has_constraint[face])
      candidates.push_back({face, -surface.squared_length(a), other, a});
  };
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, Surface::CLOSED | Surface::JOINING) && !constraints[a]) {
      add(surface.lower_face(a), surface.higher_face(a), a);
      add(surface.higher_face(a), surface.lower_face(a), a);
    }
  std::sort(candidates.begin(), candidates.end());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (i == 0 || std::get<0>(candidates[i]) != std::get<0>(candidates[i - 1]))
      result.push_back(std::get<3>(candidates[i]));
  std::sort(result.begin(), result.end());
  return result;
}

/// The connected components of the faces across edges that are neither features nor constrained. A
/// degenerate face joins the component across its longest edge that is not constrained.
inline Partition grow(const Surface& surface, const Edge_marks& is_feature,
                      const Constraints& constraints, const Execution& execution)
{
  const std::vector<std::size_t> joining = joining_edges_beside(surface, constraints);
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
