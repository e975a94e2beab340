// SPDX-License-Identifier: GPL-3.0-or-later

// Closed components inside others: which of them bound voids, and the segments of their faces.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/region_segmentation.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace voids_test {

constexpr std::size_t none = std::size_t(-1);

/// A soup of components, in shuffled order.
struct Hollow
{
  Hollow(const std::vector<Soup>& components, std::vector<std::size_t> bodies, unsigned seed)
    : body_of_void(std::move(bodies))
  {
    std::mt19937 random(seed);
    std::vector<std::pair<Polygon, std::size_t>> faces; // with their components
    for (std::size_t c = 0; c < components.size(); ++c) {
      const Soup part = mapped(components[c], [&](const Point& p) { // without symmetry
        return Point{p[0] + 0.01 * p[1] * p[2], 1.01 * p[1] - 0.02 * p[0] * p[0], 0.99 * p[2]};
      });
      for (Polygon polygon : part.polygons) {
        for (std::size_t& v : polygon)
          v += soup.points.size();
        faces.push_back({polygon, c});
      }
      soup.points.insert(soup.points.end(), part.points.begin(), part.points.end());
    }
    std::shuffle(faces.begin(), faces.end(), random);
    for (const auto& [polygon, c] : faces) {
      soup.polygons.push_back(polygon);
      component.push_back(c);
    }
  }

  bool is_void(std::size_t face) const { return body_of_void[component[face]] != none; }

  /// The faces that bound no void, in their order.
  Soup solid() const
  {
    Soup result{soup.points, {}};
    for (std::size_t f = 0; f < component.size(); ++f)
      if (!is_void(f))
        result.polygons.push_back(soup.polygons[f]);
    return result;
  }

  Soup soup;
  std::vector<std::size_t> component;    // by face
  std::vector<std::size_t> body_of_void; // by component, `none`: it bounds no void
};

std::map<std::string, Hollow> hollow_shapes(unsigned seed)
{
  const Soup ball = sphere(2);
  const auto ball_of = [&](double radius) { return scaled(ball, radius); };
  const auto void_of = [&](double radius) { return reversed(ball_of(radius)); };
  const Soup ring = triangulated(torus(24, 12, 0.8)), tube = triangulated(torus(18, 8, 0.5));
  const Soup bar = triangulated(translated(block(8, 3, 3), -4, -1.5, -1.5));
  const Soup spiked = mapped(void_of(1.5), [](const Point& p) {
    const double factor = p[0] < -1.49 ? 1.6 : 1;
    return Point{factor * p[0], p[1], p[2]};
  });
  return {{"ball", Hollow({ball_of(2), void_of(1.5)}, {none, 0}, seed)},
          {"void that pierces the wall", Hollow({ball_of(2), spiked}, {none, 0}, seed)},
          {"ring", Hollow({reversed(tube), ring}, {1, none}, seed)},
          {"bar with two voids",
           Hollow({bar, translated(void_of(1), -2.3, 0, 0.1), translated(void_of(1.2), 2, 0, 0)},
                  {none, 0, 0}, seed)},
          {"ball in a bell", Hollow({ball_of(2), void_of(1.8), translated(ball_of(1), 0.5, 0, 0)},
                                    {none, 0, none}, seed)},
          {"void in a ball in a bell",
           Hollow({ball_of(2), void_of(1.7), ball_of(1.2), void_of(1)}, {none, 0, none, 2}, seed)},
          {"two hollow balls", Hollow({ball_of(2), void_of(1.5), translated(ball_of(2), 4.5, 0, 0),
                                       translated(void_of(0.7), 4.2, 0.2, 0)},
                                      {none, 0, none, 2}, seed)},
          {"ball in a ball", Hollow({ball_of(2), ball_of(1)}, {none, none}, seed)},
          {"inside out in a void",
           Hollow({ball_of(2), void_of(1.8), void_of(1)}, {none, 0, none}, seed)}};
}

/// The labels of polygons and of a `Surface_mesh`, which are equal.
template <typename Parameters>
Labels labels_of_both(const Soup& soup, const Parameters& np)
{
  Labels labels(soup.polygons.size());
  RS::segment_polygon_soup(soup.points, soup.polygons, labels, np);
  EXPECT_EQ(segments_of(to_surface_mesh(soup), np), labels);
  return labels;
}

/// Calls `check(np)` for all methods that fill voids, with a number of segments and with one that
/// they choose.
template <typename Check>
void for_each_method(const Check& check)
{
  const auto given = RS::parameters::number_of_segments(4);
  check("learned", given.method(RS::Learned_merging()));
  check("learned, chosen", RS::parameters::method(RS::Learned_merging()));
  check("visibility", given.method(RS::Visibility_merging()));
  check("visibility, chosen", RS::parameters::method(RS::Visibility_merging()));
  RS::Two_step two_step;
  two_step.maximum_angle = 20;
  two_step.feature_convexity = RS::Feature_convexity::ALL;
  check("two-step", given.method(two_step));
}

