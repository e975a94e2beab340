// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SPECTRAL_PARTITIONER_H
#define CGAL_REGION_SEGMENTATION_METHODS_SPECTRAL_PARTITIONER_H

/// \file Spectral_partitioner.h
/// Requires Eigen 3, and uses Spectra 1 if it is installed; so it is not part of
/// region_segmentation.h.

#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/internal/concepts/check_merging.h>
#include <CGAL/Region_segmentation/internal/concepts/check_graph_data.h>
#include <CGAL/Region_segmentation/internal/cuts/normalized_cut.h>
#include <CGAL/Region_segmentation/merge_regions.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The `Visibility_cost` \f$c\f$ whose \f$e^{-c}\f$ is an affinity: proportional to the length of
/// the section, so that the affinity of two sets of regions, a sum over sections, is one over the
/// length of their border. The depth of the valley counts squared. The areas of the regions do not
/// count, since a normalized cut itself balances the sizes of the parts.
struct Additive_visibility_cost : Visibility_cost
{
  Additive_visibility_cost()
  {
    depth_exponent = 2;
    depth_offset = 0.05;
    length_exponent = 0.5; // L^2 / m to this power, with the area m cancelled: L
    area_exponent = -0.5;
    harmonic_share = 0;
  }
};

namespace internal {

/// A set of regions in space: its weight and the weighted sum of their points.
struct Weighted_points
{
  double weight = 0;
  Eigen::VectorXd sum;

  template <typename Nothing>
  void absorb(const Weighted_points& other, const Nothing&)
  {
    weight += other.weight;
    sum += other.sum;
  }
};

struct No_section_data
{
  void absorb(const No_section_data&) {}
};

/// The increase of the weighted sum of squared distances to the means when two sets are united
/// (Ward).
struct Growth_of_variance
{
  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Weighted_points &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    return a.weight * b.weight / (a.weight + b.weight) *
           (a.sum / a.weight - b.sum / b.weight).squaredNorm();
  }
};

template <typename RegionData>
using Has_area = decltype(std::declval<const RegionData&>().area);

