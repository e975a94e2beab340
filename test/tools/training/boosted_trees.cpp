// SPDX-License-Identifier: GPL-3.0-or-later

#include "boosted_trees.h"

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <xgboost/c_api.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace train_merge_cost {

namespace {

using boost::property_tree::ptree;

void check(int status)
{
  if (status != 0)
    throw std::runtime_error(std::string("XGBoost: ") + XGBGetLastError());
}

/// The rows as XGBoost holds them; the weights have the mean 1.
class Matrix
{
public:
  explicit Matrix(const Training_rows& rows)
  {
    std::vector<float> values;
    values.reserve(rows.size() * Merge_features::NUMBER_OF_FEATURES);
    for (const Merge_features::Values& x : rows.features)
      values.insert(values.end(), x.begin(), x.end());
    check(XGDMatrixCreateFromMat(values.data(), rows.size(), Merge_features::NUMBER_OF_FEATURES,
                                 NAN, &m_handle));
    std::vector<float> weights = rows.weights;
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) /
                        double(weights.size());
    for (float& w : weights)
      w = float(w / mean);
    check(XGDMatrixSetFloatInfo(m_handle, "label", rows.probabilities.data(), rows.size()));
    check(XGDMatrixSetFloatInfo(m_handle, "weight", weights.data(), rows.size()));
  }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { XGDMatrixFree(m_handle); }

  DMatrixHandle handle() const { return m_handle; }

private:
  DMatrixHandle m_handle = nullptr;
};

class Booster
{
public:
  explicit Booster(const Matrix& matrix)
  {
    const DMatrixHandle handle = matrix.handle();
    check(XGBoosterCreate(&handle, 1, &m_handle));
  }
  Booster(const Booster&) = delete;
  Booster& operator=(const Booster&) = delete;
  ~Booster() { XGBoosterFree(m_handle); }

  template <typename Value>
  void set(const char* name, const Value& value)
  {
    std::ostringstream text;
    text << value;
    check(XGBoosterSetParam(m_handle, name, text.str().c_str()));
  }

  void add_tree(const Matrix& matrix, int iteration)
  {
    check(XGBoosterUpdateOneIter(m_handle, iteration, matrix.handle()));
  }

  ptree model() const
  {
    bst_ulong length = 0;
    const char* text = nullptr;
    check(XGBoosterSaveModelToBuffer(m_handle, "{\"format\": \"json\"}", &length, &text));
    std::istringstream in(std::string(text, length));
    ptree result;
    read_json(in, result);
    return result;
  }

private:
  BoosterHandle m_handle = nullptr;
};

void set_options(Booster& booster, const Boosting_options& options, unsigned seed)
{
  booster.set("objective", "binary:logistic");
  booster.set("base_score", 0.5);
  booster.set("tree_method", "hist");
  booster.set("grow_policy", "lossguide");
  booster.set("max_depth", 0);
  booster.set("max_leaves", options.number_of_leaves);
  booster.set("max_bin", options.number_of_bins);
  booster.set("eta", options.rate);
  booster.set("subsample", options.share_of_rows);
  booster.set("colsample_bytree", options.share_of_features);
  booster.set("lambda", options.lambda);
  booster.set("min_child_weight", options.least_weight);
  booster.set("nthread", 1);
  booster.set("seed", seed);
  booster.set("verbosity", 0);
}

template <typename Value>
std::vector<Value> values_of(const ptree& array)
{
  std::vector<Value> values;
  for (const auto& entry : array)
    values.push_back(entry.second.get_value<Value>());
  return values;
}

/// A tree of XGBoost: left below the threshold, which lies between two values of the feature; -1:
/// no child.
class Tree_reader
{
public:
  explicit Tree_reader(const ptree& tree)
    : m_left(values_of<int>(tree.get_child("left_children")))
    , m_right(values_of<int>(tree.get_child("right_children")))
    , m_feature(values_of<int>(tree.get_child("split_indices")))
    , m_value(values_of<double>(tree.get_child("split_conditions")))
  {}

  /// Adds the nodes, as those of tree t, and returns the leaves.
  Model::Trees::Leaves read(std::size_t t, std::vector<Tree_node>& nodes)
  {
    m_leaves = Model::Trees::Leaves();
    m_number_of_leaves = 0;
    add(0, t, nodes);
    return m_leaves;
  }

private:
  void add(int i, std::size_t t, std::vector<Tree_node>& nodes)
  {
    if (m_left[i] < 0) {
      m_leaves.at(m_number_of_leaves++) = std::int32_t(
        std::lround(std::ldexp(m_value[i], Model::result_bits)));
      return;
    }
    const std::size_t first = m_number_of_leaves;
    add(m_left[i], t, nodes);
    const unsigned excluded = (1u << m_number_of_leaves) - (1u << first);
    nodes.push_back({std::size_t(m_feature[i]),
                     {Model::Feature(std::ceil(m_value[i])), std::uint16_t(t),
                      Model::Trees::Leaf_set(~excluded)}});
    add(m_right[i], t, nodes);
  }

  std::vector<int> m_left, m_right, m_feature;
  std::vector<double> m_value; // the threshold of an inner node, the value of a leaf
  Model::Trees::Leaves m_leaves;
  std::size_t m_number_of_leaves = 0;
};

} // namespace

Integer_trees::Integer_trees(std::vector<Tree_node> nodes,
                             std::vector<Model::Trees::Leaves> leaves_of_trees)
  : leaves(std::move(leaves_of_trees))
{
  const auto key = [](const Tree_node& n) {
    return std::make_tuple(n.feature, n.condition.threshold, n.condition.tree,
                           n.condition.remaining);
  };
  std::sort(nodes.begin(), nodes.end(),
            [&](const Tree_node& a, const Tree_node& b) { return key(a) < key(b); });
  for (const Tree_node& node : nodes) {
    conditions.push_back(node.condition);
    ++first_conditions[node.feature + 1];
  }
  std::partial_sum(first_conditions.begin(), first_conditions.end(), first_conditions.begin());
}

std::vector<Tree_node> Integer_trees::nodes() const
{
  std::vector<Tree_node> result;
  for (std::size_t f = 0; f + 1 < first_conditions.size(); ++f)
    for (std::size_t i = first_conditions[f]; i < first_conditions[f + 1]; ++i)
      result.push_back({f, conditions[i]});
  return result;
}

Integer_trees grow_trees(const Training_rows& rows, const Boosting_options& options, unsigned seed)
{
  const Matrix matrix(rows);
  Booster booster(matrix);
  set_options(booster, options, seed);
  for (unsigned i = 0; i < options.number_of_trees; ++i)
    booster.add_tree(matrix, int(i));
  const ptree model = booster.model();
  std::vector<Tree_node> nodes;
  std::vector<Model::Trees::Leaves> leaves;
  for (const auto& entry : model.get_child("learner.gradient_booster.model.trees"))
    leaves.push_back(Tree_reader(entry.second).read(leaves.size(), nodes));
  return {std::move(nodes), std::move(leaves)};
}

} // namespace train_merge_cost
