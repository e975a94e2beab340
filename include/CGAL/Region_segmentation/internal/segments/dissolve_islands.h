// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISSOLVE_ISLANDS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_DISSOLVE_ISLANDS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/segments/Halfedge_table.h>
#include <CGAL/Region_segmentation/internal/segments/Mesh_geometry.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The components of faces with equal labels, across edges.
inline Partition components_of_labels(const Halfedge_table& mesh,
                                      const std::vector<Halfedge_table::Index>& label_of_face)
{
  Lowest_root_forest forest(mesh.number_of_faces());
  for (Halfedge_table::Index h = 0; h < mesh.size(); ++h)
    if (mesh.opposite[h] != Halfedge_table::none) {
      const auto f = mesh.face[h], g = mesh.face[mesh.opposite[h]];
      if (label_of_face[f] == label_of_face[g])
        forest.unite(f, g);
    }
  return forest.take_partition();
}

/// Which components are islands: all but the largest ones of their label, `numbers[label]` of them,
/// if smaller than a tenth of the largest one. Of equal ones the first are the largest.
inline std::vector<char> find_islands(const std::vector<Halfedge_table::Index>& label_of_component,
                                      const std::vector<double>& areas,
                                      const std::map<Halfedge_table::Index, std::size_t>& numbers)
{
  std::vector<std::size_t> by_size(areas.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t(0));
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  std::map<Halfedge_table::Index, std::pair<std::size_t, double>> seen; // number, largest area
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
inline void dissolve_islands(const Halfedge_table& mesh, const Mesh_geometry& geometry,
                             const std::map<Halfedge_table::Index, std::size_t>& numbers,
                             std::vector<Halfedge_table::Index>& label_of_face)
{
  using Index = Halfedge_table::Index;
  const Partition components = components_of_labels(mesh, label_of_face);
  std::vector<double> areas(components.number_of_parts(), 0);
  std::vector<Index> labels(components.number_of_parts());
  for (Index f = 0; f < components.size(); ++f) {
    areas[components[f]] += geometry.surface().area(f);
    labels[components[f]] = label_of_face[f];
  }
  std::vector<char> is_island = find_islands(labels, areas, numbers);
  bool is_changed = true;
  while (std::exchange(is_changed, false)) {
    std::map<Index, std::map<Index, double>> lengths; // of islands with labels around them
    for (Index h = 0; h < mesh.size(); ++h)
      if (mesh.opposite[h] != mesh.none && is_island[components[mesh.face[h]]]) {
        const Index across = components[mesh.face[mesh.opposite[h]]];
        if (!is_island[across])
          lengths[components[mesh.face[h]]][labels[across]] += geometry.length(h);
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
