// SPDX-License-Identifier: GPL-3.0-or-later

#include "Network.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace train_merge_cost {

namespace {

constexpr double pi = 3.14159265358979323846;

/// In [0, 1), from the bits of the generator: the distributions of the standard library are not
/// prescribed.
double uniform(std::mt19937& random)
{
  return std::ldexp(double(random()), -32);
}

/// Fisher and Yates.
void shuffle(std::vector<std::size_t>& items, std::mt19937& random)
{
  for (std::size_t i = items.size(); i > 1; --i)
    std::swap(items[i - 1], items[std::size_t(uniform(random) * double(i))]);
}

using Inputs = decltype(Model::inputs);

/// Features as standardized inputs, as the integer network computes them.
class Standardization
{
public:
  explicit Standardization(const Training_rows& rows)
  {
    constexpr std::size_t n = Model::number_of_features;
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(n), variance = mean;
    for (const auto& x : rows.features)
      for (std::size_t i = 0; i < n; ++i)
        mean[i] += x[i];
    mean /= double(rows.size());
    for (const auto& x : rows.features)
      for (std::size_t i = 0; i < n; ++i)
        variance[i] += (x[i] - mean[i]) * (x[i] - mean[i]);
    for (std::size_t i = 0; i < n; ++i) {
      const double deviation = std::max(least_deviation,
                                        std::sqrt(variance[i] / double(rows.size())));
      m_inputs[i] = {std::int32_t(std::lround(mean[i])),
                     std::int32_t(std::lround(
                       std::ldexp(1 / deviation, Model::factor_bits + Model::input_bits)))};
    }
  }

  const Inputs& inputs() const { return m_inputs; }

  Eigen::MatrixXf operator()(const Training_rows& rows) const
  {
    Eigen::MatrixXf result(m_inputs.size(), rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t i = 0; i < m_inputs.size(); ++i) {
        const double y = std::ldexp(double(rows.features[r][i] - m_inputs[i].center) *
                                      m_inputs[i].factor,
                                    -Model::factor_bits - Model::input_bits);
        constexpr double bound = Model::input_bound >> Model::input_bits;
        result(i, r) = float(std::max(-bound, std::min(bound, y)));
      }
    return result;
  }

private:
  static constexpr double least_deviation = 4; // steps of a feature

  Inputs m_inputs{};
};

/// Kingma and Ba 2015, with their constants.
class Adam
{
public:
  explicit Adam(std::size_t n)
    : m_first(Eigen::VectorXf::Zero(n))
    , m_second(Eigen::VectorXf::Zero(n))
  {}

