// SPDX-License-Identifier: GPL-3.0-or-later

// What the manual and doc/performance.md promise of memory on large meshes.

#include "allocated_bytes.h"
#include "make_mesh.h"
#include "make_triangles.h"

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using speed_benchmark::peak_of_allocated_bytes;

// 4,147,200 faces: patches, whose number is bounded, no longer count.
speed_benchmark::Triangles large_torus()
{
  auto torus = speed_benchmark::wavy_torus(4050);
  for (int i = 0; i < 5; ++i)
    torus = subdivided(torus);
  return torus;
}

double bytes_a_face_of_default(const speed_benchmark::Triangles& triangles)
{
  const speed_benchmark::Mesh mesh = speed_benchmark::make_mesh(triangles);
  std::vector<std::uint32_t> segments(num_faces(mesh));
  const auto map = boost::make_iterator_property_map(segments.begin(), get(CGAL::face_index, mesh));
  const std::size_t peak = peak_of_allocated_bytes(
    [&] { CGAL::Region_segmentation::segment(mesh, map); });
  return double(peak) / double(num_faces(mesh));
}

TEST(Peak_memory, of_the_default_method_is_150_bytes_a_face_on_large_meshes)
{
  const speed_benchmark::Triangles torus = large_torus();
  ASSERT_EQ(torus.corners.size(), 4147200u);
  for (const auto& [name, triangles] :
       {std::pair("smooth", torus), std::pair("noisy", roughened(torus, 0.2))}) {
    const double a_face = bytes_a_face_of_default(triangles);
    RecordProperty(name, std::to_string(a_face));
    EXPECT_LE(a_face, 150) << name;
    EXPECT_GE(a_face, 57.5) << "fewer than the arrays of the mesh: allocations are not counted";
  }
}

} // namespace