/// Whether the label of a face of a void is that of a face of its body that is nearest to the mean
/// of its corners, by brute force.
bool is_label_around(const Hollow& hollow, const Labels& labels, std::size_t face)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto point = [&](std::size_t v) {
    const Point& p = hollow.soup.points[v];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  const Polygon& polygon = hollow.soup.polygons[face];
  Kernel::Vector_3 sum(0, 0, 0);
  for (std::size_t v : polygon)
    sum = sum + (point(v) - CGAL::ORIGIN) / double(polygon.size());
  double least = 1e300, least_of_label = 1e300;
  for (std::size_t f = 0; f < labels.size(); ++f)
    if (hollow.component[f] == hollow.body_of_void[hollow.component[face]]) {
      const Polygon& p = hollow.soup.polygons[f];
      const double d = CGAL::squared_distance(
        CGAL::ORIGIN + sum, Kernel::Triangle_3(point(p[0]), point(p[1]), point(p[2])));
      least = std::min(least, d);
      if (labels[f] == labels[face])
        least_of_label = std::min(least_of_label, d);
    }
  return least_of_label <= least * (1 + 1e-9);
}

TEST(Voids_test, have_the_segments_of_the_nearest_faces_around_and_do_not_change_the_others)
{
  for (const bool is_inside_out : {false, true}) {
    auto shapes = hollow_shapes(is_inside_out ? 2 : 1);
    for (auto& [shape, hollow] : shapes) {
      if (is_inside_out)
        hollow.soup = reversed(hollow.soup);
      for_each_method([&, &shape = shape, &hollow = hollow](const char* method, const auto& np) {
        SCOPED_TRACE(shape + ", " + method + (is_inside_out ? ", inside out" : ""));
        const Labels labels = labels_of_both(hollow.soup, np);
        Labels of_solid;
        for (std::size_t f = 0; f < labels.size(); ++f)
          if (!hollow.is_void(f))
            of_solid.push_back(labels[f]);
          else {
            ASSERT_TRUE(is_label_around(hollow, labels, f)) << f;
          }
        if (shape != "inside out in a void") { // without the void it would bound one
          EXPECT_EQ(renumbered(of_solid), labels_of_both(hollow.solid(), np));
        }
      });
    }
  }
}

// With more than 16,383 faces, some have one nearest face.
TEST(Voids_test, of_many_faces_are_linked_with_near_faces)
{
  const Soup outer = scaled(sphere(6), 2), inner = reversed(scaled(outer, 0.9));
  const Soup soup = joined(outer, inner);
  const std::size_t size = outer.polygons.size();
  const RS::Surface surface = RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
  std::vector<std::size_t> number_of_links(size);
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (surface.has_flag(a, RS::Surface::LINK)) {
      const std::size_t f = surface.lower_face(a), g = surface.higher_face(a);
      ASSERT_TRUE(f < size && g >= size);
      ++number_of_links[g - size];
      ASSERT_LT(norm(surface.centroid(g) - 0.9 * surface.centroid(f)), 0.15);
    }
  EXPECT_EQ(number_of_links, std::vector<std::size_t>(size, 1));
}

TEST(Voids_test, are_in_bodies)
{
  for (const auto& [shape, hollow] : hollow_shapes(1))
    for (const Soup& soup : {hollow.soup, reversed(hollow.soup)})
      for (const RS::Surface& surface :
           {RS::make_surface_of_polygon_soup(soup.points, soup.polygons),
            RS::make_surface(to_surface_mesh(soup))}) {
        SCOPED_TRACE(shape);
        // Turned as a whole, what is inside out in a void lies in a body that is not.
        bool has_voids = false;
        for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
          has_voids |= hollow.is_void(f);
          const std::size_t body = surface.body_around(f),
                            first = std::size_t(
                              std::find(hollow.component.begin(), hollow.component.end(),
                                        hollow.body_of_void[hollow.component[f]]) -
                              hollow.component.begin());
          if (hollow.is_void(f))
            ASSERT_EQ(body, surface.components()[first]) << f;
          else
            ASSERT_EQ(body, RS::Surface::none) << f;
        }
        EXPECT_EQ(surface.has_voids(), has_voids);
      }
  const Soup soup = hollow_shapes(1).at("ball").soup;
  EXPECT_FALSE(
    RS::make_surface(to_surface_mesh(soup), RS::parameters::component_links(false)).has_voids());
}

// Open pieces, and closed ones beside each other, have no inside for each other.
TEST(Voids_test, are_not_beside_bodies_or_in_open_surfaces)
{
  Soup open = scaled(sphere(2), 2);
  open.polygons.pop_back();
  const Soup inner = reversed(sphere(2));
  for (const Soup& soup : {joined(open, inner), joined(sphere(2), translated(inner, 3, 0, 0))})
    EXPECT_FALSE(RS::make_surface_of_polygon_soup(soup.points, soup.polygons).has_voids());
}

