// SPDX-License-Identifier: GPL-3.0-or-later

// Invariants on real meshes: those that come with CGAL's demos, unpacked by test/run.sh to a folder
// that the environment variable REGION_SEGMENTATION_REAL_MESHES names.

#include "meshes.h"
#include "oracles.h"

#include <CGAL/boost/graph/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

namespace RS = CGAL::Region_segmentation;
using namespace test;

std::vector<std::filesystem::path> off_files()
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

void check(const Surface_mesh& mesh)
{
  const Soup soup = soup_of(mesh);
  for (const auto& options : {Options(8), Options(5, reference::Convexity::all, 30),
                              Options(1, reference::Convexity::convex, 10)}) {
    const Result result = run(mesh, options);
    const std::size_t regions = result.tree.number_of_regions();
    EXPECT_TRUE(is_numbered_by_first_face(result.segments, result.number_of_segments));
    EXPECT_TRUE(is_numbered_by_first_face(result.regions, regions));
    EXPECT_TRUE(is_connected(soup, result.regions));
    EXPECT_TRUE(is_connected(soup, result.segments));
    EXPECT_TRUE(nests(result.regions, result.segments));
    EXPECT_EQ(result.number_of_segments,
              (std::min)(regions, (std::max)(options.k, number_of_components(soup))));
  }
}

/// Calls `check_one(mesh)` for the meshes of the folder with at most `most_faces`; it returns whether it did check.
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

TEST(Real_meshes, keep_the_invariants)
{
  check_real_meshes(100000, [](const Surface_mesh& mesh) {
    check(mesh);
    return true;
  });
}

TEST(Real_meshes, agree_with_the_reference_where_they_are_small)
{
  check_real_meshes(8000, [](const Surface_mesh& mesh) {
    const Soup soup = soup_of(mesh);
    const Options options(8);
    try {
      const auto expected = reference::two_step(soup.points, soup.polygons, options);
      EXPECT_EQ(run(mesh, options).regions, expected.region_id);
      return true;
    } catch (const std::invalid_argument&) {
      return false; // two edges between the same vertices, which the reference does not know
    }
  });
}

} // namespace
