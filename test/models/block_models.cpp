// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/block_models.h"

#include "models/Quad_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace segment_mesh {

namespace {

/// A place in the grid: the lowest corner of a cell, or a cell.
using Cell = std::array<int, 3>;

/// The cells from `low` to below `high`.
struct Block
{
  Cell low, high;
  std::size_t part;
};

/// Where a corner of the grid is, from its place in the usual grid.
using Bend = Point (*)(const Point& corner);

/// The planes of the grid across an axis: those at the ends of blocks stay, whatever the fineness.
class Planes
{
public:
  Planes(const std::vector<Block>& blocks, std::size_t axis, double fineness)
  {
    for (const Block& block : blocks) {
      m_index_at[block.low[axis]] = 0;
      m_index_at[block.high[axis]] = 0;
    }
    for (auto end = m_index_at.begin(); end != m_index_at.end(); ++end) {
      if (end != m_index_at.begin())
        fill_between(std::prev(end)->first, end->first, fineness);
      end->second = int(m_positions.size());
      m_positions.push_back(end->first);
    }
  }

  int index_at(int end_of_block) const { return m_index_at.at(end_of_block); }
  double position(int index) const { return m_positions[std::size_t(index)]; }

private:
  void fill_between(int low, int high, double fineness)
  {
    const long steps = (std::max)(1l, std::lround((high - low) * fineness));
    for (long i = 1; i < steps; ++i)
      m_positions.push_back(low + double(i) * (high - low) / double(steps));
  }

  std::map<int, int> m_index_at; // of the ends of blocks
  std::vector<double> m_positions;
};

/// Collects the faces between full and empty cells.
class Grid
{
public:
  /// Of two blocks in the same place, the later one counts.
  /// \param period the end of the blocks where the first axis returns to its start; 0: none
  Grid(const std::vector<Block>& blocks, int period, double fineness)
    : m_planes{Planes(blocks, 0, fineness), Planes(blocks, 1, fineness),
               Planes(blocks, 2, fineness)}
    , m_period(period > 0 ? m_planes[0].index_at(period) : 0)
  {
    for (const Block& block : blocks)
      fill({index_of(block.low), index_of(block.high), block.part});
  }

  Labelled_model surface(Bend bend)
  {
    for (const auto& [cell, part] : m_part_of_cell)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
          Cell neighbor = cell;
          neighbor[axis] += 2 * side - 1;
          if (m_part_of_cell.count(wrapped(neighbor)) == 0)
            add_face(cell, axis, side, part, bend);
        }
    return m_model;
  }

private:
  Cell index_of(const Cell& ends) const
  {
    return {m_planes[0].index_at(ends[0]), m_planes[1].index_at(ends[1]),
            m_planes[2].index_at(ends[2])};
  }

  void fill(const Block& block)
  {
    for (int i = block.low[0]; i < block.high[0]; ++i)
      for (int j = block.low[1]; j < block.high[1]; ++j)
        for (int k = block.low[2]; k < block.high[2]; ++k)
          m_part_of_cell[wrapped({i, j, k})] = block.part;
    m_model.number_of_parts = (std::max)(m_model.number_of_parts, block.part + 1);
  }

  Cell wrapped(Cell cell) const
  {
    if (m_period > 0)
      cell[0] = (cell[0] + m_period) % m_period;
    return cell;
  }

  std::size_t point_at(const Cell& corner, Bend bend)
  {
    const Cell c = wrapped(corner);
    const auto entry = m_point_of_corner.emplace(c, m_model.soup.points.size());
    if (entry.second)
      m_model.soup.points.push_back(
        bend({m_planes[0].position(c[0]), m_planes[1].position(c[1]), m_planes[2].position(c[2])}));
    return entry.first->second;
  }

