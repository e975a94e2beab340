// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_SUPERFACETS_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_SUPERFACETS_H

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Graph/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Farthest_point_seeding.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Joins regions of patches so that none consists of degenerate faces alone, if possible: across
/// the edges that join these, then across their other edges, then across seams and links.
inline Partition join_degenerate_regions(const Surface& surface, const Patches& patches,
                                         const Partition& regions)
{
  const Partition& patch_of = patches.of_elements();
  std::vector<bool> is_proper(regions.number_of_parts()); // by root
  for (std::size_t p = 0; p < regions.size(); ++p)
    if (!surface.is_degenerate(patches[p].center))
      is_proper[regions[p]] = true;
  if (std::find(is_proper.begin(), is_proper.end(), false) == is_proper.end())
    return regions;
  Lowest_root_forest forest(is_proper.size());
  constexpr std::array<std::uint8_t, 3> order = {Surface::JOINING, Surface::CLOSED,
                                                 Surface::SEAM | Surface::LINK};
  for (const std::uint8_t flag : order)
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const auto r = forest.root(regions[patch_of[surface.lower_face(a)]]),
                 s = forest.root(regions[patch_of[surface.higher_face(a)]]);
      if (!surface.has_flag(a, flag) || surface.has_flag(a, Surface::CONSTRAINED) ||
          (is_proper[r] && is_proper[s]))
        continue;
      is_proper[(std::min)(r, s)] = is_proper[r] || is_proper[s];
      forest.unite(r, s);
    }
  return composed(regions, forest.take_partition());
}

} // namespace internal

/// \ingroup PkgRegionSegmentationInitializers
/// makes regions of bounded size whose borders follow concave edges: each patch of
/// the surface (see `Surface_patches`) belongs to the nearest seed. Only edges are crossed, neither
/// seams nor links.
///
/// A step between two adjacent patches has the length \f$|c_i - c_j| / \sqrt{A} + w \,
/// \min(\delta^+, m)\f$, rounded to `float`, at least \f$10^{-37}\f$ and at most \f$10^{28}\f$,
/// \f$c\f$ the centroids, \f$A\f$ the area of the surface, \f$\delta^+\f$ the angle of their
/// normals if they face each other, \f$(n_j - n_i) \cdot (c_j - c_i) < 0\f$, else 0 (and 0 if one
/// has no normal). Distances are sums of steps in `double`. The first seeds are placed in the
/// connected components without one, each at the patch of them that is farthest from the centroid
/// of the surface, even if this exceeds the number (those of crumbs do not count); then each
/// further one at the patch farthest from all seeds so far; of several, at the lower one.
///
/// Seeds are placed like this on the coarse patches, if there are at least four for each region,
/// and moved to their centers; else on the patches. A patch belongs to the nearest seed. It is
/// reached through a neighbor; of several through which its distance is the same, through that with
/// the smallest distance, rounded to `float`, then the lowest one; and belongs to the seed of this
/// neighbor. Regions are connected, and are numbered by their first face.
///
/// Several draws are such partitions with fewer and fewer seeds: \f$n_1\f$ is the `number`,
/// \f$n_{i+1}\f$ is \f$15/16 \, n_i\f$, rounded down, at least 1. Each takes the first ones of
/// the same sequence of seeds. Where a patch is as near to two seeds, that which the smaller draw
/// has comes first. A draw that has as many seeds as another one, since there are as many
/// components or no more patches, is left out.
///
/// Since concavity is added to a step, not multiplied, and angles are those between patches, the
/// regions of a surface depend little on the resolution of its mesh.
///
/// Complexity: O(F + P log P) in practice, P the number of patches, at most some 60,000, with a
/// small constant: seeds are placed on some 4,000 coarse patches, each of which is reached by a few
/// seeds. Deterministic.
///
/// Source: farthest-point seeding \cgalCite{G85}, in images \cgalCite{ELPZ97}.
class Superfacets
{
public:
  static constexpr std::size_t largest_number = std::size_t(1) << 30;

  std::size_t number;       ///< of regions, in [1, `largest_number`]
  double concave_weight;    ///< w, relative length per radian, at least 0: the lengthening of steps
                            ///< into valleys
  double maximum_deviation; ///< m, radian, at least 0: deviations above it count as this one

