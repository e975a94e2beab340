// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SUPERFACET_MERGING_H
#define CGAL_REGION_SEGMENTATION_METHODS_SUPERFACET_MERGING_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Methods/Border_straightening.h>
#include <CGAL/Region_segmentation/Methods/Region_rays.h>
#include <CGAL/Region_segmentation/Methods/Superfacets.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/internal/graph/check_parts.h>
#include <CGAL/Region_segmentation/internal/superfacets/Patch_builder.h>
#include <CGAL/Region_segmentation/internal/support/concept_checks.h>
#include <CGAL/Region_segmentation/internal/surface/smooth_noise.h>
#include <CGAL/Region_segmentation/requested_regions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The tree of regions that have new numbers, or no elements any more (the highest number): their
/// merges are left out.
inline Merge_tree renumber_tree(const Merge_tree& tree, std::vector<Partition::Index> new_numbers)
{
  constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
  Merge_tree result(std::size_t(std::count_if(new_numbers.begin(), new_numbers.end(),
                                              [](auto number) { return number != none; })));
  for (const Merge_tree::Merge& merge : tree.merges()) {
    // Of each segment, the lowest of the new numbers.
    Partition::Index& kept = new_numbers[merge.kept];
    const Partition::Index removed = new_numbers[merge.removed];
    if (kept != none && removed != none)
      result.push_back({(std::min)(kept, removed), (std::max)(kept, removed), merge.cost});
    kept = (std::min)(kept, removed);
  }
  return result;
}

