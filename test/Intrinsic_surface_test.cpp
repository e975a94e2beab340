// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same shape in another frame, unit or numbering is the same surface to the methods, and has
// the same parts, up to its symmetries.

#include "meshes.h"
#include "oracles.h"
#include "real_meshes.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Scalar_annotator.h>
#include <CGAL/Region_segmentation/Methods/Scalar_cost.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#endif
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/evaluation/rand_index_distance.h>
#include <CGAL/Region_segmentation/internal/surface/Intrinsic_surface.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace Intrinsic_surface_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Order = std::vector<std::size_t>;

/// A random rotation, translation, scale from 1e-3 to 1e3, and numbering of vertices, faces and
/// corners. `new_face`: the number of each face
Soup similar(const Soup& soup, unsigned seed, Order& new_face)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any(-1, 1);
  std::array<double, 4> q; // a unit quaternion
  double length = 0, size = 0;
  for (double& x : q)
    length = std::hypot(length, x = normal(random));
  for (double& x : q)
    x /= length;
  for (const Point& p : soup.points)
    size = std::max({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  const double scale = std::pow(1000, any(random)), w = q[0], x = q[1], y = q[2], z = q[3];
  const Point shift = {size * any(random), size * any(random), size * any(random)};
  Soup result = mapped(soup, [&](const Point& p) {
    return Point{scale * (shift[0] + (1 - 2 * (y * y + z * z)) * p[0] + 2 * (x * y - w * z) * p[1] +
                          2 * (x * z + w * y) * p[2]),
                 scale * (shift[1] + 2 * (x * y + w * z) * p[0] + (1 - 2 * (x * x + z * z)) * p[1] +
                          2 * (y * z - w * x) * p[2]),
                 scale * (shift[2] + 2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] +
                          (1 - 2 * (x * x + y * y)) * p[2])};
  });
  new_face.resize(soup.polygons.size());
  std::iota(new_face.begin(), new_face.end(), std::size_t(0));
  std::shuffle(new_face.begin(), new_face.end(), random);
  for (std::size_t f = 0; f < new_face.size(); ++f) {
    Polygon polygon = soup.polygons[f];
    std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(random() % polygon.size()),
                polygon.end());
    result.polygons[new_face[f]] = polygon;
  }
  Order new_vertex;
  shuffle_vertices(result, random, new_vertex);
  return result;
}

RS::Surface intrinsic_surface(const Soup& soup)
{
  const RS::Surface given = RS::make_surface(soup.points, soup.polygons);
  return RS::internal::Intrinsic_surface(given).of(given);
}

void expect_equal(const RS::Surface& a, const RS::Surface& b)
{
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_adjacencies(), b.number_of_adjacencies());
  std::size_t different = 0;
  for (std::size_t v = 0; v < a.number_of_vertices(); ++v)
    different += RS::squared_norm(a.point(v) - b.point(v)) != 0;
  for (std::size_t f = 0; f < a.number_of_faces(); ++f) {
    different += RS::squared_norm(a.normal(f) - b.normal(f)) != 0 || a.area(f) != b.area(f) ||
                 a.is_crumb(f) != b.is_crumb(f);
    ASSERT_EQ(a.number_of_corners(f), b.number_of_corners(f));
    for (std::size_t i = 0; i < a.number_of_corners(f); ++i)
      different += a.corner(f, i) != b.corner(f, i);
  }
  for (std::size_t i = 0; i < a.number_of_adjacencies(); ++i)
    different += a.lower_face(i) != b.lower_face(i) || a.higher_face(i) != b.higher_face(i) ||
                 a.squared_length(i) != b.squared_length(i) || a.flags(i) != b.flags(i);
  EXPECT_EQ(different, 0u);
  EXPECT_EQ(a.area(), b.area());
  EXPECT_EQ(a.length_unit(), b.length_unit());
  EXPECT_EQ(a.has_seams_or_links(), b.has_seams_or_links());
}

TEST(Intrinsic_surface_test, is_bitwise_the_same_in_any_frame)
{
  for (const Family family : {Family::SPHERE, Family::SHEET, Family::BLOCKS, Family::TORUS})
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      Order new_face;
      expect_equal(intrinsic_surface(soup), intrinsic_surface(similar(soup, seed, new_face)));
    }
}

