// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Partition_editor.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace Partition_editor_test {

using CGAL::Region_segmentation::Merge_tree;
using CGAL::Region_segmentation::Partition_editor;
using namespace test;

/// Random merges, by random costs, that leave two trees.
Merge_tree random_tree(std::size_t regions, unsigned seed)
{
  std::mt19937 random(seed);
  Merge_tree tree(regions);
  std::vector<std::uint32_t> live(regions);
  for (std::size_t i = 0; i < regions; ++i)
    live[i] = std::uint32_t(i);
  while (live.size() > 2) {
    std::swap(live[random() % live.size()], live.back());
    std::swap(live[random() % (live.size() - 1)], live[live.size() - 2]);
    const auto [kept, removed] = std::minmax(live[live.size() - 2], live.back());
    tree.push_back({kept, removed, double(random() % 50) - 10});
    live[live.size() - 2] = kept;
    live.pop_back();
  }
  return tree;
}

Labels labels_of(const Partition_editor& editor)
{
  const auto partition = editor.partition();
  EXPECT_EQ(partition.number_of_parts(), editor.number_of_segments());
  const Labels labels = test::labels_of(partition);
  EXPECT_TRUE(is_numbered_by_first_face(labels, editor.number_of_segments()));
  return labels;
}

/// The sets of regions that the merges make, each with its merges; by brute force.
struct Cluster
{
  std::set<std::size_t> regions;
  std::vector<double> costs;
};

std::vector<Cluster> clusters_of(const Merge_tree& tree)
{
  std::vector<Cluster> all;
  std::map<std::size_t, Cluster> live;
  for (std::size_t r = 0; r < tree.number_of_regions(); ++r)
    all.push_back(live[r] = {{r}, {}});
  for (const auto& merge : tree.merges()) {
    Cluster& kept = live[merge.kept];
    const Cluster& removed = live[merge.removed];
    kept.regions.insert(removed.regions.begin(), removed.regions.end());
    kept.costs.insert(kept.costs.end(), removed.costs.begin(), removed.costs.end());
    kept.costs.push_back(merge.cost);
    all.push_back(kept);
    live.erase(merge.removed);
  }
  return all;
}

/// The largest clusters that `is_good`, or are regions.
template <typename IsGood>
Labels largest(const Merge_tree& tree, const IsGood& is_good)
{
  Labels labels(tree.number_of_regions());
  const auto clusters = clusters_of(tree); // smaller ones come before those that contain them
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (i < tree.number_of_regions() || is_good(clusters[i]))
      for (std::size_t r : clusters[i].regions)
        labels[r] = i;
  return renumbered(labels);
}

// As after new seeds of a Segmenter, whose tree is another one then.
TEST(Partition_editor_test, keeps_its_tree)
{
  Merge_tree tree = random_tree(30, 2);
  const Merge_tree copy = tree;
  Partition_editor editor(tree);
  tree = Merge_tree(1);
  editor.set_count(7);
  EXPECT_EQ(labels_of(editor), test::labels_of(copy.partition_at_count(7)));
  editor.set_maximum_size(std::vector<double>(30, 1.0), 1);
  EXPECT_EQ(editor.number_of_segments(), 30u);
}

TEST(Partition_editor_test, starts_from_whole_trees)
{
  const Merge_tree tree = random_tree(30, 1);
  const Partition_editor editor(tree);
  EXPECT_EQ(labels_of(editor), test::labels_of(tree.partition_at_count(1)));
  EXPECT_EQ(editor.number_of_changes(), 0u);
  const Merge_tree none;
  EXPECT_EQ(Partition_editor(none).number_of_segments(), 0u);
}

TEST(Partition_editor_test, has_the_numbers_of_the_tree)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Merge_tree tree = random_tree(40, seed);
    Partition_editor editor(tree);
    for (std::size_t k : {1, 2, 3, 7, 39, 40, 100}) {
      editor.set_count(k);
      EXPECT_EQ(labels_of(editor), test::labels_of(tree.partition_at_count(k)));
    }
  }
}

