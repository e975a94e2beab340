// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Superfacets/internal/Border_cut.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace smooth_borders_test {

const RS::Minimum_cut_borders wide = {0.2, 0.5};

/// `gain`: how much cheaper a border in a valley is
RS::Minimum_cut_borders borders(double width, double width_of_segment, double gain)
{
  RS::Minimum_cut_borders result = {width, width_of_segment};
  result.cost.concave_gain = gain;
  return result;
}

template <typename Mesh>
Labels smoothed_on(const Soup& soup, const Labels& labels, const RS::Minimum_cut_borders& smoother,
                   const std::set<Edge>& constrained)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  const auto map = face_labels(mesh, labels);
  const std::size_t changed = RS::smooth_borders(
    mesh, map, smoother,
    RS::parameters::component_links(false).edge_is_constrained_map(edge_map(mesh, constrained)));
  const Labels result = labels_of(mesh, map);
  EXPECT_EQ(changed, std::inner_product(labels.begin(), labels.end(), result.begin(),
                                        std::size_t(0), std::plus<>(), std::not_equal_to<>()));
  return result;
}

Labels smoothed(const Soup& soup, const Labels& labels,
                const RS::Minimum_cut_borders& smoother = wide,
                const std::set<Edge>& constrained = {})
{
  return smoothed_on<Surface_mesh>(soup, labels, smoother, constrained);
}

/// Connected segments of a random mesh: balls of faces around some, as ragged as they come.
Labels random_segments(const Soup& soup, std::size_t number, std::mt19937& random,
                       const std::set<Edge>& uncrossed = {})
{
  std::vector<std::vector<std::size_t>> neighbors(soup.polygons.size());
  for (const auto& [edge, both] : faces_of_edges(soup))
    if (both.size() == 2 && !uncrossed.count(edge)) {
      neighbors[both[0]].push_back(both[1]);
      neighbors[both[1]].push_back(both[0]);
    }
  const std::size_t none = soup.polygons.size();
  Labels labels(soup.polygons.size(), none);
  std::vector<std::size_t> front;
  for (std::size_t s = 0; s < number; ++s)
    if (const std::size_t f = random() % labels.size(); labels[f] == none) {
      labels[f] = s;
      front.push_back(f);
    }
  std::size_t next_label = number;
  for (std::size_t next_face = 0; true;) {
    if (front.empty()) { // a piece that has no segment yet
      next_face = std::size_t(std::find(labels.begin(), labels.end(), none) - labels.begin());
      if (next_face == labels.size())
        return labels;
      labels[next_face] = next_label++;
      front.push_back(next_face);
    }
    std::swap(front[random() % front.size()], front.back());
    const std::size_t f = front.back();
    front.pop_back();
    for (std::size_t g : neighbors[f])
      if (labels[g] == none) {
        labels[g] = labels[f];
        front.push_back(g);
      }
  }
}

