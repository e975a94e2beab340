// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/procedural_models.h"
#include "soup/link_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

using namespace segment_mesh;

namespace {

class Every_model : public testing::TestWithParam<Model_recipe>
{};

using Edge = std::array<std::size_t, 2>;

/// The faces of each edge.
std::map<Edge, std::vector<std::size_t>> faces_of_edges(const Polygon_soup& soup)
{
  std::map<Edge, std::vector<std::size_t>> result;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (std::size_t i = 0; i < soup.polygons[f].size(); ++i) {
      const auto [a, b] = std::minmax(soup.polygons[f][i],
                                      soup.polygons[f][(i + 1) % soup.polygons[f].size()]);
      result[{a, b}].push_back(f);
    }
  return result;
}

/// The number of pieces into which edges between faces of different labels cut the surface.
std::size_t number_of_pieces(const Polygon_soup& soup, const std::vector<std::size_t>& labels)
{
  std::vector<std::size_t> parents(soup.polygons.size());
  for (std::size_t f = 0; f < parents.size(); ++f)
    parents[f] = f;
  const auto root = [&parents](std::size_t f) {
    while (parents[f] != f)
      f = parents[f] = parents[parents[f]];
    return f;
  };
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (labels[faces[0]] == labels[faces[1]])
      parents[root(faces[0])] = root(faces[1]);
  std::set<std::size_t> roots;
  for (std::size_t f = 0; f < parents.size(); ++f)
    roots.insert(root(f));
  return roots.size();
}

double signed_volume(const Polygon_soup& soup)
{
  double volume = 0;
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Point &a = soup.points[polygon[0]], &b = soup.points[polygon[i - 1]],
                  &c = soup.points[polygon[i]];
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0])) /
                6;
    }
  return volume;
}

TEST_P(Every_model, is_a_closed_manifold_oriented_outwards)
{
  const Labelled_model model = GetParam().make();
  EXPECT_EQ(model.name, GetParam().name);
  EXPECT_TRUE(is_oriented_manifold(model.soup));
  for (const auto& [edge, faces] : faces_of_edges(model.soup))
    ASSERT_EQ(faces.size(), 2u) << "edge " << edge[0] << " " << edge[1];
  EXPECT_GT(signed_volume(model.soup), 0);
  EXPECT_GE(model.soup.polygons.size(), 1000u);
  EXPECT_LE(model.soup.polygons.size(), 30000u);
}

TEST_P(Every_model, has_connected_parts)
{
  const Labelled_model model = GetParam().make();
  ASSERT_EQ(model.labels.size(), model.soup.polygons.size());
  const std::set<std::size_t> parts(model.labels.begin(), model.labels.end());
  EXPECT_EQ(parts.size(), model.number_of_parts);
  EXPECT_EQ(*parts.rbegin() + 1, model.number_of_parts);
  EXPECT_EQ(number_of_pieces(model.soup, model.labels), model.number_of_parts);
  EXPECT_EQ(number_of_pieces(model.soup, std::vector<std::size_t>(model.labels.size(), 0)), 1u);
}

TEST_P(Every_model, is_the_same_each_time)
{
  const Labelled_model a = GetParam().make();
  // Other addresses, and another state of the default generator.
  const std::vector<std::vector<int>> clutter(1000, std::vector<int>(17));
  const Labelled_model b = GetParam().make();
  EXPECT_EQ(a.soup.points, b.soup.points);
  EXPECT_EQ(a.soup.polygons, b.soup.polygons);
  EXPECT_EQ(a.labels, b.labels);
}

TEST(Procedural_models, begin_with_the_figure_and_have_names_of_their_own)
{
  EXPECT_EQ(procedural_models().front().name, "articulated_figure");
  std::set<std::string> names;
  for (const Model_recipe& recipe : procedural_models())
    names.insert(recipe.name);
  EXPECT_EQ(names.size(), procedural_models().size());
}

INSTANTIATE_TEST_SUITE_P(Procedural_models, Every_model, testing::ValuesIn(procedural_models()),
                         [](const auto& info) { return info.param.name; });

} // namespace
