// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Evaluation/overlap_measures.h>
#include <CGAL/Region_segmentation/Superfacets/Superfacets.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Farthest_point_seeding.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Patch_builder.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Superfacets_test {

RS::Surface surface_of(const Soup& soup)
{
  return RS::make_surface(to_surface_mesh(soup));
}

RS::Surface_patches patches_of(const RS::Surface& surface)
{
  return RS::internal::Patch_builder::build(surface, 0, RS::Execution());
}

/// The regions of the faces.
RS::Partition regions_of(const RS::Surface& surface, const RS::Superfacets& superfacets)
{
  const RS::Surface_patches patches = patches_of(surface);
  return composed(patches.fine.of_elements(), superfacets(surface, patches));
}

bool is_edge(const RS::Surface& surface, std::size_t adjacency)
{
  return !surface.has_flag(adjacency, RS::Surface::SEAM | RS::Surface::LINK);
}

/// The definition, step by step: all distances from scratch for each seed, by relaxing until
/// nothing changes. `inside`: along paths inside its parts.
std::vector<double> distances_from(const RS::Surface& mesh, std::size_t seed, double weight,
                                   const RS::Partition* inside = nullptr)
{
  double area = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    area += mesh.area(f);
  std::vector<double> distances(mesh.number_of_faces(), std::numeric_limits<double>::infinity());
  distances[seed] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e) {
      const std::size_t f = mesh.lower_face(e), g = mesh.higher_face(e);
      if (!is_edge(mesh, e) || (inside && (*inside)[f] != (*inside)[g]))
        continue;
      const double concavity = mesh.has_flag(e, RS::Surface::CONCAVE)
                                 ? std::min(mesh.deviation(e), 0.6)
                                 : 0;
      const double step = norm(mesh.centroid(f) - mesh.centroid(g)) / std::sqrt(area) +
                          weight * concavity;
      for (auto [from, to] : {std::make_pair(f, g), std::make_pair(g, f)})
        if (distances[from] + double(float(step)) < distances[to]) { // steps are stored as float
          distances[to] = distances[from] + double(float(step));
          changed = true;
        }
    }
  }
  return distances;
}

/// Of each face, from the centroid of the surface.
std::vector<double> distances_from_centroid(const RS::Surface& mesh)
{
  RS::Double_3 center{};
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    center = center + (mesh.area(f) / mesh.area()) * mesh.centroid(f);
  std::vector<double> distances;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    distances.push_back(norm(mesh.centroid(f) - center));
  return distances;
}

/// Seeds, the distances from each of them, and of each face the distance to the nearest one.
struct Seeding
{
  std::vector<std::size_t> seeds;
  std::vector<std::vector<double>> from_seed;
  std::vector<double> nearest;
};

/// Of the faces that no seed reaches, that farthest from the centroid of the surface; then the face
/// farthest from the seeds before it.
Seeding seeding_of(const RS::Surface& mesh, std::size_t number, double weight)
{
  Seeding result;
  result.nearest.assign(mesh.number_of_faces(), std::numeric_limits<double>::infinity());
  const std::vector<double> from_centroid = distances_from_centroid(mesh);
  while (result.seeds.size() < number) {
    std::size_t seed = 0;
    for (std::size_t f = 1; f < mesh.number_of_faces(); ++f)
      if (result.nearest[f] > result.nearest[seed] ||
          (std::isinf(result.nearest[f]) && std::isinf(result.nearest[seed]) &&
           from_centroid[f] > from_centroid[seed]))
        seed = f;
    result.seeds.push_back(seed);
    result.from_seed.push_back(distances_from(mesh, seed, weight));
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      result.nearest[f] = std::min(result.nearest[f], result.from_seed.back()[f]);
  }
  return result;
}

