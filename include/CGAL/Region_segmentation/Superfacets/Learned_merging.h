// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_LEARNED_MERGING_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_LEARNED_MERGING_H

#include <CGAL/Region_segmentation/Graph/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Graph/Number_from_expected_costs.h>
#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Superfacets/Merge_features.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Merge_model.h>
#include <CGAL/Region_segmentation/Superfacets/internal/learned_merge_model.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationAnnotators
/// fills the data of which `Merge_features` are made, those of `Visibility_annotator` included, of
/// graphs with `Learned_region_data` and `Learned_section_data`.
///
/// A fine patch of area \f$a\f$ (share of the surface), unit normal \f$N\f$ and centroid \f$c\f$
/// adds to its region
/// - \f$a N\f$ to the area vector, and
/// - \f$a\f$, \f$a c\f$ and \f$a (c c^T + \sigma a (I - N N^T))\f$ to the moments,
///   \f$\sigma = 1 / (6 \sqrt{3})\f$: those of an equilateral triangle of its area.
///
/// The perimeter is the sum of the lengths of the region's sections; borders of the mesh do not
/// count. The own visibility is the weight of the rays that start and end in the region. The log
/// thickness of a section is its length times the mean of the thicknesses of its two regions.
/// Coordinates are relative to the centroid of the first face, in units of \f$\sqrt{A}\f$. Each
/// region has the `Whole_shape` of all of them.
///
/// Complexity: O(P + S) beyond that of `Visibility_annotator`. Deterministic.
class Learned_annotator : public Visibility_annotator
{
public:
  using RegionData = Learned_region_data;
  using SectionData = Learned_section_data;

  /// Fills the data of `graph`.
  template <typename Graph>
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Region_rays& rays) const
  {
    Visibility_annotator::operator()(graph, surface, regions, rays);
    if (surface.area() == 0)
      return;
    for (Surface::Index r = 0; r < regions.number_of_parts(); ++r) {
      Learned_region_data& region = graph[r];
      region.area_vector = rays.shapes.regions[r].area_vector;
      region.moments = rays.shapes.regions[r].moments;
      region.squared_log_thickness = region.log_thickness * region.mean_log_thickness();
      region.own_visibility = region.visibility / 2;
      region.perimeter = 0;
    }
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      Learned_section_data& section = graph[*range.first];
      Learned_region_data &a = graph[graph.source(*range.first)],
                          &b = graph[graph.target(*range.first)];
      section.log_thickness = section.length * (a.mean_log_thickness() + b.mean_log_thickness()) /
                              2;
      for (Learned_region_data* region : {&a, &b}) {
        region->own_visibility -= section.visibility / 2;
        region->perimeter += section.length;
      }
    }
    const Whole_shape whole = whole_shape(graph);
    for (Surface::Index r = 0; r < regions.number_of_parts(); ++r)
      graph[r].whole = whole;
  }

