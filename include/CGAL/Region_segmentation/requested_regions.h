// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
#define CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H

#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>
#include <CGAL/Region_segmentation/internal/surface/find_links.h>
#include <CGAL/Region_segmentation/merge_regions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The regions with faces of several seeds.
inline std::vector<std::uint8_t> regions_of_several_seeds(const Partition& regions,
                                                          const Seeds& seeds)
{
  std::vector<Seeds::Index> seed_of(regions.number_of_parts(), Seeds::none);
  std::vector<std::uint8_t> has_several(regions.number_of_parts());
  for (std::size_t f = 0; f < regions.size(); ++f) {
    if (seeds.of[f] == Seeds::none)
      continue;
    Seeds::Index& seed = seed_of[regions[f]];
    if (seed == Seeds::none)
      seed = seeds.of[f];
    has_several[regions[f]] |= seed != seeds.of[f];
  }
  return has_several;
}

/// Splits those regions that have faces of several seeds: a face is assigned to the seed from which
/// the fewest edges have to be crossed, of several to the one that is reached first from the lower
/// faces; constrained edges are not crossed. Each connected component becomes a region. O(F).
inline Partition split_at_seeds(const Surface& surface, const Partition& regions,
                                const Seeds& seeds)
{
  using Index = Partition::Index;
  const auto is_split = regions_of_several_seeds(regions, seeds);
  if (std::find(is_split.begin(), is_split.end(), 1) == is_split.end())
    return regions;

  const auto is_inside = [&](std::size_t a) {
    const Index r = regions[surface.lower_face(a)];
    return is_split[r] && r == regions[surface.higher_face(a)] &&
           !surface.has_flag(a, Surface::CONSTRAINED);
  };
  const Grouped_items<Index> neighbors(regions.size(), [&](const auto& add) {
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
      if (is_inside(a)) {
        add(surface.lower_face(a), surface.higher_face(a));
        add(surface.higher_face(a), surface.lower_face(a));
      }
  });
  std::vector<Index> seed_of = seeds.of, front;
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (is_split[regions[f]] && seed_of[f] != Seeds::none)
      front.push_back(Index(f));
  for (std::size_t i = 0; i < front.size(); ++i)
    for (const Index f : neighbors[front[i]])
      if (seed_of[f] == Seeds::none) {
        seed_of[f] = seed_of[front[i]];
        front.push_back(f);
      }

  const Partition pieces = label_components(
    surface,
    [&](std::size_t a) {
      return is_inside(a) && seed_of[surface.lower_face(a)] == seed_of[surface.higher_face(a)];
    },
    Execution());
  std::vector<std::uint64_t> labels(regions.size());
  for (std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = is_split[regions[f]] ? std::uint64_t(regions.number_of_parts()) + pieces[f]
                                     : regions[f];
  return Partition::from_labels(labels);
}

/// The seeds of regions, each of which has faces of one seed at most.
inline Seeds seeds_of_regions(const Partition& regions, const Seeds& of_faces)
{
  Seeds result{std::vector<Seeds::Index>(regions.number_of_parts(), Seeds::Index(Seeds::none)),
               of_faces.values};
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (of_faces.of[f] != Seeds::none)
      result.of[regions[f]] = of_faces.of[f];
  return result;
}

/// Joins the regions of each seed along the cheapest paths of regions that avoid all other seeds.
///
/// A step from region i to j across a section of length L costs (sqrt(a_i) + sqrt(a_j)) / 2 (1 + 80
/// C / L), a the areas and C the integral of the deviation of the concave edges of the section.
/// Seeds are joined in order; a seed that cannot be joined any more is the first one in another
/// attempt.
///
/// Complexity: O(F + E log E) for E adjacencies between regions, and for each attempt and seed
/// O(R + S log R) in practice.
class Seed_joining
{
  using Index = Partition::Index;

public:
  /// \pre each region has faces of one seed at most: that in `seeds`
  Seed_joining(const Surface& surface, const Partition& regions, const Seeds& seeds)
    : m_steps(regions.number_of_parts())
    , m_seeds(seeds)
    , m_members(seeds.number())
  {
    add_steps(surface, regions);
    for (Index r = 0; r < regions.number_of_parts(); ++r)
      if (m_seeds.of[r] != Seeds::none)
        m_members[m_seeds.of[r]].push_back(r);
  }

  /// The seeds, extended to the regions on the paths, so that the regions of each are connected.
  /// Empty if there are no such paths.
  std::optional<Seeds> join()
  {
    std::vector<Index> order(m_seeds.number());
    std::iota(order.begin(), order.end(), Index(0));
    // A seed that failed is first from then on, so that there are at most as many attempts as
    // seeds.
    for (std::size_t number_of_tries = 0; number_of_tries <= order.size(); ++number_of_tries) {
      m_owner = m_seeds.of;
      Index* failed = order.data();
      Index* const end = failed + order.size();
      while (failed != end && join_members(*failed))
        ++failed;
      if (failed == end)
        return Seeds{std::move(m_owner), m_seeds.values};
      m_failed = *failed;
      if (failed == order.data())
        break;
      std::rotate(order.data(), failed, failed + 1);
    }
    return std::nullopt;
  }

  /// The seed, as in the user's map, that could not be joined.
  std::size_t failed_seed() const { return m_seeds.values[m_failed]; }

private:
  static constexpr double concave_weight = 80; // 1/radian

  struct Step
  {
    Index region;
    double cost;
  };

  void add_steps(const Surface& surface, const Partition& regions)
  {
    const std::vector<double> areas = part_areas(surface, regions);
    std::vector<std::pair<std::uint64_t, Index>> sections; // two regions, an adjacency
    for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
      const Index r = regions[surface.lower_face(a)], s = regions[surface.higher_face(a)];
      if (r != s)
        sections.push_back({(std::uint64_t((std::min)(r, s)) << 32) | (std::max)(r, s), Index(a)});
    }
    std::sort(sections.data(), sections.data() + sections.size());
    for (std::size_t first = 0, past = 0; first < sections.size(); first = past) {
      double length = 0, concave = 0;
      bool is_barred = false;
      for (; past < sections.size() && sections[past].first == sections[first].first; ++past) {
        const Index a = sections[past].second;
        length += surface.length(a);
        if (surface.has_flag(a, Surface::CONCAVE))
          concave += surface.length(a) * surface.deviation(a);
        is_barred = is_barred || surface.has_flag(a, Surface::CONSTRAINED);
      }
      if (is_barred)
        continue;
      const Index r = Index(sections[first].first >> 32), s = Index(sections[first].first);
      const double concavity = length > 0 ? concave / length : 0;
      const double cost = (std::sqrt(areas[r]) + std::sqrt(areas[s])) / 2 *
                          (1 + concave_weight * concavity);
      m_steps[r].push_back({s, cost});
      m_steps[s].push_back({r, cost});
    }
  }

  /// Whether the regions of a seed could be joined; if so, those on the paths now belong to the
  /// seed. Dijkstra's algorithm from its first region through regions of no other seed; those on a
  /// path to another one are sources from then on.
  bool join_members(Index seed)
  {
    std::vector<double> distances(m_owner.size(), std::numeric_limits<double>::infinity());
    std::vector<Index> predecessors(m_owner.size());
    std::vector<bool> is_connected(m_owner.size());
    std::vector<Index> path;
    std::size_t left = m_members[seed].size();
    const auto connect_to = [&](Index r) {
      for (; !is_connected[r]; r = predecessors[r]) {
        is_connected[r] = true;
        m_owner[r] = seed;
        path.push_back(r);
        left -= m_seeds.of[r] == seed;
      }
    };
    const Index first = m_members[seed].front();
    predecessors[first] = first;
    find_shortest_paths(
      std::vector<Index>{first}, distances,
      [&](Index r) {
        path.clear();
        if (m_seeds.of[r] == seed && !is_connected[r])
          connect_to(r);
        return left > 0;
      },
      [&](Index r, const auto& enter) {
        for (const auto& [next, cost] : m_steps[r])
          if ((m_owner[next] == Seeds::none || m_owner[next] == seed) && enter(next, cost))
            predecessors[next] = r;
        const double distance = distances[r];
        for (const Index source : path)
          enter(source, -distance);
      });
    return left == 0;
  }

  std::vector<std::vector<Step>> m_steps;    // by region
  const Seeds& m_seeds;                      // of the regions
  std::vector<std::vector<Index>> m_members; // by seed: its regions
  std::vector<Index> m_owner; // by region: the seed that it or a path through it belongs to
  Index m_failed = 0;
};

