// SPDX-License-Identifier: GPL-3.0-or-later

// The program says where the largest number that a method chooses was chosen.

#include "Program.h"

#include <array>
#include <map>
#include <set>
#include <sstream>

namespace largest_number_test {

using Cell = std::array<int, 3>;

Cell sum(const Cell& a, const Cell& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// The surface of a plate of unit cubes with n by n pillars on it.
std::string pillars(int n)
{
  constexpr int height = 6;
  std::set<Cell> cells;
  for (int x = 0; x <= 3 * n; ++x)
    for (int y = 0; y <= 3 * n; ++y)
      for (int z = 0; z <= (x % 3 == 1 && y % 3 == 1 ? height : 0); ++z)
        cells.insert({x, y, z});

  // The corners of the side at 0 and of that at 1, along each axis, seen from outside.
  constexpr std::array<Cell, 4> sides[3][2] = {{{{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}},
                                                {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}},
                                               {{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},
                                                {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}}},
                                               {{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}},
                                                {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}}};
  std::map<Cell, std::size_t> number_of_point;
  std::ostringstream points, faces;
  std::size_t number_of_faces = 0;
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) {
        Cell neighbor = cell;
        neighbor[axis] += side == 0 ? -1 : 1;
        if (cells.count(neighbor) > 0)
          continue;
        faces << 4;
        for (const Cell& corner : sides[axis][side]) {
          const Cell p = sum(cell, corner);
          const auto entry = number_of_point.emplace(p, number_of_point.size());
          if (entry.second)
            points << p[0] << " " << p[1] << " " << p[2] << "\n";
          faces << " " << entry.first->second;
        }
        faces << "\n";
        ++number_of_faces;
      }
  return "OFF\n" + std::to_string(number_of_point.size()) + " " + std::to_string(number_of_faces) +
         " 0\n" + points.str() + faces.str();
}

TEST_F(Program, says_where_the_largest_number_is_chosen)
{
  const std::string remark = " (the most that are chosen: there may be more parts, see -k)";
  folder.write("a.off", pillars(10));
  EXPECT_NE(run("a.off").out.find(" 60 segments" + remark), std::string::npos);
  EXPECT_NE(run("a.off --method visibility").out.find(" 40 segments" + remark), std::string::npos);
  EXPECT_EQ(run("a.off -k 60").out.find(remark), std::string::npos);
  folder.write("b.off", pillars(1));
  EXPECT_EQ(run("b.off").out.find(remark), std::string::npos);
}

} // namespace largest_number_test
