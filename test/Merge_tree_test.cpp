// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>

#include <gtest/gtest.h>

namespace Merge_tree_test {

using CGAL::Region_segmentation::Merge_tree;
using namespace test;

//     0  1  2  3  4
//     |  |  +--+  |    cost 1
//     |  +-----|--+    cost 5
//     +--------+       cost 3: a cost may go down again
Merge_tree small_tree()
{
  Merge_tree tree(5);
  tree.push_back({2, 3, 1});
  tree.push_back({1, 4, 5});
  tree.push_back({0, 2, 3});
  return tree;
}

TEST(Merge_tree_test, partition_at_a_count_that_the_tree_does_not_have)
{
  const Merge_tree tree = small_tree();
  EXPECT_EQ(tree.partition_at_count(1).number_of_parts(), 2u);
  EXPECT_EQ(tree.partition_at_count(0).number_of_parts(), 2u);
  EXPECT_EQ(tree.partition_at_count(1000).number_of_parts(), 5u);
}

TEST(Merge_tree_test, partition_at_cost_ends_before_the_first_dearer_merge)
{
  const Merge_tree tree = small_tree();
  EXPECT_EQ(tree.partition_at_cost(0.5).number_of_parts(), 5u);
  EXPECT_EQ(tree.partition_at_cost(1).number_of_parts(), 4u);
  EXPECT_EQ(tree.partition_at_cost(4).number_of_parts(), 4u);
  EXPECT_EQ(tree.partition_at_cost(5).number_of_parts(), 2u);
}

TEST(Merge_tree_test, without_merges_or_regions)
{
  EXPECT_EQ(Merge_tree().partition_at_count(3).number_of_parts(), 0u);
  EXPECT_EQ(labels_of(Merge_tree(3).partition_at_count(1)), (Labels{0, 1, 2}));
  EXPECT_EQ(Merge_tree(3).partition_at_cost(1e300).number_of_parts(), 3u);
}

// In a release build such a merge read and wrote outside of arrays.
TEST(Merge_tree_test, an_invalid_merge_is_refused_in_every_build)
{
  Merge_tree tree(4);
  tree.push_back({1, 2, 0});
  const std::pair<std::uint32_t, std::uint32_t> invalid[] = {{1, 0},          {1, 1}, {1, 4},
                                                             {0, 4000000000}, {0, 2}, {2, 3}};
  for (const auto& [kept, removed] : invalid)
    EXPECT_THROW(tree.push_back({kept, removed, 0}), CGAL::Region_segmentation::Invalid_method)
      << kept << " " << removed;
  ASSERT_EQ(tree.merges().size(), 1u);
  EXPECT_EQ(labels_of(tree.partition_at_count(1)), (Labels{0, 1, 1, 2}));
}

TEST(Merge_tree_test, random_trees_nest_and_agree_with_sets)
{
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t n = 1 + random() % 40;
    Merge_tree tree(n);
    std::map<std::size_t, std::set<std::size_t>> live; // by its lowest region
    for (std::size_t r = 0; r < n; ++r)
      live[r] = {r};
    Labels finer;
    for (std::size_t left = n;; --left) {
      Labels expected(n);
      std::size_t label = 0;
      for (const auto& [lowest, members] : live) {
        for (std::size_t r : members)
          expected[r] = label;
        ++label;
      }
      // The merges to come must not matter: ask the finished tree later, the growing one now.
      const auto partition = tree.partition_at_count(left);
      ASSERT_EQ(partition.number_of_parts(), left);
      const Labels labels = labels_of(partition);
      ASSERT_EQ(labels, expected);
      ASSERT_TRUE(finer.empty() || nests(finer, labels));
      finer = labels;
      if (left == 1)
        break;
      auto a = std::next(live.begin(), std::ptrdiff_t(random() % live.size()));
      auto b = std::next(live.begin(), std::ptrdiff_t(random() % live.size()));
      while (a == b)
        b = std::next(live.begin(), std::ptrdiff_t(random() % live.size()));
      if (a->first > b->first)
        std::swap(a, b);
      tree.push_back({std::uint32_t(a->first), std::uint32_t(b->first), double(n - left)});
      a->second.insert(b->second.begin(), b->second.end());
      live.erase(b);
    }
    for (std::size_t k = 1; k <= n; ++k)
      EXPECT_EQ(tree.partition_at_count(k).number_of_parts(), k);
  }
}

} // namespace Merge_tree_test