double border_length(const Soup& soup, const Labels& labels, const std::set<Edge>& left_out = {})
{
  double length = 0;
  for (const auto& [edge, both] : faces_of_edges(soup))
    if (both.size() == 2 && labels[both[0]] != labels[both[1]] && !left_out.count(edge)) {
      const Point &p = soup.points[edge.first], &q = soup.points[edge.second];
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
  return length;
}

/// A sheet of 16 x 8 squares, divided at x = 8, with teeth of one square.
Labels toothed(std::size_t nx = 16, std::size_t ny = 8)
{
  Labels labels;
  for (std::size_t y = 0; y < ny; ++y)
    for (std::size_t x = 0; x < nx; ++x)
      labels.push_back(x < nx / 2 + y % 2 ? 0 : 1);
  return labels;
}

TEST(Minimum_cut_test, finds_the_cheapest_of_all_cuts_and_moves_few_nodes)
{
  for (unsigned seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::uint32_t nodes = 2 + random() % 7; // and two terminals
    RS::internal::Minimum_cut cut;
    std::uint32_t before = 1;
    for (std::uint32_t n = 2; n < nodes + 2; ++n) {
      const std::uint8_t side = random() % 2;
      EXPECT_EQ(cut.add_node(side), n);
      before |= std::uint32_t(side) << n;
    }
    std::vector<std::array<std::uint32_t, 3>> edges;
    for (int i = 0; i < 20; ++i) {
      const std::uint32_t a = random() % (nodes + 2), b = random() % (nodes + 2),
                          c = 1 + random() % 4;
      cut.add_edge(a, b, c);
      if (a != b && std::max(a, b) > 1)
        edges.push_back({a, b, c});
    }
    const auto capacity = [&](std::uint32_t sides) {
      std::uint32_t sum = 0;
      for (const auto& [a, b, c] : edges)
        sum += ((sides >> a) ^ (sides >> b)) & 1 ? c : 0;
      return sum;
    };
    const auto quality = [&](std::uint32_t sides) { // and the number of nodes moved
      return std::make_pair(capacity(sides), std::bitset<32>(sides ^ before).count());
    };
    auto best = quality(before);
    for (std::uint32_t others = 0; others < 1u << nodes; ++others)
      best = std::min(best, quality(others << 2 | 1));

    EXPECT_EQ(cut.improve(), best.first < capacity(before));
    std::uint32_t after = 0;
    for (std::uint32_t n = 0; n < nodes + 2; ++n)
      after |= std::uint32_t(cut.is_on_source_side(n)) << n;
    EXPECT_EQ(quality(after), best);
    EXPECT_EQ(after & 3, 1u);
  }
}

TEST(Minimum_cut_test, moves_all_nodes_for_a_cut_that_is_cheaper_by_the_least)
{
  // A chain of four nodes. Its first edge costs less than the last one by a unit of the capacities,
  // of which some 2^51 / 6, for six nodes, are their sum of 8.
  using Cut = RS::internal::Minimum_cut;
  Cut cut;
  std::vector<Cut::Node> nodes = {Cut::source};
  for (int i = 0; i < 4; ++i)
    nodes.push_back(cut.add_node(1));
  nodes.push_back(Cut::sink);
  const std::vector<double> capacities = {1 - std::ldexp(1.0, -46), 2, 2, 2, 1};
  for (std::size_t i = 0; i < capacities.size(); ++i)
    cut.add_edge(nodes[i], nodes[i + 1], capacities[i]);
  EXPECT_TRUE(cut.improve());
  for (std::size_t i = 1; i <= 4; ++i)
    EXPECT_FALSE(cut.is_on_source_side(nodes[i])) << i;
}

TEST(Smooth_borders_test, teeth_are_cut_off)
{
  const Labels labels = smoothed(grid(16, 8), toothed());
  // Any straight line is the shortest; two of them move only the teeth.
  for (std::size_t f = 0; f < labels.size(); ++f)
    EXPECT_EQ(labels[f], labels[f % 16]) << f;
  EXPECT_EQ(border_length(grid(16, 8), labels), 8);
  EXPECT_EQ(std::abs(std::count(labels.begin(), labels.end(), 0u) - 68), 4);
}

TEST(Smooth_borders_test, does_not_depend_on_the_size_of_the_surface)
{
  const Labels expected = smoothed(grid(16, 4), toothed(16, 4));
  EXPECT_EQ(border_length(grid(16, 4), expected), 4);
  for (double factor : {1. / 16, 1. / 8, 1. / 4}) // 1/8: a surface of area 1
    EXPECT_EQ(smoothed(scaled(grid(16, 4), factor), toothed(16, 4)), expected) << factor;
}

TEST(Smooth_borders_test, a_valley_is_chosen_by_the_ratio_of_the_costs)
{
  // A strip of 12 quads, bent up by .1 rad along an edge beside the border; with g = 10 this edge
  // costs half its length. That of the border has length 1, all others 4.
  const auto result = [](double length_of_valley) {
    Soup strip;
    for (std::size_t i = 0; i <= 12; ++i) {
      const double length = i == 6   ? 1
                            : i == 7 ? length_of_valley
                                     : 4,
                   beyond = 0.2 * std::max(0.0, double(i) - 7);
      const double x = 0.2 * std::min(double(i), 7.0) + std::cos(0.1) * beyond,
                   z = std::sin(0.1) * beyond;
      strip.points.push_back({x, -length / 2, z});
      strip.points.push_back({x, length / 2, z});
    }
    for (std::size_t i = 0; i < 12; ++i)
      strip.polygons.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    return smoothed(strip, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, borders(0.2, 0.5, 10));
  };
  const Labels moved{0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, kept{0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  EXPECT_EQ(result(1.05), moved);
  EXPECT_EQ(result(1.95), moved);
  EXPECT_EQ(result(2.05), kept);
  EXPECT_EQ(result(3.00), kept);
}

TEST(Smooth_borders_test, faces_beyond_the_band_stay)
{
  // A tooth of 3 x 3 squares; one square is 1 / sqrt(128) = 0.088 wide. A band of no width is the
  // faces beside the border: that in the middle of the tooth stays, and holds the others.
  Labels labels;
  for (std::size_t f = 0; f < 128; ++f)
    labels.push_back(f % 16 < 8 || (f % 16 < 11 && f / 16 >= 3 && f / 16 < 6) ? 0 : 1);
  EXPECT_EQ(
    border_length(grid(16, 8), smoothed(grid(16, 8), labels, RS::Minimum_cut_borders{0.3, 1})), 8);
  EXPECT_EQ(smoothed(grid(16, 8), labels, RS::Minimum_cut_borders{0, 1}), labels);
  EXPECT_EQ(smoothed(grid(16, 8), labels, RS::Minimum_cut_borders{1, 0}), labels);
}

// The middle of a tooth is one step from the faces beside the border.
TEST(Smooth_borders_test, the_band_ends_with_its_width)
{
  Labels labels; // a tooth of 3 x 3 squares, each exactly 1/16 wide
  for (std::size_t f = 0; f < 256; ++f)
    labels.push_back(f % 32 < 16 || (f % 32 < 19 && f / 32 >= 3 && f / 32 < 6) ? 0 : 1);
  const auto length_within = [&](double width) {
    return border_length(grid(32, 8),
                         smoothed(grid(32, 8), labels, RS::Minimum_cut_borders{width, 1}));
  };
  EXPECT_EQ(length_within(0.99 / 16), 14);
  EXPECT_LT(length_within(1. / 16), 14);
}

TEST(Smooth_borders_test, keeps_its_promises_on_random_meshes)
{
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      std::mt19937 random(seed);
      const std::set<Edge> constrained = seed % 2 ? std::set<Edge>()
                                                  : random_edges(soup, 10, random);
      const Labels labels = random_segments(soup, 2 + seed, random, constrained);
      ASSERT_TRUE(is_connected(soup, labels, constrained));
      const Labels result = smoothed(soup, labels, wide, constrained);

      EXPECT_TRUE(is_connected(soup, result, constrained));
      EXPECT_EQ(std::set<std::size_t>(labels.begin(), labels.end()),
                std::set<std::size_t>(result.begin(), result.end()));
      EXPECT_TRUE(separates(soup, constrained, labels, result));
      EXPECT_EQ(smoothed_on<CGAL::Polyhedron_3<Kernel>>(soup, labels, wide, constrained), result);
      const RS::Minimum_cut_borders by_length = borders(0.2, 0.5, 0);
      EXPECT_LE(border_length(soup, smoothed(soup, labels, by_length, constrained), constrained),
                border_length(soup, labels, constrained) * (1 + 1e-6));
    }
}

TEST(Smooth_borders_test, pieces_of_one_label_stay_pieces)
{
  // Label 0 on both ends of the sheet, ragged.
  Labels labels = toothed(24, 8);
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (f % 24 >= 16 + f / 24 % 2)
      labels[f] = 0;
  const Labels result = smoothed(grid(24, 8), labels);
  EXPECT_EQ(border_length(grid(24, 8), result), 16);
  EXPECT_EQ(result[0], 0u);
  EXPECT_EQ(result[12], 1u);
  EXPECT_EQ(result[23], 0u);
}

TEST(Smooth_borders_test, has_constants_of_its_own)
{
  const Soup soup = grid(100, 50); // fine enough for a band of 0.03
  const Labels expected = smoothed(soup, toothed(100, 50), RS::Minimum_cut_borders());
  EXPECT_EQ(border_length(soup, expected), 50);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto map = face_labels(mesh, toothed(100, 50));
  RS::smooth_borders(mesh, map);
  EXPECT_EQ(labels_of(mesh, map), expected);
  const auto other_map = face_labels(mesh, toothed(100, 50));
  RS::smooth_borders(mesh, other_map, {}, CGAL::parameters::vertex_point_map(mesh.points()));
  EXPECT_EQ(labels_of(mesh, other_map), expected);
}

TEST(Smooth_borders_test, bears_meshes_with_nothing_to_do)
{
  EXPECT_EQ(smoothed(Soup(), {}), Labels());
  EXPECT_EQ(smoothed(cube(), {0, 1, 2, 3, 4, 5}), (Labels{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(smoothed(cube(), Labels(6, 9)), Labels(6, 9));
  Soup point;
  point.points = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  point.polygons = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(smoothed(point, {0, 1}), (Labels{0, 1}));
}

TEST(Smooth_borders_test, refuses_points_that_are_not_finite)
{
  Soup soup = grid(2, 1);
  soup.points[3][0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(smoothed(soup, {0, 1}), RS::Invalid_input);
}

} // namespace smooth_borders_test
