// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_CHOOSERS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_CHOOSERS_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/internal/Region_shapes.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments before the first merge that costs more than a bound. A model of
/// `NumberChooser`, for costs that mean the same on every mesh, such as `Surface_face_cost`.
///
/// Complexity: O(R).
struct Number_below_cost
{
  double bound; ///< in the units of the costs

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Number_below_cost: bound", bound, -internal::greatest_finite);
  }

  std::size_t operator()(const Merge_tree& tree, const Surface&) const
  {
    return tree.number_at_cost(bound);
  }
};

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

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree: merging ends where costs become high, compared
/// with the highest cost of all. A model of `NumberChooser`, for costs on a logarithmic scale such
/// as `Visibility_cost`.
///
/// Let \f$c_k\f$ be the cost of the merge from \f$k\f$ regions to \f$k - 1\f$, \f$c\f$ the highest
/// of these costs from `maximum_number` regions on, and \f$g\f$ the `granularity`. The number is
/// the largest \f$k\f$ in `Number_range` for which \f$c_k > (c + l) / 2 - \ln g\f$, \f$l\f$ the
/// `level`, or the least number of the range if there is none.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected pieces.
struct Number_from_costs : Number_range
{
  double level; ///< in the units of the costs

  explicit Number_from_costs(double level_)
    : level(level_)
  {}

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    Number_range::check_constants();
    internal::check_constant("Number_from_costs: level", level, -internal::greatest_finite);
  }

  std::size_t operator()(const Merge_tree& tree, const Surface& mesh = Surface()) const
  {
    const auto [least, largest] = range(tree, mesh);
    double highest = Merge_tree::least_cost;
    for (std::size_t n = largest; n > number_of_pieces(tree); --n)
      highest = (std::max)(highest, cost_of_merge(tree, n));
    const double threshold = (level + highest) / 2 - std::log(granularity);
    std::size_t number = largest;
    while (number > least && !(cost_of_merge(tree, number) > threshold))
      --number;
    return number;
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// chooses the number of segments from a merge tree whose costs can be added: that at which the sum
/// of the costs, from `maximum_number` regions on, is lowest. A model of `NumberChooser`, for costs
/// that are below 0 where a merge pays, such as `Learned_cost::recorded_cost()`.
///
/// The number is within `Number_range`. Of several such numbers, the largest is taken. Costs above
/// 0, of merges that do not pay, are multiplied by `granularity`.
///
/// Complexity: O(m), m the larger of `maximum_number` and the number of connected pieces.
struct Number_from_expected_costs : Number_range
{
  std::size_t operator()(const Merge_tree& tree, const Surface& mesh = Surface()) const
  {
    const auto [least, largest] = range(tree, mesh);
    std::size_t best = largest;
    double sum = 0, lowest = 0;
    for (std::size_t n = largest; n > least; --n) {
      const double cost = cost_of_merge(tree, n);
      const bool is_of_crumbs = cost == Merge_tree::least_cost;
      if (!is_of_crumbs)
        sum += cost > 0 ? granularity * cost : cost;
      if (sum < lowest || is_of_crumbs) {
        lowest = sum;
        best = n - 1;
      }
    }
    return best;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_NUMBER_CHOOSERS_H
