// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_REQUESTED_REGIONS_H
#define CGAL_REGION_SEGMENTATION_GRAPH_REQUESTED_REGIONS_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The graph of faces on which paths between the faces of a seed are searched. A step from face i
/// to face j costs |c_i - c_j| (1 + 80 d), c the centroids, d the deviation in radians if the edge
/// is concave, else 0. There are no steps across constrained edges, nor between two regions with a
/// constrained edge between them.
inline Dual_graph steps_of_seeds(const Surface& surface, const Partition& regions)
{
  constexpr double concave_weight = 80;
  const auto regions_of = [&](std::size_t a) {
    return std::minmax({regions[surface.lower_face(a)], regions[surface.higher_face(a)]});
  };
  std::set<std::pair<Partition::Index, Partition::Index>> barred;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (const auto [r, s] = regions_of(a); r != s && surface.has_flag(a, Surface::CONSTRAINED))
      barred.insert({r, s});
  return Dual_graph(
    surface,
    [&](std::size_t a) {
      return !surface.has_flag(a, Surface::CONSTRAINED) && barred.count(regions_of(a)) == 0;
    },
    [&](std::size_t a) {
      return norm(surface.centroid(surface.lower_face(a)) -
                  surface.centroid(surface.higher_face(a))) *
             (1 + concave_weight * surface.concave_deviation(a));
    });
}

/// Extends a seed to the faces on the cheapest paths that connect its faces and meet no other seed.
/// Returns whether there are such paths. Dijkstra's algorithm starts from the first face of the
/// seed; the faces of a path to another one are further sources from then on.
inline bool connect_seed(const Dual_graph& steps, const std::vector<Partition::Index>& faces,
                         std::vector<Seeds::Index>& seed_of)
{
  using Index = Partition::Index;
  const Index first = faces.front(), seed = seed_of[first];
  if (faces.size() == 1)
    return true;
  std::vector<double> distances(seed_of.size(), std::numeric_limits<double>::infinity());
  // A face that is connected to the seed is its own predecessor.
  std::vector<Index> predecessors(seed_of.size()), path;
  predecessors[first] = first;
  std::size_t left = faces.size() - 1;
  find_shortest_paths(
    std::vector<Index>{first}, distances,
    [&](Index f) {
      path.clear();
      if (seed_of[f] == seed && predecessors[f] != f) {
        --left;
        for (; predecessors[f] != f; f = std::exchange(predecessors[f], f)) {
          seed_of[f] = seed;
          path.push_back(f);
        }
      }
      return left > 0;
    },
    [&](Index f, const auto& enter) {
      for (const auto& step : steps.steps(f))
        if ((seed_of[step.face] == Seeds::none || seed_of[step.face] == seed) &&
            enter(step.face, double(step.length)))
          predecessors[step.face] = f;
      const double distance = distances[f];
      for (const Index source : path)
        enter(source, -distance);
    });
  return left == 0;
}