TEST(Voids_test, follow_all_numbers_of_a_segmenter)
{
  const Hollow hollow = hollow_shapes(3).at("bar with two voids");
  const Surface_mesh mesh = to_surface_mesh(hollow.soup), solid = to_surface_mesh(hollow.solid());
  const RS::Segmenter segmenter(mesh), of_solid(solid);
  EXPECT_EQ(segmenter.surface().number_of_faces(), mesh.number_of_faces());
  EXPECT_EQ(segmenter.regions().size(), mesh.number_of_faces());
  EXPECT_EQ(segmenter.regions().number_of_parts(), of_solid.regions().number_of_parts());
  EXPECT_EQ(segmenter.number_of_segments(), of_solid.number_of_segments());
  for (std::size_t k = 1; k < 20; ++k) {
    auto labels = face_map(mesh), expected = face_map(solid);
    EXPECT_EQ(segmenter.segment(labels, k), of_solid.segment(expected, k));
    Labels kept;
    const Labels all = labels_of(mesh, labels);
    for (std::size_t f = 0; f < all.size(); ++f)
      if (!hollow.is_void(f))
        kept.push_back(all[f]);
    EXPECT_EQ(renumbered(kept), labels_of(solid, expected));
  }
}

TEST(Voids_test, take_seeds_to_the_faces_around_them)
{
  const Hollow hollow = hollow_shapes(4).at("ring");
  const Surface_mesh mesh = to_surface_mesh(hollow.soup);
  const auto labels_with = [&](const std::map<std::size_t, std::size_t>& seeds) {
    Labels values(hollow.soup.polygons.size(), none);
    for (const auto& [face, seed] : seeds)
      values[face] = seed;
    return segments_of(
      mesh, RS::parameters::number_of_segments(3).face_seed_map(face_labels(mesh, values)));
  };
  const auto lowest = [&](bool is_void, std::size_t axis, double sign) {
    std::size_t best = none;
    for (std::size_t f = 0; f < hollow.component.size(); ++f)
      if (hollow.is_void(f) == is_void &&
          (best == none || sign * hollow.soup.points[hollow.soup.polygons[f][0]][axis] <
                             sign * hollow.soup.points[hollow.soup.polygons[best][0]][axis]))
        best = f;
    return best;
  };
  const std::size_t left = lowest(true, 0, 1), right = lowest(false, 0, -1);
  const Labels labels = labels_with({{left, 7}, {right, 9}});
  EXPECT_NE(labels[left], labels[right]);
  EXPECT_TRUE(is_label_around(hollow, labels, left));
  const Labels same = labels_with({{left, 7}, {right, 7}});
  EXPECT_EQ(same[left], same[right]);
  std::map<std::size_t, std::size_t> everywhere{{left, 1}};
  for (std::size_t f = 0; f < hollow.component.size(); ++f)
    if (!hollow.is_void(f))
      everywhere[f] = 2;
  EXPECT_TRUE(contains(message_of([&] { labels_with(everywhere); }),
                       "are at one place of the wall of a void"));
}

TEST(Voids_test, with_constrained_edges_have_segments_of_their_own)
{
  const Hollow hollow = hollow_shapes(5).at("ring");
  const Surface_mesh mesh = to_surface_mesh(hollow.soup);
  std::set<Edge> of_void; // all edges of one face
  std::size_t face = 0;
  while (!hollow.is_void(face))
    ++face;
  for (std::size_t i = 0; i < 3; ++i)
    of_void.insert(
      make_edge(hollow.soup.polygons[face][i], hollow.soup.polygons[face][(i + 1) % 3]));
  const Labels labels = segments_of(
    mesh, RS::parameters::number_of_segments(3).edge_is_constrained_map(edge_map(mesh, of_void)));
  EXPECT_TRUE(separates(hollow.soup, of_void, labels, labels));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), labels[face]), 1);
}

TEST(Voids_test, are_components_without_links)
{
  const Soup soup = hollow_shapes(1).at("bar with two voids").soup;
  EXPECT_TRUE(is_connected(
    soup, labels_of_both(soup, RS::parameters::number_of_segments(1).component_links(false))));
}

#ifdef TEST_EIGEN
TEST(Voids_test, of_machine_parts_have_faces_of_their_own)
{
  const Soup box = joined(scaled(triangulated(cube()), 8),
                          reversed(translated(scaled(triangulated(cube()), 4), 2, 2, 2)));
  const Labels labels = labels_of_both(box, RS::parameters::method(RS::Smooth_faces()));
  EXPECT_EQ(*std::max_element(labels.begin(), labels.end()) + 1, 12u);
}
#endif

} // namespace voids_test