/// The area of a region if its data has one, 1 otherwise; never 0.
template <typename RegionData>
double weight_of(const RegionData& region)
{
  if constexpr (satisfies<Has_area, RegionData>)
    return (std::max)(double(region.area), (std::numeric_limits<double>::min)());
  else
    return 1;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationPolicies
/// partitions a region graph by a relaxed normalized cut.
///
/// `#include <CGAL/Region_segmentation/Methods/Spectral_partitioner.h>`, which requires Eigen.
///
/// A section of cost \f$c\f$ has the affinity \f$w = e^{c_0 - c}\f$, \f$c_0\f$ the lowest cost; the
/// scale of the affinities does not matter, and \f$c_0\f$ keeps them in [0, 1]. Regions become
/// points by the \f$k + 3\f$ lowest solutions of \f$L y = \lambda D y\f$ (\f$D\f$ the sums of the
/// affinities of the regions, \f$L = D
/// - W\f$, \f$y^T D y = 1\f$), each coordinate \f$y / \sqrt{\lambda}\f$: the squared distance of
/// two regions is their commute time in a random traversal. Then the two adjacent sets of regions
/// are united whose union adds least to the sum of squared distances to the means, weighted by area
/// if the data of regions has a member `area`, until \f$k\f$ remain. So all segments are connected,
/// and nothing is random. Neither the signs of eigenvectors nor their choice in a common eigenspace
/// matter, except at the last value. (Of a value that many eigenvectors share, as in a graph of
/// many equal pieces, Spectra may miss some.)
///
/// Sections that are not mergeable, or whose cost is not a number, do not connect regions.
///
/// Complexity: O(R^3) by Eigen's dense solver; where Spectra is installed, and R is at least 64 and
/// four times the number of eigenvectors, a sparse factorization and a few hundred solutions
/// instead, a few ms for 800 regions; then O(k S log S). Deterministic as Eigen and Spectra are:
/// labels can differ between their versions and between machines where two unions are within
/// rounding of each other.
///
/// \tparam SectionCost a model of `SectionCost`
///
/// Source: normalized cuts \cgalCite{SM00}; commute times \cgalCite{QH07}; clusters \cgalCite{W63};
/// on meshes \cgalCite{LZ04}.
template <typename SectionCost = Additive_visibility_cost>
class Spectral_partitioner : public internal::Data_named_by<SectionCost>
{
public:
  /// `cost`: minus the logarithm of the affinity, up to a constant
  explicit Spectral_partitioner(SectionCost cost = SectionCost())
    : m_cost(std::move(cost))
  {}

  /// The segments of the regions.
  /// \pre `number_of_segments` is at least 1; no region was removed
  /// \post every segment is connected by mergeable sections; there are `number_of_segments` of
  ///       them, or as many as there are regions if those are fewer, or connected pieces of the
  ///       graph if those are more
  template <typename Graph>
  Partition operator()(const Graph& graph, std::size_t number_of_segments) const
  {
    static_assert(internal::check_section_cost<SectionCost, Graph>());
    CGAL_precondition(number_of_segments >= 1);
    CGAL_precondition(graph.number_of_regions() == graph.index_bound_of_regions());
    const Eigen::MatrixXd points = internal::commute_time_embedding<internal::Eigen_solver>(
      graph.number_of_regions(), affinities(graph), number_of_segments + additional_eigenvectors);

    Clusters clusters;
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      const double weight = internal::weight_of(graph[*range.first]);
      clusters.add_region({weight, weight * points.row(Eigen::Index(*range.first)).transpose()});
    }
    for_each_connection(
      graph, [&](auto s, double) { clusters.add_section(graph.source(s), graph.target(s)); });
    return merge_regions(clusters, Lowest_cost_first<internal::Growth_of_variance>(),
                         number_of_segments, Stop_at_count{number_of_segments})
      .partition_at_count(number_of_segments);
  }

private:
  static constexpr std::size_t additional_eigenvectors = 3; // beyond the number of segments
  using Clusters = Region_adjacency_graph<internal::Weighted_points, internal::No_section_data>;

  /// Calls `f(section, cost)` in the order of the sections.
  template <typename Graph, typename F>
  void for_each_connection(const Graph& graph, const F& f) const
  {
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      if (graph.is_mergeable(*range.first)) {
        const double cost = m_cost(graph, *range.first);
        if (!std::isnan(cost))
          f(*range.first, cost);
      }
  }

  template <typename Graph>
  std::vector<internal::Affinity> affinities(const Graph& graph) const
  {
    double lowest = (std::numeric_limits<double>::max)();
    for_each_connection(graph, [&](auto, double cost) { lowest = (std::min)(lowest, cost); });
    std::vector<internal::Affinity> result;
    for_each_connection(graph, [&](auto s, double cost) {
      result.push_back({graph.source(s), graph.target(s), std::exp(lowest - cost)});
    });
    return result;
  }

  SectionCost m_cost;
};

/// \ingroup PkgRegionSegmentationMethods
/// A method that partitions the graph of superfacets by `Spectral_partitioner` in place of merging
/// them one pair at a time. A model of `SegmentationMethod` that requires the number of segments
/// and takes no seeds.
template <typename SectionCost = Additive_visibility_cost>
struct Spectral_partitioning
{
  Spectral_partitioner<SectionCost> partitioner;
  Visibility_merging superfacets; ///< its superfacets and their annotation are used

  using Prepared = Visibility_merging::Prepared;

  Prepared prepare(const Surface& surface, const Execution& execution = Execution()) const
  {
    return superfacets.prepare(surface, execution);
  }

  /// \throws Invalid_input if there are seeds
  Segmentation merge(const Surface& surface, const Prepared& prepared, const Request& request,
                     const Execution& execution = Execution()) const
  {
    if (!request.seeds.empty())
      throw Invalid_input("Spectral_partitioning takes no seeds");
    const Request of_shape = prepared.intrinsic.request(surface, request);
    const Partition regions = requested_regions(prepared.shape(surface), prepared.regions, of_shape)
                                .regions;
    const auto graph = superfacets.annotated_graph(surface, prepared, regions, of_shape.constraints,
                                                   execution.stage("graph"));
    execution.stage("merging");
    const Partition segments = partitioner(graph, request.number_of_segments);
    const std::vector<Partition::Index> numbers = prepared.intrinsic.new_numbers(regions);
    std::vector<Partition::Index> segment_of(numbers.size());
    for (std::size_t r = 0; r < numbers.size(); ++r)
      segment_of[numbers[r]] = segments[r];
    return {prepared.intrinsic.of_given(regions, numbers), Partition::from_labels(segment_of),
            Merge_tree(numbers.size())};
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SPECTRAL_PARTITIONER_H
