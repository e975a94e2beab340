// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_NETWORK_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_NETWORK_H

#include "Training_rows.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace train_merge_cost {

struct Network_options
{
  std::size_t number_of_units = 16;
  std::size_t epochs = 12, batch = 128;
  double step = 4e-3;                 ///< of Adam at the start; it falls to 0 by a cosine
  double penalty = 3e-4;              ///< L2, of all weights
  std::size_t number_of_networks = 3; ///< their mean is one network with all their units
};

/// A neural network with one hidden layer and a direct way, as in `Merge_model`, in real numbers.
/// Inputs are standardized.
class Network
{
public:
  Network(std::size_t inputs, std::size_t units, unsigned seed);

  /// The parameters as one vector: w by units, b_j, v, s, b.
  Eigen::VectorXf parameters;

  /// The logarithms of the odds. `x`: a column for each row of data
  Eigen::RowVectorXf operator()(const Eigen::MatrixXf& x) const;

  /// The gradient of the sum of weights * logistic loss over the columns.
  Eigen::VectorXf gradient(const Eigen::MatrixXf& x, const Eigen::RowVectorXf& probabilities,
                           const Eigen::RowVectorXf& weights) const;

  std::size_t inputs() const { return m_inputs; }
  std::size_t units() const { return m_units; }

  Eigen::Map<const Eigen::MatrixXf> hidden_weights() const
  {
    return {parameters.data(), Eigen::Index(m_units), Eigen::Index(m_inputs)};
  }
  Eigen::Map<const Eigen::VectorXf> hidden_biases() const
  {
    return {parameters.data() + m_units * m_inputs, Eigen::Index(m_units)};
  }
  Eigen::Map<const Eigen::VectorXf> output_weights() const
  {
    return {parameters.data() + m_units * (m_inputs + 1), Eigen::Index(m_units)};
  }
  Eigen::Map<const Eigen::VectorXf> direct_weights() const
  {
    return {parameters.data() + m_units * (m_inputs + 2), Eigen::Index(m_inputs)};
  }
  float bias() const { return parameters[parameters.size() - 1]; }

private:
  std::size_t m_inputs, m_units;
};

/// Trains networks by Adam on the weighted logistic loss; returns their mean, with integer
/// constants and without a name. One thread; equal seeds give equal networks.
Model train_networks(const Training_rows& rows, const Network_options& options, unsigned seed);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_NETWORK_H
