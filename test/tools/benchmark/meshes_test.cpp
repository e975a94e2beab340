// SPDX-License-Identifier: GPL-3.0-or-later

// The meshes that speed is measured on, and the count of bytes.

#include "allocated_bytes.h"
#include "make_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace speed_benchmark;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// How often every edge is there in its direction.
std::map<Edge, int> directed_edges(const Triangles& triangles)
{
  std::map<Edge, int> count;
  for (const auto& t : triangles.corners)
    for (std::size_t i = 0; i < 3; ++i)
      ++count[{t[i], t[(i + 1) % 3]}];
  return count;
}

/// Closed and oriented: every edge once in each direction.
bool is_closed(const Triangles& triangles)
{
  const auto count = directed_edges(triangles);
  for (const auto& [edge, n] : count)
    if (n != 1 || count.count({edge.second, edge.first}) == 0)
      return false;
  return !count.empty();
}

long euler_characteristic(const Triangles& triangles)
{
  return long(triangles.points.size()) - long(directed_edges(triangles).size() / 2) +
         long(triangles.corners.size());
}

double area(const Triangles& triangles)
{
  double sum = 0;
  for (const auto& t : triangles.corners) {
    double u[3], v[3];
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = triangles.points[t[1]][i] - triangles.points[t[0]][i];
      v[i] = triangles.points[t[2]][i] - triangles.points[t[0]][i];
    }
    sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]) /
           2;
  }
  return sum;
}

TEST(Wavy_torus, is_a_closed_torus)
{
  const Triangles torus = wavy_torus(800);
  EXPECT_EQ(torus.corners.size(), 800u);
  EXPECT_TRUE(is_closed(torus));
  EXPECT_EQ(euler_characteristic(torus), 0);
}

TEST(Subdivided, is_the_same_surface_in_four_times_as_many_triangles)
{
  const Triangles coarse = wavy_torus(200), fine = subdivided(coarse);
  EXPECT_EQ(fine.corners.size(), 4 * coarse.corners.size());
  EXPECT_EQ(fine.points.size(), coarse.points.size() + coarse.corners.size() * 3 / 2);
  EXPECT_TRUE(is_closed(fine));
  EXPECT_EQ(euler_characteristic(fine), euler_characteristic(coarse));
  EXPECT_NEAR(area(fine), area(coarse), 1e-12 * area(coarse));
  EXPECT_TRUE(std::equal(coarse.points.begin(), coarse.points.end(), fine.points.begin()));
}

TEST(Subdivided, keeps_borders)
{
  const Triangles two{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const Triangles fine = subdivided(two);
  EXPECT_EQ(fine.points.size(), 9u);
  EXPECT_EQ(fine.corners.size(), 8u);
  EXPECT_DOUBLE_EQ(area(fine), 1);
}

TEST(Roughened, moves_every_coordinate_a_little_and_always_the_same_way)
{
  const Triangles flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const double most = 0.1 * (2 + std::sqrt(2.0)) / 3;
  const Triangles rough = roughened(flat, 0.1);
  EXPECT_EQ(rough.points, roughened(flat, 0.1).points);
  std::set<double> moves;
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t i = 0; i < 3; ++i) {
      const double move = rough.points[v][i] - flat.points[v][i];
      EXPECT_LE(std::abs(move), most);
      EXPECT_NE(move, 0);
      moves.insert(move);
    }
  EXPECT_GT(moves.size(), 6u);
}

TEST(Read_triangles, names_a_file_that_is_not_right)
{
  const std::string head = "OFF 3 1 0\n0 0 0 1 0 0 ";
  for (const std::string& content :
       {std::string(), head, head + "0 1 0\n4 0 1 2 0\n", head + "0 1 0\n3 0 1 3\n"}) {
    const auto file = std::filesystem::path(testing::TempDir()) / "benchmark_parts_test.off";
    std::ofstream(file) << content;
    try {
      read_triangles(file.string());
      ADD_FAILURE() << "was read: " << content;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
    }
    std::filesystem::remove(file);
  }
}

TEST(Peak_of_allocated_bytes, is_that_of_what_is_held_at_once)
{
  std::vector<char> before(1 << 16);
  const std::size_t peak = peak_of_allocated_bytes([&] {
    {
      const std::vector<char> first(100000);
    }
    const std::vector<char> second(200000), third(300000);
    before = std::vector<char>(); // frees what was there before
  });
  EXPECT_GE(peak, 500000u);
  EXPECT_LE(peak, 500000u + 2 * 4096); // malloc rounds large blocks up to pages
  EXPECT_EQ(peak_of_allocated_bytes([] {}), 0u);
}

} // namespace
