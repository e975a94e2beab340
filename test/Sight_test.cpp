// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Sight.h>
#include <CGAL/Region_segmentation/internal/build_graph.h>
#include <CGAL/Region_segmentation/internal/read_flat_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace RS = CGAL::Region_segmentation;
using namespace test;
using RS::internal::Vector_3;

namespace {

RS::Flat_mesh flat_mesh_of(const Soup& soup)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto np = CGAL::parameters::default_values();
  return RS::internal::read_flat_mesh(RS::internal::make_mesh_walk(mesh, np), np,
                                      RS::Flat_mesh::Content::ANGLES_AND_POINTS);
}

/// Where a ray meets the plane of a triangle, if that is inside by the signs of three volumes.
double distance_to_triangle(const Vector_3& o, const Vector_3& d, const Vector_3& a,
                            const Vector_3& b, const Vector_3& c)
{
  const double u = dot(d, cross(a - o, b - o)), v = dot(d, cross(b - o, c - o)),
               w = dot(d, cross(c - o, a - o));
  const bool is_inside = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
  const Vector_3 n = cross(b - a, c - a);
  const double t = is_inside ? dot(a - o, n) / dot(d, n) : -1;
  return t > 0 ? t : std::numeric_limits<double>::infinity();
}

using Graph = RS::Region_adjacency_graph<RS::Part_data, RS::Cut_data>;

Graph annotated(const RS::Flat_mesh& mesh, const RS::Region_labels& regions)
{
  Graph graph = RS::internal::build_graph<Graph>(mesh, regions);
  RS::Sight()(graph, mesh, regions);
  return graph;
}

RS::Region_labels face_each(const RS::Flat_mesh& mesh)
{
  RS::Region_labels regions;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    regions.of_face.push_back(RS::Flat_mesh::Index(f));
  regions.number_of_regions = mesh.number_of_faces();
  return regions;
}

} // namespace

TEST(Ray_tree_test, finds_what_a_look_at_every_triangle_finds)
{
  for (Family family : {Family::SPHERE, Family::SHEET, Family::TWO_COMPONENTS})
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const RS::Flat_mesh mesh = flat_mesh_of(triangulated(random_mesh(family, seed)));
      const RS::internal::Ray_tree tree(mesh);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> any(-1, 1);
      std::size_t hits = 0;
      for (int i = 0; i < 300; ++i) {
        const std::size_t skipped = random() % mesh.number_of_faces();
        const Vector_3 source = mesh.centroid(skipped);
        Vector_3 d{any(random), any(random), any(random)};
        d = (1 / norm(d)) * d;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
          if (f != skipped)
            nearest = std::min(nearest,
                               distance_to_triangle(source, d, mesh.point(mesh.corner(f, 0)),
                                                    mesh.point(mesh.corner(f, 1)),
                                                    mesh.point(mesh.corner(f, 2))));
        const auto hit = tree.first_hit(source, d, RS::Flat_mesh::Index(skipped));
        if (std::isinf(nearest)) {
          EXPECT_EQ(hit.face, RS::internal::Ray_tree::no_face);
        } else {
          ++hits;
          EXPECT_NEAR(hit.distance, nearest, 1e-4 * (1 + nearest));
        }
      }
      EXPECT_GT(hits, 20u);
    }
}

TEST(Ray_tree_test, of_faces_hit_at_the_same_distance_it_is_the_lowest)
{
  // Rays straight down on edges and corners of a plate of unit squares: without the face that was hit, another one is,
  // and not a lower one at the same distance.
  const RS::Flat_mesh mesh = flat_mesh_of(voxel_surface(voxel_block({0, 0, 0}, {16, 16, 1})));
  const RS::internal::Ray_tree tree(mesh);
  std::size_t ties = 0;
  for (double x = 1; x < 16; x += 0.5)
    for (double y = 1; y < 16; y += 0.5) {
      const auto hit = tree.first_hit({x, y, 3}, {0, 0, -1}, RS::internal::Ray_tree::no_face);
      const auto next = tree.first_hit({x, y, 3}, {0, 0, -1}, hit.face);
      ASSERT_NE(next.face, RS::internal::Ray_tree::no_face);
      EXPECT_GE(next.distance, hit.distance);
      if (next.distance == hit.distance) {
        ++ties;
        EXPECT_GT(next.face, hit.face) << x << ' ' << y;
      }
    }
  EXPECT_GT(ties, 100u);
}

TEST(Sight_test, the_thickness_of_a_plate_is_its_height)
{
  // A plate of 20 x 20 x 1: rays against the normal go 1 deep, those 0.9 rad away 1 / cos(0.9).
  std::vector<Voxel> plate = voxel_block({0, 0, 0}, {20, 20, 1});
  const RS::Flat_mesh mesh = flat_mesh_of(voxel_surface(plate));
  const Graph graph = annotated(mesh, face_each(mesh));
  const double unit = std::sqrt(2 * 400 + 4 * 20.0);
  std::size_t middle = 0;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Vector_3 c = mesh.centroid(f), n = mesh.normal(f);
    if (std::abs(n.z) < 0.5 || c.x < 3 || c.x > 17 || c.y < 3 || c.y > 17)
      continue;
    ++middle;
    const double thickness = graph[std::uint32_t(f)].mean_thickness();
    EXPECT_GT(thickness, std::log(1 / unit));
    EXPECT_LT(thickness, std::log(1 / std::cos(0.9) / unit + 1e-4) + 1e-9);
  }
  EXPECT_EQ(middle, 2 * 14u * 14u);
}

TEST(Sight_test, areas_are_shares_and_every_ray_has_two_ends)
{
  for (Family family : {Family::SPHERE, Family::TORUS, Family::DEGENERATE_TORUS}) {
    const RS::Flat_mesh mesh = flat_mesh_of(random_mesh(family, 3));
    const Graph graph = annotated(mesh, face_each(mesh));
    double area = 0, ends = 0, between = 0;
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      area += graph[*range.first].area;
      ends += graph[*range.first].sight;
    }
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      between += graph[*range.first].sight;
    EXPECT_NEAR(area, 1, 1e-12);
    // No ray of a region of one face ends in it, so each is in the section of its ends.
    EXPECT_NEAR(ends, 2 * between, 1e-12);
    EXPECT_LE(between, 1 + 1e-12);
  }
}

TEST(Sight_test, opposite_sides_see_each_other_without_a_common_border)
{
  // The six faces of a cube: rays from one end on others, the one straight in on the opposite one.
  const RS::Flat_mesh mesh = flat_mesh_of(cube());
  const Graph graph = annotated(mesh, face_each(mesh));
  EXPECT_EQ(graph.number_of_sections(), 12u + 3u);
  for (std::uint32_t axis : {0u, 2u, 4u}) {
    const auto opposite = graph.section(axis, axis + 1);
    ASSERT_TRUE(opposite.has_value());
    EXPECT_EQ(graph[*opposite].number_of_edges, 0u);
    EXPECT_GT(graph[*opposite].sight, 0);
  }
}