private:
  template <typename Graph>
  static Whole_shape whole_shape(const Graph& graph)
  {
    Second_moments moments;
    double area_vectors = 0, outward = 0, distances = 0, openness = 1;
    double strongly_concave = 0, length = 0;
    // With the area vectors written as w n, n of length 1, these are the sums of the tensors w n n
    // and w n n n n. Their squared norms are the sums over all pairs of regions of the second and
    // fourth powers of the cosine between two normals, weighted by w.
    std::array<double, 9> squares{};
    std::array<double, 81> fourth_powers{};
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      const Learned_region_data& region = graph[*range.first];
      moments.add(region.moments);
      openness -= region.visibility / 2;
      const double weight = norm(region.area_vector);
      if (!(weight > 0))
        continue;
      area_vectors += weight;
      const Double_3 n = 1 / weight * region.area_vector;
      const std::array<double, 3> x = {n.x, n.y, n.z};
      for (std::size_t i = 0; i < 9; ++i)
        squares[i] += weight * x[i % 3] * x[i / 3];
      for (std::size_t i = 0; i < 81; ++i)
        fourth_powers[i] += weight * x[i % 3] * x[i / 3 % 3] * x[i / 9 % 3] * x[i / 27];
    }
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      const Learned_region_data& region = graph[*range.first];
      const Double_3 c = region.moments.centroid() - moments.centroid();
      outward += dot(region.area_vector, c);
      distances += norm(region.area_vector) * norm(c);
    }
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      strongly_concave += graph[*range.first].strongly_concave_length;
      length += graph[*range.first].length;
    }
    double squared_sines = 0; // the sum of sin^2(2 alpha) / 4 over all pairs
    for (const double s : squares)
      squared_sines += s * s;
    for (const double f : fourth_powers)
      squared_sines -= f * f;
    const auto ratio = [](double a, double b) { return b > 0 ? a / b : 0; };
    return {-std::log((std::max)(1e-12, CGAL_PI * moments.covariance().trace())),
            ratio(area_vectors, moments.weight),
            ratio(strongly_concave, length),
            1 - 4 * ratio(squared_sines, area_vectors * area_vectors),
            ratio(outward, distances),
            openness};
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// The probability that a learned model gives to a merge, and the features that costs need beside
/// it.
///
/// The model is a function of `Merge_features`, integers \f$x_i\f$: a neural network with one
/// hidden layer. With the inputs \f$y_i = f_i (x_i - c_i)\f$, in \f$2^{-8}\f$, rounded toward 0
/// and clamped to [-4, 4], the logarithm of the odds is \f$b + \sum_i s_i y_i + \sum_j v_j h_j / (1
/// + |h_j|)\f$, \f$h_j = b_j + \sum_i w_{ji} y_i\f$. \f$s, w\f$ are integers in \f$2^{-10}\f$,
/// \f$f\f$ in \f$2^{-16}\f$ of the units of y and x, \f$b_j\f$ in \f$2^{-18}\f$, \f$h / (1 +
/// |h|)\f$ in \f$2^{-12}\f$, rounded toward 0, \f$v\f$ in \f$2^{-14}\f$, and \f$b\f$ and the sum
/// in \f$2^{-26}\f$; the result is rounded toward 0 to \f$2^{-20}\f$.
///
/// \f$p = 1 / (1 + e^{-o})\f$, \f$o\f$ the logarithm of the odds clamped to [-16, 16]. An
/// exponential \f$e^x\f$ is computed as \f$(1 + x / 2^{16})^{2^{16}}\f$ by squaring 16 times, here
/// and in the costs.
///
/// The model of `Learned_merging()` was trained on half of the Princeton benchmark and on
/// furniture, see `doc/accuracy.md`. Since features are rounded, constants are integers, and all
/// later operations have a prescribed rounding, costs do not depend on the last bits of logarithms,
/// which differ between libraries.
struct Merge_estimate
{
  double probability;        ///< p: the probability that two points, one in either region, belong
                             ///< to one part for people; the least one if the section has no length
  double log_share_of_pairs; ///< ln w, w the product of the shares of the area of the two regions
  double visibility_cost;    ///< v: the `Visibility_cost`, rounded as a feature

