// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"
#include "superfacet_stages.h"

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Support/Execution.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::Double_3;

namespace Patches_test {

using RS::Surface_patches;

/// Without crumbs.
RS::Surface unlinked(const Soup& soup)
{
  return surface_of_soup(soup, false);
}

/// A bumpy sheet beside a square that has nearly all of the area: the faces of the sheet are small
/// enough to be joined.
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

/// Of the faces.
Labels coarse_labels_of(const Surface_patches& patches)
{
  return labels_of(composed(patches.fine.of_elements(), patches.coarse.of_elements()));
}

TEST(Patches_test, another_round_follows_one_that_joined_one_of_32)
{
  // In a row of four squares the first round makes two pairs, the second one joins these.
  const auto patches_of_row = [](std::size_t number_of_others) {
    const Soup others = translated(scaled(grid(number_of_others, 1), 300), 100, 0, 0);
    const double side = 0.0018 * 300 * std::sqrt(double(number_of_others));
    return patches_of(unlinked(joined(scaled(grid(4, 1), side), others))).fine.size() -
           number_of_others;
  };
  EXPECT_EQ(patches_of_row(60), 1u); // 2 of 64
  EXPECT_EQ(patches_of_row(92), 2u); // 2 of 96
}

/// A row of rectangles, each turned by an angle against the one before, beside a square of area 1.
/// Two of them may be a patch, three are too large.
RS::Surface turning_row(const std::vector<double>& angles)
{
  const double width = 0.0014, height = 0.0042;
  Soup row;
  double x = 2, z = 0, direction = 0;
  for (std::size_t i = 0; i <= angles.size(); ++i) {
    row.points.insert(row.points.end(), {{x, 0, z}, {x, height, z}});
    if (i > 0)
      row.polygons.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
    direction += i < angles.size() ? angles[i] : 0;
    x += width * std::cos(direction);
    z += width * std::sin(direction);
  }
  return unlinked(joined(row, grid(1, 1)));
}

TEST(Patches_test, a_face_joins_a_patch_of_lower_faces_whose_first_face_is_near_and_has_its_normal)
{
  const auto patches_of_row = [](const std::vector<double>& angles) {
    return labels_of(patches_of(turning_row(angles)).fine.of_elements());
  };
  EXPECT_EQ(patches_of_row({0, 0.05, 0.05, 0.05}), (Labels{0, 0, 1, 1, 2}));
  EXPECT_EQ(patches_of_row({0, 0.1, 0, 0.1}), (Labels{0, 1, 1, 2, 3}));
}

using Lengths = std::map<std::pair<std::size_t, std::size_t>, double>;

template <typename Adjacencies>
void expect_lengths(const Adjacencies& adjacencies, const Lengths& lengths)
{
  ASSERT_EQ(adjacencies.size(), lengths.size());
  auto expected = lengths.begin();
  for (const RS::Patches::Adjacency& a : adjacencies) {
    EXPECT_EQ(std::make_pair(std::size_t(a.lower), std::size_t(a.higher)), expected->first);
    EXPECT_NEAR(a.length, expected->second, 1e-9);
    ++expected;
  }
}

enum class Contacts { YES, NO };

/// What patches should be, of the faces of a mesh. `patch_of`: the patch of each face;
/// `have_contacts`: whether the patches know them
void expect_description(const RS::Patches& patches, const RS::Surface& mesh, const Labels& patch_of,
                        Contacts have_contacts)
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
  Lengths lengths, contacts;
  for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e) {
    const std::size_t a = patch_of[mesh.lower_face(e)], b = patch_of[mesh.higher_face(e)];
    if (a != b && !mesh.has_flag(e, RS::Surface::CONSTRAINED))
      (mesh.has_flag(e, RS::Surface::SEAM | RS::Surface::LINK)
         ? contacts
         : lengths)[std::minmax(a, b)] += mesh.length(e);
  }
  expect_lengths(patches.adjacencies(), lengths);
  if (have_contacts == Contacts::YES)
    expect_lengths(patches.contacts(), contacts);
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
    EXPECT_NEAR(norm(centroid(patches[p].center) - patches[p].centroid), nearest[p], 1e-9);
  }
}

TEST(Patches_test, are_small_connected_and_described)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = small_faces(seed);
    const RS::Surface mesh = unlinked(soup);
    const Surface_patches patches = patches_of(mesh);
    EXPECT_LT(patches.fine.size(), mesh.number_of_faces() / 8);
    EXPECT_LT(patches.coarse.size(), patches.fine.size() / 4);
    EXPECT_TRUE(is_connected(soup, labels_of(patches.fine.of_elements())));
    EXPECT_TRUE(is_connected(soup, coarse_labels_of(patches)));
    expect_description(patches.fine, mesh, labels_of(patches.fine.of_elements()), Contacts::YES);
    expect_description(patches.coarse, mesh, coarse_labels_of(patches), Contacts::NO);
    expect_centers(patches.fine, [&](std::size_t f) { return mesh.centroid(f); });
    expect_centers(patches.coarse, [&](std::size_t p) { return patches.fine[p].centroid; });
  }
}

