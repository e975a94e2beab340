// SPDX-License-Identifier: GPL-3.0-or-later

#include "real_meshes.h"
#include "segments.h"

#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace close_segments_test {

using Corners = std::array<Point, 3>; // the lowest of three orders

Corners from_lowest(const Corners& c)
{
  return (std::min)({c, Corners{c[1], c[2], c[0]}, Corners{c[2], c[0], c[1]}});
}

/// Of a closed soup.
double volume(const Soup& soup)
{
  double sum = 0;
  for (const Polygon& polygon : soup.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Point &p = soup.points[polygon[0]], &q = soup.points[polygon[i - 1]],
                  &r = soup.points[polygon[i]];
      sum += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
              p[2] * (q[0] * r[1] - q[1] * r[0])) /
             6;
    }
  return sum;
}

/// The solids as soups, and which solids have each triangle of a cap.
struct Solids
{
  std::vector<Soup> soups;
  std::map<Corners, std::vector<std::size_t>> segments_of_cap;

  double sum_of_volumes() const
  {
    double sum = 0;
    for (const Soup& soup : soups)
      sum += volume(soup);
    return sum;
  }
};

/// Closes the segments of a mesh, and checks what is right for all meshes.
template <typename Mesh, typename Solid_mesh = Mesh,
          typename Parameters = RS::parameters::Default_named_parameters>
Solids close(const Soup& soup, const Labels& labels,
             const Parameters& np = RS::parameters::default_values())
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<RS::Segment_piece<Solid_mesh, Mesh, std::size_t>> solids;
  RS::close_segments<Solid_mesh>(mesh, face_labels(mesh, labels), std::back_inserter(solids), np);
  std::map<typename boost::graph_traits<Mesh>::face_descriptor, std::size_t> rank;
  for (auto f : faces(mesh))
    rank.emplace(f, rank.size());
  Solids result;
  std::multiset<std::size_t> found;
  for (const auto& solid : solids) {
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(solid.mesh));
    EXPECT_TRUE(CGAL::is_closed(solid.mesh));
    result.soups.push_back(soup_of(solid.mesh));
    const Soup& copy = result.soups.back();
    EXPECT_EQ(solid.faces.size(), copy.polygons.size());
    EXPECT_EQ(solid.vertices.size(), copy.points.size());
    for (std::size_t f = 0; f < copy.polygons.size(); ++f)
      if (solid.faces[f] != boost::graph_traits<Mesh>::null_face()) {
        found.insert(rank.at(solid.faces[f]));
        EXPECT_EQ(labels[rank.at(solid.faces[f])], solid.segment);
        EXPECT_EQ(copy.polygons[f].size(), soup.polygons[rank.at(solid.faces[f])].size());
      } else {
        EXPECT_EQ(copy.polygons[f].size(), 3u);
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i)
          corners[i] = copy.points[copy.polygons[f][i]];
        result.segments_of_cap[from_lowest(corners)].push_back(solid.segment);
      }
  }
  std::multiset<std::size_t> expected;
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (labels[f] != std::size_t(-1))
      expected.insert(f);
  EXPECT_EQ(found, expected);
  return result;
}

/// Each triangle of a cap is in two solids, with opposite orientations; the volumes add up.
void expect_fitting(const Soup& soup, const Solids& solids)
{
  for (const auto& [corners, segments] : solids.segments_of_cap) {
    const auto other = solids.segments_of_cap.find(
      from_lowest({corners[0], corners[2], corners[1]}));
    ASSERT_NE(other, solids.segments_of_cap.end());
    ASSERT_EQ(segments.size(), other->second.size());
    if (segments.size() == 1) {
      EXPECT_NE(segments[0], other->second[0]);
    }
  }
  EXPECT_NEAR(solids.sum_of_volumes(), volume(soup), 1e-9 * std::abs(volume(soup)));
}

Labels thirds_around_z(const Soup& soup)
{
  Labels labels;
  for (const Polygon& polygon : soup.polygons) {
    double x = 0, y = 0;
    for (std::size_t v : polygon) {
      x += soup.points[v][0];
      y += soup.points[v][1];
    }
    labels.push_back(std::size_t((std::atan2(y, x) + 3.2) / 6.4 * 3));
  }
  return labels;
}

TEST(Close_segments_test, halves_of_a_cube_share_a_flat_cap)
{
  const Soup soup = block(2, 2, 2);
  const Labels labels = labels_along(0, soup, {1});
  const Solids solids = close<Surface_mesh>(soup, labels);
  expect_fitting(soup, solids);
  EXPECT_EQ(solids.segments_of_cap.size(), 16u); // 8 sides of the square, from both
  for (const Soup& half : solids.soups)
    EXPECT_NEAR(volume(half), 4, 1e-12);
  for (const auto& [corners, segments] : solids.segments_of_cap)
    for (const Point& p : corners)
      EXPECT_DOUBLE_EQ(p[0], 1);
}

std::vector<Soup> solids_with_clearance(const Soup& soup, const Labels& labels, double clearance)
{
  return close<Surface_mesh>(soup, labels, RS::parameters::clearance(clearance)).soups;
}

