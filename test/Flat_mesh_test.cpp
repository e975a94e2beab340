// SPDX-License-Identifier: GPL-3.0-or-later

// What is read of a mesh, against what a polygon soup tells without an order of faces.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::internal::Vector_3;

namespace {

Vector_3 vector(const Point& p)
{
  return {p[0], p[1], p[2]};
}

/// A bumpy sheet of several blocks of triangles and squares in any order; its points are not in one plane.
Soup mixed_sheet(std::mt19937& random)
{
  Soup soup = grid(90, 80);
  std::vector<Polygon> polygons;
  for (const Polygon& p : soup.polygons)
    if (random() % 3 == 0)
      polygons.push_back(p);
    else {
      polygons.push_back({p[0], p[1], p[2]});
      polygons.push_back({p[0], p[2], p[3]});
    }
  soup.polygons = std::move(polygons);
  bump(soup, 0.3, random);
  shuffle_faces(soup, random);
  return soup;
}

/// Half the sum of the cross products around the mean of the corners.
Vector_3 area_vector(const Soup& soup, const Polygon& polygon)
{
  Vector_3 center{}, sum{};
  for (std::size_t v : polygon)
    center = center + (1.0 / double(polygon.size())) * vector(soup.points[v]);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(vector(soup.points[polygon[i]]) - center,
                      vector(soup.points[polygon[(i + 1) % polygon.size()]]) - center);
  return 0.5 * sum;
}

/// From where to where a polygon goes along an edge.
std::pair<std::size_t, std::size_t> side_of(const Polygon& polygon, const Edge& edge)
{
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t u = polygon[i], v = polygon[(i + 1) % polygon.size()];
    if (make_edge(u, v) == edge)
      return {u, v};
  }
  throw std::logic_error("the polygon does not have the edge");
}

class Flat_mesh_test : public ::testing::TestWithParam<unsigned>
{
protected:
  void SetUp() override
  {
    std::mt19937 random(GetParam());
    soup = mixed_sheet(random);
    constrained = random_edges(soup, 9, random);
    const Surface_mesh mesh = to_surface_mesh(soup);
    const auto np = RS::internal::pack(RS::parameters::edge_is_constrained_map(edge_map(mesh, constrained)));
    flat = RS::internal::read_flat_mesh(RS::internal::make_mesh_walk(mesh, np), np,
                                        RS::Flat_mesh::Content::ANGLES_AND_POINTS);
    ASSERT_GT(flat.number_of_faces(), 2 * RS::internal::block_size);
    ASSERT_EQ(flat.number_of_faces(), soup.polygons.size());
  }

  Soup soup;
  std::set<Edge> constrained;
  RS::Flat_mesh flat;
};

TEST_P(Flat_mesh_test, faces_have_their_corners_areas_and_normals)
{
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f) {
    Polygon expected = soup.polygons[f];
    std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
    Polygon corners;
    for (std::size_t i = 0; i < flat.number_of_corners(f); ++i)
      corners.push_back(flat.corner(f, i));
    ASSERT_EQ(corners, expected) << "face " << f << ", seed " << GetParam();
    const Vector_3 a = area_vector(soup, expected);
    ASSERT_NEAR(flat.area(f), norm(a), 1e-12) << "face " << f << ", seed " << GetParam();
    ASSERT_LT(norm(flat.area(f) * flat.normal(f) - a), 1e-12) << "face " << f << ", seed " << GetParam();
  }
}

TEST_P(Flat_mesh_test, dual_edges_are_those_of_the_soup_by_higher_then_by_lower_face)
{
  std::map<std::pair<std::size_t, std::size_t>, Edge> expected;
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (faces.size() == 2)
      expected[{std::max(faces[0], faces[1]), std::min(faces[0], faces[1])}] = edge;
  ASSERT_EQ(flat.number_of_edges(), expected.size());

  std::size_t e = 0, number_convex = 0, number_concave = 0, number_constrained = 0;
  for (const auto& [faces, edge] : expected) {
    const auto [higher, lower] = faces;
    ASSERT_EQ(flat.higher_face(e), higher) << "edge " << e << ", seed " << GetParam();
    ASSERT_EQ(flat.lower_face(e), lower) << "edge " << e << ", seed " << GetParam();
    const auto [u, v] = side_of(soup.polygons[lower], edge);
    const Vector_3 d = vector(soup.points[v]) - vector(soup.points[u]);
    const double sign = dot(cross(flat.normal(lower), flat.normal(higher)), d);
    ASSERT_GT(std::abs(sign), 1e-12) << "the oracle cannot tell";
    ASSERT_NEAR(flat.length(e), norm(d), 1e-14);
    ASSERT_EQ(flat.has_flag(e, RS::Flat_mesh::CONVEX), sign > 0) << "edge " << e << ", seed " << GetParam();
    ASSERT_EQ(flat.has_flag(e, RS::Flat_mesh::CONCAVE), sign < 0) << "edge " << e << ", seed " << GetParam();
    ASSERT_EQ(flat.has_flag(e, RS::Flat_mesh::CONSTRAINED), constrained.count(edge) > 0)
      << "edge " << e << ", seed " << GetParam();
    number_convex += sign > 0;
    number_concave += sign < 0;
    number_constrained += constrained.count(edge);
    ++e;
  }
  EXPECT_GT(number_convex, 0u);
  EXPECT_GT(number_concave, 0u);
  EXPECT_GT(number_constrained, 0u);
}

TEST_P(Flat_mesh_test, the_first_edge_of_a_face_is_found)
{
  for (std::size_t f = 0; f <= flat.number_of_faces(); f += 7) {
    const std::size_t e = flat.first_edge(f);
    EXPECT_TRUE(e == flat.number_of_edges() || flat.higher_face(e) >= f) << "face " << f;
    EXPECT_TRUE(e == 0 || flat.higher_face(e - 1) < f) << "face " << f;
  }
}

INSTANTIATE_TEST_SUITE_P(seeds, Flat_mesh_test, ::testing::Values(1u, 2u));

} // namespace
