// SPDX-License-Identifier: GPL-3.0-or-later

#include "copies.h"
#include "field_copies.h"
#include "sheets.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/subdivision_method_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace princeton_benchmark {

namespace {

using Vector = CGAL::Simple_cartesian<double>::Vector_3;

Soup figure()
{
  Soup soup;
  if (!CGAL::IO::read_OFF(TEST_FIGURE, soup.points, soup.triangles))
    throw std::runtime_error(TEST_FIGURE);
  return soup;
}

Copy copy_of(const Soup& soup, const std::vector<Copying>& kinds, const std::string& name)
{
  for (const Copying& kind : kinds)
    if (kind.name == name)
      return kind.copy({soup, 1, {}}, 3);
  throw std::runtime_error("no copies " + name);
}

/// What is learned from beside a model.
std::vector<Copying> all_kinds()
{
  std::vector<Copying> kinds = variants();
  kinds.insert(kinds.end(), field_copies().begin(), field_copies().end());
  return kinds;
}

const Point& corner(const Soup& soup, std::size_t f, std::size_t i)
{
  return soup.points[soup.triangles[f][i % 3]];
}

double area(const Soup& soup, std::size_t f)
{
  return std::sqrt(squared_area(corner(soup, f, 0), corner(soup, f, 1), corner(soup, f, 2)));
}

double mean_edge(const Soup& soup)
{
  double sum = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      sum += std::sqrt(squared_distance(corner(soup, f, i), corner(soup, f, i + 1)));
  return sum / double(3 * soup.triangles.size());
}

double deviation(const Soup& soup, const Soup& moved)
{
  double squares = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    squares += squared_distance(soup.points[v], moved.points[v]);
  return std::sqrt(squares / double(3 * soup.points.size()));
}

TEST(Copies, four_faces_for_one_are_the_same_surface)
{
  const Soup soup = figure();
  const Copy copy = copy_of(soup, variants(), "faces split into four");
  ASSERT_EQ(copy.source.size(), 4 * soup.triangles.size());
  for (std::size_t f = 0; f < copy.source.size(); ++f)
    EXPECT_NEAR(4 * area(copy.soup, f), area(soup, copy.source[f]), 1e-12);
  EXPECT_TRUE(CGAL::is_closed(make_mesh(copy.soup)));
}

TEST(Copies, noise_has_the_wanted_size)
{
  const Soup soup = figure();
  const double eighth = deviation(soup,
                                  copy_of(soup, variants(), "noise of 1/8 of the mean edge").soup);
  EXPECT_NEAR(eighth / mean_edge(soup), 1. / 8, 0.004);
  const double diagonal = deviation(soup, copy_of(soup, equal_copies(), "noise of 1e-5").soup);
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  EXPECT_NEAR(diagonal / std::hypot(box.x_span(), box.y_span(), box.z_span()), 1e-5, 4e-7);
}

TEST(Copies, holes_leave_the_other_faces)
{
  const Soup soup = figure();
  const Copy copy = copy_of(soup, variants(), "holes of 1 % of the faces");
  const double faces = double(soup.triangles.size()), left = double(copy.source.size());
  EXPECT_LE(left, 0.99 * faces);
  EXPECT_GT(left, 0.99 * faces - 10);
}

TEST(Copies, faces_that_are_left_are_those_of_the_model)
{
  const Soup soup = figure();
  for (const char* name : {"holes of 1 % of the faces", "seen from one side", "cut in half"}) {
    const Copy copy = copy_of(soup, all_kinds(), name);
    EXPECT_GT(copy.source.size(), soup.triangles.size() / 5) << name;
    for (std::size_t f = 0; f < copy.source.size(); ++f)
      EXPECT_EQ(copy.soup.triangles[f], soup.triangles[copy.source[f]]) << name;
  }
}

/// The sum of the area vectors, of length 1.
Vector direction(const Soup& soup)
{
  Vector sum = CGAL::NULL_VECTOR;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    sum += cross_product(corner(soup, f, 1) - corner(soup, f, 0),
                         corner(soup, f, 2) - corner(soup, f, 0));
  return sum / std::sqrt(sum.squared_length());
}

TEST(Copies, of_a_ball_a_camera_sees_the_half_that_faces_it)
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0, 0, 0), 1.);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  Soup ball;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, ball.points, ball.triangles);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Copy copy = seen_from_one_side(ball, seed);
    const Vector to_camera = direction(copy.soup);
    std::vector<bool> is_seen(ball.triangles.size(), false);
    for (const std::size_t f : copy.source)
      is_seen[f] = true;
    for (std::size_t f = 0; f < is_seen.size(); ++f) {
      const Vector normal = cross_product(corner(ball, f, 1) - corner(ball, f, 0),
                                          corner(ball, f, 2) - corner(ball, f, 0));
      const double cosine = normal * to_camera / std::sqrt(normal.squared_length());
      if (std::abs(cosine - 0.05) > 0.03) {
        EXPECT_EQ(is_seen[f], cosine > 0.05) << cosine;
      }
    }
  }
}

