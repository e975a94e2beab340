// SPDX-License-Identifier: GPL-3.0-or-later

// `Visibility_merging` and `Learned_merging` against reference implementations of the manual's
// text, which share no code with them.

#include "meshes.h"
#include "real_meshes.h"
#include "reference_learned.h"
#include "reference_visibility.h"

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace reference_merging_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

constexpr unsigned seed = 7;

/// Moves all points a little: symmetric meshes have equal candidates, between which rounding would
/// decide.
void add_noise(Surface_mesh& mesh, double share_of_edge, std::mt19937& random)
{
  double sum = 0;
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    sum += std::sqrt(CGAL::to_double(
      CGAL::squared_distance(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)))));
  }
  const double noise = share_of_edge * sum / double(num_edges(mesh));
  std::uniform_real_distribution<double> moves(-noise, noise);
  for (auto v : vertices(mesh)) {
    const auto& p = mesh.point(v);
    const double x = p.x() + moves(random), y = p.y() + moves(random), z = p.z() + moves(random);
    mesh.point(v) = {x, y, z};
  }
}

reference::visibility::Mesh to_reference(const RS::Surface& surface)
{
  std::vector<reference::visibility::Vector> points;
  for (std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    points.push_back({surface.point(v).x, surface.point(v).y, surface.point(v).z});
  std::vector<std::vector<std::size_t>> polygons(surface.number_of_faces());
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
      polygons[f].push_back(surface.corner(f, i));
  return {points, polygons};
}

template <typename Method, typename Reference>
void expect_same_labels(Surface_mesh& mesh, const reference::visibility::Mesh& copy,
                        const reference::visibility::Annotated& annotated)
{
  const Reference expected(copy, annotated);
  auto segment_id = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
  const auto np = RS::parameters::method(Method()).component_links(false);
  const RS::Segmenter segmenter(mesh, np);
  const auto expect_labels = [&](std::size_t k) {
    const auto of_shape = reference::visibility::labels_after(expected.region_of, expected.merges,
                                                              k);
    std::vector<std::size_t> labels, expected_labels;
    for (auto f : faces(mesh)) {
      labels.push_back(segment_id[f]);
      expected_labels.push_back(of_shape[std::size_t(f)]);
    }
    EXPECT_TRUE(labels == reference::visibility::numbered(expected_labels)) << k << " segments";
  };
  EXPECT_EQ(segmenter.number_of_segments(), expected.chosen_number);
  for (std::size_t k : {1, 2, 3, 5, 8, 12, 20, 40, 100, 200, 400, 800}) {
    if (k > reference::visibility::number_of(expected.region_of))
      break; // regions would be split
    segmenter.segment(segment_id, k);
    expect_labels(k);
  }
  // Alone, it moves no other borders than those of the chosen number.
  EXPECT_EQ(RS::segment(mesh, segment_id, np), expected.chosen_number);
  expect_labels(expected.chosen_number);
}

/// Of both methods on superfacets.
void expect_as_defined(Surface_mesh& mesh)
{
  const RS::Surface surface = RS::make_surface(mesh, RS::parameters::component_links(false));
  const reference::visibility::Mesh copy = without_noise(to_reference(surface));
  const reference::visibility::Annotated annotated(copy);
  {
    SCOPED_TRACE("visibility");
    expect_same_labels<RS::Visibility_merging, reference::visibility::Visibility_result>(mesh, copy,
                                                                                         annotated);
  }
  SCOPED_TRACE("learned");
  expect_same_labels<RS::Learned_merging, reference::visibility::learned::Learned_result>(
    mesh, copy, annotated);
}

TEST(Reference_merging_test, methods_on_superfacets_are_as_the_manual_defines_them)
{
  std::mt19937 random(seed);
  const Soup block = scaled(voxel_surface(voxel_block({0, 0, 0}, {9, 3, 3})), 0.1);
  for (const Soup& soup : {sphere(3), torus(30, 12), joined(block, translated(sphere(2), 3, 0, 0)),
                           random_mesh(Family::SPHERE, seed), random_mesh(Family::SHEET, seed),
                           random_mesh(Family::BLOCKS, seed), random_mesh(Family::TORUS, seed)}) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(soup.polygons.size()) +
                 " faces");
    Surface_mesh mesh = to_surface_mesh(soup);
    add_noise(mesh, 0.05, random);
    expect_as_defined(mesh);
  }
}

TEST(Real_meshes, methods_on_superfacets_are_as_the_manual_defines_them)
{
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  check_real_meshes(4000, [&](Surface_mesh& mesh) {
    if (num_faces(mesh) < 20)
      return false;
    add_noise(mesh, 0.01, random);
    expect_as_defined(mesh);
    return true;
  });
}

} // namespace reference_merging_test
