// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REAL_MESHES_H
#define CGAL_REGION_SEGMENTATION_TEST_REAL_MESHES_H

// The meshes that come with CGAL's demos, in the folder that the environment variable
// REGION_SEGMENTATION_REAL_MESHES names.

#include "meshes.h"

#include <CGAL/boost/graph/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace test {

inline std::vector<std::filesystem::path> off_files()
{
  std::vector<std::filesystem::path> files;
  const char* folder = std::getenv("REGION_SEGMENTATION_REAL_MESHES");
  if (!folder || !std::filesystem::is_directory(folder))
    return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".off")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Calls `check_one(mesh)` for the meshes of the folder with at most `most_faces`; it returns
/// whether it did check.
template <typename Check>
void check_real_meshes(std::size_t most_faces, const Check& check_one)
{
  const auto files = off_files();
  if (files.empty())
    GTEST_SKIP() << "REGION_SEGMENTATION_REAL_MESHES names no folder with .off files";
  std::size_t checked = 0;
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    Surface_mesh mesh;
    std::ifstream in(file);
    // The folder also holds point sets, soups, and files that are broken by intent.
    if (!CGAL::IO::read_OFF(in, mesh) || faces(mesh).empty() || num_faces(mesh) > most_faces)
      continue;
    checked += check_one(mesh);
  }
  std::cout << checked << " meshes of " << files.size() << " files\n";
  EXPECT_GT(checked, 10u);
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_REAL_MESHES_H
