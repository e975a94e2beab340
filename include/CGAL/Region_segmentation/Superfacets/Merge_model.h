// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_MERGE_MODEL_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_MERGE_MODEL_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// A function from features to the logarithm of the odds of a merge: a neural network with one
/// hidden layer.
///
/// Features, constants and results are integers, so that every processor computes the same: a
/// feature x stands for x / 2^9, a result y for y / 2^20.
///
/// In real numbers: with y_i = f_i (x_i - c_i), clamped to [-4, 4] and rounded to 2^-8,
/// \f$b + \sum_i s_i y_i + \sum_j v_j h_j / (1 + |h_j|)\f$, \f$h_j = b_j + \sum_i w_{ji} y_i\f$.
///
/// A default constructed model, whose constants are 0, gives every merge the odds 1.
///
/// Complexity: O(number of features * number of units).
struct Merge_model
{
  static constexpr std::size_t number_of_features = 37;
  using Feature = std::int16_t;
  using Features = std::array<Feature, number_of_features>;

  static constexpr int feature_bits = 9, result_bits = 20;

  /// \name Bits after the binary point of y, w and s, f, h / (1 + |h|), v
  /// @{
  static constexpr int input_bits = 8, weight_bits = 10, factor_bits = 16;
  static constexpr int activation_bits = 12, output_weight_bits = 14;
  static constexpr int sum_bits = input_bits + weight_bits;
  /// @}
  static constexpr std::int32_t input_bound = 4 << input_bits;
  /// The largest absolute value of w and s with which no sum exceeds 32 bits.
  static constexpr std::int32_t weight_bound = 8 << weight_bits;

  /// The constants by which a feature becomes an input of the network.
  struct Input
  {
    std::int32_t center; ///< c_i, in 2^-feature_bits
    std::int32_t factor; ///< f_i, in 2^(feature_bits - factor_bits - input_bits)
  };

  using Weights = std::array<std::int16_t, number_of_features>;

  struct Unit
  {
    std::int32_t bias;          ///< b_j, in 2^-sum_bits
    std::int32_t output_weight; ///< v_j, in 2^-output_weight_bits
    Weights weights;            ///< w_ji, in 2^-weight_bits
  };

  /// Tells the model and its version: labels of a method change only with this name.
  std::string name;
  std::array<Input, number_of_features> inputs{};
  std::vector<Unit> units;
  Weights direct_weights{};     ///< s_i, in 2^-weight_bits
  std::int64_t output_bias = 0; ///< b, in 2^-(activation_bits + output_weight_bits)

  /// The logarithm of the odds that two regions belong to one part, in 2^-result_bits.
  std::int64_t operator()(const Features& x) const
  {
    const Weights y = inputs_of(x);
    constexpr int output_bits = activation_bits + output_weight_bits;
    std::int64_t output = output_bias;
    output += std::int64_t(product(direct_weights, y)) * (1 << (output_bits - sum_bits));
    for (const Unit& unit : units)
      output += std::int64_t(unit.output_weight) * activation(unit.bias + product(unit.weights, y));
    return output / (1 << (output_bits - result_bits));
  }

private:
  Weights inputs_of(const Features& x) const
  {
    Weights y{};
    for (std::size_t i = 0; i < number_of_features; ++i) {
      const std::int64_t scaled = std::int64_t(x[i] - inputs[i].center) * inputs[i].factor /
                                  (1 << factor_bits);
      y[i] = std::int16_t(
        (std::max)(std::int64_t(-input_bound), (std::min)(std::int64_t(input_bound), scaled)));
    }
    return y;
  }

  static std::int32_t product(const Weights& w, const Weights& y)
  {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < number_of_features; ++i)
      sum += std::int32_t(w[i]) * y[i];
    return sum;
  }

  /// Computes h / (1 + |h|) by a single division of two exact numbers, which all processors round
  /// in the same way.
  static std::int32_t activation(std::int32_t h)
  {
    const double exact = h;
    return std::int32_t((1 << activation_bits) * exact / ((1 << sum_bits) + std::abs(exact)));
  }
};

namespace internal {

/// Computes e^x with a relative error of at most x^2 / 2^17, for |x| <= 64, by additions and
/// multiplications alone, which all processors round in the same way.
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

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_MERGE_MODEL_H
