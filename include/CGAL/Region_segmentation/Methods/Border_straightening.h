// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_BORDER_STRAIGHTENING_H
#define CGAL_REGION_SEGMENTATION_METHODS_BORDER_STRAIGHTENING_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/cuts/Nested_borders.h>
#include <CGAL/Region_segmentation/internal/reading/Patch_builder.h>
#include <CGAL/Region_segmentation/internal/regions/border_costs.h>
#include <CGAL/Region_segmentation/internal/regions/connected_pieces.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationInitializers
/// moves the borders of the segments of a merge tree to minimum cuts, from the roots of the tree down, so that the
/// segmentations of all numbers stay nested.
///
/// Elements are the patches of the mesh (see `Mesh_patches`); a patch with faces of several regions is divided by them
/// into connected elements. An element is its region's own at first. Merges are undone from the last one on. Each
/// divides a segment into two parts, the kept one and the removed one:
/// -# The own elements of either part's regions belong to it. If they are not connected, those outside of the component
///    of largest area (of ones equal in 13 bits, that with the lowest element) become guests.
/// -# In rounds, guests of the segment that are adjacent to elements of the parts join the part to which their border
///    costs more, of equal ones the kept one. If neither part has own elements, all guests join the kept part. The border between two
///    elements costs
///    \f$l / (\sqrt{A} (1 + g \, \min(\delta^+, m)))\f$, as in `Superfacets`, rounded alike.
/// -# In the last \f$n\f$ merges, the border between the parts moves. Its band contains the elements of both within
///    \f$\min(D_0, q \sqrt{a / A})\f$ of it, \f$a\f$ the area of the smaller part; if that is below \f$10^{-6}\f$, the
///    border stays. Elements at the border have the distance 0, and a step to an adjacent element of the same part has the
///    length \f$|c_i - c_j| / \sqrt{A}\f$. An element of the band that is adjacent to one of its part outside of the
///    band stays. If some stay in either part, elements move to the minimum cut: the sides between which the borders of
///    elements of the band cost least, of several cuts one that moves the fewest elements, and of these that with the
///    fewest elements in the kept part.
///    Costs are rounded to multiples of about \f$2^{-50} N C\f$, \f$N\f$ the number of elements that may move and
///    \f$C\f$ the sum of their costs. Elements outside of the band count with their own part. The move is not made if
///    it disconnects a part. Moved elements become guests.
///
/// A region can lose all elements: then its merge is left out. New regions are what remains of each, numbered by their
/// first face.
///
/// Complexity: O(P + R log R) in practice for P elements and R regions, and the cuts, whose bands contain few elements.
///
/// Source: minimum cuts in a fuzzy band \cgalCite{KT03}; the flow \cgalCite{BK04}.
struct Border_straightening
{
  static constexpr Mesh_data required_mesh_data = Mesh_data::PATCHES;

  std::size_t number_of_cuts = 63;    ///< n: at most one less than the largest number of segments whose borders are moved
  double width = 0.03;                ///< D_0, at least 0, in units of the square root of the area of the surface
  double width_of_segment = 0.2;      ///< q, at least 0: at most this part of the square root of the smaller area
  double concave_gain = 10;           ///< g, 1/radian, at least 0: how much cheaper a border in a valley is
  double maximum_deviation = 0.6;     ///< m, radian, at least 0: deviations above it count as this one

  /// The region of each face after moving borders, by its former number; or, if `number_of_segments` is less than the number of
  /// regions that are left, the segment of each face in that segmentation (or the one nearest to it), named by its lowest
  /// region: the other merges are not undone then.
  ///
  /// `regions`: connected; `tree`: their merges; `is_fixed(region)`: whether its faces stay in the segments of the
  /// region, of at most one region of a tree.
  template <typename IsFixed, typename ConcurrencyTag>
  std::vector<Flat_mesh::Index> operator()(const Flat_mesh& mesh, const Partition& regions, const Merge_tree& tree,
                                           const IsFixed& is_fixed, const Execution<ConcurrencyTag>& execution,
                                           std::size_t number_of_segments = (std::numeric_limits<std::size_t>::max)()) const
  {
    CGAL_precondition_msg(width >= 0 && width_of_segment >= 0 && concave_gain >= 0 && maximum_deviation >= 0,
                          "Border_straightening: constants are at least 0");
    if (are_unions_of_patches(mesh.patches(), regions))
      return move_borders(mesh, mesh.patches(), regions, tree, is_fixed, execution, number_of_segments);
    return move_borders(mesh, divided_patches(mesh, regions), regions, tree, is_fixed, execution, number_of_segments);
  }

private:
  using Index = Flat_mesh::Index;

  /// Distances of centroids have an error of this order where the origin is far away, and parts without area have a width
  /// like that.
  static constexpr double narrowest_band = 1e-6;

  static bool are_unions_of_patches(const Mesh_patches& patches, const Partition& regions)
  {
    for (std::size_t f = 0; f < regions.size(); ++f)
      if (regions[f] != regions[patches[patches.of_faces()[f]].center])
        return false;
    return true;
  }

  static Patches divided_patches(const Flat_mesh& mesh, const Partition& regions)
  {
    std::vector<std::uint64_t> labels;
    labels.reserve(regions.size());
    for (std::size_t f = 0; f < regions.size(); ++f)
      labels.push_back((std::uint64_t(mesh.patches().of_faces()[f]) << 32) | regions[f]);
    return internal::Patch_builder<CGAL::Sequential_tag>::build(mesh, internal::connected_pieces(mesh, labels));
  }

  /// The regions are unions of the patches.
  template <typename IsFixed, typename ConcurrencyTag>
  std::vector<Index> move_borders(const Flat_mesh& mesh, const Patches& patches, const Partition& regions,
                                  const Merge_tree& tree, const IsFixed& is_fixed,
                                  const Execution<ConcurrencyTag>& execution, std::size_t number_of_segments) const
  {
    const double unit = mesh.relative_unit();
    std::vector<double> areas;
    std::vector<Index> region_of;
    areas.reserve(patches.size());
    region_of.reserve(patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
      areas.push_back(patches[p].area / unit / unit);
      region_of.push_back(regions[patches[p].center]);
    }
    const internal::Dual_graph costs = internal::border_costs(mesh, patches, concave_gain, maximum_deviation);
    const auto distance = [&](Index p, Index q) { return norm(patches[p].centroid - patches[q].centroid) / unit; };
    const auto band_width = [&](double area) {
      const double result = (std::min)(width, width_of_segment * std::sqrt(area));
      return result >= narrowest_band ? result : 0;
    };
    internal::Nested_borders borders(costs, distance, areas, region_of, tree);
    borders.run(number_of_cuts, number_of_segments, band_width, is_fixed, execution);
    const std::vector<Index> labels = borders.take_labels();
    std::vector<Index> label_of_face;
    label_of_face.reserve(regions.size());
    for (const Index patch : patches.of_elements())
      label_of_face.push_back(labels[patch]);
    return label_of_face;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_BORDER_STRAIGHTENING_H
