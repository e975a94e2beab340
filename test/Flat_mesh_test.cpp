// SPDX-License-Identifier: GPL-3.0-or-later

// The data read from a mesh, compared with those of a polygon soup without an order of faces.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::Double_3;

namespace Flat_mesh_test {

Double_3 vector(const Point& p)
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
Double_3 area_vector(const Soup& soup, const Polygon& polygon)
{
  Double_3 center{}, sum{};
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
    flat = RS::read_flat_mesh(mesh,
                              RS::Mesh_data::POINTS | RS::Mesh_data::CENTROIDS | RS::Mesh_data::SURFACE_AREA,
                              RS::parameters::edge_is_constrained_map(edge_map(mesh, constrained)));
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
    for (std::size_t i = 0; i < flat.points().number_of_corners(f); ++i)
      corners.push_back(flat.points().corner(f, i));
    ASSERT_EQ(corners, expected) << "face " << f << ", seed " << GetParam();
    const Double_3 a = area_vector(soup, expected);
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
    const Double_3 d = vector(soup.points[v]) - vector(soup.points[u]);
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

TEST_P(Flat_mesh_test, points_centroids_and_the_area_of_the_surface)
{
  ASSERT_EQ(flat.unit(), 1);
  ASSERT_EQ(flat.points().number_of_points(), soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (double d : {flat.points()[v].x - soup.points[v][0], flat.points()[v].y - soup.points[v][1],
                     flat.points()[v].z - soup.points[v][2]})
      ASSERT_EQ(d, 0) << "vertex " << v;
  double area = 0;
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f) {
    Double_3 center{};
    for (std::size_t v : soup.polygons[f])
      center = center + (1.0 / double(soup.polygons[f].size())) * vector(soup.points[v]);
    ASSERT_LT(norm(flat.centroid(f) - center), 1e-12) << "face " << f;
    area += flat.area(f);
  }
  EXPECT_EQ(flat.surface_area(), area);
  EXPECT_EQ(flat.relative_unit(), std::sqrt(area));
}

TEST_P(Flat_mesh_test, a_mesh_is_the_same_when_points_are_read_after_the_patches)
{
  std::mt19937 random(GetParam());
  const Surface_mesh surface_mesh = to_surface_mesh(mixed_sheet(random));
  const auto& np = RS::internal::pack(RS::parameters::default_values());
  const auto traversal = RS::internal::make_mesh_traversal(surface_mesh, np);
  const RS::Execution<> execution;
  const RS::Mesh_data data = RS::Mesh_data::POINTS | RS::Mesh_data::PATCHES;
  const auto read = [&](std::size_t most_with_early_corners) {
    return RS::internal::Flat_mesh_reader(traversal, np, data, execution, most_with_early_corners).read();
  };
  const RS::Flat_mesh one = read(num_faces(surface_mesh)), other = read(num_faces(surface_mesh) - 1);
  const RS::Mesh_points &early = one.points(), &late = other.points();
  ASSERT_EQ(early.number_of_points(), late.number_of_points());
  for (std::size_t v = 0; v < early.number_of_points(); ++v)
    EXPECT_EQ(squared_norm(early[v] - late[v]), 0);
  for (std::size_t f = 0; f < num_faces(surface_mesh); ++f) {
    ASSERT_EQ(early.number_of_corners(f), late.number_of_corners(f));
    for (std::size_t i = 0; i < early.number_of_corners(f); ++i)
      EXPECT_EQ(early.corner(f, i), late.corner(f, i)) << "face " << f;
    EXPECT_EQ(squared_norm(one.centroid(f) - other.centroid(f)), 0) << "stored, and computed, of face " << f;
    EXPECT_EQ(one.patches().of_faces()[f], other.patches().of_faces()[f]) << "face " << f;
  }
  for (std::size_t p = 0; p < one.patches().size(); ++p)
    EXPECT_EQ(one.patches()[p].center, other.patches()[p].center) << "patch " << p;
}

TEST_P(Flat_mesh_test, a_constraint_can_be_set_and_taken_back)
{
  const std::size_t e = 17;
  const auto flags = flat.flags(e);
  flat.constrain(e);
  EXPECT_TRUE(flat.has_flag(e, RS::Flat_mesh::CONSTRAINED));
  flat.release(e);
  EXPECT_FALSE(flat.has_flag(e, RS::Flat_mesh::CONSTRAINED));
  EXPECT_EQ(flat.flags(e), flags & ~RS::Flat_mesh::CONSTRAINED);
}

INSTANTIATE_TEST_SUITE_P(seeds, Flat_mesh_test, ::testing::Values(1u, 2u));

TEST(Deviation_test, is_a_number_where_normals_are_equal_or_opposite)
{
  // Two unit squares in any plane, and two triangles back to back: rounding may bring the product of unit normals beyond 1 or -1.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t beyond = 0;
  for (int i = 0; i < 1000; ++i) {
    const Double_3 u{any(random), any(random), any(random)}, v{any(random), any(random), any(random)};
    const auto on_plane = [&](const Point& p) -> Point {
      return {p[0] * u.x + p[1] * v.x, p[0] * u.y + p[1] * v.y, p[0] * u.z + p[1] * v.z};
    };
    const auto read = [&](const Soup& soup) { return RS::read_flat_mesh(to_surface_mesh(mapped(soup, on_plane))); };
    const RS::Flat_mesh flat = read(grid(2, 1)), folded = read({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
    beyond += dot(flat.normal(0), flat.normal(0)) > 1;
    ASSERT_EQ(flat.number_of_edges(), 1u);
    EXPECT_LE(flat.cosine(0, 0), 1);
    EXPECT_NEAR(flat.deviation(0, 0), 0, 1e-6) << "plane " << i;
    ASSERT_EQ(folded.number_of_edges(), 3u);
    EXPECT_GE(folded.cosine(0, 0), -1);
    EXPECT_NEAR(folded.deviation(0, 0), std::acos(-1.0), 1e-6) << "plane " << i;
  }
  EXPECT_GT(beyond, 100u);
}

TEST(Mesh_data_test, what_was_not_asked_for_cannot_be_read)
{
  using RS::Mesh_data;
  const Surface_mesh mesh = to_surface_mesh(cube());
  for (int set = 0; set < 8; ++set) {
    const auto data = Mesh_data(set);
    const RS::Flat_mesh flat = RS::read_flat_mesh(mesh, data);
    EXPECT_EQ(flat.data(), data);
    const auto expect = [&](Mesh_data one, const char* name, auto read) {
      if (includes(data, one))
        EXPECT_NO_THROW(read());
      else
        try {
          read();
          ADD_FAILURE() << name << " was read";
        } catch (const RS::Invalid_method& error) {
          EXPECT_NE(std::string(error.what()).find(std::string("Mesh_data::") + name), std::string::npos)
            << error.what();
        }
    };
    expect(Mesh_data::POINTS, "POINTS", [&] { flat.points(); });
    expect(Mesh_data::CENTROIDS, "CENTROIDS", [&] { flat.centroid(0); });
    expect(Mesh_data::SURFACE_AREA, "SURFACE_AREA", [&] { flat.surface_area(); });
    expect(Mesh_data::SURFACE_AREA, "SURFACE_AREA", [&] { flat.relative_unit(); });
    expect(Mesh_data::PATCHES, "PATCHES", [&] { flat.patches(); });
    EXPECT_EQ(flat.area(0), 1);
  }
}

TEST(Unit_test, is_that_of_the_mesh_unless_coordinates_are_extreme)
{
  const Soup soup = random_mesh(Family::SPHERE, 2);
  const auto read = [](const Soup& s) { return RS::read_flat_mesh(to_surface_mesh(s)); };
  const RS::Flat_mesh expected = read(soup);
  ASSERT_EQ(expected.unit(), 1);
  for (int exponent : {-900, -300, -10, 0, 10, 300, 900}) {
    SCOPED_TRACE(exponent);
    const double scale = std::ldexp(1, exponent);
    const RS::Flat_mesh flat = read(scaled(soup, scale));
    if (std::abs(exponent) <= 10) {
      EXPECT_EQ(flat.unit(), 1);
    } else if (std::abs(exponent) >= 900) {
      EXPECT_NE(flat.unit(), 1);
    }
    int power = 0;
    EXPECT_EQ(std::frexp(flat.unit(), &power), 0.5) << "a power of two";
    // In mesh units lengths are the same bits, times the scale.
    for (std::size_t e = 0; e < flat.number_of_edges(); ++e) {
      ASSERT_EQ(flat.length(e) * flat.unit(), expected.length(e) * scale);
      ASSERT_EQ(flat.flags(e), expected.flags(e));
    }
    for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
      ASSERT_EQ(norm(flat.normal(f) - expected.normal(f)), 0);
  }
}

} // namespace Flat_mesh_test