/// Two boxes of 2 x 2 x .9 in place of 1, at any angle and scale; the outer sides stay.
TEST(Close_segments_test, halves_of_a_cube_with_clearance_are_so_far_apart)
{
  const Soup cube = block(2, 2, 2);
  const Labels labels = labels_along(0, cube, {1});
  for (double scale : {1e-3, 1.0, 1e3}) {
    Soup soup = cube;
    for (Point& p : soup.points)
      p = {scale * (.6 * p[0] - .8 * p[1]), scale * (.8 * p[0] + .6 * p[1]), scale * p[2]};
    const std::vector<Soup> solids = solids_with_clearance(soup, labels, .2 * scale);
    ASSERT_EQ(solids.size(), 2u);
    for (const Soup& half : solids) {
      EXPECT_NEAR(volume(half), 3.6 * scale * scale * scale, 1e-9 * scale * scale * scale);
      for (const Point& p : half.points) {
        const double x = (.6 * p[0] + .8 * p[1]) / scale, y = (.6 * p[1] - .8 * p[0]) / scale;
        const double z = p[2] / scale;
        EXPECT_LT((std::min)({std::abs(x), std::abs(x - .9), std::abs(x - 1.1), std::abs(x - 2)}),
                  1e-9);
        EXPECT_LT((std::max)({-x, x - 2, -y, y - 2, -z, z - 2}), 1e-9);
      }
    }
  }
}

/// Each pyramid of six is made of planes that were moved: it is one of the height h - .1 sqrt(2),
/// as its base stays and its four sides move by .1.
TEST(Close_segments_test, pyramids_with_clearance_are_smaller)
{
  const Soup soup = cube(); // of edge 2
  const double edge = std::cbrt(volume(soup));
  const double height = edge / 2 - .05 * edge * std::sqrt(2);
  for (const Soup& pyramid : solids_with_clearance(soup, {0, 1, 2, 3, 4, 5}, .1 * edge))
    EXPECT_NEAR(volume(pyramid), 4 * height * height * height / 3, 1e-9 * volume(soup));
}

TEST(Close_segments_test, clearance_of_huge_coordinates_and_of_open_meshes)
{
  const Soup soup = scaled(cube(), 1e250);
  for (const Soup& solid : solids_with_clearance(soup, {0, 0, 0, 1, 1, 1}, 1e248))
    for (const Point& p : solid.points)
      EXPECT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
  // Caps on the border of the mesh stay.
  const Labels one(cap().polygons.size(), 7);
  EXPECT_EQ(solids_with_clearance(cap(), one, .1)[0].points,
            solids_with_clearance(cap(), one, 0)[0].points);
}

/// Three segments that meet in the poles of a sphere: the caps of all meet in an inner curve.
TEST(Close_segments_test, three_segments_share_an_inner_curve)
{
  const Soup soup = sphere(3);
  const Labels labels = thirds_around_z(soup);
  const Solids solids = close<Surface_mesh>(soup, labels);
  ASSERT_EQ(solids.soups.size(), 3u);
  expect_fitting(soup, solids);
  for (const Soup& third : solids.soups)
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(to_surface_mesh(third)));
}

/// Two lobes with a thin wall, and each of them alone.
TEST(Close_segments_test, segments_of_a_hollow_mesh_are_hollow)
{
  const Soup outer = mapped(triangulated(sphere(4)), [](const Point& p) {
    const double waist = 1 - 0.7 * std::exp(-9 * p[0] * p[0]);
    return Point{3 * p[0], waist * p[1], waist * p[2]};
  });
  const Soup inner = reversed(scaled(outer, 0.8)), soup = joined(outer, inner);
  const Labels labels = segments_of(to_surface_mesh(soup), RS::parameters::number_of_segments(2));
  const Solids solids = close<Surface_mesh>(soup, labels);
  ASSERT_EQ(solids.soups.size(), 2u);
  expect_fitting(soup, solids);
  for (const Soup& half : solids.soups)
    EXPECT_NEAR(volume(half), volume(soup) / 2, 0.05 * volume(soup));
}

TEST(Close_segments_test, random_segments_fit)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  for_each_random_mesh(all_families, 5, [&](const Soup& soup, unsigned seed) {
    Labels labels = random_labels(soup, 2 + seed, seed);
    const Solids solids = close<Surface_mesh>(soup, labels);
    const Solids others = close<Polyhedron, Surface_mesh>(soup, labels);
    EXPECT_EQ(solids.segments_of_cap, others.segments_of_cap);
    if (!CGAL::is_closed(to_surface_mesh(soup)))
      return;
    const Soup triangles = triangulated(soup); // whose volume is defined
    labels = random_labels(triangles, 2 + seed, seed);
    std::replace(labels.begin(), labels.end(), std::size_t(-1), std::size_t(0));
    expect_fitting(triangles, close<Surface_mesh>(triangles, labels));
  });
}

TEST(Real_meshes_close_segments, bands_of_real_meshes_fit)
{
  check_real_meshes(20000, [](const Surface_mesh& mesh) {
    if (!CGAL::is_closed(mesh))
      return false;
    const Soup soup = triangulated(soup_of(mesh));
    double low = 1e300, high = -1e300;
    for (const Point& p : soup.points) {
      low = (std::min)(low, p[0]);
      high = (std::max)(high, p[0]);
    }
    const double band = (high - low) / 4;
    const Labels labels = labels_along(0, soup, {low + band, low + 2 * band, low + 3 * band});
    expect_fitting(soup, close<Surface_mesh>(soup, labels));
    return true;
  });
}

} // namespace close_segments_test