/// Returns the regions after seeds are applied: there is one region for each seed, whose faces are
/// connected, and the regions without seeds remain. A face of a region with seeds belongs to the
/// nearest seed in its region, counted in edges; ties: by breadth-first search from the lower
/// faces.
///
/// O(F log F), and for each seed with several faces O(F), O(F log F) at worst.
/// \throws Invalid_input if the faces of a seed cannot be connected
inline Partition apply_seeds(const Surface& surface, const Partition& regions, const Seeds& seeds)
{
  using Index = Partition::Index;
  const Dual_graph steps = steps_of_seeds(surface, regions);
  std::vector<std::vector<Index>> faces_of(seeds.number());
  for (Index f = 0; f < seeds.of.size(); ++f)
    if (seeds.of[f] != Seeds::none)
      faces_of[seeds.of[f]].push_back(f);
  std::vector<Seeds::Index> seed_of = seeds.of;
  for (Index seed = 0; seed < seeds.number(); ++seed)
    if (!connect_seed(steps, faces_of[seed], seed_of))
      throw Invalid_input(
        "the faces of seed " + std::to_string(seeds.values[seed]) +
        " cannot be joined: other components, constrained edges or other seeds are between them");

  std::vector<Index> front;
  for (Index f = 0; f < seed_of.size(); ++f)
    if (seed_of[f] != Seeds::none)
      front.push_back(f);
  for (std::size_t i = 0; i < front.size(); ++i)
    for (const auto& step : steps.steps(front[i]))
      if (seed_of[step.face] == Seeds::none && regions[step.face] == regions[front[i]]) {
        seed_of[step.face] = seed_of[front[i]];
        front.push_back(step.face);
      }
  std::vector<std::uint64_t> labels(regions.size());
  for (std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = seed_of[f] == Seeds::none ? regions[f] : (std::uint64_t(1) << 32) | seed_of[f];
  return Partition::from_labels(labels);
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// The first regions after seeds were applied, and the seeds of these regions.
struct Requested_regions
{
  Partition regions; ///< of the faces
  Seeds seeds;       ///< of the regions

  /// Whether the region has a seed.
  bool is_fixed(Partition::Index region) const
  {
    return !seeds.empty() && seeds.of[region] != Seeds::none;
  }
};

/// \ingroup PkgRegionSegmentationData
/// connects equal seeds along the cheapest paths of faces, splits regions that have faces of
/// several seeds, and joins regions of equal seeds.
/// \throws Invalid_input if the faces of a seed cannot be joined, Invalid_method if `regions` is no
///         partition of the faces
inline Requested_regions requested_regions(const Surface& surface, const Partition& regions,
                                           const Seeds& seeds)
{
  internal::check_regions(regions, surface.number_of_faces());
  if (seeds.empty())
    return {regions, Seeds()};
  Requested_regions result{internal::apply_seeds(surface, regions, seeds), Seeds()};
  result.seeds.values = seeds.values;
  result.seeds.of.assign(result.regions.number_of_parts(), Seeds::none);
  for (std::size_t f = 0; f < regions.size(); ++f)
    if (seeds.of[f] != Seeds::none)
      result.seeds.of[result.regions[f]] = seeds.of[f];
  return result;
}

namespace internal {

/// The contact of a crumb with another component, across all their adjacencies.
struct Contact_of_crumb
{
  double length = 0;                                         ///< in total
  double distance = std::numeric_limits<double>::infinity(); ///< the least one of two centroids
  /// Of the longest adjacency, of equal ones the nearest: -length, distance, the two regions.
  std::tuple<double, double, Partition::Index, Partition::Index> longest{1, 0, 0, 0};
};

/// The contacts by crumb and component.
inline std::map<std::pair<Partition::Index, Partition::Index>, Contact_of_crumb>
contacts_of_crumbs(const Surface& surface, const Partition& regions)
{
  const Partition& component_of = surface.components();
  std::map<std::pair<Partition::Index, Partition::Index>, Contact_of_crumb> result;
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Surface::Index lower = surface.lower_face(a), higher = surface.higher_face(a);
    for (const auto& [f, g] : {std::pair(lower, higher), std::pair(higher, lower)}) {
      if (component_of[f] == component_of[g] || !surface.is_crumb(f))
        continue;
      const double distance = norm(surface.centroid(f) - surface.centroid(g));
      const std::tuple adjacency(-surface.length(a), distance, regions[f], regions[g]);
      Contact_of_crumb& contact = result[{component_of[f], component_of[g]}];
      contact.longest = (std::min)(contact.longest, adjacency);
      contact.length += surface.length(a);
      contact.distance = (std::min)(contact.distance, distance);
    }
  }
  return result;
}

/// Sets of components that are joined, and whether all components of a set are crumbs.
class Joined_components
{
public:
  using Index = Partition::Index;

  /// `regions` can be of several components, as a face of a machine part with a sliver on its
  /// border.
  Joined_components(const Surface& surface, const Partition& regions, const Partition& component_of)
    : m_sets(component_of.number_of_parts())
    , m_is_crumb(component_of.number_of_parts())
  {
    std::vector<Index> first_of(regions.number_of_parts(), Surface::none);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      m_is_crumb[component_of[f]] = surface.is_crumb(f);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      Index& first = first_of[regions[f]];
      if (first == Surface::none)
        first = component_of[f];
      unite(first, component_of[f]);
    }
  }

  bool is_crumb(Index component) { return m_is_crumb[m_sets.root(component)]; }

  /// Returns whether the two components were not joined before.
  bool unite(Index c, Index d)
  {
    const bool both = is_crumb(c) && is_crumb(d), is_new = m_sets.unite(c, d);
    m_is_crumb[m_sets.root(c)] = both;
    return is_new;
  }

private:
  Lowest_root_forest m_sets;
  std::vector<bool> m_is_crumb; // by root
};

/// The pairs of regions to be merged first, so that each crumb is one region and joins another
/// component: the smallest crumb first, each that component with which its adjacencies are longest
/// in total, of equal ones the nearest. Crumbs that join each other are joined to further
/// components until one of these is no crumb.
inline std::vector<std::pair<Partition::Index, Partition::Index>>
merges_of_crumbs(const Surface& surface, const Partition& regions)
{
  using Index = Partition::Index;
  std::vector<std::pair<Index, Index>> result;
  if (surface.number_of_crumbs() == 0)
    return result;
  const Partition& component_of = surface.components();
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a) {
    const Index f = surface.lower_face(a), g = surface.higher_face(a);
    if (surface.is_crumb(f) && component_of[f] == component_of[g] && regions[f] != regions[g])
      result.insert(result.end(), {{regions[f], regions[g]}, {regions[g], regions[f]}});
  }
  const std::vector<double> areas = part_areas(surface, component_of);
  std::vector<std::tuple<double, Index, double, double, Index, Index, Index>> ways; // in order
  for (const auto& [pair, contact] : contacts_of_crumbs(surface, regions))
    ways.push_back({areas[pair.first], pair.first, -contact.length, contact.distance, pair.second,
                    std::get<2>(contact.longest), std::get<3>(contact.longest)});
  std::sort(ways.begin(), ways.end());
  Joined_components joined(surface, regions, component_of);
  for (const auto& [area, crumb, length, distance, component, region, other] : ways)
    if (joined.is_crumb(crumb) && joined.unite(crumb, component))
      result.push_back({region, other});
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// merges the regions of a graph by a policy until `number` of them are left. Crumbs are merged
/// first. Regions of different seeds are never merged.
///
/// \tparam Graph a `Region_adjacency_graph` of `requested.regions`
/// \tparam Policy a model of `MergingPolicy`, or `Policy_phases`
/// \param surface that of the regions
/// \param requested the regions as seeds have changed them
/// \param graph is merged
/// \param policy determines the order of merges
/// \param number the number of regions at which merging ends; with 1 the tree has all numbers
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

#endif // CGAL_REGION_SEGMENTATION_GRAPH_REQUESTED_REGIONS_H
