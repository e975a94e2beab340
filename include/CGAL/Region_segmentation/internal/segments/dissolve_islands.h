// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISSOLVE_ISLANDS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISSOLVE_ISLANDS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>
#include <CGAL/Region_segmentation/internal/support/part_areas.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The components of faces with equal labels.
inline Partition components_of_labels(const Surface& surface,
                                      const std::vector<Surface::Index>& label_of_face)
{
  return label_components(
    surface,
    [&](std::size_t a) {
      return label_of_face[surface.lower_face(a)] == label_of_face[surface.higher_face(a)];
    },
    Execution());
}

/// Which components are islands: all but the largest ones of their label, `numbers[label]` of them,
/// if smaller than a tenth of the largest one. Of equal ones the first are the largest.
inline std::vector<char> find_islands(const std::vector<Surface::Index>& label_of_component,
                                      const std::vector<double>& areas,
                                      const std::map<Surface::Index, std::size_t>& numbers)
{
  std::vector<std::size_t> by_size(areas.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t(0));
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  std::map<Surface::Index, std::pair<std::size_t, double>> seen; // number, largest area
  std::vector<char> is_island(areas.size(), false);
  for (std::size_t c : by_size) {
    auto& [rank,
           largest] = seen.emplace(label_of_component[c], std::pair(0, areas[c])).first->second;
    is_island[c] = rank++ >= numbers.at(label_of_component[c]) && areas[c] < 0.1 * largest;
  }
  return is_island;
}

/// Gives the faces of islands the label with which they share the longest border, from outside to
/// inside; those without a neighbor keep theirs.
/// `numbers`: how many components of each label are expected, see `find_islands()`
inline void dissolve_islands(const Surface& surface,
                             const std::map<Surface::Index, std::size_t>& numbers,
                             std::vector<Surface::Index>& label_of_face)
{
  using Index = Surface::Index;
  const Partition components = components_of_labels(surface, label_of_face);
  std::vector<Index> labels(components.number_of_parts());
  for (Index f = 0; f < components.size(); ++f)
    labels[components[f]] = label_of_face[f];
  std::vector<char> is_island = find_islands(labels, part_areas(surface, components), numbers);
  bool is_changed = true;
  while (std::exchange(is_changed, false)) {
    std::map<Index, std::map<Index, double>> lengths; // of islands with labels around them
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const Index f = components[surface.lower_face(a)], g = components[surface.higher_face(a)];
      if (is_island[f] != is_island[g])
        lengths[is_island[f] ? f : g][labels[is_island[f] ? g : f]] += surface.length(a);
    }
    for (const auto& [island, of_labels] : lengths) {
      labels[island] = std::max_element(
                         of_labels.begin(), of_labels.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; })
                         ->first;
      is_island[island] = false;
      is_changed = true;
    }
  }
  for (Index f = 0; f < components.size(); ++f)
    label_of_face[f] = labels[components[f]];
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISSOLVE_ISLANDS_H
