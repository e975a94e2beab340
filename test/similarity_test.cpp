// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same shape in another frame, unit or numbering has the same parts, up to its symmetries.

#include "meshes.h"
#include "oracles.h"
#include "real_meshes.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/evaluation/rand_index_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace similarity_test {

using Order = std::vector<std::size_t>;

constexpr unsigned number_of_similarities = 20;

Soup soup_of(const Surface_mesh& mesh)
{
  Soup soup;
  for (auto v : vertices(mesh))
    soup.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (auto f : faces(mesh)) {
    soup.polygons.emplace_back();
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      soup.polygons.back().push_back(std::size_t(v));
  }
  return soup;
}

/// A random rotation, translation, scale, and numbering of vertices and faces. `new_face`: the number of each face
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
  const double scale = std::exp(7 * any(random));
  const Point shift = {size * any(random), size * any(random), size * any(random)};
  const auto [w, x, y, z] = q;
  Soup result = mapped(soup, [&, w = w, x = x, y = y, z = z](const Point& p) {
    return Point{
      scale * (shift[0] + (1 - 2 * (y * y + z * z)) * p[0] + 2 * (x * y - w * z) * p[1] + 2 * (x * z + w * y) * p[2]),
      scale * (shift[1] + 2 * (x * y + w * z) * p[0] + (1 - 2 * (x * x + z * z)) * p[1] + 2 * (y * z - w * x) * p[2]),
      scale * (shift[2] + 2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] + (1 - 2 * (x * x + y * y)) * p[2])};
  });
  new_face.resize(soup.polygons.size());
  for (std::size_t f = 0; f < new_face.size(); ++f)
    new_face[f] = f;
  std::shuffle(new_face.begin(), new_face.end(), random);
  const std::vector<Polygon> polygons = result.polygons;
  for (std::size_t f = 0; f < new_face.size(); ++f)
    result.polygons[new_face[f]] = polygons[f];
  Order new_vertex;
  shuffle_vertices(result, random, new_vertex);
  return result;
}

template <typename Method>
std::vector<Labels> segmentations(const Soup& soup)
{
  Surface_mesh mesh = to_surface_mesh(soup);
  auto segment_id = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
  const RS::Segmenter<Surface_mesh, Method> segmenter(mesh);
  std::vector<Labels> result;
  segmenter.segment(segment_id);
  result.push_back(labels_of(mesh, segment_id));
  segmenter.segment(segment_id, 7);
  result.push_back(labels_of(mesh, segment_id));
  return result;
}

/// `symmetries`: of the shape, to which face each one leads
template <typename Method>
void expect_same_parts(const Soup& soup, const std::vector<Order>& symmetries)
{
  const std::vector<Labels> expected = segmentations<Method>(soup);
  std::array<std::size_t, 2> different{};
  for (unsigned seed = 1; seed <= number_of_similarities; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Order new_face;
    const Soup other = similar(soup, seed, new_face);
    const std::vector<Labels> labels = segmentations<Method>(other);
    for (std::size_t i = 0; i < 2; ++i) {
      double least = 1;
      for (const Order& symmetry : symmetries) {
        Labels back;
        for (std::size_t f = 0; f < new_face.size(); ++f)
          back.push_back(labels[i][new_face[symmetry[f]]]);
        least = std::min(least, RS::rand_index_distance(RS::Partition::from_labels(expected[i]),
                                                        RS::Partition::from_labels(back)));
      }
      EXPECT_LE(least, 0.02) << (i == 0 ? "chosen number" : "7 segments");
      different[i] += least > 0.005;
    }
  }
  for (std::size_t n : different)
    EXPECT_LE(n, number_of_similarities / 20);
}

void expect_same_parts(const Soup& soup, const std::vector<Order>& symmetries)
{
  {
    SCOPED_TRACE("learned");
    expect_same_parts<RS::Learned_merging>(soup, symmetries);
  }
  SCOPED_TRACE("visibility");
  expect_same_parts<RS::Visibility_merging>(soup, symmetries);
}

Order identity(const Soup& soup)
{
  Order result(soup.polygons.size());
  for (std::size_t f = 0; f < result.size(); ++f)
    result[f] = f;
  return result;
}

/// Those of the eight symmetries of a square in x and y, about the center of the box, that the shape has.
std::vector<Order> symmetries_about_z(const Soup& soup)
{
  Point low = soup.points[0], high = low;
  for (const Point& p : soup.points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  std::map<std::array<long, 3>, std::size_t> face_at; // in doubled coordinates, summed over the corners
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

Soup voxel_model(const std::vector<std::pair<Voxel, Voxel>>& blocks)
{
  std::vector<Voxel> voxels;
  for (const auto& [from, to] : blocks)
    for (const Voxel& v : voxel_block(from, to))
      voxels.push_back(v);
  return voxel_surface(voxels);
}

// Each face has equal ones beside it, and each part a mirror image.
TEST(similarity_test, symmetric_models_have_the_same_parts_in_any_frame)
{
  const std::vector<std::pair<Voxel, Voxel>> legs = {
    {{0, 0, 0}, {2, 2, 9}}, {{11, 0, 0}, {13, 2, 9}}, {{0, 11, 0}, {2, 13, 9}}, {{11, 11, 0}, {13, 13, 9}}};
  auto table = legs, chair = legs;
  table.push_back({{0, 0, 9}, {13, 13, 11}});
  chair.push_back({{0, 0, 9}, {13, 13, 11}});
  chair.push_back({{0, 11, 11}, {13, 13, 22}});
  for (const auto& blocks : {table, chair}) {
    const Soup soup = voxel_model(blocks);
    const std::vector<Order> symmetries = symmetries_about_z(soup);
    SCOPED_TRACE(std::to_string(symmetries.size()) + " symmetries");
    EXPECT_EQ(symmetries.size(), blocks.size() == table.size() ? 8u : 2u);
    expect_same_parts(soup, symmetries);
  }
}

// Flat faces of fandisk.off have thousands of coplanar patches.
TEST(Real_meshes, have_the_same_parts_in_any_frame)
{
  std::size_t checked = 0;
  for (const auto& file : off_files()) {
    const std::string name = file.stem().string();
    if (name != "fandisk" && name != "joint" && name != "rotor")
      continue;
    SCOPED_TRACE(name);
    Surface_mesh mesh;
    std::ifstream in(file);
    ASSERT_TRUE(CGAL::IO::read_OFF(in, mesh));
    const Soup soup = soup_of(mesh);
    expect_same_parts(soup, {identity(soup)});
    ++checked;
  }
  if (checked == 0)
    GTEST_SKIP() << "REGION_SEGMENTATION_REAL_MESHES names no folder with these meshes";
}

} // namespace similarity_test
