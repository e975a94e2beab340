// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::Double_3;

namespace Mesh_patches_test {

using RS::Mesh_patches;

RS::Flat_mesh flat_mesh_of(const Soup& soup)
{
  return RS::read_flat_mesh(to_surface_mesh(soup), RS::Mesh_data::PATCHES);
}

/// A bumpy sheet beside a square that has nearly all of the area: the faces of the sheet are small enough to be joined.
Soup small_faces(unsigned seed, std::size_t n = 24)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  Soup soup = triangulated(grid(n, n));
  for (Point& p : soup.points) {
    p[0] += 0.2 * any(random);
    p[1] += 0.2 * any(random);
    p[2] = std::sin(p[0] / 4) + 0.1 * any(random);
  }
  Soup square = scaled(grid(1, 1), 36.0 * double(n));
  square = translated(square, 100.0 * double(n), 0, 0);
  soup = joined(soup, square);
  shuffle_faces(soup, random);
  return soup;
}

struct Node
{
  double area = 0;
  Double_3 moment{0, 0, 0}, area_vector{0, 0, 0};

  Double_3 centroid() const { return (1 / area) * moment; }
  Double_3 normal() const { return (1 / norm(area_vector)) * area_vector; }
};

/// The definition, with sets and maps: the patch of each face. `patch_of`: before the first round
Labels joined_in_rounds(const RS::Flat_mesh& mesh, Labels patch_of, double maximum_area)
{
  while (true) {
    std::map<std::size_t, Node> nodes;
    for (std::size_t f = 0; f < patch_of.size(); ++f) {
      Node& node = nodes[patch_of[f]];
      node.area += mesh.area(f);
      node.moment = node.moment + mesh.area(f) * mesh.centroid(f);
      node.area_vector = node.area_vector + mesh.area(f) * mesh.normal(f);
    }
    const auto position = [&](std::size_t i) { return mesh.patches().frame().position(nodes[i].centroid()); };
    std::map<std::size_t, std::tuple<std::uint32_t, double, std::size_t>> selected; // step, position, patch
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
      const std::size_t a = patch_of[mesh.lower_face(e)], b = patch_of[mesh.higher_face(e)];
      const Node &x = nodes[a], &y = nodes[b];
      if (a == b || mesh.has_flag(e, RS::Flat_mesh::CONSTRAINED) ||
          x.area + y.area > maximum_area * mesh.surface_area())
        continue;
      const double step = norm(x.centroid() - y.centroid()) / std::sqrt(mesh.surface_area()) +
                          Mesh_patches::deviation_weight * norm(x.normal() - y.normal());
      for (auto [from, to] : {std::make_pair(a, b), std::make_pair(b, a)})
        if (const auto key = std::make_tuple(RS::internal::coarse_bits(step), position(to), to);
            !selected.count(from) || key < selected[from])
          selected[from] = key;
    }
    const auto parent = [&](std::size_t i) {
      if (!selected.count(i))
        return i;
      const std::size_t j = std::get<2>(selected[i]);
      const auto key = [&](std::size_t p) {
        const double share = nodes[p].area / mesh.surface_area();
        return std::make_pair(-double(RS::internal::coarse_bits(share)), position(p));
      };
      return std::get<2>(selected[j]) == i && key(i) < key(j) ? i : j;
    };
    const auto depth = [&](std::size_t i) {
      std::size_t d = 0;
      for (; parent(i) != i; i = parent(i))
        ++d;
      return d;
    };
    std::set<std::size_t> parents;
    for (const auto& [i, node] : nodes)
      if (parent(i) != i)
        parents.insert(parent(i));
    std::map<std::size_t, std::size_t> root;
    std::size_t joined = 0;
    for (const auto& [i, node] : nodes) {
      root[i] = depth(i) % 2 == 1 ? parent(i) : parents.count(i) ? i : parent(parent(i));
      joined += root[i] != i;
    }
    for (std::size_t& patch : patch_of)
      patch = root[patch];
    // Patches are named by their first face, so that ties are decided in the order of patches.
    patch_of = renumbered(patch_of);
    if (joined == 0 || joined < nodes.size() / 32)
      return patch_of;
  }
}

Labels patches_by_definition(const RS::Flat_mesh& mesh)
{
  Labels faces(mesh.number_of_faces());
  std::iota(faces.begin(), faces.end(), 0);
  return joined_in_rounds(mesh, faces, Mesh_patches::maximum_area);
}

Labels coarse_patches_by_definition(const RS::Flat_mesh& mesh)
{
  return joined_in_rounds(mesh, patches_by_definition(mesh), Mesh_patches::maximum_coarse_area);
}

/// Of the faces.
Labels coarse_labels_of(const Mesh_patches& patches)
{
  return renumbered(labels_of(composed(patches.of_faces(), patches.coarse().of_elements())));
}