TEST(Intrinsic_surface_test, is_what_is_made_of_its_points)
{
  for (const Soup& soup : {cube(), l_shape(), sphere(2), random_mesh(Family::SHEET, 3),
                           random_mesh(Family::BLOCKS, 3)}) {
    const RS::Surface surface = intrinsic_surface(soup);
    Soup of_surface;
    for (std::size_t v = 0; v < surface.number_of_vertices(); ++v)
      of_surface.points.push_back({surface.point(v).x, surface.point(v).y, surface.point(v).z});
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      of_surface.polygons.emplace_back();
      for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
        of_surface.polygons.back().push_back(surface.corner(f, i));
    }
    expect_equal(surface, RS::make_surface(of_surface.points, of_surface.polygons));
  }
}

// The largest faces, degenerate ones, and distances in units of the size, are those given.
TEST(Intrinsic_surface_test, keeps_degenerate_faces_and_proportions)
{
  for (const Soup& soup : {cap(), needle_on_crease(), pillow(), translated(cap(), 1e3, -2e3, 0)}) {
    const RS::Surface given = RS::make_surface(soup.points, soup.polygons);
    const RS::internal::Intrinsic_surface intrinsic(given);
    const RS::Surface& surface = intrinsic.of(given);
    const double unit = intrinsic.frame().unit();
    for (std::size_t f = 0; f < given.number_of_faces(); ++f) {
      if (surface.input_face(intrinsic.face(f)) != f)
        continue; // given twice
      EXPECT_EQ(surface.is_degenerate(intrinsic.face(f)), given.is_degenerate(f));
      EXPECT_NEAR(surface.area(intrinsic.face(f)), given.area(f) / unit / unit, 1e-7);
    }
    EXPECT_NEAR(surface.length_unit(), given.length_unit() / unit, 1e-7);
  }
}

// A triangle a million times as far away as the shape is large.
TEST(Intrinsic_surface_test, a_part_far_away_does_not_coarsen_the_others)
{
  Soup soup = torus(40, 20);
  const std::size_t faces = soup.polygons.size(), first = soup.points.size();
  for (const Point& p : {Point{3e6, 0, 0}, Point{3e6, 1, 0}, Point{3e6, 0, 1}})
    soup.points.push_back(p);
  soup.polygons.push_back({first, first + 1, first + 2});
  const RS::Surface given = RS::make_surface(soup.points, soup.polygons);
  const RS::internal::Intrinsic_surface intrinsic(given);
  for (std::size_t f = 0; f < faces; ++f) {
    const RS::Double_3 p = intrinsic.of(given).centroid(intrinsic.face(f));
    EXPECT_LT(norm(intrinsic.frame().point(p) - given.centroid(f)), 1e-8 * given.length_unit());
  }
}

/// Of the chosen number of segments, and of 4, 7 and 12.
template <typename Method>
std::vector<Labels> segmentations(const Soup& soup)
{
  Surface_mesh mesh = to_surface_mesh(soup);
  auto segment_id = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
  const RS::Segmenter segmenter(mesh, RS::parameters::method(Method()));
  segmenter.segment(segment_id);
  std::vector<Labels> result = {labels_of(mesh, segment_id)};
  for (const std::size_t number : {4, 7, 12}) {
    segmenter.segment(segment_id, number);
    result.push_back(labels_of(mesh, segment_id));
  }
  return result;
}

/// The Rand index distance is at most .005 for 95 % of the similarities, and .02 for all.
/// `symmetries`: of the shape, to which face each one leads
template <typename Method>
void expect_same_parts(const Soup& soup, const std::vector<Order>& symmetries)
{
  constexpr unsigned similarities = 20;
  const std::vector<Labels> expected = segmentations<Method>(soup);
  std::vector<unsigned> different(expected.size());
  for (unsigned seed = 1; seed <= similarities; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Order new_face;
    const std::vector<Labels> labels = segmentations<Method>(similar(soup, seed, new_face));
    for (std::size_t i = 0; i < labels.size(); ++i) {
      double least = 1;
      for (const Order& symmetry : symmetries) {
        Labels back;
        for (std::size_t f = 0; f < new_face.size(); ++f)
          back.push_back(labels[i][new_face[symmetry[f]]]);
        least = std::min(least, RS::rand_index_distance(RS::Partition::from_labels(expected[i]),
                                                        RS::Partition::from_labels(back)));
      }
      EXPECT_LE(least, 0.02) << "segmentation " << i;
      different[i] += least > 0.005;
    }
  }
  for (const unsigned n : different)
    EXPECT_LE(n, similarities / 20);
}

