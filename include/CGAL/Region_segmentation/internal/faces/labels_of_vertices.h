// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_LABELS_OF_VERTICES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_LABELS_OF_VERTICES_H

#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The pairs of labels and vertices of their faces, each once, in order.
template <typename Labels>
std::vector<std::pair<Surface::Index, Surface::Index>> labels_of_vertices(const Surface& surface,
                                                                          const Labels& labels)
{
  std::vector<std::pair<Surface::Index, Surface::Index>> pairs;
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
      pairs.push_back({Surface::Index(labels[f]), surface.corner(f, i)});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_LABELS_OF_VERTICES_H
