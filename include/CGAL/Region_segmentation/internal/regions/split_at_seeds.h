// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_SEEDS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_SPLIT_AT_SEEDS_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>

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
                                const Seeds& seeds)
{
  using Index = Partition::Index;
  const auto is_split = regions_of_several_seeds(regions, seeds);
  if (std::find(is_split.begin(), is_split.end(), 1) == is_split.end())
    return regions;

  const auto is_inside = [&](std::size_t a) {
    const Index r = regions[surface.lower_face(a)];
    return is_split[r] && r == regions[surface.higher_face(a)] &&
           !surface.has_flag(a, Surface::CONSTRAINED);
  };
  const Grouped_items<Index> neighbors(regions.size(), [&](const auto& add) {
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      if (is_inside(a)) {
        add(surface.lower_face(a), surface.higher_face(a));
        add(surface.higher_face(a), surface.lower_face(a));
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

  const Partition pieces = label_components(
    surface,
    [&](std::size_t a) {
      return is_inside(a) && seed_of[surface.lower_face(a)] == seed_of[surface.higher_face(a)];
    },
    Execution());
  std::vector<std::uint64_t> labels(regions.size());
  for (std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = is_split[regions[f]] ? std::uint64_t(regions.number_of_parts()) + pieces[f]
                                     : regions[f];
  return Partition::from_labels(labels);
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
