// SPDX-License-Identifier: GPL-3.0-or-later

// The pipeline on small meshes, with answers found by hand.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace segment_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
constexpr auto all = reference::Convexity::all;

TEST(Segment_test, dumbbell)
{
  // Concave: cube of 53 squares, bar of 8, cube of 53. k = 2: step two at once; the bar counts
  // least, both its sections are equal: the lower neighbor.
  const Result three = run(dumbbell(), Options(3));
  Labels expected(53, 0);
  expected.insert(expected.end(), 8, 1);
  expected.insert(expected.end(), 53, 2);
  EXPECT_EQ(three.segments, expected);
  EXPECT_EQ(three.number_of_segments, 3u);
  EXPECT_EQ(count(three.features), 8u);

  const Result two = run(dumbbell(), Options(2));
  std::fill(expected.begin(), expected.begin() + 61, 0);
  std::fill(expected.begin() + 61, expected.end(), 1);
  EXPECT_EQ(two.segments, expected);
  EXPECT_EQ(count(two.features), 8u) << "the features separate regions, not segments";
}

TEST(Segment_test, meshes_without_faces_or_with_one)
{
  EXPECT_EQ(run(Soup(), Options(3)).number_of_segments, 0u);
  EXPECT_EQ(run(grid(1, 1), Options(3)).segments, (Labels{0}));
}

TEST(Segment_test, isolated_vertices_do_not_matter)
{
  Surface_mesh mesh = to_surface_mesh(dumbbell());
  mesh.add_vertex(Kernel::Point_3(100, 100, 100));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mesh.add_vertex(Kernel::Point_3(nan, 1e300, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(run(mesh, Options(3)).segments, run(dumbbell(), Options(3)).segments);
}

/// What is said of a method with a constant outside of its range.
template <typename Method>
std::string refusal(const Method& method)
{
  const Surface_mesh mesh = to_surface_mesh(cube());
  auto map = face_map(mesh, 77);
  const std::string message = message_of<RS::Invalid_method>(
    [&] { RS::segment(mesh, map, RS::parameters::number_of_segments(2).method(method)); });
  EXPECT_TRUE(message == "taken" || labels_of(mesh, map) == Labels(6, 77));
  return message;
}

/// The same for each value of a constant, which `set(method, value)` sets.
template <typename Method, typename Set>
void expect_refused(const std::string& name, std::initializer_list<double> values, const Set& set)
{
  for (const double value : values) {
    Method method;
    set(method, value);
    EXPECT_EQ(refusal(method).find(name + " is "), 0u) << name << ' ' << value;
  }
  EXPECT_EQ(refusal(Method()), "taken");
}

TEST(Segment_test, constants_are_in_their_ranges)
{
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  using Two = RS::Two_step;
  expect_refused<Two>("Two_step: beta", {7, -1e-9, nan}, [](Two& m, double x) { m.beta = x; });
  expect_refused<Two>("Two_step: gamma", {-3, 1.1, nan}, [](Two& m, double x) { m.gamma = x; });
  expect_refused<Two>("Two_step: factor", {0, .9, nan}, [](Two& m, double x) { m.factor = x; });
  expect_refused<Two>("Two_step: maximum_angle", {-.001, 180.001, nan},
                      [](Two& m, double x) { m.maximum_angle = x; });
  using Visibility = RS::Visibility_merging;
  expect_refused<Visibility>("Superfacet_merging: number_of_draws", {0, 101, 1e18},
                             [](Visibility& m, double x) { m.number_of_draws = std::size_t(x); });
  expect_refused<Visibility>("Superfacets: number", {0, 1e10}, [](Visibility& m, double x) {
    m.superfacets.number = std::size_t(x);
  });
  expect_refused<Visibility>("Superfacets: concave_weight", {-1, nan, inf},
                             [](Visibility& m, double x) { m.superfacets.concave_weight = x; });
  expect_refused<Visibility>("Superfacets: maximum_deviation", {-1, nan},
                             [](Visibility& m, double x) { m.superfacets.maximum_deviation = x; });
  expect_refused<Visibility>(
    "Border_cost: concave_gain", {-1, nan, inf},
    [](Visibility& m, double x) { m.straightening.cost.concave_gain = x; });
  expect_refused<Visibility>("Minimum_cut_borders: width", {-1, nan},
                             [](Visibility& m, double x) { m.straightening.width = x; });
  expect_refused<Visibility>("granularity", {0, -1, nan},
                             [](Visibility& m, double x) { m.chooser.granularity = x; });
  expect_refused<Visibility>("minimum_number", {0}, [](Visibility& m, double x) {
    m.chooser.minimum_number = std::size_t(x);
  });
  expect_refused<Visibility>("an offset of Visibility_cost", {0, nan}, [](Visibility& m, double x) {
    RS::Visibility_cost cost;
    cost.depth_offset = x;
    m = Visibility(cost);
  });
  using Learned = RS::Learned_merging;
  expect_refused<Learned>("granularity", {0, nan},
                          [](Learned& m, double x) { m.chooser.granularity = x; });
  EXPECT_EQ(refusal(Two{1, RS::Feature_convexity::ALL, 7, -3, 0}),
            "Two_step: beta is 7, which is not in [0, 1]");
  EXPECT_THROW(RS::Smallest_region_first{nan}, RS::Invalid_method);
  EXPECT_THROW(RS::Least_compact_region_first(0.1, -3), RS::Invalid_method);
}

// Polygons

/// Labels 0 to 254 fit, 255 is `no_segment`; for a signed type 127 fits.
TEST(Segment_test, maps_of_too_small_a_type_are_refused_before_anything_is_written)
{
  const Soup soup = sphere(3);
  const Surface_mesh mesh = to_surface_mesh(soup);
  Surface_mesh copy = mesh;
  const auto try_with = [&](auto zero, std::size_t most) {
    using Label = decltype(zero);
    auto map = copy.add_property_map<Surface_mesh::Face_index, Label>("f:small", 77).first;
    std::vector<Label> labels(soup.polygons.size(), 77);
    const RS::Segmenter segmenter(mesh);
    const RS::Polygon_soup_segmenter of_soup(soup.points, soup.polygons);
    for (const std::size_t k : {most, most + 1}) {
      const bool fits = k == most;
      const auto expect = [&](const auto& segment) {
        if (fits)
          EXPECT_EQ(segment(), k);
        else
          EXPECT_THROW(segment(), RS::Invalid_input);
      };
      std::fill(labels.begin(), labels.end(), Label(77));
      for (auto f : faces(mesh))
        map[f] = Label(77);
      expect([&] { return RS::segment(mesh, map, RS::parameters::number_of_segments(k)); });
      expect([&] { return segmenter.segment(map, k); });
      expect([&] {
        return RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                        RS::parameters::number_of_segments(k));
      });
      expect([&] { return of_soup.segment(labels, k); });
      for (auto f : faces(mesh)) {
        EXPECT_TRUE(fits || map[f] == Label(77));
        EXPECT_TRUE(fits || labels[f] == Label(77));
      }
    }
    copy.remove_property_map(map);
  };
  try_with((unsigned char)(0), 255);
  try_with((signed char)(0), 128);
  auto small = copy.add_property_map<Surface_mesh::Face_index, unsigned char>("f:regions").first;
  Labels segments(soup.polygons.size(), 77);
  auto segment_map = boost::make_iterator_property_map(segments.begin(),
                                                       get(boost::face_index, mesh));
  const auto np = RS::parameters::number_of_segments(2).method(Options(2, all).method());
  EXPECT_EQ(RS::segment(mesh, segment_map, np), 2u);
  std::fill(segments.begin(), segments.end(), 77);
  EXPECT_THROW(RS::segment(mesh, segment_map, np.region_map(small)), RS::Invalid_input);
  EXPECT_EQ(segments, Labels(soup.polygons.size(), 77));
}

TEST(Segment_test, ranges_of_another_size_than_the_polygons_are_refused)
{
  const Soup soup = cube();
  const std::size_t size = soup.polygons.size();
  for (const std::size_t other : {std::size_t(0), size - 1, size + 1}) {
    Labels labels(other, 77), seeds(other, 0), regions(other), right(size, 77);
    EXPECT_THROW(RS::segment_polygon_soup(soup.points, soup.polygons, labels), RS::Invalid_input);
    EXPECT_EQ(labels, Labels(other, 77));
    EXPECT_THROW(RS::segment_polygon_soup(soup.points, soup.polygons, right,
                                          RS::parameters::face_seed_map(seeds)),
                 RS::Invalid_input);
    EXPECT_EQ(right, Labels(size, 77));
    const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons);
    EXPECT_THROW(segmenter.segment(labels, 2), RS::Invalid_input);
    EXPECT_EQ(labels, Labels(other, 77));
  }
}