TEST(Copies, pieces_are_closed_and_of_positive_volume)
{
  Model model{figure(), 2, {{{}, 2}}};
  for (const auto& triangle : model.soup.triangles)
    model.people.front().labels.push_back(model.soup.points[triangle[0]].z() > 0);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Copy copy = in_closed_pieces(model, seed);
    std::multiset<std::pair<std::size_t, std::size_t>> edges; // as often in either direction
    double volume = 0;
    for (std::size_t f = 0; f < copy.source.size(); ++f) {
      const auto& t = copy.soup.triangles[f];
      volume += CGAL::volume(Point(0, 0, 0), corner(copy.soup, f, 0), corner(copy.soup, f, 1),
                             corner(copy.soup, f, 2));
      for (std::size_t i = 0; i < 3; ++i)
        edges.insert({t[i], t[(i + 1) % 3]});
    }
    for (const auto& [a, b] : edges)
      EXPECT_EQ(edges.count({b, a}), edges.count({a, b}));
    EXPECT_GT(volume, 0);
    const std::set<std::size_t> sources(copy.source.begin(), copy.source.end());
    EXPECT_EQ(sources.size(), model.soup.triangles.size());
  }
}

TEST(Sheets, are_connected_open_and_one_part)
{
  for (const Sheet& sheet : make_sheets(1)) {
    const Mesh mesh = make_mesh(sheet.model.soup);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    EXPECT_EQ(num_vertices(mesh) + num_faces(mesh), num_edges(mesh) + 1) << sheet.kind;
    EXPECT_EQ(sheet.model.people.front().labels,
              std::vector<int>(sheet.model.soup.triangles.size(), 0));
  }
  EXPECT_EQ(make_sheets(2).back().model.soup.points, make_sheets(2).back().model.soup.points);
}

TEST(Copies, fewer_faces_come_from_the_nearest)
{
  const Soup soup = figure();
  const Copy copy = copy_of(soup, variants(), "a tenth of the edges");
  EXPECT_NEAR(double(copy.source.size()), 0.1 * double(soup.triangles.size()), 10);
  const auto center = [](const Soup& s, std::size_t f) {
    return centroid(corner(s, f, 0), corner(s, f, 1), corner(s, f, 2));
  };
  for (std::size_t f = 0; f < copy.source.size(); ++f) {
    double least = 1e9;
    for (std::size_t g = 0; g < soup.triangles.size(); ++g)
      least = std::min(least, squared_distance(center(copy.soup, f), center(soup, g)));
    EXPECT_NEAR(squared_distance(center(copy.soup, f), center(soup, copy.source[f])), least, 1e-12);
  }
}

/// The lengths of the edges of a triangle, sorted, as multiples of the mean length.
std::vector<double> edge_lengths(const Soup& soup, std::size_t f, double mean)
{
  std::vector<double> lengths;
  for (std::size_t i = 0; i < 3; ++i)
    lengths.push_back(std::sqrt(squared_distance(corner(soup, f, i), corner(soup, f, i + 1))) /
                      mean);
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(Copies, other_numbers_and_motions_keep_the_shape)
{
  const Soup soup = figure();
  for (const char* name : {"renumbered", "motion"}) {
    SCOPED_TRACE(name);
    const Copy copy = copy_of(soup, equal_copies(), name);
    const double mean = mean_edge(soup), mean_of_copy = mean_edge(copy.soup);
    for (std::size_t f = 0; f < copy.source.size(); ++f) {
      const auto before = edge_lengths(soup, copy.source[f], mean),
                 after = edge_lengths(copy.soup, f, mean_of_copy);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(after[i], before[i], 1e-9);
    }
    EXPECT_TRUE(CGAL::is_closed(make_mesh(copy.soup)));
    EXPECT_NE(copy.soup.points, soup.points);
  }
}

TEST(Copies, have_the_labels_of_the_faces_that_they_come_from)
{
  Model model{figure(), 2, {{{}, 3}}};
  for (std::size_t f = 0; f < model.soup.triangles.size(); ++f)
    model.people.front().labels.push_back(int(f));
  for (const Copying& kind : all_kinds()) {
    const Copy copy = kind.copy(model, 7);
    const Model copy_of_model = copied(model, kind, 7);
    EXPECT_EQ(copy_of_model.soup.triangles, copy.soup.triangles) << kind.name;
    EXPECT_TRUE(std::equal(copy.source.begin(), copy.source.end(),
                           copy_of_model.people.front().labels.begin()))
      << kind.name;
  }
}

} // namespace

} // namespace princeton_benchmark