TEST(Mesh_patches_test, are_those_of_the_definition)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RS::Flat_mesh mesh = flat_mesh_of(small_faces(seed));
    EXPECT_LT(mesh.patches().size(), mesh.number_of_faces() / 8);
    EXPECT_EQ(renumbered(labels_of(mesh.patches().of_faces())), patches_by_definition(mesh));
    EXPECT_LT(mesh.patches().coarse().size(), mesh.patches().size() / 4);
    EXPECT_EQ(coarse_labels_of(mesh.patches()), coarse_patches_by_definition(mesh));
  }
}

TEST(Mesh_patches_test, coarse_ones_are_made_of_single_faces_too)
{
  // No face is small enough to be joined at first.
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Soup soup = triangulated(torus(120, 60));
    bump(soup, 0.01, random);
    const RS::Flat_mesh mesh = flat_mesh_of(soup);
    EXPECT_EQ(mesh.patches().size(), mesh.number_of_faces());
    EXPECT_LT(mesh.patches().coarse().size(), mesh.number_of_faces() / 2);
    EXPECT_EQ(coarse_labels_of(mesh.patches()), coarse_patches_by_definition(mesh));
  }
}

TEST(Mesh_patches_test, another_round_follows_one_that_joined_just_enough)
{
  // The more large faces there are, the earlier the rounds end for the small ones.
  std::mt19937 random(1);
  Soup small = triangulated(grid(8, 8));
  bump(small, 0.2, random);
  std::set<std::size_t> numbers;
  for (std::size_t columns = 1; columns <= 200; columns += 3) {
    const Soup large = translated(scaled(grid(columns, 8), 300), 100, 0, 0);
    const RS::Flat_mesh mesh = flat_mesh_of(joined(small, large));
    EXPECT_EQ(renumbered(labels_of(mesh.patches().of_faces())), patches_by_definition(mesh)) << columns;
    numbers.insert(mesh.patches().size() - 8 * columns);
  }
  EXPECT_GT(numbers.size(), 3u);
}

TEST(Mesh_patches_test, large_faces_are_patches)
{
  for (Family family : all_families) {
    const RS::Flat_mesh mesh = flat_mesh_of(random_mesh(family, 1));
    std::size_t large = 0;
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      large += mesh.area(f) > Mesh_patches::maximum_area * mesh.surface_area();
    EXPECT_GE(mesh.patches().size(), large) << name(family);
  }
}

/// What patches should be, of the faces of a mesh. `patch_of`: the patch of each face
void expect_description(const RS::Patches& patches, const RS::Flat_mesh& mesh, const Labels& patch_of)
{
  std::vector<Node> nodes(patches.size());
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    Node& node = nodes[patch_of[f]];
    node.area += mesh.area(f);
    node.moment = node.moment + mesh.area(f) * mesh.centroid(f);
    node.area_vector = node.area_vector + mesh.area(f) * mesh.normal(f);
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    EXPECT_NEAR(patches[p].area, nodes[p].area, 1e-12 * nodes[p].area);
    EXPECT_LT(norm(patches[p].centroid - nodes[p].centroid()), 1e-9);
    EXPECT_LT(norm(patches[p].normal - nodes[p].normal()), 1e-9);
  }
  std::map<std::pair<std::size_t, std::size_t>, double> lengths;
  for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
    const std::size_t a = patch_of[mesh.lower_face(e)], b = patch_of[mesh.higher_face(e)];
    if (a != b)
      lengths[std::minmax(a, b)] += mesh.length(e);
  }
  ASSERT_EQ(patches.adjacencies().size(), lengths.size());
  auto expected = lengths.begin();
  for (const RS::Patches::Adjacency& a : patches.adjacencies()) {
    EXPECT_EQ(std::make_pair(std::size_t(a.lower), std::size_t(a.higher)), expected->first);
    EXPECT_NEAR(a.length, expected->second, 1e-9);
    ++expected;
  }
}

/// `centroid(element)`
template <typename Centroid>
void expect_centers(const RS::Patches& patches, const Centroid& centroid)
{
  std::vector<double> nearest(patches.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < patches.of_elements().size(); ++i) {
    const std::size_t p = patches.of_elements()[i];
    nearest[p] = std::min(nearest[p], norm(centroid(i) - patches[p].centroid));
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    EXPECT_EQ(patches.of_elements()[patches[p].center], p);
    EXPECT_LE(norm(centroid(patches[p].center) - patches[p].centroid), (1 + 1. / 2048) * nearest[p] + 1e-9);
  }
}

TEST(Mesh_patches_test, are_connected_and_described)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = small_faces(seed);
    const RS::Flat_mesh mesh = flat_mesh_of(soup);
    const Mesh_patches& patches = mesh.patches();
    EXPECT_TRUE(is_connected(soup, labels_of(patches.of_faces())));
    EXPECT_TRUE(is_connected(soup, coarse_labels_of(patches)));
    expect_description(patches, mesh, labels_of(patches.of_faces()));
    expect_description(patches.coarse(), mesh,
                       labels_of(composed(patches.of_faces(), patches.coarse().of_elements())));
    expect_centers(patches, [&](std::size_t f) { return mesh.centroid(f); });
    expect_centers(patches.coarse(), [&](std::size_t p) { return patches[p].centroid; });
  }
}

