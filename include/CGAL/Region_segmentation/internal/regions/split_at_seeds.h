// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_SEEDS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_SEEDS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/divide_parts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The regions with faces of several seeds.
inline std::vector<std::uint8_t> regions_of_several_seeds(const Partition& regions,
                                                          const Seeds& seeds)
{
  std::vector<Seeds::Index> seed_of(regions.number_of_parts(), Seeds::none);
  std::vector<std::uint8_t> has_several(regions.number_of_parts());
  for (std::size_t f = 0; f < regions.size(); ++f) {
    if (seeds.of[f] == Seeds::none)
      continue;
    Seeds::Index& seed = seed_of[regions[f]];
    if (seed == Seeds::none)
      seed = seeds.of[f];
    has_several[regions[f]] |= seed != seeds.of[f];
  }
  return has_several;
}

/// Splits those regions that have faces of several seeds: a face is assigned to the seed from which
/// the fewest edges have to be crossed, of several to the one that is reached first from the lower
/// faces; constrained edges are not crossed. Each connected component becomes a region. O(F).
inline Partition split_at_seeds(const Surface& surface, const Partition& regions,
                                const Seeds& seeds, const Constraints& constraints)
{
  using Index = Partition::Index;
  const auto is_split = regions_of_several_seeds(regions, seeds);
  if (std::find(is_split.begin(), is_split.end(), 1) == is_split.end())
    return regions;

  const auto adjacencies = adjacencies_of_parts(surface, regions, is_split);
  const Grouped_items<Index> neighbors(regions.size(), [&](const auto& add) {
    for (const Index a : adjacencies) {
      const Index f = surface.lower_face(a), g = surface.higher_face(a);
      if (regions[f] == regions[g] && !constraints[a]) {
        add(f, g);
        add(g, f);
      }
    }
  });

  std::vector<Index> seed_of = seeds.of, front;
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (is_split[regions[f]] && seed_of[f] != Seeds::none)
      front.push_back(Index(f));
  for (std::size_t i = 0; i < front.size(); ++i)
    for (const Index f : neighbors[front[i]])
      if (seed_of[f] == Seeds::none) {
        seed_of[f] = seed_of[front[i]];
        front.push_back(f);
      }

  return divide_parts(surface, regions, is_split, adjacencies, [&](std::size_t a) {
    return !constraints[a] && seed_of[surface.lower_face(a)] == seed_of[surface.higher_face(a)];
  });
}

/// The seeds of regions, each of which has faces of one seed at most.
inline Seeds seeds_of_regions(const Partition& regions, const Seeds& of_faces)
{
  Seeds result{std::vector<Seeds::Index>(regions.number_of_parts(), Seeds::Index(Seeds::none)),
               of_faces.values};
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (of_faces.of[f] != Seeds::none)
      result.of[regions[f]] = of_faces.of[f];
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_SEEDS_H