// Time: a shape that is large in one way takes as long as others of its size.

/// Seeds 0 on all rows of squares but a band, seeds 1 on one side of a column of the band, through
/// which seeds 0 are joined, or on both, which then cannot be joined.
TEST(Segment_time_test, seeds_on_most_faces)
{
  constexpr std::size_t n = 150;
  const Soup soup = grid(n, n);
  for (const bool is_possible : {true, false}) {
    std::vector<std::size_t> seeds(n * n, std::size_t(-1)), labels(n * n);
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x)
        if (y < 72 || y > 78)
          seeds[y * n + x] = 0;
        else if (x < 50 || (x > 50 && !is_possible))
          seeds[y * n + x] = 1;
    const auto segment = [&] {
      return RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                      RS::parameters::number_of_segments(2).face_seed_map(seeds));
    };
    const std::clock_t start = std::clock();
    if (is_possible) {
      EXPECT_EQ(segment(), 2u);
      for (std::size_t f = 0; f < seeds.size(); ++f)
        EXPECT_TRUE(seeds[f] > 1 || labels[f] == seeds[f]);
    } else
      EXPECT_THROW(segment(), RS::Invalid_input);
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 5);
  }
}

TEST(Segment_time_test, polygons_of_many_corners)
{
  constexpr std::size_t n = 40000;
  Soup prism;
  Polygon bottom, top;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.0) * double(i) / n;
    prism.points.push_back({std::cos(angle), std::sin(angle), 0});
    prism.points.push_back({std::cos(angle), std::sin(angle), 1});
    const std::size_t next = 2 * ((i + 1) % n);
    prism.polygons.push_back({2 * i, next, next + 1, 2 * i + 1});
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
  }
  prism.polygons.push_back(bottom);
  prism.polygons.push_back(top);
  std::vector<std::size_t> labels(prism.polygons.size());
  const std::clock_t start = std::clock();
  EXPECT_EQ(RS::segment_polygon_soup(prism.points, prism.polygons, labels,
                                     RS::parameters::number_of_segments(3)),
            3u);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 8);
}

} // namespace segment_test
