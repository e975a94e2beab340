// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/errors.h"
#include "io/read_mesh.h"
#include "soup/link_corners.h"

#include <gtest/gtest.h>

#include <ctime>

namespace repair_test {

using namespace segment_mesh;

using Indices = std::vector<std::size_t>;

//  3 ----- 2 ----- 5
//  |       |       |     two squares in the plane
//  0 ----- 1 ----- 4
const std::vector<Point> ladder = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                   {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};

TEST(Repair, leaves_an_oriented_manifold_alone)
{
  const Polygons polygons = {{0, 1, 2, 3}, {1, 4, 5, 2}};
  const Input_mesh input = make_input_mesh("x", {ladder, polygons});
  EXPECT_EQ(input.mesh_soup().polygons, polygons);
  EXPECT_EQ(input.mesh_soup().points, ladder);
  EXPECT_TRUE(input.remarks.empty());
}

TEST(Repair, leaves_out_unused_points_without_a_word)
{
  const Input_mesh input = make_input_mesh("x", {ladder, {{1, 4, 5, 2}}});
  EXPECT_EQ(input.mesh_soup().polygons, (Polygons{{0, 2, 3, 1}}));
  EXPECT_EQ(input.point_of_mesh_point, (Indices{1, 2, 4, 5}));
  EXPECT_EQ(input.soup.points, ladder);
  EXPECT_TRUE(input.remarks.empty());
}

TEST(Repair, turns_faces)
{
  const Input_mesh input = make_input_mesh("x", {ladder, {{0, 1, 2, 3}, {1, 2, 5, 4}}});
  EXPECT_TRUE(is_oriented_manifold(input.mesh_soup()));
  EXPECT_EQ(input.mesh_face_of_face, (Indices{0, 1}));
  EXPECT_EQ(
    input.remarks,
    (std::vector<std::string>{
      "x: not an oriented 2-manifold, repaired: 0 faces dropped, 1 turned, 0 points merged, 0 added"}));
}

TEST(Repair, splits_an_edge_of_three_faces)
{
  std::vector<Point> points = ladder;
  points.push_back({1, 0, 1});
  const Input_mesh input = make_input_mesh("x", {points, {{0, 1, 2, 3}, {1, 4, 5, 2}, {1, 2, 6}}});
  EXPECT_TRUE(is_oriented_manifold(input.mesh_soup()));
  EXPECT_EQ(input.mesh_soup().polygons.size(), 3u);
  EXPECT_GT(input.mesh_soup().points.size(), points.size());
  EXPECT_EQ(input.mesh_face_of_face, (Indices{0, 1, 2}));
  for (std::size_t i = 0; i < input.mesh_soup().points.size(); ++i)
    EXPECT_EQ(input.mesh_soup().points[i], points[input.point_of_mesh_point[i]]);
}

TEST(Repair, gives_a_second_copy_of_a_face_the_label_of_the_first)
{
  const Input_mesh input =
    make_input_mesh("x", {ladder, {{0, 1, 2, 3}, {1, 4, 5, 2}, {2, 3, 0, 1}}});
  EXPECT_EQ(input.mesh_soup().polygons.size(), 2u);
  EXPECT_EQ(input.mesh_face_of_face[2], input.mesh_face_of_face[0]);
  EXPECT_NE(input.mesh_face_of_face[1], input.mesh_face_of_face[0]);
  EXPECT_EQ(
    input.remarks.front().rfind("x: not an oriented 2-manifold, repaired: 1 face dropped", 0), 0u);
}

TEST(Repair, gives_a_dropped_face_the_label_of_a_neighbor)
{
  std::vector<Point> points = ladder;
  points.push_back({9, 0, 0}); // nearest to the second square
  const Polygons polygons = {{0, 1, 2, 3},
                             {1, 4, 5, 2},
                             {3, 0, 0},  // shares an edge with the first
                             {5, 5, 5},  // shares a vertex with the second
                             {6, 6, 6}}; // shares nothing
  const Input_mesh input = make_input_mesh("x", {points, polygons});
  ASSERT_EQ(input.mesh_soup().polygons.size(), 2u);
  const Indices& face = input.mesh_face_of_face;
  EXPECT_NE(face[0], face[1]);
  EXPECT_EQ(face[2], face[0]);
  EXPECT_EQ(face[3], face[1]);
  EXPECT_EQ(face[4], face[1]);
  EXPECT_EQ(
    input.remarks.front().rfind("x: not an oriented 2-manifold, repaired: 3 faces dropped", 0), 0u);
}

TEST(Repair, keeps_a_face_with_a_doubled_corner)
{
  const Input_mesh input = make_input_mesh("x", {ladder, {{0, 1, 1, 2}, {0, 2, 3}}});
  EXPECT_EQ(input.mesh_soup().polygons.size(), 2u);
  EXPECT_NE(input.mesh_face_of_face[0], input.mesh_face_of_face[1]);
  EXPECT_EQ(
    input.remarks.front().rfind("x: not an oriented 2-manifold, repaired: 0 faces dropped", 0), 0u);
}

TEST(Repair, tells_of_merged_points)
{
  std::vector<Point> points = ladder;
  points.insert(points.end(), {ladder[1], ladder[2], ladder[2]}); // the last is of no face
  const Input_mesh input = make_input_mesh("x", {points, {{0, 1, 2, 3}, {6, 7, 5, 4}, {0, 0, 1}}});
  EXPECT_EQ(input.mesh_soup().points.size(), ladder.size());
  EXPECT_EQ(
    input.remarks,
    (std::vector<std::string>{
      "x: not an oriented 2-manifold, repaired: 1 face dropped, 1 turned, 2 points merged, 0 added"}));
}

/// There and back along a line of points: a polygon that a repair in quadratic time takes a minute for.
TEST(Repair, splits_large_pinched_polygons_in_time)
{
  const std::size_t n = 40000;
  Polygon_soup soup;
  std::vector<std::vector<std::size_t>> polygons(2);
  for (std::size_t i = 0; i < n; ++i) {
    soup.points.push_back({double(i), double(i * i % 97), 0});
    polygons[0].push_back(i);
  }
  polygons[0].insert(polygons[0].end(), polygons[0].rbegin(), polygons[0].rend());
  for (std::size_t i = 0; i < n; ++i)
    polygons[1].insert(polygons[1].end(), {0, 1, 2});
  soup.polygons = polygons;
  const std::clock_t start = std::clock();
  const Input_mesh input = make_input_mesh("x", soup);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 5);
  EXPECT_EQ(input.mesh_soup().polygons.size(), 1u);
  EXPECT_EQ(input.mesh_soup().points.size(), 3u);
}

TEST(Repair, tells_when_nothing_is_left)
{
  try {
    make_input_mesh("x", {ladder, {{0, 0, 0}, {1, 1, 1}}});
    ADD_FAILURE() << "was taken";
  } catch (const Input_error& error) {
    EXPECT_STREQ(error.what(), "x: no faces are left of 2 faces after repair");
  }
}

} // namespace repair_test
