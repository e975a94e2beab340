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
    check(XGDMatrixCreateFromMat(values.data(), rows.size(), Merge_features::NUMBER_OF_FEATURES, NAN, &m_handle));
    std::vector<float> weights = rows.weights;
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / double(weights.size());
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

  void add_tree(const Matrix& matrix, int iteration) { check(XGBoosterUpdateOneIter(m_handle, iteration, matrix.handle())); }

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

/// A tree of XGBoost: left below the threshold, which lies between two values of the feature; -1: no child.
class Tree_reader
{
public:
  explicit Tree_reader(const ptree& tree)
    : m_left(values_of<int>(tree.get_child("left_children")))
    , m_right(values_of<int>(tree.get_child("right_children")))
    , m_feature(values_of<int>(tree.get_child("split_indices")))
    , m_value(values_of<double>(tree.get_child("split_conditions")))
  {}

  Model::Tree read()
  {
    m_tree = Model::Tree();
    m_nodes = m_leaves = 0;
    const std::uint8_t root = add(0);
    if (root >= Model::first_leaf) // a tree without a split
      m_tree.nodes[0] = {0, 0, {root, root}};
    return m_tree;
  }

private:
  std::uint8_t add(int i)
  {
    if (m_left[i] < 0) {
      m_tree.leaves.at(m_leaves) = std::int32_t(std::lround(std::ldexp(m_value[i], Model::result_bits)));
      return std::uint8_t(Model::first_leaf + m_leaves++);
    }
    const std::size_t place = m_nodes++;
    Model::Node& node = m_tree.nodes.at(place);
    node.threshold = Model::Feature(std::ceil(m_value[i]));
    node.feature = std::uint8_t(m_feature[i]);
    node.branches[0] = add(m_left[i]);
    node.branches[1] = add(m_right[i]);
    return std::uint8_t(place);
  }

  std::vector<int> m_left, m_right, m_feature;
  std::vector<double> m_value; // the threshold of an inner node, the value of a leaf
  Model::Tree m_tree;
  std::size_t m_nodes = 0, m_leaves = 0;
};

} // namespace

std::vector<Model::Tree> grow_trees(const Training_rows& rows, const Boosting_options& options, unsigned seed)
{
  const Matrix matrix(rows);
  Booster booster(matrix);
  set_options(booster, options, seed);
  for (unsigned i = 0; i < options.number_of_trees; ++i)
    booster.add_tree(matrix, int(i));
  const ptree model = booster.model();
  std::vector<Model::Tree> trees;
  for (const auto& entry : model.get_child("learner.gradient_booster.model.trees"))
    trees.push_back(Tree_reader(entry.second).read());
  return trees;
}

} // namespace train_merge_cost
