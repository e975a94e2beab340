// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "superfacet_stages.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Border_straightening.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacet_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Border_straightening_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Index = RS::Partition::Index;

/// Merges of adjacent segments, drawn at random, until few are left.
RS::Merge_tree random_tree(const RS::Surface& mesh, const RS::Partition& regions,
                           std::mt19937& random)
{
  RS::Merge_tree tree(regions.number_of_parts());
  Labels segments = labels_of(regions);
  while (true) {
    std::vector<std::pair<std::size_t, std::size_t>> adjacent;
    for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e) {
      const std::size_t a = segments[mesh.lower_face(e)], b = segments[mesh.higher_face(e)];
      if (a != b)
        adjacent.push_back(std::minmax(a, b));
    }
    if (adjacent.empty())
      return tree;
    const auto [kept, removed] = adjacent[random() % adjacent.size()];
    tree.push_back({std::uint32_t(kept), std::uint32_t(removed), double(tree.merges().size())});
    std::replace(segments.begin(), segments.end(), removed, kept);
  }
}

/// A surface with regions that are merged at random. Its faces are so large that each is a patch.
struct Merged_surface
{
  RS::Surface surface;
  RS::Patches patches;
  RS::Partition regions;
  RS::Merge_tree tree;

  Merged_surface(RS::Surface surface_, const RS::Partition& regions_, RS::Merge_tree tree_)
    : surface(std::move(surface_))
    , patches(patches_of(surface).fine)
    , regions(regions_)
    , tree(std::move(tree_))
  {
    EXPECT_EQ(patches.size(), surface.number_of_faces());
  }

  static Merged_surface random(Family family, unsigned seed, std::mt19937& random)
  {
    RS::Surface surface = surface_of_soup(random_mesh(family, seed));
    const RS::Partition regions = superfacets_of(surface, RS::Superfacets(40));
    RS::Merge_tree tree = random_tree(surface, regions, random);
    return Merged_surface(std::move(surface), regions, std::move(tree));
  }

  /// By default for all numbers of segments. `seeds`: of the regions
  std::vector<Index> straightened(const RS::Border_straightening& straightening,
                                  std::size_t number = std::size_t(-1),
                                  const RS::Seeds& seeds = RS::Seeds()) const
  {
    return straightening(surface, patches, {regions, seeds}, tree, number, RS::Execution());
  }
};

RS::Border_straightening wide_straightening()
{
  RS::Border_straightening straightening;
  straightening.width = 0.2;
  straightening.width_of_segment = 0.5;
  return straightening;
}

/// What a division of the patches into two segments costs.
double cost_of(const Merged_surface& merged, const RS::Border_cost& cost,
               const std::vector<Index>& segment_of_face)
{
  double sum = 0;
  for (const RS::Patches::Adjacency& a : merged.patches.adjacencies())
    if (segment_of_face[merged.patches[a.lower].center] !=
        segment_of_face[merged.patches[a.higher].center])
      sum += cost(a.length, merged.patches.concave_deviation(a));
  return sum;
}

TEST(Border_straightening_test, a_border_moves_where_it_costs_less)
{
  std::size_t cheaper = 0;
  for (Family family : {Family::SHEET, Family::SPHERE, Family::TORUS, Family::BLOCKS})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      RS::Merge_tree tree(2);
      tree.push_back({0, 1, 1.0});
      RS::Surface surface = surface_of_soup(random_mesh(family, seed));
      const RS::Partition halves = superfacets_of(surface, RS::Superfacets(2));
      const Merged_surface merged(std::move(surface), halves, tree);
      const RS::Border_straightening straightening = wide_straightening();
      const double before = cost_of(merged, straightening.cost, {halves.begin(), halves.end()}),
                   after = cost_of(merged, straightening.cost, merged.straightened(straightening));
      EXPECT_LE(after, before * (1 + 1e-6));
      cheaper += after < before;
    }
  EXPECT_GT(cheaper, 5u);
}

/// The segments of faces for a number, from the regions with borders moved for all numbers: the
/// last merges are undone, as long as there are fewer segments with faces.
Labels segments_of(const std::vector<Index>& regions, const RS::Merge_tree& tree,
                   std::size_t number)
{
  for (std::size_t merged = tree.merges().size();; --merged) {
    Labels segments(regions.begin(), regions.end());
    for (std::size_t i = 0; i < merged; ++i)
      std::replace(segments.begin(), segments.end(), std::size_t(tree.merges()[i].removed),
                   std::size_t(tree.merges()[i].kept));
    if (merged == 0 || std::set<std::size_t>(segments.begin(), segments.end()).size() >= number)
      return segments;
  }
}

