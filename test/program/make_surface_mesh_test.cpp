// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/make_surface_mesh.h"

#include "soup/link_corners.h"

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <iostream>
#include <optional>
#include <random>

namespace make_surface_mesh_test {

using namespace segment_mesh;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// Some squares and triangles of a grid, whose sides may be joined to a cylinder or a torus.
Polygon_soup random_faces(std::mt19937& random)
{
  const std::size_t n = 3 + random() % 4, columns = n + random() % 2, rows = n + random() % 2;
  const auto point = [=](std::size_t i, std::size_t j) {
    return i % columns + columns * (j % rows);
  };
  Polygon_soup soup;
  const bool is_whole = random() % 2;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1),
                        d = point(i, j + 1);
      if (!is_whole && random() % 5 == 0)
        continue;
      if (random() % 2)
        soup.polygons.push_back({a, b, c, d});
      else {
        soup.polygons.push_back({a, b, c});
        soup.polygons.push_back({a, c, d});
      }
    }
  // Without isolated points.
  std::vector<std::size_t> new_index(columns * rows, std::size_t(-1));
  soup.polygons.renumber([&](std::size_t i) {
    if (new_index[i] == std::size_t(-1)) {
      new_index[i] = soup.points.size();
      soup.points.push_back({double(i), double(random() % 100), 0});
    }
    return new_index[i];
  });
  return soup;
}

/// The vertices of each face from the lowest one, and of each border.
std::vector<std::vector<std::size_t>> cycles(const Surface_mesh& mesh)
{
  std::vector<std::vector<std::size_t>> result;
  const auto add = [&](Surface_mesh::Halfedge_index start) {
    auto lowest = start;
    for (const auto h : mesh.halfedges_around_face(start))
      if (mesh.target(h) < mesh.target(lowest))
        lowest = h;
    auto& cycle = result.emplace_back();
    for (const auto h : mesh.halfedges_around_face(lowest))
      cycle.push_back(mesh.target(h));
  };
  for (const auto face : mesh.faces())
    add(mesh.halfedge(face));
  const std::size_t number_of_faces = result.size();
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      add(h);
  std::sort(result.begin() + std::ptrdiff_t(number_of_faces), result.end());
  return result;
}

TEST(Make_surface_mesh, gives_the_mesh_that_cgal_gives)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  int number_of_meshes = 0;
  while (number_of_meshes < 500) {
    const Polygon_soup soup = random_faces(random);
    const std::optional<Corner_links> links = link_corners(soup);
    if (soup.polygons.empty() || !links)
      continue;
    ++number_of_meshes;
    const Surface_mesh mesh = make_surface_mesh<Surface_mesh>(soup, *links);
    Surface_mesh expected;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons,
                                                                expected);
    ASSERT_TRUE(mesh.is_valid(false) && CGAL::is_valid_polygon_mesh(mesh));
    ASSERT_EQ(mesh.number_of_edges(), expected.number_of_edges());
    ASSERT_EQ(cycles(mesh), cycles(expected));
    for (const auto v : mesh.vertices()) {
      ASSERT_EQ(mesh.point(v), expected.point(v));
      ASSERT_EQ(mesh.target(mesh.halfedge(v)), v);
      ASSERT_EQ(mesh.is_border(v, false),
                mesh.is_border(v)); // a vertex at a border keeps a halfedge of it
    }
  }
}

} // namespace make_surface_mesh_test
