// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "superfacet_stages.h"

#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::Double_3;

namespace Visibility_annotator_test {

/// Where a ray meets the plane of a triangle from behind, if that is inside by the signs of three
/// volumes.
double distance_to_triangle(const Double_3& o, const Double_3& d, const Double_3& a,
                            const Double_3& b, const Double_3& c)
{
  const double u = dot(d, cross(a - o, b - o)), v = dot(d, cross(b - o, c - o)),
               w = dot(d, cross(c - o, a - o));
  const bool is_inside = u > 0 && v > 0 && w > 0;
  const Double_3 n = cross(b - a, c - a);
  const double t = is_inside ? dot(a - o, n) / dot(d, n) : -1;
  return t > 0 ? t : std::numeric_limits<double>::infinity();
}

using Graph = Graph_of<RS::Visibility_annotator>;

Graph annotated(const RS::Surface& surface, const RS::Partition& regions)
{
  return test::annotated<RS::Visibility_annotator>(surface, regions);
}

RS::Partition face_each(const RS::Surface& mesh)
{
  return RS::Partition::into_single_elements(mesh.number_of_faces());
}

/// Triangles that do not touch: long and thin, in any direction.
Soup needles(std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Soup soup;
  for (std::size_t i = 0; i < number; ++i) {
    const Point a{any(random), any(random), any(random)}, b{any(random), any(random), any(random)};
    for (const Point& p :
         {a, b,
          Point{b[0] + 0.01 * any(random), b[1] + 0.01 * any(random), b[2] + 0.01 * any(random)}})
      soup.points.push_back(p);
    soup.polygons.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

RS::internal::Ray_tree tree_of(const RS::Surface& surface, const Double_3& origin)
{
  return RS::internal::Ray_tree(surface, patches_of(surface), origin);
}

RS::internal::Ray_tree tree_of(const RS::Surface& surface)
{
  return tree_of(surface, surface.centroid(0));
}

double distance_to_face(const RS::Surface& surface, std::size_t triangle, const Double_3& source,
                        const Double_3& direction)
{
  const auto corner = [&](std::size_t i) { return surface.point(surface.corner(triangle, i)); };
  return distance_to_triangle(source, direction, corner(0), corner(1), corner(2));
}

/// Rays from faces in all directions; returns how many hit.
std::size_t compare_hits(const Soup& soup, unsigned seed)
{
  const RS::Surface mesh = surface_of_soup(soup, false);
  const RS::internal::Ray_tree tree = tree_of(mesh);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t hits = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t skipped = random() % mesh.number_of_faces();
    const Double_3 source = mesh.centroid(skipped);
    Double_3 d{any(random), any(random), any(random)};
    d = (1 / norm(d)) * d;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      if (f != skipped)
        nearest = std::min(nearest, distance_to_face(mesh, f, source, d));
    const auto hit = tree.first_hit(source, d, RS::Surface::Index(skipped));
    if (std::isinf(nearest)) {
      EXPECT_EQ(hit.face, RS::internal::Ray_tree::no_face);
    } else {
      ++hits;
      EXPECT_NEAR(hit.distance, nearest, 1e-4 * (1 + nearest));
    }
  }
  return hits;
}

TEST(Ray_tree_test, finds_what_a_look_at_every_triangle_finds)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    for (Family family : {Family::SPHERE, Family::SHEET, Family::TWO_COMPONENTS}) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      EXPECT_GT(compare_hits(triangulated(random_mesh(family, seed)), seed), 20u);
    }
    SCOPED_TRACE("needles, seed " + std::to_string(seed));
    EXPECT_GT(compare_hits(needles(400, seed), seed), 20u);
  }
  // The last one has so many faces that the boxes are those of fine patches.
  for (const Soup& of_many_boxes :
       {needles(6000, 1), triangulated(torus(150, 60)), triangulated(torus(600, 120))})
    EXPECT_GT(compare_hits(of_many_boxes, 1), 20u);
}

TEST(Ray_tree_test, a_ray_that_is_not_a_number_hits_nothing)
{
  const RS::Surface mesh = surface_of_soup(triangulated(sphere(3)));
  const RS::internal::Ray_tree tree = tree_of(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [source, direction] :
       {std::make_pair(Double_3{nan, nan, nan}, Double_3{0, 0, 1}),
        std::make_pair(Double_3{0, 0, 0}, Double_3{nan, nan, nan})})
    EXPECT_EQ(tree.first_hit(source, direction, RS::internal::Ray_tree::no_face).face,
              RS::internal::Ray_tree::no_face);
}

TEST(Ray_tree_test, finds_needles_up_to_their_tips)
{
  const RS::Surface mesh = surface_of_soup(needles(400, 1));
  const RS::internal::Ray_tree tree = tree_of(mesh);
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Double_3& corner = mesh.point(mesh.corner(f, i));
      const Double_3 target = corner + 0.02 * (mesh.centroid(f) - corner);
      const auto hit = tree.first_hit(target - 0.5 * mesh.normal(f), mesh.normal(f),
                                      RS::internal::Ray_tree::no_face);
      ASSERT_NE(hit.face, RS::internal::Ray_tree::no_face) << f;
      EXPECT_LE(hit.distance, 0.5 + 1e-4) << f; // or another one before
    }
}

