// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_CRUMBS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_CRUMBS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>
#include <CGAL/Region_segmentation/internal/support/part_areas.h>
#include <CGAL/Region_segmentation/internal/support/sorted_indices.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Marks the faces of the components that are crumbs, if there are any.
inline void mark_crumbs(Surface& surface, const Partition& component_of)
{
  constexpr double largest = 1e-3; // share of the area of the largest component
  const std::vector<double> areas = part_areas(surface, component_of);
  const auto bounds = std::minmax_element(areas.begin(), areas.end());
  const double bound = largest * *bounds.second;
  if (*bounds.first < bound)
    for (const Partition::Index component : component_of)
      arrays_of(surface).is_crumb.push_back(areas[component] < bound);
}

/// The components across edges, and which of them are crumbs.
struct Bodies
{
  Partition component_of; // of the faces
  std::vector<double> areas;
  std::vector<bool> is_crumb;

  explicit Bodies(const Surface& surface)
    : component_of(edge_components(surface, Execution()))
    , areas(part_areas(surface, component_of))
    , is_crumb(areas.size(), true)
  {
    for (std::size_t f = 0; f < component_of.size(); ++f)
      if (!surface.is_crumb(f))
        is_crumb[component_of[f]] = false;
  }

  /// Of those that are no crumbs.
  std::size_t number() const
  {
    return std::size_t(std::count(is_crumb.begin(), is_crumb.end(), false));
  }
};

/// The pairs of regions to be merged first, so that each crumb is one region and joins another
/// component: that with the longest contact, of equal ones the nearest; smallest crumbs first.
/// Crumbs that join each other go on until they reach a component that is none.
inline std::vector<std::pair<Partition::Index, Partition::Index>>
merges_of_crumbs(const Surface& surface, const Partition& regions)
{
  using Index = Partition::Index;
  std::vector<std::pair<Index, Index>> result;
  if (!surface.has_seams_or_links())
    return result;
  const Bodies bodies(surface);
  // Out of crumbs, in the order to be taken: area of the crumb, crumb, -length, distance, the two
  // regions, the component.
  std::vector<std::tuple<double, Index, double, double, Index, Index, Index>> ways;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Index f = surface.lower_face(a), g = surface.higher_face(a);
    const Index c = bodies.component_of[f], d = bodies.component_of[g];
    if (c == d && regions[f] != regions[g] && bodies.is_crumb[c])
      result.push_back({regions[f], regions[g]});
    if (c == d || !(bodies.is_crumb[c] || bodies.is_crumb[d]))
      continue;
    const double length = surface.length(a),
                 distance = norm(surface.centroid(f) - surface.centroid(g));
    if (bodies.is_crumb[c])
      ways.push_back({bodies.areas[c], c, -length, distance, regions[f], regions[g], d});
    if (bodies.is_crumb[d])
      ways.push_back({bodies.areas[d], d, -length, distance, regions[g], regions[f], c});
  }
  const auto order = sorted_indices(ways.size(),
                                    [&](Index i, Index j) { return ways[i] < ways[j]; });

  Lowest_root_forest joined(bodies.areas.size());
  std::vector<bool> has_arrived(bodies.areas.size()); // by root: one of its components is no crumb
  for (std::size_t c = 0; c < has_arrived.size(); ++c)
    has_arrived[c] = !bodies.is_crumb[c];
  for (bool is_any = true; std::exchange(is_any, false);)
    for (const Index way : order) {
      const auto& [area, crumb, length, distance, region, other, component] = ways[way];
      const Index from = joined.root(crumb), to = joined.root(component);
      if (from == to || has_arrived[from])
        continue;
      const bool arrives = has_arrived[to];
      joined.unite(from, to);
      has_arrived[joined.root(from)] = arrives;
      result.push_back({region, other});
      is_any = true;
    }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_CRUMBS_H