  Eigen::VectorXf step(const Eigen::VectorXf& gradient, double rate)
  {
    ++m_steps;
    m_first = 0.9f * m_first + 0.1f * gradient;
    m_second = 0.999f * m_second + 0.001f * gradient.cwiseAbs2();
    const float a = float(rate / (1 - std::pow(0.9, m_steps))),
                b = float(1 / (1 - std::pow(0.999, m_steps)));
    return -a * m_first.array() / ((b * m_second.array()).sqrt() + 1e-8f);
  }

private:
  Eigen::VectorXf m_first, m_second;
  int m_steps = 0;
};

std::int64_t fixed(double x, int bits)
{
  return std::int64_t(std::llround(std::ldexp(x, bits)));
}

std::int16_t weight(double x)
{
  constexpr std::int64_t bound = Model::weight_bound;
  return std::int16_t(std::max(-bound, std::min(bound, fixed(x, Model::weight_bits))));
}

/// Adds a share of a network: `share` * its output.
void add(Model& result, const Network& network, double share)
{
  for (std::size_t j = 0; j < network.units(); ++j) {
    Model::Unit unit{
      std::int32_t(fixed(network.hidden_biases()[j], Model::sum_bits)),
      std::int32_t(fixed(share * network.output_weights()[j], Model::output_weight_bits)),
      {}};
    for (std::size_t i = 0; i < network.inputs(); ++i)
      unit.weights[i] = weight(network.hidden_weights()(j, i));
    result.units.push_back(unit);
  }
}

/// The mean of networks with the same inputs.
Model mean_of(const std::vector<Network>& networks, const Inputs& inputs)
{
  Model result;
  result.inputs = inputs;
  const double share = 1 / double(networks.size());
  Eigen::VectorXf direct = Eigen::VectorXf::Zero(inputs.size());
  double bias = 0;
  for (const Network& network : networks) {
    add(result, network, share);
    direct += float(share) * network.direct_weights();
    bias += share * network.bias();
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
    result.direct_weights[i] = weight(direct[i]);
  result.output_bias = fixed(bias, Model::activation_bits + Model::output_weight_bits);
  return result;
}

} // namespace

Network::Network(std::size_t inputs, std::size_t units, unsigned seed)
  : parameters(Eigen::VectorXf::Zero(units * (inputs + 2) + inputs + 1))
  , m_inputs(inputs)
  , m_units(units)
{
  std::mt19937 random(seed);
  const std::size_t weights = units * inputs;
  for (std::size_t i = 0; i < weights; ++i)
    parameters[i] = float((2 * uniform(random) - 1) * std::sqrt(3.0 / double(inputs)));
  for (std::size_t j = 0; j < units; ++j)
    parameters[weights + units + j] = float((2 * uniform(random) - 1) *
                                            std::sqrt(3.0 / double(units)));
}

Eigen::RowVectorXf Network::operator()(const Eigen::MatrixXf& x) const
{
  const Eigen::ArrayXXf h = ((hidden_weights() * x).colwise() + hidden_biases()).array();
  const Eigen::MatrixXf y = h / (1 + h.abs());
  return ((output_weights().transpose() * y + direct_weights().transpose() * x).array() + bias())
    .matrix();
}

Eigen::VectorXf Network::gradient(const Eigen::MatrixXf& x, const Eigen::RowVectorXf& probabilities,
                                  const Eigen::RowVectorXf& weights) const
{
  const Eigen::ArrayXXf h = ((hidden_weights() * x).colwise() + hidden_biases()).array();
  const Eigen::MatrixXf y = h / (1 + h.abs());
  const Eigen::ArrayXXf slope = (1 + h.abs()).square().inverse();
  const Eigen::RowVectorXf
    output = ((output_weights().transpose() * y + direct_weights().transpose() * x).array() +
              bias())
               .matrix();
  const Eigen::RowVectorXf error = (((1 + (-output.array()).exp()).inverse() -
                                     probabilities.array()) *
                                    weights.array())
                                     .matrix();
  const Eigen::MatrixXf hidden_error = ((output_weights() * error).array() * slope).matrix();

  Eigen::VectorXf result(parameters.size());
  const std::size_t weights_end = m_units * m_inputs;
  Eigen::Map<Eigen::MatrixXf>(result.data(), Eigen::Index(m_units),
                              Eigen::Index(m_inputs)) = hidden_error * x.transpose();
  result.segment(weights_end, m_units) = hidden_error.rowwise().sum();
  result.segment(weights_end + m_units, m_units) = y * error.transpose();
  result.segment(weights_end + 2 * m_units, m_inputs) = x * error.transpose();
  result[result.size() - 1] = error.sum();
  return result;
}

namespace {

Network train_network(const Eigen::MatrixXf& x, const Training_rows& rows,
                      const Network_options& options, unsigned seed)
{
  Network network(std::size_t(x.rows()), options.number_of_units, seed);
  Adam adam(std::size_t(network.parameters.size()));
  std::mt19937 random(seed + 1);
  const double mean_weight = std::accumulate(rows.weights.begin(), rows.weights.end(), 0.0) /
                             double(rows.size());
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const std::size_t size = std::min(options.batch, rows.size());
  const std::size_t batches = rows.size() / size, steps = options.epochs * batches;
  Eigen::MatrixXf batch(x.rows(), size);
  Eigen::RowVectorXf probabilities(size), weights(size);
  for (std::size_t step = 0; step < steps; ++step) {
    if (step % batches == 0)
      shuffle(order, random);
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t row = order[step % batches * size + i];
      batch.col(i) = x.col(row);
      probabilities[i] = rows.probabilities[row];
      weights[i] = float(rows.weights[row] / (mean_weight * double(size)));
    }
    const double rate = options.step * (1 + std::cos(pi * double(step) / double(steps))) / 2;
    const Eigen::VectorXf gradient = network.gradient(batch, probabilities, weights) +
                                     float(options.penalty) * network.parameters;
    network.parameters += adam.step(gradient, rate);
  }
  return network;
}

} // namespace

Model train_networks(const Training_rows& rows, const Network_options& options, unsigned seed)
{
  const Standardization standardization(rows);
  const Eigen::MatrixXf x = standardization(rows);
  std::vector<Network> networks;
  for (std::size_t k = 0; k < options.number_of_networks; ++k)
    networks.push_back(train_network(x, rows, options, seed + 1000 * unsigned(k)));
  return mean_of(networks, standardization.inputs());
}

} // namespace train_merge_cost