TEST(Ray_tree_test, finds_faces_right_in_front_of_a_source)
{
  // Faces whose boxes have no thickness of their own, at some units in the last place of a float:
  // from inside; from outside the opposite face is met.
  const Soup block = voxel_surface(voxel_block({0, 0, 0}, {4, 4, 4}));
  const RS::Surface mesh = surface_of_soup(block);
  const RS::internal::Ray_tree tree = tree_of(mesh, {2, 2, 2});
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const double side : {1.0, -1.0}) {
      const Double_3 away = side * mesh.normal(f);
      const auto hit = tree.first_hit(mesh.centroid(f) + 1e-6 * away, -1.0 * away,
                                      RS::internal::Ray_tree::no_face);
      EXPECT_EQ(hit.face == f, side < 0);
      EXPECT_NEAR(hit.distance, side < 0 ? 1e-6 : 4 + 1e-6, 1e-6);
    }
}

TEST(Ray_tree_test, of_faces_hit_at_the_same_distance_it_is_the_lowest)
{
  // Rays straight up to edges and corners of a plate of unit squares: without the face that was hit
  // another one is hit there, and not a lower one.
  const RS::Surface mesh = surface_of_soup(voxel_surface(voxel_block({0, 0, 0}, {16, 16, 1})));
  const RS::internal::Ray_tree tree = tree_of(mesh);
  std::size_t ties = 0;
  for (double x = 1; x < 16; x += 0.5)
    for (double y = 1; y < 16; y += 0.5) {
      const auto hit = tree.first_hit({x, y, -3}, {0, 0, 1}, RS::internal::Ray_tree::no_face);
      const auto next = tree.first_hit({x, y, -3}, {0, 0, 1}, hit.face);
      EXPECT_NEAR(hit.distance, 4, 1e-12);
      EXPECT_GE(next.distance, hit.distance);
      if (next.distance == hit.distance) {
        ++ties;
        EXPECT_GT(next.face, hit.face) << x << ' ' << y;
      }
    }
  EXPECT_GT(ties, 100u);
}

TEST(Region_shapes_test, are_those_of_the_faces_and_of_the_first_face_where_there_is_no_area)
{
  const Soup point{{{7, 8, 9}, {7, 8, 9}, {7, 8, 9}}, {{0, 1, 2}}};
  const RS::Surface mesh = surface_of_soup(joined(grid(2, 1), point)),
                    of_square = surface_of_soup(grid(1, 1));
  const RS::Region_shapes shapes(mesh, patches_of(mesh).fine,
                                 RS::Partition::from_labels(std::vector<int>{0, 0, 1}));
  ASSERT_EQ(shapes.regions.size(), 2u);
  EXPECT_EQ(shapes.regions[0].moments.weight, 1);
  EXPECT_EQ(shapes.regions[1].moments.weight, 0);
  const auto expect_equal = [](const Double_3& a, const Double_3& b) {
    EXPECT_NEAR(norm(a - b), 0, 1e-15) << a.x << ' ' << b.x;
  };
  expect_equal(shapes.regions[0].normal(), {0, 0, 1});
  expect_equal(shapes.regions[1].normal(), {0, 0, 0});
  expect_equal(shapes.centroid(shapes.regions[0].moments), {1, 0.5, 0});
  expect_equal(shapes.centroid(shapes.regions[1].moments), {0.5, 0.5, 0});
  expect_equal(shapes.centroid(shapes.surface), {1, 0.5, 0});

  const RS::Region_shapes of_one(of_square, patches_of(of_square).fine,
                                 RS::Partition::from_labels(std::vector<int>{0}));
  EXPECT_EQ(of_one.regions.at(0).moments.weight, 1);
  expect_equal(of_one.centroid(of_one.regions[0].moments), {0.5, 0.5, 0});
  expect_equal(of_one.centroid(of_one.surface), {0.5, 0.5, 0});
}

TEST(Inward_rays_test, small_regions_cast_one_ray_or_none)
{
  const auto number_of_rays = [](double one_of) {
    return RS::internal::Inward_rays::number_of_rays(1 / one_of);
  };
  EXPECT_EQ(number_of_rays(1), 12u);
  EXPECT_EQ(number_of_rays(6399), 12u);
  EXPECT_EQ(number_of_rays(6401), 1u);
  EXPECT_EQ(number_of_rays(25599), 1u);
  EXPECT_EQ(number_of_rays(25601), 0u);
}

