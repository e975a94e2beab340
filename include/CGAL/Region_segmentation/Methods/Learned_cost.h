// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LEARNED_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_LEARNED_COST_H

#include <CGAL/Region_segmentation/Methods/Learned_data.h>
#include <CGAL/Region_segmentation/Methods/Merge_features.h>
#include <CGAL/Region_segmentation/internal/model/Merge_model.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// What a learned model says of a section: the probability that two points, one in either region,
/// belong to one part for people, and what its two regions weigh.
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
/// The constants are those of the header `internal/model/learned_merge_model.h`. They were trained
/// on half of the Princeton benchmark and on furniture, see `doc/accuracy.md`. Since features are
/// rounded, constants are integers, and what follows uses only arithmetic operations whose rounding
/// is prescribed, the last bits of logarithms, which differ between libraries, do not decide.
class Merge_estimate
{
public:
  /// \tparam Graph a `Region_adjacency_graph` with the data of `Learned_annotator`
  template <typename Graph>
  Merge_estimate(const Merge_features::Model& model, const Graph& graph,
                 typename Graph::section_descriptor s)
    : m_features(Merge_features::of(graph, s))
    , m_log_odds(graph[s].length > 0 ? model(m_features) : never)
  {}

  const Merge_features::Values& features() const { return m_features; }

  /// p, in [0, 1].
  double probability() const
  {
    constexpr std::int64_t bound = 16;
    constexpr std::int64_t one = std::int64_t(1) << Merge_features::Model::result_bits;
    const std::int64_t clamped = (std::max)(-bound * one, (std::min)(bound * one, m_log_odds));
    return 1 / (1 + internal::portable_exp(-double(clamped) / double(one)));
  }

  /// The share of the pairs of points of the surface that have one point in either region, over 2:
  /// the product of the shares of the area.
  double share_of_pairs() const { return internal::portable_exp(log_share_of_pairs()); }

  double log_share_of_pairs() const
  {
    return feature(Merge_features::LOG_AREA_M) + feature(Merge_features::LOG_AREA_L);
  }

  /// A feature in its unit.
  double feature(Merge_features::Feature f) const
  {
    return double(m_features[f]) / (1 << Merge_features::Model::feature_bits);
  }

private:
  static constexpr std::int64_t never = -(std::int64_t(1) << 40);

  Merge_features::Values m_features;
  std::int64_t m_log_odds; // `never` where two components do not touch
};

/// \ingroup PkgRegionSegmentationPolicies
/// The order in which a learned model merges. A model of `SectionCost`, for graphs annotated by
/// `Learned_annotator`.
///
/// With p the probability that two points, one in either region, belong to one part, and w the
/// product of the shares of the area of the two regions, the cost is \f[ (1 - 2 p) (w / w_0)^e + c
/// \, v, \f] \f$w_0 = e^{-4.605}\f$ (0.01), \f$e\f$ the exponent of gains if p > 1/2, else that of
/// losses, \f$v\f$ the `Visibility_cost`. \f$w\f$ and \f$v\f$ are those of the rounded features. A
/// merge changes the expected Rand index distance by 2 w (1 - 2 p); but the lowest powers of w give
/// the best order.
struct Learned_cost
{
  using RegionData = Learned_region_data;
  using SectionData = Learned_section_data;

  const Merge_features::Model* model;  ///< which must exist as long as the cost
  double exponent_of_gains = 0.1;      ///< in [0, 1]
  double exponent_of_losses = 0.2;     ///< in [0, 1]
  double visibility_cost_weight = 0.1; ///< c

  explicit Learned_cost(const Merge_features::Model& model_)
    : model(&model_)
  {}

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    return of(Merge_estimate(*model, graph, s));
  }

  double of(const Merge_estimate& estimate) const
  {
    const double z = 1 - 2 * estimate.probability();
    const double exponent = z < 0 ? exponent_of_gains : exponent_of_losses;
    return z * internal::portable_exp(exponent *
                                      (estimate.log_share_of_pairs() - log_of_usual_share)) +
           visibility_cost_weight * estimate.feature(Merge_features::COST);
  }

private:
  static constexpr double log_of_usual_share = -4.605; // w_0 = 0.01
};

/// \ingroup PkgRegionSegmentationPolicies
/// What a merge is expected to cost: w (1 - 2 p), w and p as in `Learned_cost`; half the expected
/// change of the Rand index distance. A model of `SectionCost`, for graphs annotated by
/// `Learned_annotator`.
///
/// The sum of several merges is the cost of all.
struct Expected_merge_cost
{
  using RegionData = Learned_region_data;
  using SectionData = Learned_section_data;

  const Merge_features::Model* model; ///< which must exist as long as the cost

  explicit Expected_merge_cost(const Merge_features::Model& model_)
    : model(&model_)
  {}

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Merge_estimate estimate(*model, graph, s);
    return estimate.share_of_pairs() * (1 - 2 * estimate.probability());
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LEARNED_COST_H
