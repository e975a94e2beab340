// SPDX-License-Identifier: GPL-3.0-or-later

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/find_nearest_faces.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace transfer_labels_test {

template <typename From, typename To>
Labels transferred(const From& from, const Labels& labels, const To& to)
{
  auto map = face_map(to);
  const std::size_t number = RS::transfer_labels(from, face_labels(from, labels), to, map);
  const Labels result = labels_of(to, map);
  EXPECT_EQ(number, std::set<std::size_t>(result.begin(), result.end()).size());
  return result;
}

TEST(Transfer_labels_test, a_copy_of_any_type_has_the_same_labels)
{
  for_each_random_mesh(all_families, 3, [](const Soup& soup, unsigned seed) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    if (number_of_proper_faces(soup) < soup.polygons.size())
      return; // faces without area have no place of their own
    const Labels labels = random_labels(soup, 2 + seed, seed);
    const auto copy = to_mesh<CGAL::Polyhedron_3<Kernel>>(soup);
    EXPECT_EQ(transferred(mesh, labels, copy), labels);
    EXPECT_EQ(transferred(copy, labels, mesh), labels);
  });
}

/// Labels of the type From in a map of the type To.
template <typename To, typename From>
std::vector<To> transferred_to(const std::vector<From>& labels)
{
  const Surface_mesh mesh = to_surface_mesh(grid(labels.size(), 1));
  std::vector<To> into(labels.size(), 77);
  try {
    RS::transfer_labels(
      mesh, boost::make_iterator_property_map(labels.begin(), get(CGAL::face_index, mesh)), mesh,
      boost::make_iterator_property_map(into.begin(), get(CGAL::face_index, mesh)));
  } catch (const RS::Invalid_input&) {
    EXPECT_EQ(into, std::vector<To>(labels.size(), 77)) << "nothing is written";
    throw;
  }
  return into;
}

TEST(Transfer_labels_test, a_type_that_does_not_hold_the_labels_is_refused)
{
  std::vector<std::size_t> labels(400);
  std::iota(labels.begin(), labels.end(), std::size_t(0));
  EXPECT_THROW(transferred_to<std::uint8_t>(labels), RS::Invalid_input);
  EXPECT_EQ(transferred_to<std::uint16_t>(labels).back(), 399);
  for (std::size_t& label : labels)
    label = label % 256 == 255 ? std::size_t(-1) : label % 256;
  EXPECT_EQ(transferred_to<std::uint8_t>(labels)[255], 255) << "-1 is none in both types";
  labels.back() = 255;
  EXPECT_THROW(transferred_to<std::uint8_t>(labels), RS::Invalid_input) << "it would be none";
}

template <typename From, typename To>
void expect_no_segment_is_transferred()
{
  const From none = RS::no_segment;
  EXPECT_EQ(transferred_to<To>(std::vector<From>{0, none, 5, 100}),
            (std::vector<To>{0, RS::no_segment, 5, 100}));
}

TEST(Transfer_labels_test, no_segment_is_no_segment_in_every_type)
{
  expect_no_segment_is_transferred<std::uint32_t, std::size_t>();
  expect_no_segment_is_transferred<std::size_t, std::uint32_t>();
  expect_no_segment_is_transferred<std::uint8_t, std::int32_t>();
  expect_no_segment_is_transferred<std::uint16_t, std::int8_t>();
  expect_no_segment_is_transferred<std::int32_t, std::size_t>();
  expect_no_segment_is_transferred<std::int8_t, std::uint64_t>();
  expect_no_segment_is_transferred<std::int64_t, std::uint8_t>();
  expect_no_segment_is_transferred<unsigned, unsigned>();
}

TEST(Transfer_labels_test, a_label_keeps_its_value_or_is_refused)
{
  EXPECT_EQ(transferred_to<std::int8_t>(std::vector<int>{-128, -2, -1, 127}),
            (std::vector<std::int8_t>{-128, -2, -1, 127}));
  EXPECT_THROW(transferred_to<std::size_t>(std::vector<int>{0, -2}), RS::Invalid_input);
  EXPECT_THROW(transferred_to<int>(std::vector<std::uint32_t>{0, 4294967294u}), RS::Invalid_input);
  EXPECT_THROW(transferred_to<std::int8_t>(std::vector<std::uint8_t>{0, 128}), RS::Invalid_input);
  EXPECT_EQ(transferred_to<std::uint8_t>(std::vector<char>{0, 1}),
            (std::vector<std::uint8_t>{0, 1}));
}

TEST(Transfer_labels_test, a_remeshed_copy_and_back)
{
  const Soup soup = triangulated(dumbbell());
  Surface_mesh mesh = to_surface_mesh(soup), copy = mesh;
  const auto sides = [](const Surface_mesh& m) {
    double sum = 0;
    for (auto e : edges(m))
      sum += std::sqrt(CGAL::squared_distance(m.point(source(e, m)), m.point(target(e, m))));
    return sum / double(num_edges(m));
  };
  CGAL::Polygon_mesh_processing::isotropic_remeshing(faces(copy), 0.3 * sides(mesh), copy);
  copy.collect_garbage();
  const Labels labels = labels_along(0, soup, {2, 4});
  const Labels there = transferred(mesh, labels, copy);
  EXPECT_EQ(transferred(copy, there, mesh), labels);
  const Labels expected = labels_along(0, soup_of(copy), {2, 4});
  std::size_t same = 0;
  for (std::size_t f = 0; f < there.size(); ++f)
    same += there[f] == expected[f];
  EXPECT_GT(double(same), 0.95 * double(there.size()));
}

