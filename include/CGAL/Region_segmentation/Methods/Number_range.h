// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_NUMBER_RANGE_H
#define CGAL_REGION_SEGMENTATION_METHODS_NUMBER_RANGE_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/label_components.h>
#include <CGAL/Region_segmentation/internal/surface/find_crumbs.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The numbers of segments among which `Number_from_costs` and `Number_from_expected_costs` choose:
/// at least `minimum_number`, if the tree has as many, and at least the number of connected
/// components, where components also are what constrained edges separate: a drawn loop adds one. A
/// surface that is convex is one segment a component, where the chooser sees the mesh.
class Number_range
{
public:
  std::size_t maximum_number; ///< of segments, at least `minimum_number`; see `largest_number()`
  std::size_t minimum_number = 2; ///< of segments, at least 1

  explicit Number_range(std::size_t maximum_number_)
    : maximum_number(maximum_number_)
  {}

  /// The largest number that is chosen for a tree: `maximum_number`, or the number of connected
  /// components if there are more, and at most the number of first regions. Where this number was
  /// chosen, there may be more parts.
  std::size_t largest_number(const Merge_tree& tree) const
  {
    return (std::min)(tree.number_of_regions(), (std::max)(maximum_number, number_of_pieces(tree)));
  }

protected:
  std::size_t least_number(const Merge_tree& tree) const
  {
    return (std::max)((std::min)(tree.number_of_regions(), minimum_number), number_of_pieces(tree));
  }

  /// That merging leaves.
  static std::size_t number_of_pieces(const Merge_tree& tree)
  {
    return tree.number_of_regions() - tree.merges().size();
  }

  /// The number of components, which are convex, and as many more as constrained edges keep apart.
  static std::size_t number_of_convex(const Merge_tree& tree, const Surface& mesh)
  {
    if (!mesh.has_seams_or_links())
      return number_of_pieces(tree);
    const Partition connected = internal::label_components(
      mesh, [](std::size_t) { return true; }, Execution());
    return internal::Bodies(mesh).number() + number_of_pieces(tree) - connected.number_of_parts();
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_NUMBER_RANGE_H