TEST(Partition_editor_test, splits_as_the_tree_does)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Merge_tree tree = random_tree(40, seed);
    Partition_editor editor(tree);
    for (std::size_t k = 2; k < 40; ++k) {
      // The segment that differs between k and k + 1 has the last merge.
      const Labels before = test::labels_of(tree.partition_at_count(k)),
                   after = test::labels_of(tree.partition_at_count(k + 1));
      ASSERT_EQ(labels_of(editor), before);
      std::map<std::size_t, std::set<std::size_t>> parts;
      for (std::size_t r = 0; r < before.size(); ++r)
        parts[before[r]].insert(after[r]);
      const auto split = std::find_if(parts.begin(), parts.end(),
                                      [](const auto& p) { return p.second.size() == 2; });
      EXPECT_EQ(editor.split(split->first), 2u);
      EXPECT_EQ(labels_of(editor), after);
    }
    EXPECT_EQ(editor.split(0), 1u); // a region
    EXPECT_EQ(editor.number_of_changes(), 38u);
    while (editor.undo())
      ;
    EXPECT_EQ(labels_of(editor), test::labels_of(tree.partition_at_count(2)));
  }
}

TEST(Partition_editor_test, splits_one_segment_into_several)
{
  const Merge_tree tree = random_tree(40, 3);
  Partition_editor editor(tree);
  const Labels before = labels_of(editor);
  const std::size_t regions = std::size_t(std::count(before.begin(), before.end(), 1u));
  EXPECT_EQ(editor.split(1, 5), (std::min)(regions, std::size_t(5)));
  EXPECT_EQ(editor.number_of_segments(), 1 + (std::min)(regions, std::size_t(5)));
  EXPECT_TRUE(nests(labels_of(editor), before));
  editor.undo();
  EXPECT_EQ(editor.split(1, 1000), regions);
}

TEST(Partition_editor_test, joins_and_takes_apart)
{
  const Merge_tree tree = random_tree(40, 4);
  Partition_editor editor(tree);
  editor.set_count(6);
  const Labels six = labels_of(editor);
  editor.join(4, 1);
  Labels joined = six;
  std::replace(joined.begin(), joined.end(), std::size_t(4), std::size_t(1));
  EXPECT_EQ(labels_of(editor), renumbered(joined));
  EXPECT_EQ(editor.split(1), 2u);
  EXPECT_EQ(labels_of(editor), six);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(labels_of(editor), renumbered(joined));
  editor.join(0, 1);
  EXPECT_EQ(editor.number_of_segments(), 4u);
  EXPECT_EQ(editor.split(0, 3), 3u); // all that was joined
  EXPECT_EQ(labels_of(editor), six);
}

TEST(Partition_editor_test, cuts_at_a_cost_or_a_size)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Merge_tree tree = random_tree(40, seed);
    Partition_editor editor(tree);
    for (double bound : {-20., -5., 0., 12., 30., 100.}) {
      editor.set_maximum_cost(bound);
      EXPECT_EQ(labels_of(editor), largest(tree, [&](const Cluster& c) {
                  return std::all_of(c.costs.begin(), c.costs.end(),
                                     [&](double cost) { return cost <= bound; });
                }));
    }
    std::vector<double> sizes;
    for (std::size_t r = 0; r < 40; ++r)
      sizes.push_back(double(r % 7));
    for (double bound : {0., 3., 10., 50., 1000.}) {
      editor.set_maximum_size(sizes, bound);
      EXPECT_EQ(labels_of(editor), largest(tree, [&](const Cluster& c) {
                  double size = 0;
                  for (std::size_t r : c.regions)
                    size += sizes[r];
                  return size <= bound;
                }));
    }
  }
}

TEST(Partition_editor_test, a_change_without_effect_is_none)
{
  const Merge_tree tree = random_tree(10, 5);
  Partition_editor editor(tree);
  editor.set_count(4);
  editor.set_count(4);
  EXPECT_EQ(editor.split(0, 1), 1u);
  EXPECT_EQ(editor.number_of_changes(), 1u);
  EXPECT_TRUE(editor.undo());
  EXPECT_FALSE(editor.undo());
}

} // namespace Partition_editor_test
