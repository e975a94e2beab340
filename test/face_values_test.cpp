// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/face_values.h>

#include <gtest/gtest.h>

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

TEST(Partition_test, is_numbered_by_first_elements_whatever_the_labels)
{
  const std::vector<std::int64_t> labels = {-7, 5, -7, 1LL << 40, 5, 0};
  const RS::Partition partition = RS::Partition::from_labels(labels);
  EXPECT_EQ(std::vector<std::uint32_t>(partition.begin(), partition.end()),
            (std::vector<std::uint32_t>{0, 1, 0, 2, 1, 3}));
  EXPECT_EQ(partition.number_of_parts(), 4u);
  EXPECT_EQ(partition, RS::Partition::from_labels(partition));
  EXPECT_EQ(RS::Partition::from_labels(std::vector<int>()).number_of_parts(), 0u);
}

TEST(Partition_test, composes)
{
  const auto fine = RS::Partition::from_labels(std::vector<int>{0, 0, 1, 2, 2, 3});
  const auto coarse = RS::Partition::from_labels(std::vector<int>{0, 1, 0, 1}); // of the parts of
                                                                                // the fine one
  const RS::Partition both = composed(fine, coarse);
  EXPECT_EQ(std::vector<std::uint32_t>(both.begin(), both.end()),
            (std::vector<std::uint32_t>{0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(both.number_of_parts(), 2u);
}

} // namespace face_values_test
