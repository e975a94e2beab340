// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_BORDER_STRAIGHTENING_H
#define CGAL_REGION_SEGMENTATION_METHODS_BORDER_STRAIGHTENING_H

#include <CGAL/Region_segmentation/Border_cost.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/superfacets/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/superfacets/Nested_borders.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/concept_checks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// moves the borders of the segments of a merge tree to minimum cuts, from the roots of the tree
/// down, so that the segmentations of all numbers stay nested.
///
/// Elements are cells: the patches of the surface; a patch with faces of several regions is divided
/// by them into connected elements. An element is its region's own at first. Merges are undone from
/// the last one on. Each divides a segment into two parts, the kept one and the removed one:
/// -# The own elements of either part's regions belong to it. If they are not connected, those
/// outside of the component
///    of largest area (of equal ones, that with the lowest element) become guests.
/// -# In rounds, guests of the segment that are adjacent to elements of the parts join the part to
/// which their border
///    costs more, of equal ones the kept one. If neither part has own elements, all guests join the
///    kept part. Costs are those of `Border_cost`, rounded to `float`.
/// -# In the last \f$n\f$ merges, the border between the parts moves. Its band contains the
/// elements of both within
///    \f$\min(D_0, q \sqrt{a / A})\f$ of it, \f$a\f$ the area of the smaller part; if that is below
///    \f$10^{-6}\f$, the border stays. Elements at the border have the distance 0, and a step to an
///    adjacent element of the same part has the length \f$|c_i - c_j| / \sqrt{A}\f$. An element of
///    the band that is adjacent to one of its part outside of the band stays. If some stay in
///    either part, elements move to the minimum cut: the sides between which the borders of
///    elements of the band cost least, of several cuts one that moves the fewest elements, and of
///    these that with the fewest elements in the kept part. Costs are rounded to multiples of about
///    \f$2^{-50} N C\f$, \f$N\f$ the number of elements that may move and \f$C\f$ the sum of their
///    costs. Elements outside of the band count with their own part. The move is not made if it
///    disconnects a part. Moved elements become guests.
///
/// A region can lose all elements: then its merge is left out. New regions are what remains of
/// each, numbered by their first face.
///
/// Complexity: O(P + R log R) in practice for P elements and R regions, and the cuts, whose bands
/// contain few elements.
///
/// Source: minimum cuts in a fuzzy band \cgalCite{KT03}; the flow \cgalCite{BK04}.
struct Border_straightening
{
  std::size_t number_of_cuts = 63; ///< n: at most one less than the largest number of segments
                                   ///< whose borders are moved
  double width = 0.03; ///< D_0, at least 0, in units of the square root of the area of the surface
  double width_of_segment = 0.2; ///< q, at least 0: at most this part of the square root of the
                                 ///< smaller area

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Border_straightening: width", width, 0);
    internal::check_constant("Border_straightening: width_of_segment", width_of_segment, 0);
  }

  /// The region of each cell after moving borders, by its former number; or, if
  /// `number_of_segments` is less than the number of regions that are left, the segment of each
  /// cell in that segmentation (or the one nearest to it), named by its lowest region: the other
  /// merges are not undone then.
  ///
  /// `cells`: of the surface; `regions`: of its faces, each a union of cells; `tree`: the merges of
  /// the regions, which are connected; `is_fixed(region)`: whether its faces stay in the segments
  /// of the region, of at most one region of a tree.
  std::vector<Surface::Index> operator()(const Surface& surface, const Patches& cells,
                                         const Border_cost& border_cost, const Partition& regions,
                                         const Merge_tree& tree,
                                         std::function<bool(Surface::Index)> is_fixed,
                                         std::size_t number_of_segments,
                                         const Execution& execution) const
  {
    const double length_unit = surface.length_unit();
    std::vector<double> areas;
    std::vector<Surface::Index> region_of;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      areas.push_back(cells[c].area / length_unit / length_unit);
      region_of.push_back(regions[cells[c].center]);
    }
    const auto distance = [&](Surface::Index p, Surface::Index q) {
      return norm(cells[p].centroid - cells[q].centroid) / length_unit;
    };
    const auto band_width = [&](double area) {
      const double result = (std::min)(width, width_of_segment * std::sqrt(area));
      return result >= narrowest_band ? result : 0;
    };
    const internal::Dual_graph costs(cells, internal::Dual_graph::EDGES_AND_CONTACTS,
                                     [&](const Patches::Adjacency& a, double deviation) {
                                       return border_cost(a.length / length_unit, deviation);
                                     });
    internal::Nested_borders borders(costs, distance, areas, region_of, tree);
    borders.run(number_of_cuts, number_of_segments, band_width, is_fixed, execution);
    return borders.take_labels();
  }

private:
  /// Distances of centroids have an error of this order where the origin is far away, and parts
  /// without area have a width like that.
  static constexpr double narrowest_band = 1e-6;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_BORDER_STRAIGHTENING_H