TEST(Border_straightening_test, for_one_number_the_segments_are_the_same)
{
  for (Family family : {Family::SHEET, Family::SPHERE, Family::TORUS, Family::BLOCKS})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const Merged_surface merged = Merged_surface::random(family, seed, random);
      RS::Border_straightening straightening = wide_straightening();
      straightening.number_of_cuts = 10;
      const std::vector<Index> all = merged.straightened(straightening);
      for (std::size_t number = 1; number <= merged.regions.number_of_parts() + 1; ++number) {
        const auto labels = merged.straightened(straightening, number);
        EXPECT_EQ(Labels(labels.begin(), labels.end()), segments_of(all, merged.tree, number))
          << number << " segments";
      }
    }
}

TEST(Border_straightening_test, fixed_regions_keep_their_faces)
{
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Merged_surface merged = Merged_surface::random(Family::SPHERE, seed, random);
    const Index fixed = Index(random() % merged.regions.number_of_parts());
    RS::Seeds seeds{std::vector<Index>(merged.regions.number_of_parts(), Index(RS::Seeds::none)),
                    {0}};
    seeds.of[fixed] = 0;
    const std::vector<Index> labels = merged.straightened(wide_straightening(), std::size_t(-1),
                                                          seeds);
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (merged.regions[f] == fixed) {
        EXPECT_EQ(labels[f], fixed) << "face " << f;
      }
  }
}

template <typename Method>
void expect_connected_and_nested(Method method)
{
  method.superfacets.number = 60;
  method.straightening.width = 0.1;
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      const Surface_mesh mesh = to_surface_mesh(soup);
      auto map = face_map(mesh);
      const RS::Segmenter segmenter(
        mesh, RS::parameters::method(method).region_map(map).component_links(false));
      const RS::Segmenter linked(mesh, RS::parameters::method(method));
      Labels finer = labels_of(mesh, map);
      const std::size_t regions = segmenter.merge_tree().number_of_regions();
      EXPECT_TRUE(is_numbered_by_first_face(finer, regions));
      EXPECT_TRUE(is_connected(soup, finer));
      for (std::size_t k = mesh.number_of_faces(); k > 0; k -= 1 + k / 10) {
        const std::size_t n = segmenter.segment(map, k);
        const Labels labels = labels_of(mesh, map);
        EXPECT_EQ(n, std::max(std::min(k, regions), number_of_components(soup)));
        EXPECT_TRUE(is_connected(soup, labels)) << k;
        EXPECT_TRUE(nests(finer, labels)) << k;
        EXPECT_EQ(linked.segment(map, k), std::min(k, linked.merge_tree().number_of_regions()));
      }
    }
}

TEST(Border_straightening_test, segments_are_connected_and_nest)
{
  expect_connected_and_nested(RS::Visibility_merging());
  expect_connected_and_nested(RS::Learned_merging());
}

TEST(Border_straightening_test, a_tree_is_renumbered_without_lost_regions)
{
  RS::Merge_tree tree(5);
  tree.push_back({1, 3, 0.1});
  tree.push_back({0, 1, 0.2});
  tree.push_back({2, 4, 0.3});
  tree.push_back({0, 2, 0.4});
  const RS::Hierarchy hierarchy = RS::internal::renumbered_hierarchy({4, 3, 0, 2}, tree, 1);
  const RS::Merge_tree& renumbered = hierarchy.merge_tree();
  ASSERT_EQ(renumbered.number_of_regions(), 4u);
  ASSERT_EQ(renumbered.merges().size(), 3u);
  const std::vector<RS::Merge_tree::Merge> expected{{1, 2, 0.2}, {0, 3, 0.3}, {0, 1, 0.4}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(renumbered.merges()[i].kept, expected[i].kept);
    EXPECT_EQ(renumbered.merges()[i].removed, expected[i].removed);
    EXPECT_EQ(renumbered.merges()[i].cost, expected[i].cost);
  }
}

} // namespace Border_straightening_test
