// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_SUPERFACET_MERGING_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_SUPERFACET_MERGING_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Superfacets/Border_straightening.h>
#include <CGAL/Region_segmentation/Superfacets/Region_rays.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacets.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Patch_builder.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The sum of the squared weights of the intersections of the parts of two partitions.
inline std::int64_t squared_intersections(const Partition& a, const Partition& b,
                                          const std::vector<std::int64_t>& weights)
{
  const Partition intersections = Partition::from_labels(
    boost::irange(std::size_t(0), a.size()), a.size(),
    [&](std::size_t e) { return std::uint64_t(a[e]) * b.number_of_parts() + b[e]; });
  std::vector<std::int64_t> sums(intersections.number_of_parts());
  for (std::size_t e = 0; e < a.size(); ++e)
    sums[intersections[e]] += weights[e];
  return std::inner_product(sums.begin(), sums.end(), sums.begin(), std::int64_t(0));
}

/// The place of the partition with the smallest sum of Rand index distances to the others, of
/// several the first. `weights`: of the elements; integers, so that no order of sums matters
inline std::size_t most_central(const std::vector<Partition>& partitions,
                                const std::vector<std::int64_t>& weights)
{
  std::vector<std::int64_t> own, sums(partitions.size());
  for (std::size_t i = 0; i < partitions.size(); ++i) {
    own.push_back(squared_intersections(partitions[i], partitions[i], weights));
    for (std::size_t j = 0; j < i; ++j) {
      const std::int64_t distance = own[i] + own[j] -
                                    2 *
                                      squared_intersections(partitions[i], partitions[j], weights);
      sums[i] += distance;
      sums[j] += distance;
    }
  }
  return std::size_t(std::min_element(sums.begin(), sums.end()) - sums.begin());
}

} // namespace internal

/// \ingroup PkgRegionSegmentationMethods
/// Merges superfacets: divides the surface into `Superfacets`, annotates them with what rays from
/// them see, merges them by a policy, and moves the borders of the segments to minimum cuts. A
/// model of `SegmentationMethod`.
///
/// `segment()` and `Segmenter` give it surfaces without their noise (\ref
/// RegionSegmentationNoise).
///
/// The superfacets decide which of nearly equal merges comes first. Since a slightly different
/// mesh has other superfacets, a single set of them would make the segments a matter of chance. So
/// several *draws*, sets of superfacets of different size (`Superfacets::draws()`), are merged,
/// each by itself; the result is the draw whose segmentation into its chosen number of segments has
/// the smallest sum of Rand index distances to those of the others, of several the one with most
/// superfacets. (Segmentations are compared on the centers of the coarse patches, by the areas of
/// these in \f$2^{-26}\f$ of the surface, rounded down.) Rays are those of the superfacets of the
/// first draw. Seeds do not change which draw is taken.
///
/// The order of merges does not depend on the number of segments. If no number is given, a chooser
/// chooses it. If a number k of segments is given to `prepare()`, there are at least 2k superfacets
/// in the first draw, and draws with fewer than k are left out. If the surface has fewer patches
/// than k, each face is a patch. So every k is met, up to the number of faces that are not
/// degenerate.
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
  static constexpr bool smooths_noise = true;    ///< see `SegmentationMethod`
  static constexpr std::size_t most_draws = 100; ///< more take only time
  std::size_t number_of_draws = 5;               ///< in [1, `most_draws`]

  /// What does not depend on the wanted number of segments and on seeds.
  struct Prepared
  {
    Surface_patches patches;
    std::vector<Inward_ray> rays;  ///< of the superfacets of the first draw
    Partition regions;             ///< the superfacets of the draw that is taken, of the faces
    Merge_tree tree;               ///< their merges without seeds
    std::size_t chosen_number = 0; ///< of segments
  };

  /// `number_of_segments`: for which there are enough superfacets; 0: those of `superfacets`
  Prepared prepare(const Surface& surface, std::size_t number_of_segments = 0,
                   const Execution& execution = Execution()) const
  {
    internal::check_constants(policy);
    internal::check_constants(chooser);
    superfacets.check_constants();
    straightening.check_constants();
    internal::check_constant("Superfacet_merging: number_of_draws", double(number_of_draws), 1,
                             double(most_draws));
    static_assert(
      std::is_invocable_r<std::size_t, const NumberChooser&, const Merge_tree&,
                          const Surface&>::value,
      "a NumberChooser needs: std::size_t operator()(const Merge_tree&, const Surface&) const");
    const Execution stage = execution.stage("regions");
    Prepared result;
    result.patches = internal::Patch_builder::build(surface, number_of_segments,
                                                    stage.step(0, 0.6));
    const std::vector<Partition> draws = draws_for(surface, result.patches, number_of_segments,
                                                   stage.step(0.6, 1));
    if (const Execution rays = execution.stage("rays"); surface.area() > 0)
      result.rays = internal::Inward_rays(
                      surface, result.patches,
                      composed(result.patches.fine.of_elements(), draws.front()))
                      .trace(rays);
    take_central_draw(surface, draws, result, execution.stage("draws"));
    return result;
  }

  Hierarchy merge(const Surface& surface, const Prepared& prepared, const Request& request,
                  const Execution& execution = Execution()) const
  {
    const Requested_regions requested = requested_regions(surface, prepared.regions, request.seeds);
    Merge_tree tree = prepared.tree;
    std::optional<Patches> divided;
    if (!request.seeds.empty()) {
      divided = internal::Patch_builder::divided(surface, prepared.patches.fine, requested.regions);
      tree = merged(surface, prepared.rays, *divided, requested, execution.stage("merging"));
    }
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments
                               : request.seeds.empty()        ? prepared.chosen_number
                                                              : chooser(tree, surface);
    const Patches& cells = divided ? *divided : prepared.patches.fine;
    const std::vector<Surface::Index> label_of_cell = straightening(
      surface, cells, requested, tree,
      request.needs_all_numbers ? tree.number_of_regions() : number, execution.stage("borders"));
    std::vector<Surface::Index> region_of;
    region_of.reserve(surface.number_of_faces());
    for (const Surface::Index cell : cells.of_elements())
      region_of.push_back(label_of_cell[cell]);
    Hierarchy result = internal::renumbered_hierarchy(region_of, tree, number);
    // If so many regions have lost all their faces that too few are left, borders stay.
    if (result.regions().number_of_parts() <
        (std::min)(request.number_of_segments, tree.number_of_regions()))
      return Hierarchy(requested.regions, std::move(tree), number);
    return result;
  }

  /// The graph of regions of the faces, each a union of `cells`, with the data of the annotator.
  auto annotated_graph(const Surface& surface, const std::vector<Inward_ray>& rays,
                       const Patches& cells, const Partition& regions,
                       const Execution& execution) const
  {
    auto graph = internal::build_region_graph<typename GraphAnnotator::RegionData,
                                              typename GraphAnnotator::SectionData>(
      surface, regions, cells.borders(), execution);
    annotator(graph, surface, regions, Region_rays{rays, Region_shapes(surface, cells, regions)});
    return graph;
  }

