// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_RANGE_H
#define CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_RANGE_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/internal/is_convex.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// What `Number_from_costs` and `Number_from_expected_costs` have in common. The number is at least
/// `minimum_number`, if the tree has as many regions, and at least the number of pieces that
/// merging leaves: the components, and what closed loops of constrained edges separate. A surface
/// whose components are convex is one segment a component.
struct Number_range
{
  std::size_t maximum_number = 40; ///< of segments, at least `minimum_number`; see
                                   ///< `largest_number()`
  std::size_t minimum_number = 2;  ///< of segments, at least 1
  /// How much finer the segmentation is than usual, more than 0: with 1 as usual, with 2 finer,
  /// with 0.5 coarser. A larger granularity never gives a smaller number.
  double granularity = 1;

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("minimum_number", double(minimum_number), 1);
    internal::check_constant("maximum_number", double(maximum_number), double(minimum_number));
    internal::check_constant("granularity", granularity, internal::least_positive);
  }

  /// The largest number that is chosen for a tree: `maximum_number`, or the number of pieces if
  /// there are more, and at most the number of first regions. Where this number was chosen, there
  /// may be more parts.
  std::size_t largest_number(const Merge_tree& tree) const
  {
    return (std::min)(tree.number_of_regions(), (std::max)(maximum_number, number_of_pieces(tree)));
  }

protected:
  static std::size_t number_of_pieces(const Merge_tree& tree)
  {
    return tree.number_of_regions() - tree.merges().size();
  }

  /// The least and the largest number to choose from.
  std::pair<std::size_t, std::size_t> range(const Merge_tree& tree, const Surface& mesh) const
  {
    const std::size_t pieces = number_of_pieces(tree);
    if (internal::is_convex(mesh)) {
      std::size_t number = pieces;
      if (mesh.has_seams_or_links()) // which join components to one piece
        number += mesh.number_of_components() - mesh.number_of_crumbs() -
                  internal::label_components(
                    mesh, [](std::size_t) { return true; }, Execution())
                    .number_of_parts();
      number = (std::min)(number, tree.number_of_regions());
      return {number, number};
    }
    const std::size_t least = (std::max)((std::min)(tree.number_of_regions(), minimum_number),
                                         pieces);
    return {least, (std::max)(least, largest_number(tree))};
  }

  /// The cost of the merge after which there is one region less than `number`.
  static double cost_of_merge(const Merge_tree& tree, std::size_t number)
  {
    return tree.merges()[tree.number_of_regions() - number].cost;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_RANGE_H