TEST(Transfer_labels_test, pieces_have_the_label_of_their_segment)
{
  const Soup soup = reversed(torus(12, 8)); // inside out: its pieces, which are open, are as given
  const Labels labels = random_labels(soup, 4, 1);
  const Surface_mesh mesh = to_surface_mesh(soup);
  std::vector<RS::Segment_piece<Surface_mesh, Surface_mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, face_labels(mesh, labels), std::back_inserter(pieces));
  for (const auto& piece : pieces)
    EXPECT_EQ(transferred(mesh, labels, piece.mesh), Labels(piece.faces.size(), piece.segment));
}

/// A thin plate with a label for each side, and a copy that is shifted by nearly its thickness.
TEST(Transfer_labels_test, labels_stay_on_their_side_of_a_wall)
{
  const auto plate = [](double shift) {
    return mapped(block(8, 8, 1), [=](const Point& p) {
      return Point{p[0], p[1], 0.01 * p[2] + shift};
    });
  };
  const Soup soup = plate(0);
  const Labels labels = labels_along(2, soup, {0.001, 0.009});
  EXPECT_EQ(transferred(to_surface_mesh(soup), labels, to_surface_mesh(plate(0.009))), labels);
}

/// A block with a winding band that is narrower than the faces of the other mesh: there it falls to
/// pieces, but for islands that are dissolved.
TEST(Transfer_labels_test, islands_are_dissolved)
{
  const std::size_t n = 80;
  const Soup fine = grid(n, n), coarse = scaled(grid(n / 4, n / 4), 4);
  const auto label_at = [](double x, double y) -> std::size_t {
    return x < 24 || std::abs(y - 40 - 6 * std::sin(x / 4)) < 1.5 ? 8 : 3;
  };
  Labels labels;
  for (std::size_t f = 0; f < n * n; ++f)
    labels.push_back(label_at(double(f % n) + 0.5, double(f / n) + 0.5));
  Labels votes; // of the quarters of each face
  for (std::size_t f = 0; f < n * n / 16; ++f) {
    const double x = 4 * double(f % (n / 4)) + 2, y = 4 * double(f / (n / 4)) + 2, d = 4. / 3;
    std::size_t number = 0;
    for (const auto& [i, j] : {std::pair(d, 0.), {-d, 0.}, {0., d}, {0., -d}})
      number += labels[std::size_t(y + j) * n + std::size_t(x + i)] == 8;
    votes.push_back(number >= 2 ? 8 : 3);
  }
  const auto number_of_components = [&](const Labels& l) {
    return count_segments(coarse, l).at(8).components;
  };
  ASSERT_EQ(count_segments(fine, labels).at(8).components, 1u);
  ASSERT_GT(number_of_components(votes), 1u);
  const Labels there = transferred(to_surface_mesh(fine), labels, to_surface_mesh(coarse));
  EXPECT_EQ(number_of_components(there), 1u);
  for (std::size_t f = 0; f < votes.size(); ++f)
    if (there[f] != votes[f]) {
      EXPECT_EQ(there[f], 3u); // the label around islands
    }
}

TEST(Find_nearest_faces_test, boxes_of_rounded_coordinates_leave_out_nothing)
{
  const double far = 1 << 23; // floats are integers there
  const auto triangle = [&](double x) {
    return Soup{{{far + x, 0, 0}, {far + x, 1, 0}, {far + x, 0, 1}}, {{0, 1, 2}}};
  };
  const Surface_mesh mesh = to_surface_mesh(joined(triangle(1.2), triangle(0.4)));
  std::vector<Surface_mesh::Face_index> nearest;
  RS::find_nearest_faces(mesh, std::vector<Kernel::Point_3>{{far + 0.6, 0.2, 0.2}},
                         std::back_inserter(nearest));
  EXPECT_EQ(nearest, std::vector<Surface_mesh::Face_index>{Surface_mesh::Face_index(1)});
}

TEST(Find_nearest_faces_test, distances_are_the_least)
{
  const auto squared_distance = [](const Soup& soup, std::size_t f, const Kernel::Point_3& p) {
    const auto corner = [&](std::size_t i) {
      const Point& c = soup.points[soup.polygons[f][i]];
      return Kernel::Point_3(c[0], c[1], c[2]);
    };
    return CGAL::squared_distance(p, Kernel::Triangle_3(corner(0), corner(1), corner(2)));
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Soup soup = triangulated(torus(12 + seed, 9));
    bump(soup, 0.1, random);
    const Surface_mesh mesh = to_surface_mesh(soup);
    std::uniform_real_distribution<double> coordinate(-4, 4);
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = 0; i < 200; ++i)
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    std::vector<Surface_mesh::Face_index> nearest;
    RS::find_nearest_faces(mesh, points, std::back_inserter(nearest));
    ASSERT_EQ(nearest.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t f = 0; f < soup.polygons.size(); ++f)
        least = (std::min)(least, squared_distance(soup, f, points[i]));
      EXPECT_NEAR(squared_distance(soup, nearest[i], points[i]), least, 1e-12);
    }
  }
}

TEST(Transfer_labels_test, wrong_input_is_refused)
{
  const Surface_mesh mesh = to_surface_mesh(cube());
  EXPECT_THROW(transferred(Surface_mesh(), {}, mesh), RS::Invalid_input);
  EXPECT_TRUE(transferred(mesh, Labels(6, 1), Surface_mesh()).empty());
  std::vector<Surface_mesh::Face_index> nearest;
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(RS::find_nearest_faces(mesh, std::vector<Kernel::Point_3>{{infinity, 0, 0}},
                                      std::back_inserter(nearest)),
               RS::Invalid_input);
  EXPECT_TRUE(nearest.empty());
}

} // namespace transfer_labels_test
