// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_COMPETE_AT_BORDERS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_COMPETE_AT_BORDERS_H

#include <CGAL/Region_segmentation/internal/faces/Face_search.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The label of the surface, of those of a face and its neighbors, from which the face deviates
/// least.
inline Surface::Index nearest_label(const Face_search& search, Surface::Index face)
{
  const Surface::Index own = search.labels[face];
  const auto neighbors = search.neighbors[face];
  if (std::all_of(neighbors.begin(), neighbors.end(),
                  [&](const auto& n) { return search.labels[n.face] == own; }))
    return own;
  Surface::Index best = own;
  double least = own == Face_search::none ? std::numeric_limits<double>::infinity()
                                          : search.test.deviation(search.surfaces[own], face);
  for (const Face_neighbors::Neighbor& n : neighbors) {
    const Surface::Index label = search.labels[n.face];
    if (label == Face_search::none || label == own || label == best ||
        !search.test(search.surfaces[label], face))
      continue;
    const double deviation = search.test.deviation(search.surfaces[label], face);
    if (deviation < 0.9 * least - 1e-3 * search.test.tolerance()) {
      least = deviation;
      best = label;
    }
  }
  return best;
}

/// Faces at borders go to the neighboring surface from which they deviate least.
inline void compete_at_borders(Face_search& search)
{
  constexpr int rounds = 4;
  bool is_changed = true;
  for (int round = 0; round < rounds && is_changed; ++round) {
    is_changed = false;
    for (Surface::Index f = 0; f < search.labels.size(); ++f) {
      const Surface::Index best = nearest_label(search, f);
      is_changed = is_changed || best != search.labels[f];
      search.labels[f] = best;
    }
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_COMPETE_AT_BORDERS_H