/// By each method but `Two_step`.
void expect_same_parts_by_all(const Soup& soup, const std::vector<Order>& symmetries)
{
  {
    SCOPED_TRACE("learned");
    expect_same_parts<RS::Learned_merging>(soup, symmetries);
  }
  {
    SCOPED_TRACE("visibility");
    expect_same_parts<RS::Visibility_merging>(soup, symmetries);
  }
#ifdef TEST_EIGEN
  SCOPED_TRACE("smooth-faces");
  expect_same_parts<RS::Smooth_faces>(soup, symmetries);
#endif
}

/// Those of the eight symmetries of a square in x and y, about the center of the box, that the
/// shape has.
std::vector<Order> symmetries_about_z(const Soup& soup)
{
  Point low = soup.points[0], high = low;
  for (const Point& p : soup.points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  std::map<std::array<long, 3>, std::size_t> face_at; // in doubled coordinates, summed over corners
  std::vector<std::array<long, 3>> places;
  for (const Polygon& polygon : soup.polygons) {
    std::array<double, 3> sum{};
    for (std::size_t v : polygon)
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += 2 * soup.points[v][k] - low[k] - high[k];
    places.push_back({std::lround(sum[0]), std::lround(sum[1]), std::lround(sum[2])});
    face_at[places.back()] = places.size() - 1;
  }
  std::vector<Order> result;
  for (int s = 0; s < 8; ++s) {
    Order order;
    for (auto [x, y, z] : places) {
      if (s & 1)
        std::swap(x, y);
      const auto face = face_at.find({s & 2 ? -x : x, s & 4 ? -y : y, z});
      if (face != face_at.end())
        order.push_back(face->second);
    }
    if (order.size() == places.size())
      result.push_back(order);
  }
  return result;
}

// Each face has equal ones beside it, and each part a mirror image.
TEST(Intrinsic_surface_test, symmetric_models_have_the_same_parts_in_any_frame)
{
  using Block = std::pair<Voxel, Voxel>;
  const std::vector<Block> legs = {
    {{0, 0, 0}, {2, 2, 5}}, {{6, 0, 0}, {8, 2, 5}}, {{0, 6, 0}, {2, 8, 5}}, {{6, 6, 0}, {8, 8, 5}}};
  std::vector<Block> table = legs, chair = legs;
  table.push_back({{0, 0, 5}, {8, 8, 6}});
  chair.push_back({{0, 0, 5}, {8, 8, 6}});
  chair.push_back({{0, 6, 6}, {8, 8, 12}});
  for (const auto& [blocks, number] : {std::pair(table, 8u), std::pair(chair, 2u)}) {
    std::vector<Voxel> voxels;
    for (const auto& [from, to] : blocks)
      for (const Voxel& v : voxel_block(from, to))
        voxels.push_back(v);
    const Soup soup = voxel_surface(voxels);
    const std::vector<Order> symmetries = symmetries_about_z(soup);
    SCOPED_TRACE(std::to_string(number) + " symmetries");
    EXPECT_EQ(symmetries.size(), number);
    expect_same_parts_by_all(soup, symmetries);
  }
}

/// The segmentations of the first faces, those of `soup`, by points and polygons.
template <typename Method>
std::vector<Labels> segmentations_of_first(const Soup& more, const Soup& soup)
{
  std::vector<Labels> result;
  for (const std::size_t number : {0, 2, 5, 9}) {
    Labels labels(more.polygons.size());
    const auto method = RS::parameters::method(Method());
    if (number == 0)
      RS::segment(more.points, more.polygons, labels, method);
    else
      RS::segment(more.points, more.polygons, labels, number, method);
    labels.resize(soup.polygons.size());
    result.push_back(labels);
  }
  return result;
}

/// By each method but `Two_step`.
void expect_equal_labels(const Soup& more, const Soup& soup)
{
  EXPECT_EQ(segmentations_of_first<RS::Learned_merging>(more, soup),
            segmentations_of_first<RS::Learned_merging>(soup, soup));
  EXPECT_EQ(segmentations_of_first<RS::Visibility_merging>(more, soup),
            segmentations_of_first<RS::Visibility_merging>(soup, soup));
#ifdef TEST_EIGEN
  EXPECT_EQ(segmentations_of_first<RS::Smooth_faces>(more, soup),
            segmentations_of_first<RS::Smooth_faces>(soup, soup));
#endif
}

// Near ties of the shape are not decided anew.
TEST(Intrinsic_surface_test, crumbs_do_not_change_the_labels_of_the_rest)
{
  std::vector<Soup> soups = {cube(), torus(20, 12), random_mesh(Family::BLOCKS, 1)};
  soups.push_back(mapped(sphere(4), [](const Point& p) { // two balls
    return Point{p[0] * 2, p[1] * (0.2 + p[0] * p[0]), p[2] * (0.2 + p[0] * p[0])};
  }));
  for (std::size_t i = 0; i < soups.size(); ++i) {
    SCOPED_TRACE(i);
    Soup more = soups[i];
    const double size = 1e-3 * std::sqrt(RS::make_surface(more.points, more.polygons).area());
    const Point at = more.points[more.polygons[0][0]];
    for (const double away : {3., 400., 1e4}) { // triangles beside, and far outside
      const std::size_t first = more.points.size();
      for (const Point& p : {Point{0, 0, 0}, Point{1, 0, 0.1}, Point{0, 1, 0.2}})
        more.points.push_back({at[0] + size * (away + p[0]), at[1] + size * (away + p[1]),
                               at[2] + size * (away + p[2])});
      more.polygons.push_back({first, first + 1, first + 2});
    }
    expect_equal_labels(more, soups[i]);
  }
}

TEST(Intrinsic_surface_test, faces_given_twice_do_not_change_the_labels)
{
  for (const Family family : {Family::SPHERE, Family::SHEET, Family::BLOCKS, Family::TORUS})
    for (const unsigned every : {1, 7}) {
      SCOPED_TRACE(name(family) + ", every " + std::to_string(every));
      const Soup soup = random_mesh(family, 2);
      Soup doubled = soup;
      for (std::size_t f = 0; f < soup.polygons.size(); f += every) {
        doubled.polygons.push_back(soup.polygons[f]);
        if (f % 2 == 0)
          std::reverse(doubled.polygons.back().begin(), doubled.polygons.back().end());
      }
      expect_equal_labels(doubled, soup);
      Labels labels(doubled.polygons.size());
      RS::segment(doubled.points, doubled.polygons, labels, 5);
      for (std::size_t f = 0, copy = soup.polygons.size(); f < soup.polygons.size();
           f += every, ++copy)
        EXPECT_EQ(labels[copy], labels[f]);
    }
}

// A scan of a part of the surface that lies on it, within 1/300 of its size.
TEST(Intrinsic_surface_test, a_scan_that_overlaps_does_not_change_the_labels)
{
  std::vector<Soup> soups = {torus(40, 24)};
  soups.push_back(mapped(sphere(4), [](const Point& p) { // two balls
    return Point{p[0] * 2, p[1] * (0.2 + p[0] * p[0]), p[2] * (0.2 + p[0] * p[0])};
  }));
  for (std::size_t i = 0; i < soups.size(); ++i) {
    const Soup& soup = soups[i];
    const double size = std::sqrt(RS::make_surface(soup.points, soup.polygons).area());
    for (unsigned seed = 1; seed <= 1; ++seed) {
      SCOPED_TRACE(std::to_string(i) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> any(-size / 1000, size / 1000);
      const Point shift = {any(random), any(random), any(random)};
      double middle = 0;
      for (const Point& p : soup.points)
        middle += p[0] / double(soup.points.size());
      Soup more = soup;
      std::vector<std::size_t> copied;
      for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
        bool is_beyond = true;
        for (const std::size_t v : soup.polygons[f])
          is_beyond = is_beyond && soup.points[v][0] > middle;
        if (!is_beyond)
          continue;
        copied.push_back(f);
        more.polygons.push_back(soup.polygons[f]);
        for (std::size_t& v : more.polygons.back())
          v += soup.points.size();
      }
      for (const Point& p : soup.points)
        more.points.push_back({p[0] + shift[0] + any(random), p[1] + shift[1] + any(random),
                               p[2] + shift[2] + any(random)});
      expect_equal_labels(more, soup);
      Labels labels(more.polygons.size());
      RS::segment(more.points, more.polygons, labels, 3);
      std::size_t equal = 0;
      for (std::size_t c = 0; c < copied.size(); ++c)
        equal += labels[soup.polygons.size() + c] == labels[copied[c]];
      EXPECT_GE(double(equal), 0.95 * double(copied.size()));
    }
  }
}

TEST(Intrinsic_surface_test, faces_given_twice_have_one_seed)
{
  Soup soup = sphere(3);
  soup.polygons.push_back(soup.polygons[5]);
  Labels seeds(soup.polygons.size(), std::size_t(-1)), labels(seeds.size());
  seeds[5] = 1;
  seeds[40] = 2;
  const auto segment = [&] {
    RS::segment(soup.points, soup.polygons, labels, 3, RS::parameters::face_seed_map(seeds));
  };
  segment();
  EXPECT_EQ(labels.back(), labels[5]);
  const Labels before = labels;
  seeds[5] = std::size_t(-1);
  seeds.back() = 1; // the copy has it
  segment();
  EXPECT_EQ(labels, before);
  seeds[5] = 2;
  EXPECT_THROW(segment(), RS::Invalid_input);
  EXPECT_EQ(labels, before);
}

// A user's values are those of the faces of the input.
TEST(Intrinsic_surface_test, values_are_by_faces_of_the_input)
{
  const Soup soup = sphere(3);
  std::vector<double> values;
  Labels halves;
  for (const Polygon& polygon : soup.polygons) {
    double z = 0;
    for (const std::size_t v : polygon)
      z += soup.points[v][2];
    values.push_back(z > 0 ? 1 : 0);
    halves.push_back(z > 0 ? 1 : 0);
  }
  const RS::Superfacet_merging method{RS::Scalar_annotator(values),
                                      RS::Lowest_cost_first(RS::Scalar_cost(1000)),
                                      RS::Number_from_costs(-19.5)};
  Labels labels(values.size());
  RS::segment(soup.points, soup.polygons, labels,
              RS::parameters::number_of_segments(2).method(method));
  EXPECT_LT(
    RS::rand_index_distance(RS::Partition::from_labels(labels), RS::Partition::from_labels(halves)),
    0.1);
  Soup doubled = soup;
  doubled.polygons.push_back(soup.polygons[0]);
  labels.push_back(0);
  const auto segment = [&] {
    RS::segment(doubled.points, doubled.polygons, labels,
                RS::parameters::number_of_segments(2).method(method));
  };
  EXPECT_THROW(segment(), RS::Invalid_input); // one value too few
}

// Flat faces of fandisk.off have thousands of coplanar patches.
TEST(Real_meshes, have_the_same_parts_in_any_frame)
{
  std::size_t checked = 0;
  for (const auto& file : off_files()) {
    const std::string name = file.stem().string();
    if (name != "fandisk" && name != "couplingdown" && name != "pinion" && name != "rotor_small")
      continue;
    SCOPED_TRACE(name);
    Surface_mesh mesh;
    std::ifstream in(file);
    ASSERT_TRUE(CGAL::IO::read_OFF(in, mesh));
    Order identity(num_faces(mesh));
    std::iota(identity.begin(), identity.end(), std::size_t(0));
    expect_same_parts_by_all(soup_of(mesh), {identity});
    ++checked;
  }
  if (checked == 0)
    GTEST_SKIP() << "REGION_SEGMENTATION_REAL_MESHES names no folder with these meshes";
}

} // namespace Intrinsic_surface_test