/// A hundred flat sheets, small beside a square, at a common side; and one that is apart. (Without
/// links, since the sheets would be crumbs, which weigh nothing.)
RS::Surface sheets_at_one_side()
{
  Soup soup;
  for (int i = 0; i < 100; ++i) {
    const double angle = i;
    soup = joined(soup, mapped(grid(4, 4), [=](const Point& p) {
                    return Point{p[0], p[1] * std::cos(angle), p[1] * std::sin(angle)};
                  }));
  }
  soup = joined(joined(soup, translated(grid(4, 4), 5, 0, 0)),
                translated(scaled(grid(1, 1), 3000), 20, 0, 0));
  return RS::make_surface_of_polygon_soup(soup.points, soup.polygons,
                                          RS::parameters::component_links(false));
}

TEST(Patches_test, are_not_joined_across_seams)
{
  const RS::Surface surface = sheets_at_one_side();
  ASSERT_TRUE(surface.has_seams_or_links());
  const Surface_patches patches = patches_of(surface);
  EXPECT_EQ(patches.fine.size(), 102u) << "each sheet";
  EXPECT_TRUE(patches.fine.adjacencies().empty());
  EXPECT_GE(patches.fine.contacts().size(), 100u);
  expect_description(patches.fine, surface, labels_of(patches.fine.of_elements()), Contacts::YES);
}

/// The pieces of patches in regions, by the lowest face that is reached.
Labels pieces_by_definition(const RS::Surface& mesh, const RS::Partition& patch_of,
                            const RS::Partition& regions)
{
  Labels lowest(mesh.number_of_faces());
  std::iota(lowest.begin(), lowest.end(), std::size_t(0));
  for (bool has_changed = true; std::exchange(has_changed, false);)
    for (std::size_t a = 0; a < mesh.number_of_adjacencies(); ++a) {
      const std::size_t f = mesh.lower_face(a), g = mesh.higher_face(a);
      if (mesh.has_flag(a, RS::Surface::barrier) || patch_of[f] != patch_of[g] ||
          regions[f] != regions[g] || lowest[f] == lowest[g])
        continue;
      lowest[f] = lowest[g] = std::min(lowest[f], lowest[g]);
      has_changed = true;
    }
  return labels_of(RS::Partition::from_labels(lowest));
}

/// A surface whose adjacencies can be constrained.
struct Constrainable_surface : RS::Surface
{
  explicit Constrainable_surface(const RS::Surface& surface)
    : RS::Surface(surface)
  {}
  void constrain(std::size_t adjacency) { m_flags[adjacency] |= CONSTRAINED; }
};

/// Divides patches by random regions, below an x.
void expect_division(const RS::Surface& surface, double x, std::mt19937& random)
{
  Constrainable_surface mesh(surface);
  for (std::size_t a = 0; a < mesh.number_of_adjacencies(); ++a)
    if (mesh.centroid(mesh.lower_face(a)).x < x && random() % 10 == 0)
      mesh.constrain(a);
  const RS::Patches patches = patches_of(mesh).fine;
  const RS::Partition& patch_of = patches.of_elements();
  Labels labels;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    labels.push_back(1000 * (patch_of[f] % 7));
    if (mesh.centroid(f).x < x && random() % 20 == 0)
      labels.back() += 1;
  }
  const RS::Partition regions = RS::Partition::from_labels(labels);
  const RS::Patches pieces = RS::internal::Patch_builder::divided(mesh, patches, regions);
  const Labels expected = pieces_by_definition(mesh, patch_of, regions);
  EXPECT_GT(pieces.size(), patches.size());
  EXPECT_EQ(labels_of(pieces.of_elements()), expected);
  expect_description(pieces, mesh, expected, Contacts::YES);
  expect_centers(pieces, [&](std::size_t f) { return mesh.centroid(f); });
}

TEST(Patches_test, are_divided_by_regions)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    expect_division(unlinked(small_faces(seed)), 12, random);
  }
}

TEST(Patches_test, divided_ones_have_contacts_across_seams)
{
  const RS::Surface sheets = sheets_at_one_side();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    expect_division(sheets, 2, random);
  }
}

TEST(Patches_test,
     folded_up_faces_have_an_angle_where_rounding_brings_the_product_of_normals_below_minus_one)
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
    const Double_3 normal = cross(Double_3{b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                                  Double_3{c[0] - a[0], c[1] - a[1], c[2] - a[2]});
    const Double_3 d = Double_3{c[0], c[1], c[2]} + (1e-10 / norm(normal)) * normal;
    book.points.push_back({d.x, d.y, d.z});
    book.polygons = {{0, 1, 2}, {1, 0, 3}};
    const RS::Surface mesh = unlinked(book);
    const Surface_patches patches = patches_of(mesh);
    ASSERT_EQ(patches.fine.adjacencies().size(), 1u);
    less += dot(patches.fine[0].normal, patches.fine[1].normal) < -1;
    EXPECT_NEAR(patches.fine.concave_deviation(patches.fine.adjacencies()[0]), std::acos(-1.0),
                1e-6);
  }
  EXPECT_GT(less, 0u);
}

TEST(Patches_test, a_mesh_without_area_is_one_patch_for_each_piece)
{
  const Soup point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}};
  const RS::Surface mesh = unlinked(point);
  const Surface_patches patches = patches_of(mesh);
  EXPECT_EQ(patches.fine.size(), 1u);
  EXPECT_EQ(patches.fine[0].area, 0);
}

} // namespace Patches_test
