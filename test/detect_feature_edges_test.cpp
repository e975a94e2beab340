// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace detect_feature_edges_test {

namespace RS = CGAL::Region_segmentation;
using RS::Feature_convexity;
using namespace test;

/// The edges that are detected, over a map that was all true.
std::set<Edge> features(const Soup& soup, const Feature_options& options)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto map = edge_map(mesh, std::uint8_t(1));
  const std::size_t n = test::detect_feature_edges(mesh, map, options);
  const std::set<Edge> result = marked_edges(mesh, map);
  EXPECT_EQ(n, result.size());
  return result;
}

std::size_t number_of_features(const Soup& soup, Feature_convexity convexity, double maximum_angle)
{
  return features(soup, {maximum_angle, convexity}).size();
}

TEST(Detect_feature_edges_test,
     a_closed_surface_is_turned_if_it_is_inside_out_an_open_one_is_read_as_it_is)
{
  EXPECT_EQ(number_of_features(reversed(cube()), Feature_convexity::CONVEX, 30), 12u);
  EXPECT_EQ(number_of_features(reversed(cube()), Feature_convexity::CONCAVE, 30), 0u);
  Soup box = cube();
  box.polygons.pop_back(); // 8 edges between faces, 4 at the border
  EXPECT_EQ(number_of_features(box, Feature_convexity::CONVEX, 30), 12u);
  EXPECT_EQ(number_of_features(reversed(box), Feature_convexity::CONVEX, 30), 4u);
  EXPECT_EQ(number_of_features(reversed(box), Feature_convexity::CONCAVE, 30), 12u);
}

TEST(Detect_feature_edges_test, the_bound_is_a_deviation_in_degrees)
{
  for (double angle : {0.0, 45.0, 89.999})
    EXPECT_EQ(number_of_features(cube(), Feature_convexity::ALL, angle), 12u) << angle;
  for (double angle : {90.001, 135.0, 180.0})
    EXPECT_EQ(number_of_features(cube(), Feature_convexity::ALL, angle), 0u) << angle;
}

TEST(Detect_feature_edges_test, defaults_are_concave_and_the_bound_of_the_paper)
{
  // A valley of deviation d along the middle of a sheet, then the same as a ridge.
  const auto valley = [](double degrees) {
    const double slope = std::tan(degrees / 2 * std::acos(-1.0) / 180);
    return mapped(grid(2, 1), [=](const Point& p) {
      return Point{p[0], p[1], slope * std::abs(p[0] - 1)};
    });
  };
  const double bound = 180 - 3.12 * 180 / std::acos(-1.0);
  const std::size_t borders = 6;
  const Feature_options defaults;
  EXPECT_EQ(features(valley(bound - 1e-6), defaults).size(), borders);
  EXPECT_EQ(features(valley(bound + 1e-6), defaults).size(), borders + 1);
  EXPECT_EQ(features(valley(-bound - 1e-6), defaults).size(), borders) << "a ridge";
}

TEST(Detect_feature_edges_test, sign_zero_counts_under_all_alone)
{
  // Folded flat: the normals are opposite, their product is 0.
  EXPECT_EQ(number_of_features(pillow(), Feature_convexity::ALL, 30), 4u);
  EXPECT_EQ(number_of_features(pillow(), Feature_convexity::CONVEX, 30), 0u);
  EXPECT_EQ(number_of_features(pillow(), Feature_convexity::CONCAVE, 30), 0u);
}

TEST(Detect_feature_edges_test, a_polygon_has_one_normal)
{
  // A pentagon whose first corner lies on the line of its neighbors; a normal from the first corner
  // alone would be 0 or noise.
  const Soup soup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0.5, 0}, {-1, 0, 0}, {-1, 1, 0}},
                  {{4, 0, 1, 2, 3}, {4, 3, 6, 5, 0}}};
  EXPECT_EQ(number_of_features(soup, Feature_convexity::ALL, 0),
            6u); // borders; 0-4 and 4-3 are flat
}