  explicit Superfacets(std::size_t number_ = 480, double concave_weight_ = 0.4,
                       double maximum_deviation_ = 0.6)
    : number(number_)
    , concave_weight(concave_weight_)
    , maximum_deviation(maximum_deviation_)
  {}

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Superfacets: number", double(number), 1, double(largest_number));
    internal::check_constant("Superfacets: concave_weight", concave_weight, 0);
    internal::check_constant("Superfacets: maximum_deviation", maximum_deviation, 0);
  }

  /// The regions of the fine patches of a surface.
  Partition operator()(const Surface& surface, const Surface_patches& patches,
                       const Execution& execution = Execution()) const
  {
    return draws(surface, patches, 1, execution).front();
  }

  /// At most `number_of_draws` such partitions, at least one, that of most regions first.
  std::vector<Partition> draws(const Surface& surface, const Surface_patches& patches,
                               std::size_t number_of_draws,
                               const Execution& execution = Execution()) const
  {
    if (surface.number_of_faces() == 0)
      return {Partition()};
    const Patches &fine = patches.fine, &coarse = patches.coarse;
    std::size_t number_of_coarse = 0; // patches that are not in crumbs
    for (std::size_t p = 0; p < coarse.size(); ++p)
      number_of_coarse += coarse[p].area > 0;
    const bool is_on_coarse = number_of_coarse / coarse_patches_of_region >= number;
    const Patches& places = is_on_coarse ? coarse : fine;
    internal::Farthest_point_seeding placing(steps(surface, places)), nearest(steps(surface, fine));
    // Each crumb has a seed of its own, which does not count.
    const std::size_t crumbs = surface.number_of_crumbs();
    placing.run(distances_from_centroid(places), number + crumbs, execution);
    std::vector<Index> seeds = placing.seeds();
    if (is_on_coarse)
      for (Index& seed : seeds)
        seed = coarse[seed].center;

    std::vector<std::size_t> ends{seeds.size()}; // by draw: the number of its seeds
    for (std::size_t i = 1, n = number; i < number_of_draws; ++i) {
      n = (std::max)(n * 15 / 16, std::size_t(1));
      if (const auto end = (std::max)(n + crumbs, placing.number_of_components());
          end < ends.back())
        ends.push_back(end);
    }
    std::vector<Partition> draws(ends.size());
    auto begin = seeds.begin();
    for (std::size_t i = ends.size(); i-- > 0;) {
      const auto end = seeds.begin() + std::ptrdiff_t(ends[i]);
      nearest.add({begin, end});
      draws[i] = nearest.regions();
      begin = end;
    }
    return draws;
  }

private:
  using Index = Surface::Index;

  internal::Dual_graph steps(const Surface& mesh, const Patches& patches) const
  {
    return internal::Dual_graph(
      patches, internal::Dual_graph::EDGES, [&](const Patches::Adjacency& a, double deviation) {
        return step(mesh, norm(patches[a.lower].centroid - patches[a.higher].centroid), deviation);
      });
  }

  /// At least the smallest float, so that only seeds have the distance 0; and so short that a path
  /// along all faces is finite in float, so that every face of a component is reached.
  double step(const Surface& mesh, double distance, double concavity) const
  {
    const double length = distance / mesh.length_unit() +
                          concave_weight * (std::min)(concavity, maximum_deviation);
    return (std::min)((std::max)(length, shortest_step), longest_step);
  }

  /// Returns the squared distance of each patch from the centroid of the surface.
  static std::vector<double> distances_from_centroid(const Patches& patches)
  {
    // Relative to a point of the mesh, to avoid cancellation far from the origin.
    const auto place = [&](std::size_t p) { return patches[p].centroid - patches[0].centroid; };
    Second_moments moments;
    for (std::size_t p = 0; p < patches.size(); ++p)
      moments.add(patches[p].area, place(p));
    std::vector<double> distances;
    for (std::size_t p = 0; p < patches.size(); ++p)
      distances.push_back(squared_norm(place(p) - moments.centroid()));
    return distances;
  }

  static constexpr std::size_t coarse_patches_of_region = 4; // at least, on average: fewer give no
                                                             // choice of seeds
  static constexpr double shortest_step = 1e-37, longest_step = 1e28;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_SUPERFACETS_H
