// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Surface/face_values.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace face_values_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;

TEST(Face_values_test, are_in_iteration_order_and_written_back)
{
  Surface_mesh mesh = to_surface_mesh(triangulated(grid(4, 3)));
  mesh.remove_face(Surface_mesh::Face_index(5)); // not collected: a gap in the indices
  auto map = face_map(mesh);
  std::size_t n = 0;
  for (auto f : mesh.faces())
    put(map, f, 10 * n++);
  const auto values = RS::face_values(mesh, map);
  ASSERT_EQ(values.size(), 23u);
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_EQ(values[i], 10 * i);

  auto copy = face_map(mesh);
  RS::write_face_values(mesh, values, copy);
  EXPECT_EQ(labels_of(mesh, copy), labels_of(mesh, map));
}

TEST(Face_values_test, labels_are_written_to_maps_of_other_types)
{
  const Surface_mesh mesh = to_surface_mesh(grid(4, 1));
  auto map = face_map(mesh);
  RS::write_face_values(mesh, std::vector<std::uint32_t>{0, std::uint32_t(-1), 2, 1}, map);
  EXPECT_EQ(labels_of(mesh, map), (std::vector<std::size_t>{0, std::size_t(-1), 2, 1}));
  EXPECT_THROW(RS::write_face_values(mesh, std::vector<int>{7, 7, 7, -2}, map), RS::Invalid_input);
  EXPECT_EQ(labels_of(mesh, map)[0], 0u) << "nothing is written";
}

} // namespace face_values_test
