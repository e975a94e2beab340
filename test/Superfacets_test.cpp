// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Superfacets.h>
#include <CGAL/Region_segmentation/internal/Front_queue.h>
#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace {

RS::Flat_mesh flat_mesh_of(const Surface_mesh& mesh)
{
  const auto np = CGAL::parameters::default_values();
  return RS::internal::read_flat_mesh(RS::internal::make_mesh_walk(mesh, np), np,
                                      RS::Flat_mesh::Content::ANGLES_AND_POINTS);
}

/// The definition, step by step: all distances from scratch for each seed, by relaxing until nothing
/// changes.
std::vector<double> distances_from(const RS::Flat_mesh& mesh, std::size_t seed, double weight)
{
  double area = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    area += mesh.area(f);
  std::vector<double> distances(mesh.number_of_faces(), std::numeric_limits<double>::infinity());
  distances[seed] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e) {
        const std::size_t f = mesh.lower_face(e), g = mesh.higher_face(e);
        const double concavity =
          mesh.has_flag(e, RS::Flat_mesh::CONCAVE) ? std::min(mesh.deviation(f, e), 0.6) : 0;
        const double step =
          norm(mesh.centroid(f) - mesh.centroid(g)) * (1 / std::sqrt(area)) * (1 + weight * concavity);
        for (auto [from, to] : {std::make_pair(f, g), std::make_pair(g, f)})
          if (distances[from] + step < distances[to]) {
            distances[to] = distances[from] + step;
            changed = true;
          }
      }
  }
  return distances;
}

} // namespace

TEST(Front_queue_test, gives_what_a_heap_gives)
{
  using Queue = RS::internal::Front_queue;
  for (double width : {0.0, 1e-9, 0.01, 1.0, 1e9})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE("width " + std::to_string(width) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      std::exponential_distribution<double> step(1);
      Queue queue(width);
      // Twice, since an empty queue starts anew; steps of 0 and long ones, among them.
      for (int round = 0; round < 2; ++round) {
        std::priority_queue<Queue::Key, std::vector<Queue::Key>, std::greater<>> heap;
        const auto push = [&](double distance) {
          const Queue::Key key = RS::internal::make_float_key(float(distance), random() % 1000);
          queue.push(key);
          heap.push(key);
        };
        push(0);
        std::size_t pushed = 1, most = 0;
        while (!heap.empty()) {
          ASSERT_FALSE(queue.empty());
          most = std::max(most, heap.size());
          const Queue::Key top = queue.pop();
          ASSERT_EQ(top, heap.top());
          heap.pop();
          const float distance = RS::internal::value_of(top);
          for (int i = 0; i < 3 && pushed < 2000; ++i, ++pushed)
            push(distance + (random() % 8 == 0 ? 0.0 : random() % 50 == 0 ? 1e4 * step(random) : step(random)));
        }
        EXPECT_TRUE(queue.empty());
        EXPECT_GT(most, 500u);
      }
    }
}

TEST(Superfacets_test, every_face_goes_to_the_nearest_of_far_apart_seeds)
{
  for (Family family : {Family::SHEET, Family::SPHERE, Family::TORUS, Family::BLOCKS})
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const RS::Flat_mesh mesh = flat_mesh_of(to_surface_mesh(random_mesh(family, seed)));
      const auto regions = RS::Superfacets(12, 5)(mesh, {});
      ASSERT_EQ(regions.number_of_regions, 12u);

      // The seeds are the faces that came at once; each face is at its distance, in the region of a
      // nearest seed, and each seed was the farthest face when it became one.
      std::map<std::size_t, std::vector<double>> distances;
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
        if (regions.lateness[f] == 0)
          distances[f] = distances_from(mesh, f, 5);
      ASSERT_EQ(distances.size(), 12u);
      double farthest = 0;
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
        double nearest = std::numeric_limits<double>::infinity(), own = nearest;
        for (const auto& [s, from_seed] : distances) {
          nearest = std::min(nearest, from_seed[f]);
          if (regions.of_face[s] == regions.of_face[f])
            own = from_seed[f];
        }
        EXPECT_NEAR(regions.lateness[f], nearest, 1e-5);
        EXPECT_NEAR(own, nearest, 1e-5);
        farthest = std::max(farthest, nearest);
      }
      for (const auto& [s, from_seed] : distances)
        for (const auto& [t, unused] : distances)
          if (s != t) {
            EXPECT_GE(from_seed[t], farthest - 1e-5);
          }
    }
}

TEST(Superfacets_test, regions_are_connected_and_numbered_by_first_face)
{
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      const auto regions = RS::Superfacets(20)(flat_mesh_of(to_surface_mesh(soup)), {});
      const Labels labels(regions.of_face.begin(), regions.of_face.end());
      EXPECT_TRUE(is_numbered_by_first_face(labels, regions.number_of_regions));
      EXPECT_TRUE(is_connected(soup, labels));
    }
}

TEST(Superfacets_test, every_piece_gets_a_seed_beyond_the_number)
{
  Soup soup = cube();
  for (int i = 1; i < 5; ++i)
    soup = joined(soup, translated(cube(), 3 * i, 0, 0));
  EXPECT_EQ(RS::Superfacets(2)(flat_mesh_of(to_surface_mesh(soup)), {}).number_of_regions, 5u);
}

TEST(Superfacets_test, there_are_no_more_regions_than_faces)
{
  const auto regions = RS::Superfacets(800)(flat_mesh_of(to_surface_mesh(cube())), {});
  EXPECT_EQ(regions.number_of_regions, 6u);
}

TEST(Superfacets_test, a_concave_line_is_a_border)
{
  const Soup soup = box_on_plate();
  const auto regions = RS::Superfacets(2, 1000)(flat_mesh_of(to_surface_mesh(soup)), {});
  const auto by_growing = RS::Region_growing()(
    flat_mesh_of(to_surface_mesh(soup)),
    RS::internal::mark_feature_edges(flat_mesh_of(to_surface_mesh(soup)), 10,
                                     RS::Feature_convexity::CONCAVE));
  EXPECT_EQ(regions.of_face, by_growing.of_face);
}
