// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Manifold.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <vector>

namespace manifold_test {

using namespace segment_mesh;

using Indices = std::vector<std::size_t>;

//  3 ----- 2 ----- 5
//  |       |       |     two squares in the plane
//  0 ----- 1 ----- 4
const std::vector<Point> ladder = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                   {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};

/// A mesh with the points of the soup.
Manifold checked(const Polygon_soup& soup)
{
  Manifold manifold = make_manifold(soup);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(manifold.mesh));
  EXPECT_EQ(manifold.mesh.number_of_faces(), manifold.face_of_mesh_face.size());
  EXPECT_EQ(manifold.mesh.number_of_vertices(), manifold.point_of_mesh_point.size());
  for (const auto v : manifold.mesh.vertices()) {
    const auto& p = manifold.mesh.point(v);
    EXPECT_EQ((Point{p.x(), p.y(), p.z()}), soup.points[manifold.point_of_mesh_point[v]]);
  }
  return manifold;
}

TEST(Manifold, has_the_points_that_are_used)
{
  const Manifold manifold = checked({ladder, {{1, 4, 5, 2}}});
  EXPECT_EQ(manifold.face_of_mesh_face, (Indices{0}));
  EXPECT_EQ(manifold.point_of_mesh_point, (Indices{1, 4, 5, 2}));
}

TEST(Manifold, turns_faces)
{
  const Manifold manifold = checked({ladder, {{0, 1, 2, 3}, {1, 2, 5, 4}}});
  EXPECT_EQ(manifold.mesh.number_of_edges(), 7u);
  EXPECT_EQ(manifold.face_of_mesh_face, (Indices{0, 1}));
}

TEST(Manifold, merges_equal_points)
{
  std::vector<Point> points = ladder;
  points.insert(points.end(), {ladder[1], ladder[2]});
  const Manifold manifold = checked({points, {{0, 1, 2, 3}, {6, 7, 5, 4}}});
  EXPECT_EQ(manifold.mesh.number_of_edges(), 7u);
  EXPECT_EQ(manifold.mesh.number_of_vertices(), 6u);
}

TEST(Manifold, is_torn_at_an_edge_of_three_faces)
{
  std::vector<Point> points = ladder;
  points.push_back({1, 0, 1});
  const Manifold manifold = checked({points, {{0, 1, 2, 3}, {1, 4, 5, 2}, {1, 2, 6}}});
  EXPECT_EQ(manifold.face_of_mesh_face, (Indices{0, 1, 2}));
  EXPECT_GT(manifold.mesh.number_of_vertices(), points.size());
}

TEST(Manifold, is_torn_at_a_point_of_two_fans)
{
  EXPECT_EQ(checked({ladder, {{0, 1, 3}, {1, 4, 5}}}).mesh.number_of_vertices(), 6u);
}

/// A strip whose ends are joined with a half turn.
TEST(Manifold, is_torn_where_faces_cannot_have_one_orientation)
{
  const std::size_t n = 7;
  Polygon_soup soup;
  std::vector<std::vector<std::size_t>> polygons;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / n, x = std::cos(angle), y = std::sin(angle),
                 r = std::cos(angle / 2) / 3, z = std::sin(angle / 2) / 3;
    soup.points.insert(soup.points.end(), {{x - r * x, y - r * y, -z}, {x + r * x, y + r * y, z}});
    const std::size_t next = i + 1 < n ? 2 * i + 2 : 1, other = i + 1 < n ? next + 1 : 0;
    polygons.push_back({2 * i, next, other, 2 * i + 1});
  }
  soup.polygons = polygons;
  const Manifold manifold = checked(soup);
  EXPECT_EQ(manifold.face_of_mesh_face.size(), n);
  EXPECT_EQ(manifold.mesh.number_of_edges(), 3 * n + 1);
}

// A square with a square hole, joined by a bridge.
TEST(Manifold, keeps_faces_that_come_back_to_a_corner)
{
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                     {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  const Manifold manifold = checked({points, {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}}});
  EXPECT_EQ(manifold.face_of_mesh_face, (Indices{0}));
  EXPECT_EQ(manifold.mesh.number_of_vertices(), 10u);
}

TEST(Manifold, is_closed_where_faces_come_back_to_a_corner)
{
  const std::vector<Point> corners = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                      {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  Polygon_soup soup;
  soup.points = corners;
  for (const Point& p : corners)
    soup.points.push_back({p[0], p[1], 1});
  std::vector<std::vector<std::size_t>> polygons = {{0, 4, 5, 6, 7, 4, 0, 3, 2, 1},
                                                    {8, 9, 10, 11, 8, 12, 15, 14, 13, 12}};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    polygons.push_back({i, next, 8 + next, 8 + i});
    polygons.push_back({4 + next, 4 + i, 12 + i, 12 + next});
  }
  soup.polygons = polygons;
  const Manifold manifold = make_manifold(soup); // a bridge has its face on both sides
  EXPECT_TRUE(CGAL::is_valid_face_graph(manifold.mesh));
  EXPECT_TRUE(CGAL::is_closed(manifold.mesh));
}

TEST(Manifold, leaves_out_faces_with_equal_corners)
{
  EXPECT_EQ(checked({ladder, {{0, 1, 2, 3}, {3, 0, 0}, {1, 4, 5, 2}, {5, 5, 5}}}).face_of_mesh_face,
            (Indices{0, 2}));
  EXPECT_TRUE(checked({ladder, {{0, 0, 0}, {1, 1, 1}}}).mesh.is_empty());
}

TEST(Manifold, has_faces_that_are_given_twice)
{
  EXPECT_EQ(checked({ladder, {{0, 1, 2, 3}, {1, 4, 5, 2}, {2, 3, 0, 1}}}).face_of_mesh_face,
            (Indices{0, 1, 2}));
}

/// There and back along a line of points: polygons that some repairs take a minute for.
TEST(Manifold, is_made_of_large_pinched_polygons_in_time)
{
  const std::size_t n = 10000;
  Polygon_soup soup;
  std::vector<std::vector<std::size_t>> polygons(2);
  for (std::size_t i = 0; i < n; ++i) {
    soup.points.push_back({double(i), double(i * i % 97), 0});
    polygons[0].push_back(i);
    polygons[1].insert(polygons[1].end(), {0, 1, 2});
  }
  polygons[0].insert(polygons[0].end(), polygons[0].rbegin(), polygons[0].rend());
  polygons.push_back({0, 1, 2});
  soup.polygons = polygons;
  const std::clock_t start = std::clock();
  EXPECT_EQ(checked(soup).face_of_mesh_face, (Indices{0, 1, 2}));
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 5);
}

} // namespace manifold_test