/// The partition with the parts of each seed joined.
inline Partition joined(const Partition& regions, const Seeds& of_regions)
{
  std::vector<std::uint64_t> labels(regions.size());
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const Seeds::Index seed = of_regions.of[regions[f]];
    labels[f] = seed == Seeds::none ? regions[f] : (std::uint64_t(1) << 32) | seed;
  }
  return Partition::from_labels(labels);
}

/// The regions, split if they have faces of several seeds, and joined if their seeds are equal: one
/// region for each seed. If there is no path of regions for a seed, one of faces is searched.
/// \throws Invalid_input if the faces of a seed cannot be joined
inline Partition apply_seeds(const Surface& surface, const Partition& regions,
                             const Seeds& of_faces)
{
  Partition split = split_at_seeds(surface, regions, of_faces);
  const Seeds of_split = seeds_of_regions(split, of_faces);
  if (const auto of_joined = Seed_joining(surface, split, of_split).join())
    return joined(split, *of_joined);

  const Partition faces = Partition::into_single_elements(regions.size());
  Seed_joining joining(surface, faces, of_faces);
  const auto connected = joining.join();
  if (!connected)
    throw Invalid_input(
      "the faces of seed " + std::to_string(joining.failed_seed()) +
      " cannot be joined: other components, constrained edges or other seeds are between them");
  split = split_at_seeds(surface, regions, *connected);
  return joined(split, seeds_of_regions(split, *connected));
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// First regions as seeds change them, and the seeds of regions.
struct Requested_regions
{
  Partition regions; ///< of the faces
  Seeds seeds;       ///< of the regions

  bool is_fixed(Partition::Index region) const
  {
    return !seeds.empty() && seeds.of[region] != Seeds::none;
  }
};

/// \ingroup PkgRegionSegmentationData
/// splits regions that have faces of several seeds, and joins regions of equal seeds along the
/// cheapest path.
/// \throws Invalid_input if the faces of a seed cannot be joined, Invalid_method if `regions` is no
///         partition of the faces
inline Requested_regions requested_regions(const Surface& surface, const Partition& regions,
                                           const Seeds& seeds)
{
  internal::check_regions(regions, surface.number_of_faces());
  if (seeds.empty())
    return {regions, Seeds()};
  Requested_regions result{internal::apply_seeds(surface, regions, seeds), Seeds()};
  result.seeds = internal::seeds_of_regions(result.regions, seeds);
  return result;
}

/// \ingroup PkgRegionSegmentationData
/// merges the graph of requested regions by a policy until `number` are left: regions of different
/// seeds never, crumbs first.
///
/// \tparam Graph a `Region_adjacency_graph` of `requested.regions`
/// \tparam Policy a model of `MergingPolicy`, or `Policy_phases`
/// \param surface that of the regions
/// \param requested the regions, which seeds and constraints have changed
/// \param graph is merged
/// \param policy determines the order of merges
/// \param number of regions to be left; with 1 there is a tree for all numbers
/// \param execution `Execution()`, or the stage of the merges (`execution.stage("merging")`)
/// \returns the tree of the merges
template <typename Graph, typename Policy>
Merge_tree merge_requested_regions(const Surface& surface, const Requested_regions& requested,
                                   Graph& graph, Policy policy, std::size_t number,
                                   const Execution& execution)
{
  auto of_crumbs = internal::merges_of_crumbs(surface, requested.regions);
  of_crumbs.erase(std::remove_if(of_crumbs.begin(), of_crumbs.end(),
                                 [&](const auto& pair) { return requested.is_fixed(pair.first); }),
                  of_crumbs.end());
  internal::Merger<Graph> merger(graph, requested.seeds, number, execution);
  merger.merge_first(of_crumbs);
  merger.run(policy);
  return merger.take_tree();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