private:
  /// Draws of superfacets, each of at least `number_of_segments`, as regions of the fine patches.
  std::vector<Partition> draws_for(const Surface& surface, const Surface_patches& patches,
                                   std::size_t number_of_segments, const Execution& execution) const
  {
    std::vector<Partition> result;
    const auto add = [&](const Partition& draw) {
      Partition joined = internal::join_degenerate_regions(surface, patches.fine, draw);
      if (result.empty() || joined.number_of_parts() >= number_of_segments)
        result.push_back(std::move(joined));
    };
    Superfacets sufficient = superfacets;
    sufficient.number = (std::max)(sufficient.number,
                                   2 * (std::min)(number_of_segments, surface.number_of_faces()));
    for (const Partition& draw : sufficient.draws(surface, patches, number_of_draws, execution))
      add(draw);
    if (result.front().number_of_parts() < number_of_segments) {
      result.clear();
      add(Partition::into_single_elements(patches.fine.size()));
    }
    return result;
  }

  Merge_tree merged(const Surface& surface, const std::vector<Inward_ray>& rays,
                    const Patches& cells, const Requested_regions& requested,
                    const Execution& execution) const
  {
    auto graph = annotated_graph(surface, rays, cells, requested.regions, execution.step(0, 0.2));
    return merge_requested_regions(surface, requested, graph, policy, 1, execution.step(0.2, 1));
  }

  /// Merges each draw, and takes that whose segmentation is nearest to those of the others.
  void take_central_draw(const Surface& surface, const std::vector<Partition>& draws,
                         Prepared& result, const Execution& execution) const
  {
    const Patches &fine = result.patches.fine, &coarse = result.patches.coarse;
    const std::size_t n = draws.size();
    std::vector<Merge_tree> trees(n);
    std::vector<std::size_t> numbers(n);
    std::vector<Partition> segmentations(n); // of the coarse patches
    execution.for_each(0, n, [&](std::size_t i) {
      const Execution step = execution.is_parallel()
                               ? execution.silent()
                               : execution.step(double(i) / double(n), double(i + 1) / double(n));
      trees[i] = merged(surface, result.rays, fine,
                        {composed(fine.of_elements(), draws[i]), Seeds()}, step);
      numbers[i] = chooser(trees[i], surface);
      const Partition segments = trees[i].partition_at_count(numbers[i]);
      segmentations[i] = Partition::from_labels(
        boost::irange(std::size_t(0), coarse.size()), coarse.size(),
        [&](std::size_t c) { return segments[draws[i][coarse[c].center]]; });
    });
    std::vector<std::int64_t> areas; // in 2^-26 of the surface
    for (std::size_t c = 0; c < coarse.size(); ++c)
      areas.push_back(
        std::int64_t(std::ldexp(coarse[c].area * internal::inverse(surface.area()), 26)));
    const std::size_t central = internal::most_central(segmentations, areas);
    result.regions = composed(fine.of_elements(), draws[central]);
    result.tree = std::move(trees[central]);
    result.chosen_number = numbers[central];
  }
};

template <typename GraphAnnotator, typename MergingPolicy, typename NumberChooser>
Superfacet_merging(GraphAnnotator, MergingPolicy, NumberChooser)
  -> Superfacet_merging<GraphAnnotator, MergingPolicy, NumberChooser>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_SUPERFACET_MERGING_H
