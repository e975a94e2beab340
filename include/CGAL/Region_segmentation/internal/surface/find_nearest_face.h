// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NEAREST_FACE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NEAREST_FACE_H

#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A face, and what it costs: its distance, or more.
using Cost_of_face = std::pair<double, Surface::Index>;

/// Searches for a face of the least cost, of several the lowest, if it is less than `best`, below a
/// node: depth first, the nearer child first.
///
/// `enters(node)`: whether the faces of a node count; `added_cost(face)`: what is added to the
/// distance, at least 0
template <typename Enters, typename AddedCost>
void find_nearest_face(Component_tree& tree, Component_tree::Index node, const Double_3& point,
                       const Enters& enters, const AddedCost& added_cost, Cost_of_face& best)
{
  if (!enters(tree[node]))
    return;
  if (tree.is_leaf(node)) {
    for (Component_tree::Index i = tree[node].begin; i < tree[node].end; ++i) {
      const auto& part = tree.part(i);
      const double distance = std::sqrt(squared_distance(point, tree.triangle(part)));
      best = (std::min)(best, Cost_of_face(distance + added_cost(part.face), part.face));
    }
    return;
  }
  const auto gap = [&](Component_tree::Index n) {
    return squared_gap(tree[n].box, box_of(std::array{point}));
  };
  Component_tree::Index nearer = tree.children(node), farther = nearer + 1;
  double nearer_gap = gap(nearer), farther_gap = gap(farther);
  if (farther_gap < nearer_gap) {
    std::swap(nearer, farther);
    std::swap(nearer_gap, farther_gap);
  }
  if (nearer_gap <= best.first * best.first)
    find_nearest_face(tree, nearer, point, enters, added_cost, best);
  if (farther_gap <= best.first * best.first)
    find_nearest_face(tree, farther, point, enters, added_cost, best);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_NEAREST_FACE_H