  /// \tparam Graph a `Region_adjacency_graph` with the data of `Learned_annotator`
  template <typename Graph>
  Merge_estimate(const Merge_model& model, const Graph& graph, typename Graph::section_descriptor s)
  {
    constexpr double bound = 16;
    const Merge_features::Values x = Merge_features::of(graph, s);
    const double log_odds = graph[s].length > 0
                              ? std::ldexp(double(model(x)), -Merge_model::result_bits)
                              : -bound;
    probability = 1 /
                  (1 + internal::portable_exp(-(std::max)(-bound, (std::min)(bound, log_odds))));
    const auto feature = [&](std::size_t i) {
      return std::ldexp(double(x[i]), -Merge_model::feature_bits);
    };
    log_share_of_pairs = feature(Merge_features::log_area_m) + feature(Merge_features::log_area_l);
    visibility_cost = feature(Merge_features::cost);
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// The order in which a learned model merges. A model of `SectionCost`, for graphs annotated by
/// `Learned_annotator`.
///
/// With \f$p\f$ the probability that two points, one in either region, belong to one part, and
/// \f$w\f$ the product of the shares of the area of the two regions, the cost is
/// \f[ (1 - 2 p) (w / w_0)^e + c \, v, \f]
/// \f$w_0 = e^{-4.605}\f$ (0.01), \f$e\f$ the exponent of gains if p > 1/2, else that of losses,
/// \f$v\f$ the `Visibility_cost`. \f$w\f$ and \f$v\f$ are those of the rounded features. A
/// merge changes the expected Rand index distance by \f$2 w (1 - 2 p)\f$; lower powers of \f$w\f$
/// give a better order of merges.
struct Learned_cost
{
  using RegionData = Learned_region_data;
  using SectionData = Learned_section_data;

  std::shared_ptr<const Merge_model> model; ///< copies share it
  double exponent_of_gains = 0.1;           ///< in [0, 1]
  double exponent_of_losses = 0.2;          ///< in [0, 1]
  double visibility_cost_weight = 0.1;      ///< c, at least 0

  explicit Learned_cost(Merge_model model_)
    : model(std::make_shared<const Merge_model>(std::move(model_)))
  {}

  /// \throws Invalid_method if a constant is not in its range
  void check_constants() const
  {
    internal::check_constant("Learned_cost: exponent_of_gains", exponent_of_gains, 0, 1);
    internal::check_constant("Learned_cost: exponent_of_losses", exponent_of_losses, 0, 1);
    internal::check_constant("Learned_cost: visibility_cost_weight", visibility_cost_weight, 0);
  }

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Merge_estimate estimate(*model, graph, s);
    const double z = 1 - 2 * estimate.probability;
    const double exponent = z < 0 ? exponent_of_gains : exponent_of_losses;
    return z *
             internal::portable_exp(exponent * (estimate.log_share_of_pairs - log_of_usual_share)) +
           visibility_cost_weight * estimate.visibility_cost;
  }

  /// w (1 - 2 p): what a merge is expected to cost, half the expected change of the Rand index
  /// distance. The sum over several merges is the expected cost of all of them.
  template <typename Graph>
  double recorded_cost(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Merge_estimate estimate(*model, graph, s);
    return internal::portable_exp(estimate.log_share_of_pairs) * (1 - 2 * estimate.probability);
  }

private:
  static constexpr double log_of_usual_share = -4.605; // ln w_0, w_0 = 0.01
};

/// \ingroup PkgRegionSegmentationMethods
/// The default method: it merges superfacets as `Visibility_merging` does until few regions are
/// left, and these at the lowest `Learned_cost` first. A model of `SegmentationMethod`.
///
/// The costs of the later merges in the tree are `Learned_cost::recorded_cost()`; those of the
/// earlier merges are `Visibility_cost`, which has another unit.
struct Learned_merging
  : Superfacet_merging<
      Learned_annotator,
      Policy_phases<Lowest_cost_first<Visibility_cost>, Lowest_cost_first<Visibility_cost>,
                    Lowest_cost_first<Learned_cost>>,
      Number_from_expected_costs>
{
  static constexpr bool fills_voids = true; ///< see `SegmentationMethod`

  /// The number of regions from which on the learned model merges, which it was trained for, and
  /// the largest number of segments that is chosen.
  static constexpr std::size_t most_learned_regions = 60;

  /// `model`: that of the package, or one of a user's own
  explicit Learned_merging(Merge_model model = internal::learned_merge_model())
    : Superfacet_merging{Learned_annotator(),
                         {std::get<0>(Visibility_merging().policy),
                          {Lowest_cost_first(Visibility_cost()), most_learned_regions},
                          {Lowest_cost_first(Learned_cost(std::move(model))), 1}},
                         Number_from_expected_costs()}
  {
    chooser.maximum_number = most_learned_regions;
    chooser.minimum_number = 1;
  }

  /// The model, which copies of the method share.
  const Merge_model& model() const { return *std::get<2>(policy).first.cost().model; }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Learned_merging>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_LEARNED_MERGING_H
