// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MODEL_MERGE_MODEL_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MODEL_MERGE_MODEL_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A function from features to the logarithm of the odds of a merge: the mean of a sum of decision trees and a neural
/// network with one hidden layer.
///
/// Features, constants and results are integers, so that every processor computes the same: a feature x stands for
/// x / 2^9, a result y for y / 2^20.
///
/// The network, in real numbers: with y_i = f_i (x_i - c_i), clamped to [-4, 4] and rounded to 2^-8,
/// \f$b + \sum_i s_i y_i + \sum_j v_j h_j / (1 + |h_j|)\f$, \f$h_j = b_j + \sum_i w_{ji} y_i\f$.
///
/// The constants belong to others, such as the generated tables.
///
/// Complexity: O(number of trees * depth + number of features * number of units).
template <std::size_t number_of_features>
struct Merge_model
{
  using Feature = std::int16_t;
  using Features = std::array<Feature, number_of_features>;

  static constexpr int feature_bits = 9, result_bits = 20;

  static constexpr std::size_t maximum_number_of_leaves = 16;

  /// An inner node of a tree.
  struct Node
  {
    Feature threshold;
    std::uint8_t feature;
    /// Inner nodes of the same tree; or leaves, counted from `first_leaf`. The second one is taken from the threshold on.
    std::uint8_t branches[2];
  };
  static constexpr std::uint8_t first_leaf = 128;

  /// The root is node 0; a tree that is one leaf has a node with two equal branches.
  struct Tree
  {
    std::array<Node, maximum_number_of_leaves - 1> nodes;
    std::array<std::int32_t, maximum_number_of_leaves> leaves; ///< in 2^-result_bits
  };

  /// \name Bits of the fractions in the network
  /// @{
  static constexpr int input_bits = 8, weight_bits = 10, factor_bits = 16; ///< y; w and s; f
  static constexpr int activation_bits = 12, output_weight_bits = 14;      ///< h / (1 + |h|); v
  static constexpr int sum_bits = input_bits + weight_bits;
  /// @}
  static constexpr std::int32_t input_bound = 4 << input_bits;
  /// Of w and s, so that no sum exceeds 32 bits.
  static constexpr std::int32_t weight_bound = 8 << weight_bits;

  /// How a feature enters the network.
  struct Input
  {
    std::int32_t center; ///< c_i, in 2^-feature_bits
    std::int32_t factor; ///< f_i, in 2^(feature_bits - factor_bits - input_bits)
  };

  /// The inputs, filled up by zeros: sums of a constant multiple of 8 products of 16 bits are vectorized.
  static constexpr std::size_t padded_number = (number_of_features + 15) / 16 * 16;
  using Weights = std::array<std::int16_t, padded_number>;

  struct Unit
  {
    std::int32_t bias;          ///< b_j, in 2^-sum_bits
    std::int32_t output_weight; ///< v_j, in 2^-output_weight_bits
    Weights weights;            ///< w_ji, in 2^-weight_bits
  };

  struct Network
  {
    const Input* inputs; ///< one for each feature
    const Unit* units;
    std::size_t number_of_units;
    Weights direct_weights;   ///< s_i, in 2^-weight_bits
    std::int64_t output_bias; ///< b, in 2^-(activation_bits + output_weight_bits)
  };

  const Tree* trees;
  std::size_t number_of_trees;
  Network network;

  /// The logarithm of the odds that two regions belong to one part, in 2^-result_bits.
  std::int64_t operator()(const Features& x) const { return (sum_of_trees(x) + network_output(x)) / 2; }

  std::int64_t sum_of_trees(const Features& x) const
  {
    constexpr std::size_t in_step = 4;
    std::int64_t sum = 0;
    std::size_t t = 0;
    for (; t + in_step <= number_of_trees; t += in_step)
      sum += sum_in_step<in_step>(trees + t, x);
    for (; t < number_of_trees; ++t)
      sum += sum_in_step<1>(trees + t, x);
    return sum;
  }

  std::int64_t network_output(const Features& x) const
  {
    const Weights y = inputs_of(x);
    constexpr int output_bits = activation_bits + output_weight_bits;
    std::int64_t output = network.output_bias;
    output += std::int64_t(product(network.direct_weights, y)) * (1 << (output_bits - sum_bits));
    for (std::size_t j = 0; j < network.number_of_units; ++j) {
      const Unit& unit = network.units[j];
      output += std::int64_t(unit.output_weight) * activation(unit.bias + product(unit.weights, y));
    }
    return output / (1 << (output_bits - result_bits));
  }

private:
  /// Several trees are descended in step, so that their latencies overlap and one branch of the program is mispredicted
  /// for all: 1.6 instead of 2.9 us for 120 trees.
  template <std::size_t n>
  static std::int64_t sum_in_step(const Tree* trees, const Features& x)
  {
    std::array<std::uint8_t, n> places{};
    bool has_inner;
    do {
      has_inner = false;
      for (std::size_t i = 0; i < n; ++i) {
        const bool is_inner = places[i] < first_leaf;
        const Node& node = trees[i].nodes[is_inner ? places[i] : 0];
        const std::uint8_t next = node.branches[x[node.feature] >= node.threshold];
        places[i] = is_inner ? next : places[i];
        has_inner |= places[i] < first_leaf;
      }
    } while (has_inner);
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += trees[i].leaves[places[i] - first_leaf];
    return sum;
  }

  Weights inputs_of(const Features& x) const
  {
    Weights y{};
    for (std::size_t i = 0; i < number_of_features; ++i) {
      const Input& input = network.inputs[i];
      const std::int64_t scaled = std::int64_t(x[i] - input.center) * input.factor / (1 << factor_bits);
      y[i] = std::int16_t((std::max)(std::int64_t(-input_bound), (std::min)(std::int64_t(input_bound), scaled)));
    }
    return y;
  }

  static std::int32_t product(const Weights& w, const Weights& y)
  {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < padded_number; ++i)
      sum += std::int32_t(w[i]) * y[i];
    return sum;
  }

  /// h / (1 + |h|): one division of two numbers without rounding errors, so all processors agree.
  static std::int32_t activation(std::int32_t h)
  {
    const double exact = h;
    return std::int32_t((1 << activation_bits) * exact / ((1 << sum_bits) + std::abs(exact)));
  }
};

/// e^x up to a relative error of x^2 / 2^17, for |x| <= 64: by additions and multiplications alone, which every
/// processor rounds in the same way.
inline double portable_exp(double x)
{
  constexpr int number_of_squarings = 16;
  double y = 1 + x / (1 << number_of_squarings);
  for (int i = 0; i < number_of_squarings; ++i)
    y *= y;
  return y;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MODEL_MERGE_MODEL_H
