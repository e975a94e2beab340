// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "superfacet_stages.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::Double_3;
using RS::Merge_features;

namespace Learned_annotator_test {

using Graph = Graph_of<RS::Learned_annotator>;
using Region = Graph::region_descriptor;

Graph annotated_soup(const Soup& soup, const std::vector<std::size_t>& labels)
{
  return annotated<RS::Learned_annotator>(surface_of_soup(soup),
                                          RS::Partition::from_labels(labels));
}

/// The faces by their nearest of `n` random faces: regions that need not be connected.
std::vector<std::size_t> random_regions(const Soup& soup, std::size_t n, std::mt19937& random)
{
  const RS::Surface mesh = surface_of_soup(soup);
  std::vector<std::size_t> seeds, labels;
  for (std::size_t i = 0; i < n; ++i)
    seeds.push_back(random() % mesh.number_of_faces());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto distance = [&](std::size_t seed) {
      return squared_norm(mesh.centroid(f) - mesh.centroid(seed));
    };
    labels.push_back(std::size_t(
      std::min_element(seeds.begin(), seeds.end(),
                       [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); }) -
      seeds.begin()));
  }
  return labels;
}

void expect_near(const Double_3& a, const Double_3& b)
{
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(a.z, b.z, 1e-9);
}

void expect_near(const RS::Second_moments& a, const RS::Second_moments& b)
{
  EXPECT_NEAR(a.weight, b.weight, 1e-9);
  expect_near(a.centroid(), b.centroid());
  const auto c = a.covariance(), d = b.covariance();
  EXPECT_NEAR(c.xx, d.xx, 1e-9);
  EXPECT_NEAR(c.xy, d.xy, 1e-9);
  EXPECT_NEAR(c.yz, d.yz, 1e-9);
  EXPECT_NEAR(c.trace(), d.trace(), 1e-9);
}

/// The features of all sections differ by at most one step. `region_of[r]`: the region of `b` that
/// is r in `a`
void expect_same_features(const Graph& a, const Graph& b, const std::vector<Region>& region_of)
{
  for (auto range = edges(a); range.first != range.second; ++range.first) {
    if (!a.is_adjacent(*range.first))
      continue;
    const auto other = b.section(region_of[a.source(*range.first)],
                                 region_of[a.target(*range.first)]);
    ASSERT_TRUE(other);
    const auto x = Merge_features::of(a, *range.first), y = Merge_features::of(b, *other);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_TRUE(std::abs(x[i] - y[i]) <= 1) << "feature " << i;
  }
}

std::vector<Region> identity(std::size_t n)
{
  std::vector<Region> result(n);
  std::iota(result.begin(), result.end(), Region(0));
  return result;
}

TEST(Second_moments_test, eigenvalues_are_roots_of_the_characteristic_polynomial)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    RS::Symmetric_3 m;
    for (int j = 0; j < 1 + i % 4; ++j) // of rank 1 to 3
      m.add_square(1, {any(random), any(random), any(random)});
    const auto l = RS::eigenvalues(m);
    EXPECT_GE(l[0], l[1]);
    EXPECT_GE(l[1], l[2] - 1e-12);
    EXPECT_NEAR(l[0] + l[1] + l[2], m.trace(), 1e-7 * l[0]);
    EXPECT_NEAR(l[0] * l[0] + l[1] * l[1] + l[2] * l[2], RS::internal::trace_of_product(m, m),
                1e-7 * l[0] * l[0]);
    EXPECT_NEAR(l[0] * l[1] * l[2], m.determinant(), 1e-7 * l[0] * l[0] * l[0]);
  }
}

TEST(Whole_shape_test, of_a_cube)
{
  const RS::Whole_shape whole = annotated_soup(cube(), {0, 1, 2, 3, 4, 5})[0].whole;
  EXPECT_NEAR(whole.flatness, 1, 1e-12);
  EXPECT_NEAR(whole.right_angles, 1, 1e-12);
  EXPECT_NEAR(whole.outward, 1, 1e-12);
  EXPECT_EQ(whole.strongly_concave, 0);
  EXPECT_NEAR(whole.openness, 0, 1e-12);
  // Each face as a triangle of area 1; in units of the square root of 6.
  const double squared_width = (0.25 + 1 / (3 * std::sqrt(3.0))) / 6;
  EXPECT_NEAR(whole.log_filling, -std::log(CGAL_PI * squared_width), 1e-12);
}

TEST(Whole_shape_test, of_a_sheet)
{
  const RS::Whole_shape whole = annotated_soup(grid(2, 1), {0, 1})[0].whole;
  EXPECT_EQ(whole.openness, 1); // no ray hits
  EXPECT_NEAR(whole.flatness, 1, 1e-12);
  EXPECT_NEAR(whole.outward, 0, 1e-12);
}

