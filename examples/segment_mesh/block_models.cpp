// SPDX-License-Identifier: GPL-3.0-or-later

#include "block_models.h"

#include "Quad_model.h"

#include <algorithm>
#include <cmath>
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

/// Where a corner of the grid is.
using Bend = Point (*)(const Cell& corner);

/// Collects the faces between full and empty cells.
class Grid
{
public:
  /// \param period the number of cells after which the first axis returns to its start; 0: none
  explicit Grid(int period) : m_period(period) {}

  void fill(const Block& block)
  {
    for (int i = block.low[0]; i < block.high[0]; ++i)
      for (int j = block.low[1]; j < block.high[1]; ++j)
        for (int k = block.low[2]; k < block.high[2]; ++k)
          m_part_of_cell[wrapped({i, j, k})] = block.part;
    m_model.number_of_parts = (std::max)(m_model.number_of_parts, block.part + 1);
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
  Cell wrapped(Cell cell) const
  {
    if (m_period > 0)
      cell[0] = (cell[0] + m_period) % m_period;
    return cell;
  }

  std::size_t point_at(const Cell& corner, Bend bend)
  {
    const auto entry = m_point_of_corner.emplace(wrapped(corner), m_model.soup.points.size());
    if (entry.second)
      m_model.soup.points.push_back(bend(corner));
    return entry.first->second;
  }

  void add_face(const Cell& cell, std::size_t axis, int side, std::size_t part, Bend bend)
  {
    // Counterclockwise seen from the high side.
    Polygon_soup::Polygon face;
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

  int m_period;
  std::map<Cell, std::size_t> m_part_of_cell, m_point_of_corner;
  Labelled_model m_model;
};

/// Of two blocks in the same place, the later one counts.
Labelled_model build(const char* name, const std::vector<Block>& blocks, Bend bend, int period = 0)
{
  Grid grid(period);
  for (const Block& block : blocks)
    grid.fill(block);
  Labelled_model model = grid.surface(bend);
  model.name = name;
  return model;
}

/// A cell is a cube.
Point as_it_is(const Cell& corner)
{
  return {double(corner[0]), double(corner[1]), double(corner[2])};
}

} // namespace

Labelled_model make_table()
{
  Labelled_model model = build("table",
                               {{{0, 0, 14}, {26, 16, 16}, 0},
                                {{1, 1, 0}, {3, 3, 14}, 1},
                                {{23, 1, 0}, {25, 3, 14}, 2},
                                {{1, 13, 0}, {3, 15, 14}, 3},
                                {{23, 13, 0}, {25, 15, 14}, 4}},
                               as_it_is);
  split_quads(model, Diagonals::AT_RANDOM);
  return model;
}

Labelled_model make_chair()
{
  // The lower, the farther from the middle; the back leans.
  const Bend splay = [](const Cell& c) {
    const double below = (std::max)(0, 10 - c[2]), above = (std::max)(0, c[2] - 12);
    const double wider = 1 + 0.02 * below;
    return Point{(c[0] - 6) * wider, (c[1] - 6) * wider + 0.15 * above, double(c[2])};
  };
  Labelled_model model = build("chair",
                               {{{0, 0, 10}, {12, 12, 12}, 0},
                                {{0, 10, 12}, {12, 12, 26}, 1},
                                {{0, 0, 0}, {2, 2, 10}, 2},
                                {{10, 0, 0}, {12, 2, 10}, 3},
                                {{0, 10, 0}, {2, 12, 10}, 4},
                                {{10, 10, 0}, {12, 12, 10}, 5}},
                               splay);
  split_quads(model, Diagonals::ALTERNATING);
  add_noise(model, 0.08);
  return model;
}

Labelled_model make_bracket()
{
  Labelled_model model =
    build("bracket",
          {{{0, 0, 0}, {20, 12, 3}, 0}, {{0, 0, 3}, {3, 12, 16}, 1}, {{10, 3, 3}, {16, 9, 9}, 2}},
          as_it_is);
  split_quads(model, Diagonals::FIRST);
  add_noise(model, 0.03);
  return model;
}

Labelled_model make_gear()
{
  // Clockwise around the axis, outwards, along the axis.
  const int teeth = 8, period = 6 * teeth;
  const Bend polar = [](const Cell& c) {
    const double angle = 6.283185307179586 * c[0] / period;
    return Point{c[1] * std::sin(angle), c[1] * std::cos(angle), double(c[2])};
  };
  std::vector<Block> blocks = {{{0, 3, 0}, {period, 9, 4}, 0}, {{0, 3, 4}, {period, 5, 9}, 1}};
  for (int i = 0; i < teeth; ++i)
    blocks.push_back({{6 * i, 9, 0}, {6 * i + 3, 12, 4}, std::size_t(2 + i)});
  Labelled_model model = build("gear", blocks, polar, period);
  split_quads(model, Diagonals::ALTERNATING);
  add_noise(model, 0.03);
  return model;
}

} // namespace segment_mesh
