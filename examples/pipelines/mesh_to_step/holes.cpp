// SPDX-License-Identifier: GPL-3.0-or-later

#include "holes.h"

#include "part_surface.h"

#include <ElSLib.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace mesh_to_step {

namespace {

using Faces = std::set<std::size_t>;
constexpr double equal = 1e-3; // lengths of a pattern

/// The faces that can be reached from one, through those that are wanted.
template <typename Predicate>
Faces reach(const Part_faces& faces, std::size_t start, const Predicate& is_wanted)
{
  Faces result{start};
  std::vector<std::size_t> waiting{start};
  while (!waiting.empty()) {
    const std::size_t face = waiting.back();
    waiting.pop_back();
    for (const auto& neighbor : faces[face].neighbors)
      if (is_wanted(neighbor.face) && result.insert(neighbor.face).second)
        waiting.push_back(neighbor.face);
  }
  return result;
}

bool is_wall(const Part_faces& faces, std::size_t face)
{
  return faces[face].role == RS::Face_role::HOLE && faces[face].surface.has_axis();
}

/// Whether what borders on the walls falls apart without these and the steps between them.
bool is_blind(const Part_faces& faces, const Faces& walls)
{
  Faces around;
  for (const std::size_t wall : walls)
    for (const auto& neighbor : faces[wall].neighbors)
      around.insert(neighbor.face);
  const auto is_outside = [&](std::size_t face) {
    const auto& neighbors = faces[face].neighbors;
    const auto count = std::count_if(neighbors.begin(), neighbors.end(),
                                     [&](const auto& n) { return walls.count(n.face) > 0; });
    const bool is_step = faces[face].role == RS::Face_role::HOLE && count > 1;
    return walls.count(face) == 0 && !is_step;
  };
  const auto first = std::find_if(around.begin(), around.end(), is_outside);
  if (first == around.end())
    return true;
  const Faces reached = reach(faces, *first, is_outside);
  return std::any_of(around.begin(), around.end(), [&](std::size_t face) {
    return is_outside(face) && reached.count(face) == 0;
  });
}

Hole make_hole(const Part_faces& faces, const Faces& walls)
{
  constexpr double degrees = 180 / CGAL_PI;
  Hole result;
  result.walls.assign(walls.begin(), walls.end());
  result.is_blind = is_blind(faces, walls);
  result.diameter = std::numeric_limits<double>::infinity();
  const Fitted_surface& axis = faces[*walls.begin()].surface;
  double lowest = result.diameter, highest = -lowest;
  for (const std::size_t wall : walls) {
    const Fitted_surface& s = faces[wall].surface;
    const double slope = s.kind == RS::Surface_kind::CONE ? std::tan(s.angle) : 0,
                 narrow = 2 * (s.radius + s.lowest * slope),
                 wide = 2 * (s.radius + s.highest * slope);
    const bool has_apex = slope > 0 && narrow < equal * wide;
    result.is_blind = result.is_blind || has_apex;
    if (has_apex && walls.size() > 1) {
      result.tip_angle = 2 * s.angle * degrees;
      continue;
    }
    result.diameter = (std::min)(result.diameter, narrow);
    if (slope > 0)
      result.countersinks.push_back({wide, 2 * s.angle * degrees});
    else
      result.counterbores.push_back({wide, s.highest - s.lowest});
    for (const double z : {s.lowest, s.highest}) {
      const double on_axis = (s.point + z * s.direction - axis.point) * axis.direction;
      lowest = (std::min)(lowest, on_axis);
      highest = (std::max)(highest, on_axis);
    }
  }
  result.depth = highest - lowest;
  auto& wider = result.counterbores;
  wider.erase(
    std::remove_if(wider.begin(), wider.end(),
                   [&](const auto& c) { return c.diameter < (1 + equal) * result.diameter; }),
    wider.end());
  return result;
}

using Position = std::complex<double>;

/// Whether some positions are the corners of a regular polygon: a turn from one to the next leaves
/// the pattern as it is.
bool is_circle(const std::vector<Position>& positions, const Position& center)
{
  const Position turn = std::polar(1.0, 2 * CGAL_PI / double(positions.size()));
  return std::all_of(positions.begin(), positions.end(), [&](const Position& p) {
    const Position turned = center + turn * (p - center);
    return std::any_of(positions.begin(), positions.end(), [&](const Position& q) {
      return std::abs(q - turned) < equal * std::abs(p - center);
    });
  });
}

/// How many different numbers there are, and by how much each is above the one before; none if they
/// are not equally far apart.
std::optional<std::pair<std::size_t, double>> find_steps(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  const double first = numbers.front(), length = numbers.back() - first;
  const auto second = std::upper_bound(numbers.begin(), numbers.end(), first + equal);
  if (second == numbers.end())
    return std::make_pair(1, 0.0);
  const double steps = std::round(length / (*second - first)), step = length / steps;
  for (const double x : numbers)
    if (std::fabs(std::remainder(x - first, step)) > equal)
      return std::nullopt;
  return std::make_pair(std::size_t(steps) + 1, step);
}

/// Sets rows and columns if some positions are all points of a grid.
bool find_grid(const std::vector<Position>& positions, Hole_pattern& pattern)
{
  Position shortest = positions[1] - positions[0];
  for (const Position& p : positions)
    for (const Position& q : positions)
      if (p != q && std::abs(q - p) < (1 - equal) * std::abs(shortest))
        shortest = q - p;
  std::vector<double> x, y;
  for (const Position& p : positions) {
    x.push_back(((p - positions[0]) / shortest).real());
    y.push_back(((p - positions[0]) / shortest).imag());
  }
  const auto columns = find_steps(x), rows = find_steps(y);
  if (!columns || !rows || columns->first * rows->first != positions.size())
    return false;
  pattern.columns = columns->first;
  pattern.rows = rows->first;
  pattern.column_pitch = std::abs(shortest) * columns->second;
  pattern.row_pitch = std::abs(shortest) * rows->second;
  return true;
}

/// Whether holes have equal diameters and depths, and parallel axes.
bool are_equal(const Part_faces& faces, const Hole& a, const Hole& b)
{
  const auto direction = [&](const Hole& h) { return faces[h.walls.front()].surface.direction; };
  return std::fabs(a.diameter - b.diameter) < equal * a.diameter && a.is_blind == b.is_blind &&
         std::fabs(a.depth - b.depth) < equal * a.depth &&
         CGAL::cross_product(direction(a), direction(b)).squared_length() < equal * equal;
}

/// The pattern of equal holes, if it is one. Several on one axis are at one position.
std::optional<Hole_pattern> find_pattern(const Part_faces& faces, const std::vector<Hole>& holes,
                                         const std::vector<std::size_t>& equal_holes)
{
  const Fitted_surface& first = faces[holes[equal_holes.front()].walls.front()].surface;
  const gp_Pln plane(point_of(first.point),
                     {first.direction.x(), first.direction.y(), first.direction.z()});
  std::set<std::size_t> axes;
  std::vector<Position> positions;
  Position center = 0;
  for (const std::size_t hole : equal_holes) {
    const auto& wall = faces[holes[hole].walls.front()];
    if (axes.insert(wall.first_on_axis).second) {
      double x, y;
      ElSLib::Parameters(plane, point_of(wall.surface.point), x, y);
      positions.emplace_back(x, y);
      center += positions.back();
    }
  }
  if (positions.size() < 3)
    return std::nullopt;
  center /= double(positions.size());
  Hole_pattern result;
  result.holes = equal_holes;
  if (is_circle(positions, center)) {
    const gp_Pnt p = ElSLib::Value(center.real(), center.imag(), plane);
    result.center = Point(p.X(), p.Y(), p.Z());
    result.diameter = 2 * std::abs(positions.front() - center);
  } else if (!find_grid(positions, result))
    return std::nullopt;
  return result;
}

} // namespace

std::vector<Hole> find_holes(const Part_faces& faces)
{
  std::vector<Hole> result;
  Faces found;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (is_wall(faces, i) && found.count(i) == 0) {
      Faces walls = reach(faces, i, [&](std::size_t face) {
        return faces[face].role == RS::Face_role::HOLE &&
               (!faces[face].surface.has_axis() ||
                faces[face].first_on_axis == faces[i].first_on_axis);
      });
      for (auto face = walls.begin(); face != walls.end();)
        face = is_wall(faces, *face) ? std::next(face) : walls.erase(face);
      found.insert(walls.begin(), walls.end());
      result.push_back(make_hole(faces, walls));
    }
  return result;
}

std::vector<Hole_pattern> find_patterns(const Part_faces& faces, const std::vector<Hole>& holes)
{
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& others) {
      return are_equal(faces, holes[others.front()], holes[i]);
    });
    if (group == groups.end())
      groups.push_back({i});
    else
      group->push_back(i);
  }
  std::vector<Hole_pattern> result;
  for (const std::vector<std::size_t>& group : groups)
    if (const auto pattern = find_pattern(faces, holes, group))
      result.push_back(*pattern);
  return result;
}

} // namespace mesh_to_step