TEST(Learned_section_data_test, knows_how_much_of_it_is_a_contact_of_components)
{
  for (unsigned seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = random_mesh(Family::TWO_COMPONENTS, seed);
    const RS::Surface mesh = surface_of_soup(soup);
    std::mt19937 random(seed);
    const RS::Partition regions = RS::Partition::from_labels(random_regions(soup, 20, random));
    const Graph graph = annotated<RS::Learned_annotator>(mesh, regions);
    double expected = 0, sum = 0;
    for (std::size_t a = 0; a < mesh.number_of_adjacencies(); ++a)
      if (mesh.has_flag(a, RS::Surface::LINK) &&
          regions[mesh.lower_face(a)] != regions[mesh.higher_face(a)])
        expected += mesh.length(a) / mesh.length_unit();
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      sum += graph[*range.first].link_length;
    EXPECT_NEAR(sum, expected, 1e-9);
  }
}

TEST(Learned_annotator_test, data_of_merged_regions_is_that_of_their_union)
{
  for (Family family : {Family::SPHERE, Family::BLOCKS, Family::TORUS, Family::TWO_COMPONENTS})
    for (unsigned seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const Soup soup = random_mesh(family, seed);
      std::vector<std::size_t> labels = random_regions(soup, 20, random);
      Graph merged = annotated_soup(soup, labels);
      std::vector<Region> kept = identity(merged.number_of_regions());
      std::vector<Region> region_of;
      for (const auto r : RS::Partition::from_labels(labels))
        region_of.push_back(r);
      for (int i = 0; i < 6; ++i)
        for (auto range = edges(merged); range.first != range.second; ++range.first)
          if (merged.is_mergeable(*range.first)) {
            const auto merge = merged.merge(*range.first);
            std::replace(region_of.begin(), region_of.end(), merge.removed, merge.kept);
            break;
          }
      const Graph fresh = annotated_soup(soup, {region_of.begin(), region_of.end()});
      const RS::Partition fresh_regions = RS::Partition::from_labels(region_of);
      for (std::size_t f = 0; f < region_of.size(); ++f) {
        const auto &a = merged[region_of[f]], &b = fresh[Region(fresh_regions[f])];
        EXPECT_NEAR(a.area, b.area, 1e-9);
        EXPECT_NEAR(a.perimeter, b.perimeter, 1e-9);
        expect_near(a.area_vector, b.area_vector);
        expect_near(a.moments, b.moments);
        for (std::size_t g = 0; g < f; ++g)
          if (const auto s = region_of[f] == region_of[g]
                               ? std::nullopt
                               : merged.section(region_of[f], region_of[g]);
              s && merged.is_adjacent(*s)) {
            const auto& x = merged[*s];
            const auto&
              y = fresh[*fresh.section(Region(fresh_regions[f]), Region(fresh_regions[g]))];
            EXPECT_NEAR(x.length, y.length, 1e-9);
            EXPECT_NEAR(x.strongly_concave_length, y.strongly_concave_length, 1e-9);
            EXPECT_NEAR(x.link_length, y.link_length, 1e-9);
          }
      }
    }
}

TEST(Learned_annotator_test, the_whole_surface_sees_itself_alone)
{
  for (Family family : {Family::SPHERE, Family::BLOCKS, Family::TORUS}) {
    SCOPED_TRACE(name(family));
    std::mt19937 random(3);
    const Soup soup = random_mesh(family, 3);
    Graph graph = annotated_soup(soup, random_regions(soup, 12, random));
    double own = 0;
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      EXPECT_GE(graph[*range.first].own_visibility, -1e-12);
      own += graph[*range.first].own_visibility;
    }
    while (graph.number_of_regions() > 1)
      for (auto range = edges(graph); range.first != range.second; ++range.first)
        if (graph.is_mergeable(*range.first)) {
          graph.merge(*range.first);
          break;
        }
    const auto& all = graph[*vertices(graph).first];
    EXPECT_GT(all.own_visibility, own);
    EXPECT_NEAR(all.own_visibility, all.visibility / 2, 1e-9);
    EXPECT_NEAR(all.perimeter, 0, 1e-9);
    EXPECT_NEAR(norm(all.area_vector), 0, 1e-9); // closed
  }
}

TEST(Merge_features_test, do_not_depend_on_motion_and_size)
{
  for (Family family : {Family::SPHERE, Family::BLOCKS, Family::TORUS, Family::SHEET})
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const Soup soup = random_mesh(family, seed);
      const auto labels = random_regions(soup, 10, random);
      const Graph graph = annotated_soup(soup, labels);
      const auto same = identity(graph.number_of_regions());
      expect_same_features(graph, annotated_soup(scaled(soup, 0.037), labels), same);
      expect_same_features(
        graph, annotated_soup(translated(rotated(soup, 0.7, 1.9), 3.3, -7.1, 0.9), labels), same);
    }
}

} // namespace Learned_annotator_test
