// SPDX-License-Identifier: GPL-3.0-or-later

#include "Trained_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace train_merge_cost {

namespace {

/// Adds networks with the inputs \f$y'_i = f'_i (x_i - c'_i)\f$ to one with the inputs \f$y_i = f_i
/// (x_i - c_i)\f$, as functions of the latter: \f$y'_i = f'_i / f_i y_i + f'_i (c_i - c'_i)\f$.
class Network_sum
{
public:
  explicit Network_sum(const std::vector<Model::Input>& inputs) { m_sum.inputs = inputs; }

  void add(const Integer_network& other, double share)
  {
    for (const Model::Unit& unit : other.units)
      m_sum.units.push_back({std::int32_t(rounded(unit.bias + offset(other, unit.weights))),
                             std::int32_t(rounded(share * unit.output_weight)),
                             scaled(other, unit.weights)});
    for (std::size_t i = 0; i < m_sum.inputs.size(); ++i)
      m_direct[i] += share * ratio(other, i) * other.direct_weights[i];
    constexpr int bits = Model::activation_bits + Model::output_weight_bits - Model::sum_bits;
    m_bias += share *
              (double(other.output_bias) + std::ldexp(offset(other, other.direct_weights), bits));
  }

  Integer_network take()
  {
    for (std::size_t i = 0; i < m_sum.inputs.size(); ++i)
      m_sum.direct_weights[i] = weight(m_direct[i]);
    m_sum.output_bias = rounded(m_bias);
    return std::move(m_sum);
  }

private:
  static std::int64_t rounded(double x) { return std::llround(x); }

  static std::int16_t weight(double x)
  {
    constexpr double bound = Model::weight_bound;
    return std::int16_t(rounded(std::max(-bound, std::min(bound, x))));
  }

  double ratio(const Integer_network& other, std::size_t i) const
  {
    return double(other.inputs[i].factor) / double(m_sum.inputs[i].factor);
  }

  Model::Weights scaled(const Integer_network& other, const Model::Weights& weights) const
  {
    Model::Weights result{};
    for (std::size_t i = 0; i < m_sum.inputs.size(); ++i)
      result[i] = weight(ratio(other, i) * weights[i]);
    return result;
  }

  /// The sum of weight * f' (c - c'), in 2^-sum_bits.
  double offset(const Integer_network& other, const Model::Weights& weights) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < m_sum.inputs.size(); ++i)
      sum += weights[i] * std::ldexp(double(m_sum.inputs[i].center - other.inputs[i].center) *
                                       other.inputs[i].factor,
                                     -Model::factor_bits);
    return sum;
  }

  Integer_network m_sum;
  std::array<double, Merge_features::NUMBER_OF_FEATURES> m_direct{};
  double m_bias = 0;
};

} // namespace

Trained_model mean_of(const std::vector<Trained_model>& models)
{
  const double share = 1 / double(models.size());
  std::vector<Tree_node> nodes;
  std::vector<Model::Trees::Leaves> all_leaves;
  Network_sum networks(models.front().network.inputs);
  for (const Trained_model& each : models) {
    for (Tree_node node : each.trees.nodes()) {
      node.condition.tree = std::uint16_t(node.condition.tree + all_leaves.size());
      nodes.push_back(node);
    }
    for (Model::Trees::Leaves leaves : each.trees.leaves) {
      for (std::int32_t& leaf : leaves)
        leaf = std::int32_t(std::lround(share * leaf));
      all_leaves.push_back(leaves);
    }
    networks.add(each.network, share);
  }
  return {Integer_trees(std::move(nodes), std::move(all_leaves)), networks.take()};
}

} // namespace train_merge_cost
