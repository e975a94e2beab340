// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SHORTEST_PATHS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SHORTEST_PATHS_H

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Dijkstra's algorithm from several sources, for graphs that are known by their steps. Nodes at
/// the same distance are visited by index.
///
/// `distances`: by node; infinite, or a bound: a node is entered below it.
/// `visit(node)`: called for each node that is reached, when its distance is final; returns whether
/// to go on. `for_each_step(node, enter)`: calls `enter(neighbor, length)` for the steps
/// from a node, which returns whether the neighbor became nearer. A length that leads back to a
/// distance of 0 makes a source of a node; it is visited again.
template <typename Index, typename Visit, typename ForEachStep>
void find_shortest_paths(const std::vector<Index>& sources, std::vector<double>& distances,
                         const Visit& visit, const ForEachStep& for_each_step)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
  for (const Index source : sources)
    if (distances[source] > 0) { // so that a source that is given twice is visited once
      distances[source] = 0;
      front.push({0, source});
    }
  while (!front.empty()) {
    const auto [distance, node] = front.top();
    front.pop();
    if (distance > distances[node]) // a shorter path was found later
      continue;
    if (!visit(node))
      return;
    for_each_step(node, [&, from = distance](Index neighbor, double length) {
      const double longer = from + length;
      if (!(longer < distances[neighbor]))
        return false;
      distances[neighbor] = longer;
      front.push({longer, neighbor});
      return true;
    });
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SHORTEST_PATHS_H