/// The dual graph of the faces with the steps of `distances_from()`.
RS::internal::Dual_graph dual_graph_of(const RS::Surface& mesh, double weight)
{
  return RS::internal::Dual_graph(
    mesh, [&](std::size_t e) { return is_edge(mesh, e); },
    [&](std::size_t e) {
      const double concavity = mesh.has_flag(e, RS::Surface::CONCAVE)
                                 ? std::min(mesh.deviation(e), 0.6)
                                 : 0;
      return norm(mesh.centroid(mesh.lower_face(e)) - mesh.centroid(mesh.higher_face(e))) /
               mesh.length_unit() +
             weight * concavity;
    });
}

TEST(Farthest_point_seeding_test, every_face_goes_to_the_nearest_of_far_apart_seeds)
{
  for (Family family : {Family::SHEET, Family::SPHERE, Family::TORUS, Family::BLOCKS})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const RS::Surface mesh = surface_of(random_mesh(family, seed));
      RS::internal::Farthest_point_seeding seeding(dual_graph_of(mesh, 0.4));
      seeding.run(distances_from_centroid(mesh), 12, RS::Execution());
      const RS::Partition regions = seeding.regions();
      ASSERT_EQ(regions.number_of_parts(), 12u);

      const Seeding expected = seeding_of(mesh, 12, 0.4);
      std::set<std::size_t> regions_of_seeds;
      for (std::size_t s : expected.seeds)
        regions_of_seeds.insert(regions[s]);
      ASSERT_EQ(regions_of_seeds.size(), 12u) << "a seed in each region";
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
        for (std::size_t i = 0; i < 12; ++i)
          if (regions[expected.seeds[i]] == regions[f]) {
            EXPECT_NEAR(expected.from_seed[i][f], expected.nearest[f], 1e-9);
          }
    }
}

TEST(Superfacets_test, seeds_of_crumbs_do_not_count)
{
  const Soup body = random_mesh(Family::SPHERE, 1), crumb = scaled(cube(), 0.001);
  const RS::Partition expected = regions_of(surface_of(body), RS::Superfacets(20)),
                      regions = regions_of(surface_of(joined(body, translated(crumb, 20, 0, 0))),
                                           RS::Superfacets(20));
  ASSERT_EQ(expected.number_of_parts(), 20u);
  EXPECT_EQ(regions.number_of_parts(), 21u);
  for (std::size_t f = 0; f < regions.size(); ++f)
    EXPECT_EQ(regions[f], f < expected.size() ? expected[f] : 20u);
}

TEST(Superfacets_test, of_patches_at_one_distance_the_lower_one_is_first)
{
  // Three squares in a row: both ends are seeds, and the middle belongs to the first one, face 0.
  const RS::Partition regions = regions_of(surface_of(grid(3, 1)), RS::Superfacets(2));
  EXPECT_EQ(labels_of(regions), (Labels{0, 0, 1}));
}

TEST(Superfacets_test, there_are_no_more_regions_than_faces)
{
  EXPECT_EQ(regions_of(surface_of(cube()), RS::Superfacets(800)).number_of_parts(), 6u);
  EXPECT_EQ(regions_of(surface_of(Soup()), RS::Superfacets(800)).number_of_parts(), 0u);
}

TEST(Superfacets_test, a_concave_line_is_a_border)
{
  const RS::Surface mesh = surface_of(box_on_plate());
  EXPECT_EQ(regions_of(mesh, RS::Superfacets(2, 50)),
            RS::grow_regions(mesh, RS::detect_feature_edges(mesh, 10)));
}

// Centroids of slivers whose steps differ by more than double can add: rounding hides that a seed
// is nearer.
TEST(Superfacets_test, regions_of_slivers_are_connected)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Soup soup = triangulated(grid(30, 12));
    // Columns from 1 to 1e-20 wide, in turn.
    for (Point& p : soup.points) {
      const auto column = std::size_t(p[0]);
      p[0] = 0;
      for (std::size_t i = 0; i < column; ++i)
        p[0] += i % 3 == 0 ? 1.0 : i % 3 == 1 ? 1e-12 : 1e-20;
    }
    shuffle_faces(soup, random);
    const Surface_mesh mesh = to_surface_mesh(soup);
    const RS::Superfacets superfacets(3 + seed);
    const RS::Partition regions = regions_of(RS::make_surface(mesh), superfacets);
    EXPECT_TRUE(is_connected(soup, labels_of(regions)));
  }
}