TEST(Detect_feature_edges_test, large_components_are_turned_one_by_one)
{
  const Soup large = translated(torus(120, 60), 30, 20, 10), small = scaled(torus(60, 30), 0.1),
             sheet = grid(3, 3);
  ASSERT_GT(large.polygons.size(), RS::internal::block_size);
  for (Feature_convexity convexity : {Feature_convexity::CONVEX, Feature_convexity::CONCAVE}) {
    const Feature_options options{2, convexity};
    const auto expected = features(joined(small, large), options);
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(features(joined(small, reversed(large)), options), expected);
    EXPECT_EQ(features(joined(reversed(small), large), options), expected);
    EXPECT_EQ(features(joined(reversed(small), reversed(large)), options), expected);
    EXPECT_EQ(features(joined(reversed(large), sheet), options),
              features(joined(large, sheet), options));
  }
}

/// A face is degenerate by its longest edge, whichever it is: the area is below 1e-12 times the
/// square of that one, but above that of the others.
TEST(Detect_feature_edges_test, the_longest_edge_of_a_cap_tells_that_it_is_degenerate)
{
  for (std::size_t turn = 0; turn < 3; ++turn) {
    const auto corner = [turn](std::size_t i) { return (i + turn) % 3; };
    Soup cap;
    cap.points.resize(4);
    cap.points[corner(0)] = {0, 0, 0};
    cap.points[corner(1)] = {1, 0, 0};
    cap.points[corner(2)] = {0.5, 1e-12, 0};
    cap.points[3] = {0.5, -0.5, 0.5};
    cap.polygons = {{corner(0), corner(1), corner(2)}, {corner(1), corner(0), 3}};
    const Feature_options all{20, Feature_convexity::ALL};
    EXPECT_EQ(features(cap, all).size(), 4u) << "its borders; turn " << turn;
    cap.points[corner(2)] = {0.5, 3e-12, 0};
    EXPECT_EQ(features(cap, all).size(), 5u) << turn;
  }
}

struct Throwing_constraints
{
  using key_type = Surface_mesh::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  std::size_t last;

  friend bool get(const Throwing_constraints& map, key_type e)
  {
    if (std::size_t(e) >= map.last)
      throw std::runtime_error("no constraint");
    return false;
  }
};

TEST(Detect_feature_edges_test, constraints_that_throw_leave_the_map_as_it_was)
{
  const Surface_mesh mesh = to_surface_mesh(torus(12, 6));
  std::vector<bool> marks(num_edges(mesh), true);
  const auto map = boost::make_iterator_property_map(marks.begin(), get(boost::edge_index, mesh));
  EXPECT_THROW(test::detect_feature_edges(mesh, map, Feature_options(),
                                          RS::parameters::edge_is_constrained_map(
                                            Throwing_constraints{num_edges(mesh) / 2})),
               std::runtime_error);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), true), std::ptrdiff_t(marks.size()));
}

// An edge that ends inside a face has that face on both sides.
//     3-----2
//     |  4  |      the face is 0 1 2 3 0 4; the edge 0-4 ends inside it
//     | /   |
//     0-----1
TEST(Detect_feature_edges_test, an_edge_inside_a_face_is_no_feature)
{
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for (const Point& p : {Point{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}})
    v.push_back(mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2])));
  const auto f = mesh.add_face(v[0], v[1], v[2], v[3]);
  const auto into = halfedge(v[3], v[0], mesh).first; // the halfedge of f that ends at 0
  const auto spike = mesh.add_edge(v[0], v[4]);
  const auto after = mesh.next(into);
  mesh.set_next(into, spike);
  mesh.set_next(spike, mesh.opposite(spike));
  mesh.set_next(mesh.opposite(spike), after);
  mesh.set_face(spike, f);
  mesh.set_face(mesh.opposite(spike), f);
  mesh.set_halfedge(v[4], spike);
  ASSERT_TRUE(mesh.is_valid());

  auto map = edge_map(mesh, std::uint8_t(1));
  EXPECT_EQ(test::detect_feature_edges(mesh, map, Feature_options{0, Feature_convexity::ALL}), 4u);
  EXPECT_FALSE(get(map, mesh.edge(spike)));
}

} // namespace detect_feature_edges_test
