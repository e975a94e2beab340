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

/// The hierarchy of regions whose faces were moved between them: `region_of` gives the region of
/// each face by the numbers of `tree`. Merges of a region without faces are left out.
inline Hierarchy renumbered_hierarchy(const std::vector<Partition::Index>& region_of,
                                      const Merge_tree& tree, std::size_t number_of_segments)
{
  constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
  Partition regions = Partition::from_labels(region_of);
  // By former number: the lowest of the new numbers in the segment of a region.
  std::vector<Partition::Index> numbers(tree.number_of_regions(), none);
  for (std::size_t f = 0; f < region_of.size(); ++f)
    numbers[region_of[f]] = regions[f];
  Merge_tree renumbered(regions.number_of_parts());
  for (const Merge_tree::Merge& merge : tree.merges()) {
    const auto [kept, removed] = std::minmax({numbers[merge.kept], numbers[merge.removed]});
    if (removed != none)
      renumbered.push_back({kept, removed, merge.cost});
    numbers[merge.kept] = kept;
  }
  return Hierarchy(std::move(regions), std::move(renumbered), number_of_segments);
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// A hierarchy whose regions can be split further, so that there are as many segments as are asked
/// for, up to the number of faces that are not degenerate.
class Refinable_hierarchy : public Hierarchy
{
public:
  Refinable_hierarchy() = default;
  /// `largest_number`: of segments; 0 if regions must not be split
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
    if (m_largest_number > 0)
      number = (std::min)(number, m_largest_number);
    if (m_largest_number == 0 || number <= regions().number_of_parts())
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
/// Merges superfacets: divides the surface into `Superfacets`, annotates them with what rays from
/// them see, merges them by a policy, and moves the borders of the segments to minimum cuts. A
/// model of `SegmentationMethod`.
///
/// A surface with noise is smoothed first (\ref RegionSegmentationNoise).
///
/// The order of merges does not depend on the number of segments. If no number is given, a chooser
/// chooses it. If more segments are wanted than there are superfacets, superfacets are split.
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

  /// What does not depend on the wanted number of segments and on seeds.
  struct Prepared
  {
    std::optional<Surface> smoothed; ///< the surface without its noise, if it has any
    Surface_patches patches;
    Partition regions; ///< the superfacets, of the faces
    Region_rays rays;

    /// The smoothed surface if there is one, else the given one.
    const Surface& shape(const Surface& surface) const { return smoothed ? *smoothed : surface; }
  };

  Prepared prepare(const Surface& given, const Execution& execution = Execution()) const
  {
    internal::check_constants(policy);
    internal::check_constants(chooser);
    superfacets.check_constants();
    straightening.check_constants();
    const Execution stage = execution.stage("regions");
    std::optional<Surface> smoothed = internal::without_noise(given, stage.step(0, 0.1));
    const Surface& surface = smoothed ? *smoothed : given;
    Surface_patches patches = internal::Patch_builder::build(surface, stage.step(0.1, 0.6));
    const Partition regions_of_patches = superfacets(surface, patches, stage.step(0.6, 1));
    Partition regions = internal::join_degenerate_regions(
      surface, composed(patches.fine.of_elements(), regions_of_patches));
    Region_rays rays(surface, patches, regions, execution.stage("rays"));
    return {std::move(smoothed), std::move(patches), std::move(regions), std::move(rays)};
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
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments
                                                              : chooser(tree, surface);
    std::optional<Patches> divided;
    if (!request.seeds.empty())
      divided = internal::Patch_builder::divided(surface, prepared.patches.fine, requested.regions);
    const Patches& cells = divided ? *divided : prepared.patches.fine;
    const bool is_for_one_number = request.numbers == Request::Numbers::ONE;
    const std::vector<Surface::Index> label_of_cell = straightening(
      surface, cells, requested, tree, is_for_one_number ? number : tree.number_of_regions(),
      execution.stage("borders"));
    std::vector<Surface::Index> region_of;
    region_of.reserve(surface.number_of_faces());
    for (const Surface::Index cell : cells.of_elements())
      region_of.push_back(label_of_cell[cell]);
    const std::size_t largest_number = (std::max)(internal::number_of_proper_faces(surface),
                                                  std::size_t(1));
    return Refinable_hierarchy(internal::renumbered_hierarchy(region_of, tree, number), superfacets,
                               request.seeds.empty() ? largest_number : 0);
  }

  /// The graph of the regions, with the data of the annotator. The rays of superfacets that are
  /// regions are not traced again.
  auto annotated_graph(const Surface& given, const Prepared& prepared, const Partition& regions,
                       const Execution& execution) const
  {
    static_assert(internal::check_annotator<GraphAnnotator>());
    const Surface& surface = prepared.shape(given);
    auto graph = build_region_adjacency_graph<typename GraphAnnotator::RegionData,
                                              typename GraphAnnotator::SectionData>(
      surface, regions, execution);
    if (regions == prepared.regions)
      annotator(graph, surface, regions, prepared.rays);
    else
      annotator(graph, surface, regions,
                Region_rays(surface, prepared.patches, regions, execution.step(0.5, 1)));
    return graph;
  }
};

template <typename GraphAnnotator, typename MergingPolicy, typename NumberChooser>
Superfacet_merging(GraphAnnotator, MergingPolicy, NumberChooser)
  -> Superfacet_merging<GraphAnnotator, MergingPolicy, NumberChooser>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SUPERFACET_MERGING_H