// Two arms of a face that are equally long, but for one unit in the last place of a sum: two faces
// of one of them, folded onto each other, have nearly one centroid. With the step to a third arm
// both sums are rounded to the same number, so that it does not show that the second seed is nearer
// to this arm, too. It belongs to the same region as the face that it hangs on.
TEST(Superfacets_test,
     a_patch_follows_the_one_it_was_reached_through_although_rounding_hides_that_it_is_nearer)
{
  constexpr double s = 1. / 64, h = s / 2, fold = 3.3e-16;
  Soup soup;
  const auto add = [&](const std::vector<Point>& points) {
    Polygon polygon;
    for (const Point& p : points) {
      polygon.push_back(
        std::size_t(std::find(soup.points.begin(), soup.points.end(), p) - soup.points.begin()));
      if (polygon.back() == soup.points.size())
        soup.points.push_back(p);
    }
    soup.polygons.push_back(polygon);
  };
  add({{-3 * s, h, fold}, {-3 * s, -h, fold}, {s, -h, fold}, {s, h, fold}}); // the end of the first
                                                                             // arm
  add({{s, h, fold}, {s, -h, fold}, {0, -h, 0}, {0, h, 0}});
  add({{0, h, 0}, {0, -h, 0}, {s, -h, 0}, {s, h, 0}});
  add({{s, h, 0},
       {s, -h, 0},
       {0.5, -0.5, 0},
       {1.5, -0.5, 0},
       {2 - s, -h, 0},
       {2 - s, h, 0},
       {1.5, 0.5, 0},
       {0.5, 0.5, 0}});
  add({{2 - s, h, 0}, {2 - s, -h, 0}, {2, -h, 0}, {2, h, 0}});
  add({{2, h, 0}, {2, -h, 0}, {2 + 2 * s, -h, 0}, {2 + 2 * s, h, 0}}); // the end of the second arm
  add({{0.5, 0.5, 0}, {1.5, 0.5, 0}, {2, 1, 0}, {1, 1, 0}});           // the third arm
  // Points at borders that are apart by rounding are not merged.
  const RS::Surface mesh = RS::make_surface(to_surface_mesh(soup),
                                            RS::parameters::component_links(false));
  const RS::Patches patches = patches_of(mesh).fine;
  ASSERT_EQ(patches.size(), soup.polygons.size());

  const auto step = [&](std::size_t f, std::size_t g) {
    return double(float(norm(patches[f].centroid - patches[g].centroid) / mesh.length_unit()));
  };
  const double first = step(0, 1) + step(1, 2) + step(2, 3), second = step(5, 4) + step(4, 3);
  ASSERT_LT(second, first);
  ASSERT_EQ(second + step(3, 6), first + step(3, 6));
  EXPECT_EQ(labels_of(regions_of(mesh, RS::Superfacets(2, 0))), (Labels{0, 0, 0, 1, 1, 1, 1}));
}

// The area of the surface is that of one tiny face, so that steps between the others are longer
// than any float.
TEST(Superfacets_test, regions_are_connected_where_steps_are_longer_than_a_float)
{
  Soup soup;
  soup.points = {{0, 0, 0},   {1e-60, 0, 0}, {0, 1e-60, 0}, {1, 0, 0},
                 {1.5, 0, 0}, {1.7, 0, 0},   {1.2, 0, 0},   {1.9, 0, 0}};
  soup.polygons = {{0, 1, 2}, {3, 4, 5}, {4, 3, 6}, {5, 4, 7}};
  const RS::Surface mesh = surface_of(soup);
  const RS::Surface_patches faces = RS::internal::Patch_builder::build(mesh, 4, RS::Execution());
  const RS::Partition regions = RS::Superfacets(3)(mesh, faces); // each face is a patch
  EXPECT_EQ(regions.number_of_parts(), 3u + mesh.number_of_crumbs());
  EXPECT_TRUE(is_connected(soup, labels_of(regions)));
}

} // namespace Superfacets_test