TEST(Mesh_patches_test, are_not_joined_across_constrained_edges)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Surface_mesh mesh = to_surface_mesh(small_faces(seed));
    std::mt19937 random(seed);
    std::set<Surface_mesh::Edge_index> constrained;
    for (auto e : edges(mesh))
      if (random() % 3 == 0)
        constrained.insert(e);
    const auto map = boost::make_function_property_map<Surface_mesh::Edge_index>(
      [&](Surface_mesh::Edge_index e) { return constrained.count(e) > 0; });
    const RS::Flat_mesh flat =
      RS::read_flat_mesh(mesh, RS::Mesh_data::PATCHES, RS::parameters::edge_is_constrained_map(map));
    EXPECT_LT(flat.patches().size(), flat.number_of_faces() / 2);
    EXPECT_EQ(renumbered(labels_of(flat.patches().of_faces())), patches_by_definition(flat));
    EXPECT_EQ(coarse_labels_of(flat.patches()), coarse_patches_by_definition(flat));
  }
}

TEST(Mesh_patches_test, folded_up_faces_have_an_angle_although_rounding_makes_the_product_of_their_normals_less_than_minus_one)
{
  std::size_t less = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    Soup book; // two pages, closed but for nothing, on the sides that face each other
    for (int i = 0; i < 3; ++i)
      book.points.push_back({any(random), any(random), any(random)});
    const Point &a = book.points[0], &b = book.points[1], &c = book.points[2];
    const Double_3 normal = cross(Double_3{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, Double_3{c[0] - a[0], c[1] - a[1], c[2] - a[2]});
    const Double_3 d = Double_3{c[0], c[1], c[2]} + (1e-10 / norm(normal)) * normal;
    book.points.push_back({d.x, d.y, d.z});
    book.polygons = {{0, 1, 2}, {1, 0, 3}};
    const RS::Flat_mesh mesh = flat_mesh_of(book);
    ASSERT_EQ(mesh.patches().adjacencies().size(), 1u);
    less += dot(mesh.patches()[0].normal, mesh.patches()[1].normal) < -1;
    EXPECT_NEAR(mesh.patches().concave_deviation(0), std::acos(-1.0), 1e-6);
  }
  EXPECT_GT(less, 0u);
}

TEST(Mesh_patches_test, do_not_depend_on_the_numbering)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = small_faces(seed);
    Soup other = soup;
    std::mt19937 random(seed);
    std::vector<std::size_t> order(soup.polygons.size()), new_vertex;
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t i = 0; i < order.size(); ++i)
      other.polygons[order[i]] = soup.polygons[i];
    shuffle_vertices(other, random, new_vertex);
    const Labels a = labels_of(flat_mesh_of(soup).patches().of_faces());
    const Labels b = labels_of(flat_mesh_of(other).patches().of_faces());
    Labels b_of_a(a.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      b_of_a[i] = b[order[i]];
    EXPECT_EQ(b_of_a, a); // neither do their numbers
  }
}

TEST(Mesh_patches_test, a_mesh_without_area_is_one_patch_for_each_piece)
{
  const Soup point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  const RS::Flat_mesh mesh = flat_mesh_of(point);
  EXPECT_EQ(mesh.patches().size(), 1u);
  EXPECT_EQ(mesh.patches()[0].area, 0);
}

TEST(Mesh_patches_test, each_round_is_reported_and_can_be_cancelled)
{
  struct Visitor
  {
    std::size_t last = std::numeric_limits<std::size_t>::max();
    std::vector<double> fractions;
    bool go_further(const char*, double fraction)
    {
      fractions.push_back(fraction);
      return fractions.size() < last;
    }
  };
  const Surface_mesh mesh = to_surface_mesh(small_faces(1));
  const auto read = [&](RS::Mesh_data data, Visitor& visitor) {
    return RS::read_flat_mesh(mesh, data, RS::parameters::visitor(std::ref(visitor)));
  };
  Visitor without, all;
  read(RS::Mesh_data::CENTROIDS, without);
  EXPECT_EQ(without.fractions.back(), 1);

  const std::size_t size = read(RS::Mesh_data::PATCHES, all).patches().coarse().size();
  EXPECT_TRUE(std::is_sorted(all.fractions.begin(), all.fractions.end()));
  const auto rounds = std::upper_bound(all.fractions.begin(), all.fractions.end(), 0.4);
  ASSERT_GT(all.fractions.end() - rounds, 3);
  EXPECT_EQ(all.fractions.back(), 1) << "the end";
  EXPECT_EQ(all.fractions.end()[-2], 1 - 0.6 * double(size) / double(num_faces(mesh))) << "the last round";
  EXPECT_EQ(std::adjacent_find(rounds, all.fractions.end()), all.fractions.end()) << "each round joins patches";
  for (std::size_t last = 1; last <= all.fractions.size(); ++last) {
    Visitor cancelling;
    cancelling.last = last;
    EXPECT_THROW(read(RS::Mesh_data::PATCHES, cancelling), RS::Segmentation_cancelled);
    EXPECT_EQ(cancelling.fractions.size(), last);
  }
}

} // namespace Mesh_patches_test