/// The hierarchy of regions whose faces were moved between them: `region_of` gives the region of
/// each face by the numbers of `tree`.
inline Hierarchy renumbered_hierarchy(const std::vector<Partition::Index>& region_of,
                                      const Merge_tree& tree, std::size_t number_of_segments)
{
  constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
  Partition regions = Partition::from_labels(region_of);
  std::vector<Partition::Index> new_numbers(tree.number_of_regions(), none);
  for (std::size_t f = 0; f < region_of.size(); ++f)
    new_numbers[region_of[f]] = regions[f];
  return Hierarchy(std::move(regions), renumber_tree(tree, std::move(new_numbers)),
                   number_of_segments);
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// A hierarchy whose first regions can be split further: so there are as many segments as are asked
/// for, up to the number of faces that are not degenerate.
class Refinable_hierarchy : public Hierarchy
{
public:
  Refinable_hierarchy() = default;
  /// `largest_number`: of segments
  Refinable_hierarchy(Hierarchy hierarchy, const Superfacets& superfacets,
                      std::size_t largest_number)
    : Hierarchy(std::move(hierarchy))
    , m_superfacets(superfacets)
    , m_largest_number(largest_number)
  {}

  /// The segments of the faces of the surface that the hierarchy was made of. O(F log F) where
  /// regions are split.
  Composed_partition segments(const Surface& surface, std::size_t number) const
  {
    number = (std::min)(number, m_largest_number);
    if (number <= regions().number_of_parts())
      return Hierarchy::segments(surface, number);
    Partition split = m_superfacets.split(surface, regions(), number);
    Partition segments = Partition::into_single_elements(split.number_of_parts());
    return {std::make_shared<const Partition>(std::move(split)), std::move(segments)};
  }

private:
  Superfacets m_superfacets;
  std::size_t m_largest_number = 0;
};

/// \ingroup PkgRegionSegmentationMethods
/// Merges superfacets: `Superfacets` on the patches of the surface, annotated with what rays from
/// them see, merged by a policy, and the borders of the segments moved to minimum cuts. A model of
/// `SegmentationMethod`.
///
/// Where the surface has noise, all of this is measured on a smoothed one (\ref
/// RegionSegmentationNoise).
///
/// The order of merges does not depend on the number of segments. Where none is given, a chooser
/// chooses it. A number that exceeds that of the superfacets splits them.
///
/// \tparam GraphAnnotator a model of `GraphAnnotator`
/// \tparam MergingPolicy a model of `MergingPolicy`, or `Policy_phases`
/// \tparam NumberChooser a model of `NumberChooser`, for the costs of the policy
template <typename GraphAnnotator, typename MergingPolicy, typename NumberChooser>
struct Superfacet_merging
{
  GraphAnnotator annotator;
  MergingPolicy policy;
  NumberChooser chooser;
  Superfacets superfacets = Superfacets();
  Border_straightening straightening = Border_straightening();

  /// What does not depend on the request.
  struct Prepared
  {
    std::optional<Surface> smoothed; ///< the surface without its noise, if it has any
    Surface_patches patches;
    Partition regions; ///< the superfacets, of the faces
    Region_rays rays;
    std::size_t number_of_proper_faces; ///< that are not degenerate

    /// The surface that is measured.
    const Surface& shape(const Surface& surface) const { return smoothed ? *smoothed : surface; }
  };

  Prepared prepare(const Surface& given, const Execution& execution = Execution()) const
  {
    internal::check_constants(policy);
    internal::check_constants(chooser);
    superfacets.check_constants();
    straightening.check_constants();
    std::optional<Surface> smoothed = internal::without_noise(given, execution.silent());
    const Surface& surface = smoothed ? *smoothed : given;
    const Execution stage = execution.stage("regions");
    Surface_patches patches = internal::Patch_builder::build(surface, stage.step(0, 0.6));
    const Partition regions_of_patches = superfacets(surface, patches, stage.step(0.6, 1));
    Partition regions = internal::join_degenerate_regions(
      surface, composed(patches.fine.of_elements(), regions_of_patches));
    Region_rays rays(surface, patches, regions, execution.stage("rays"));
    const std::size_t proper_faces = internal::number_of_proper_faces(surface);
    return {std::move(smoothed), std::move(patches), std::move(regions), std::move(rays),
            proper_faces};
  }

  Refinable_hierarchy merge(const Surface& given, const Prepared& prepared, const Request& request,
                            const Execution& execution = Execution()) const
  {
    const Surface& surface = prepared.shape(given);
    static_assert(
      std::is_invocable_r<std::size_t, const NumberChooser&, const Merge_tree&,
                          const Surface&>::value,
      "a NumberChooser needs: std::size_t operator()(const Merge_tree&, const Surface&) const");
    const Requested_regions requested = requested_regions(surface, prepared.regions, request.seeds);
    auto graph = annotated_graph(surface, prepared, requested.regions, execution.stage("graph"));
    const Merge_tree tree = merge_requested_regions(surface, requested, graph, policy, 1,
                                                    execution.stage("merging"));
    // Regions that seeds joined are not split.
    const bool can_split = request.seeds.empty();
    const std::size_t largest_number = can_split ? (std::max)(prepared.number_of_proper_faces,
                                                              std::size_t(1))
                                                 : requested.regions.number_of_parts();
    const std::size_t number = (std::min)(
      request.number_of_segments > 0 ? request.number_of_segments : chooser(tree, surface),
      largest_number);
    Hierarchy hierarchy = straightened(surface, prepared, requested, request, tree, number,
                                       execution);
    const std::size_t regions_left = hierarchy.regions().number_of_parts();
    return Refinable_hierarchy(std::move(hierarchy), superfacets,
                               can_split ? largest_number : regions_left);
  }

  /// The graph of regions of the shape, with the data of the annotator; the rays of superfacets
  /// among them are not traced again.
  auto annotated_graph(const Surface& given, const Prepared& prepared, const Partition& regions,
                       const Execution& execution) const
  {
    static_assert(internal::check_annotator<GraphAnnotator>());
    const Surface& surface = prepared.shape(given);
    auto graph = build_region_adjacency_graph<typename GraphAnnotator::RegionData,
                                       typename GraphAnnotator::SectionData>(surface, regions,
                                                                             execution);
    if (regions == prepared.regions)
      annotator(graph, surface, regions, prepared.rays);
    else
      annotator(graph, surface, regions,
                Region_rays(surface, prepared.patches, regions, execution.silent()));
    return graph;
  }

private:
  using Index = Surface::Index;

  /// The hierarchy with the borders of its segments moved: of all of them, or of one number alone
  /// if the request says so.
  Hierarchy straightened(const Surface& surface, const Prepared& prepared,
                         const Requested_regions& requested, const Request& request,
                         const Merge_tree& tree, std::size_t number_of_segments,
                         const Execution& execution) const
  {
    const Partition& regions = requested.regions;
    std::optional<Patches> divided;
    if (!request.seeds.empty())
      divided = internal::Patch_builder::divided(surface, prepared.patches.fine, regions);
    const Patches& cells = divided ? *divided : prepared.patches.fine;
    const std::size_t number = request.numbers == Request::Numbers::ONE ? number_of_segments
                                                                        : regions.number_of_parts();
    const std::vector<Index> label_of_cell = straightening(surface, cells, requested, tree, number,
                                                           execution.stage("borders"));
    std::vector<Index> region_of;
    region_of.reserve(surface.number_of_faces());
    for (const Index cell : cells.of_elements())
      region_of.push_back(label_of_cell[cell]);
    return internal::renumbered_hierarchy(region_of, tree, number_of_segments);
  }
};

template <typename GraphAnnotator, typename MergingPolicy, typename NumberChooser>
Superfacet_merging(GraphAnnotator, MergingPolicy, NumberChooser)
  -> Superfacet_merging<GraphAnnotator, MergingPolicy, NumberChooser>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SUPERFACET_MERGING_H
