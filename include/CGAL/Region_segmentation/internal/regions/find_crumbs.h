// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FIND_CRUMBS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FIND_CRUMBS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Components of less than this share of the area of the largest one are crumbs.
inline constexpr double area_of_crumbs = 1e-3;

/// The components across edges, and which of them are crumbs.
struct Bodies
{
  Partition component_of; // of the faces
  std::vector<double> areas;
  double area_of_largest = 0;

  explicit Bodies(const Surface& surface)
    : component_of(edge_components(surface, Execution())), areas(component_of.number_of_parts())
  {
    for (std::size_t f = 0; f < component_of.size(); ++f)
      areas[component_of[f]] += surface.area(f);
    for (const double area : areas)
      area_of_largest = (std::max)(area_of_largest, area);
  }

  bool is_crumb(std::size_t component) const { return areas[component] < area_of_crumbs * area_of_largest; }
  /// Those that are no crumbs.
  std::size_t number() const
  {
    std::size_t result = 0;
    for (std::size_t c = 0; c < areas.size(); ++c)
      result += !is_crumb(c);
    return result;
  }
};

/// The pairs of regions to be merged first: those that unite a crumb, then that across which it joins another component, by the
/// longest contact, of equal ones to the nearest face; smallest crumbs first.
inline std::vector<std::pair<Partition::Index, Partition::Index>> merges_of_crumbs(const Surface& surface,
                                                                                   const Partition& regions)
{
  using Index = Partition::Index;
  std::vector<std::pair<Index, Index>> result;
  if (!surface.has_seams_or_links())
    return result;
  const Bodies bodies(surface);
  struct Pair
  {
    Index crumb;
    bool leads_outside;
    double length, distance;
    Index region, other;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Index f = surface.lower_face(a), g = surface.higher_face(a);
    const Index c = bodies.component_of[f], d = bodies.component_of[g];
    if (regions[f] == regions[g] || !(bodies.is_crumb(c) || bodies.is_crumb(d)))
      continue;
    const double length = surface.length(a), distance = norm(surface.centroid(f) - surface.centroid(g));
    if (bodies.is_crumb(c))
      pairs.push_back({c, c != d, length, distance, regions[f], regions[g]});
    if (bodies.is_crumb(d) && c != d)
      pairs.push_back({d, true, length, distance, regions[g], regions[f]});
  }
  const auto key = [&](const Pair& p) {
    return std::make_tuple(bodies.areas[p.crumb], p.crumb, p.leads_outside, -p.length, p.distance, p.region, p.other);
  };
  std::sort(pairs.begin(), pairs.end(), [&](const Pair& p, const Pair& q) { return key(p) < key(q); });
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool is_first_outside =
      i == 0 || pairs[i].crumb != pairs[i - 1].crumb || !pairs[i - 1].leads_outside;
    if (!pairs[i].leads_outside || is_first_outside)
      result.push_back({pairs[i].region, pairs[i].other});
  }
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_FIND_CRUMBS_H