TEST(Visibility_annotator_test, areas_are_shares_and_every_ray_has_two_ends)
{
  for (Family family : {Family::SPHERE, Family::TORUS, Family::DEGENERATE_TORUS}) {
    const RS::Surface mesh = surface_of_soup(random_mesh(family, 3));
    const Graph graph = annotated(mesh, face_each(mesh));
    double area = 0, ends = 0, between = 0;
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      area += graph[*range.first].area;
      ends += graph[*range.first].visibility;
    }
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      between += graph[*range.first].visibility;
    EXPECT_NEAR(area, 1, 1e-12);
    // No ray of a region of one face ends in it, so each is in the section of its ends.
    EXPECT_NEAR(ends, 2 * between, 1e-12);
    EXPECT_LE(between, 1 + 1e-12);
  }
}

TEST(Visibility_annotator_test, a_ray_that_leaves_through_an_opening_tells_nothing)
{
  // A box without its top, and a plate above, which rays meet from outside: it is another body.
  // They meet one that is turned over from inside: it is a lid.
  Soup box = triangulated(cube());
  const auto is_on_top = [&](const std::vector<std::size_t>& polygon) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](std::size_t v) { return box.points[v][2] == 1; });
  };
  box.polygons.erase(std::remove_if(box.polygons.begin(), box.polygons.end(), is_on_top),
                     box.polygons.end());
  ASSERT_EQ(box.polygons.size(), 10u);
  const Soup lid = translated(grid(1, 1), 0, 0, 3);
  const RS::Surface with_plate = surface_of_soup(joined(box, reversed(lid))),
                    with_lid = surface_of_soup(joined(box, lid));
  const Graph graph = annotated(with_plate, face_each(with_plate));
  const double diagonal = std::sqrt(3) / std::sqrt(with_plate.area());
  for (std::uint32_t f = 0; f < 10; ++f)
    EXPECT_LE(graph[f].mean_log_thickness(), std::log(diagonal + 1e-4)) << f;
  EXPECT_EQ(graph[10u].visibility, 0);
  EXPECT_GT(annotated(with_lid, face_each(with_lid))[10u].visibility, 0);
}

TEST(Visibility_annotator_test, opposite_sides_see_each_other_without_a_common_border)
{
  // The six faces of a cube: rays from one end on others, the one straight in on the opposite one.
  const RS::Surface mesh = surface_of_soup(cube());
  const Graph graph = annotated(mesh, face_each(mesh));
  EXPECT_EQ(graph.number_of_sections(), 12u + 3u);
  for (std::uint32_t axis : {0u, 2u, 4u}) {
    const auto opposite = graph.section(axis, axis + 1);
    ASSERT_TRUE(opposite.has_value());
    EXPECT_EQ(graph[*opposite].number_of_adjacencies, 0u);
    EXPECT_GT(graph[*opposite].visibility, 0);
  }
}

TEST(Visibility_annotator_test, deviations_are_integrated_by_sign_up_to_a_bound)
{
  // A box on a plate: 4 concave edges of pi / 2, which count as 0.6. Inside out they are convex,
  // and count in full.
  for (bool is_inside_out : {false, true}) {
    Soup soup = box_on_plate();
    if (is_inside_out) {
      soup.polygons.pop_back(); // open, so that it is read as it is
      soup = reversed(soup);
    }
    const RS::Surface mesh = surface_of_soup(soup);
    const auto is_feature = RS::detect_feature_edges(
      mesh, 30, is_inside_out ? RS::Feature_convexity::CONVEX : RS::Feature_convexity::CONCAVE);
    const RS::Partition regions = RS::grow_regions(mesh, is_feature);
    ASSERT_EQ(regions.number_of_parts(), 2u);
    const Graph graph = annotated(mesh, regions);
    const auto& section = graph[*graph.section(0, 1)];
    const double length = double(section.number_of_adjacencies) / std::sqrt(mesh.area());
    EXPECT_NEAR(section.length, length, 1e-12);
    EXPECT_NEAR(section.concave, is_inside_out ? 0 : 0.6 * length, 1e-12);
    EXPECT_NEAR(section.convex, is_inside_out ? std::acos(-1.0) / 2 * length : 0, 1e-12);
  }
}

TEST(Visibility_annotator_test, regions_with_one_centroid_bend_away_from_each_other)
{
  const RS::Surface mesh = surface_of_soup(pillow());
  const Graph graph = annotated(mesh, face_each(mesh));
  const auto& section = graph[*graph.section(0, 1)];
  EXPECT_GT(section.length, 0);
  EXPECT_DOUBLE_EQ(section.bend, -std::acos(-1.0) * section.length);
}

TEST(Visibility_annotator_test, a_surface_without_area_is_left_as_it_is)
{
  const Soup point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  const RS::Surface mesh = surface_of_soup(point);
  const Graph graph = annotated(mesh, face_each(mesh));
  EXPECT_EQ(graph[0u].area, 0);
  EXPECT_EQ(graph[0u].visibility, 0);
  EXPECT_EQ(graph[0u].mean_log_thickness(), 0);
}

} // namespace Visibility_annotator_test