  void add_face(const Cell& cell, std::size_t axis, int side, std::size_t part, Bend bend)
  {
    // Counterclockwise seen from the high side.
    std::vector<std::size_t> face;
    for (const auto& [u, v] : {std::array<int, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      Cell corner = cell;
      corner[axis] += side;
      corner[(axis + 1) % 3] += side == 1 ? u : v;
      corner[(axis + 2) % 3] += side == 1 ? v : u;
      face.push_back(point_at(corner, bend));
    }
    m_model.soup.polygons.push_back(face);
    m_model.labels.push_back(part);
  }

  std::array<Planes, 3> m_planes;
  int m_period; // in cells
  std::map<Cell, std::size_t> m_part_of_cell, m_point_of_corner;
  Labelled_model m_model;
};

Labelled_model build(const char* name, const std::vector<Block>& blocks, Bend bend,
                     const Making& making, int period = 0)
{
  Labelled_model model = Grid(blocks, period, making.fineness).surface(bend);
  model.name = name;
  return model;
}

/// A cell is a cube.
Point as_it_is(const Point& corner)
{
  return corner;
}

} // namespace

Labelled_model make_table(const Making& making)
{
  Labelled_model model = build("table",
                               {{{0, 0, 14}, {26, 16, 16}, 0},
                                {{1, 1, 0}, {3, 3, 14}, 1},
                                {{23, 1, 0}, {25, 3, 14}, 2},
                                {{1, 13, 0}, {3, 15, 14}, 3},
                                {{23, 13, 0}, {25, 15, 14}, 4}},
                               as_it_is, making);
  split_quads(model, Diagonals::AT_RANDOM);
  return model;
}

Labelled_model make_chair(const Making& making)
{
  // The lower, the farther from the middle; the back leans.
  const Bend splay = [](const Point& c) {
    const double below = (std::max)(0.0, 10 - c[2]), above = (std::max)(0.0, c[2] - 12);
    const double wider = 1 + 0.02 * below;
    return Point{(c[0] - 6) * wider, (c[1] - 6) * wider + 0.15 * above, c[2]};
  };
  Labelled_model model = build("chair",
                               {{{0, 0, 10}, {12, 12, 12}, 0},
                                {{0, 10, 12}, {12, 12, 26}, 1},
                                {{0, 0, 0}, {2, 2, 10}, 2},
                                {{10, 0, 0}, {12, 2, 10}, 3},
                                {{0, 10, 0}, {2, 12, 10}, 4},
                                {{10, 10, 0}, {12, 12, 10}, 5}},
                               splay, making);
  split_quads(model, Diagonals::ALTERNATING);
  add_noise(model, making.noise * 0.08 / making.fineness);
  return model;
}

Labelled_model make_bracket(const Making& making)
{
  Labelled_model model = build(
    "bracket",
    {{{0, 0, 0}, {20, 12, 3}, 0}, {{2, 0, 3}, {5, 12, 16}, 1}, {{10, 3, 3}, {16, 9, 9}, 2}},
    as_it_is, making);
  split_quads(model, Diagonals::FIRST);
  add_noise(model, making.noise * 0.03 / making.fineness);
  return model;
}

Labelled_model make_gear(const Making& making)
{
  // Clockwise around the axis, outwards, along the axis.
  const int teeth = 8, period = 6 * teeth;
  const Bend polar = [](const Point& c) {
    const double angle = 6.283185307179586 * c[0] / period;
    return Point{c[1] * std::sin(angle), c[1] * std::cos(angle), c[2]};
  };
  std::vector<Block> blocks = {{{0, 3, 0}, {period, 9, 4}, 0}, {{0, 3, 4}, {period, 5, 9}, 1}};
  for (int i = 0; i < teeth; ++i)
    blocks.push_back({{6 * i, 9, 0}, {6 * i + 3, 12, 4}, std::size_t(2 + i)});
  Labelled_model model = build("gear", blocks, polar, making, period);
  split_quads(model, Diagonals::ALTERNATING);
  add_noise(model, making.noise * 0.03 / making.fineness);
  return model;
}

} // namespace segment_mesh
