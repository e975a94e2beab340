// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_REFERENCE_SMOOTHNESS_H
#define CGAL_REGION_SEGMENTATION_TEST_REFERENCE_SMOOTHNESS_H

#include "meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

// The slow, obvious implementation of what `Smoothness_annotator` measures, for triangles without
// degenerate ones, written from its documentation: paths are followed in the plane of one triangle
// after another, by their angle to the edges.

namespace reference {

class Smoothness
{
public:
  /// An edge of a face: that which starts at one of its corners.
  using Side = std::pair<std::size_t, std::size_t>;

  explicit Smoothness(const test::Soup& soup) : m_soup(soup)
  {
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        m_sides[{soup.polygons[f][i], soup.polygons[f][(i + 1) % 3]}] = {f, i};
    for (const auto& [ends, side] : m_sides)
      if (has_opposite(side)) {
        double& largest = m_largest_curvature[side.first];
        largest = std::max(largest, std::abs(joint(side).curvatures[0]));
      }
  }

  /// Of the edge between two faces.
  double discontinuity(std::size_t a, std::size_t b) const
  {
    Side side{a, 0};
    while (!has_opposite(side) || opposite(side).first != b)
      ++side.second;
    const double angle = std::abs(bend(side));
    if (angle > crease)
      return most * angle / crease;
    const Joint j = joint(side);
    const auto [k0, k1] = j.curvatures;
    const double turn_0 = k0 * j.facets[0], turn_1 = k1 * j.facets[1];
    const double largest = std::max(m_largest_curvature.at(a), m_largest_curvature.at(b));
    const double jump =
      std::abs(k0 - k1) / (std::max({std::abs(k0), std::abs(k1), 0.8 * largest}) + flat / j.length);
    const double excess = std::abs(bend(side) - (turn_0 + turn_1) / 2) -
                          4 * std::max(std::abs(turn_0), std::abs(turn_1));
    return std::min(most, jump + std::max(0.0, excess) / radians(5));
  }

private:
  static double radians(double degrees) { return degrees * std::acos(-1.0) / 180; }

  const double crease = radians(32), flat = radians(0.15), most = 3;
  static constexpr int most_crossings = 200;

  test::Point point(const Side& side, std::size_t offset) const
  {
    return m_soup.points[m_soup.polygons[side.first][(side.second + offset) % 3]];
  }
  static test::Point minus(const test::Point& p, const test::Point& q)
  {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  }
  static double dot(const test::Point& p, const test::Point& q)
  {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  }
  static double length(const test::Point& p) { return std::sqrt(dot(p, p)); }
  static test::Point cross(const test::Point& p, const test::Point& q)
  {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
  }

  Side across(const Side& side) const // of its ends, in the other direction
  {
    const auto& polygon = m_soup.polygons[side.first];
    return {polygon[(side.second + 1) % 3], polygon[side.second]};
  }
  bool has_opposite(const Side& side) const { return m_sides.count(across(side)) != 0; }
  Side opposite(const Side& side) const { return m_sides.at(across(side)); }

  /// The corners of a triangle in its plane: the edge from (0, 0) to (c, 0), the third corner at
  /// (x, y).
  struct Triangle
  {
    double c, x, y;
  };

  Triangle flattened(const Side& side) const
  {
    const test::Point edge = minus(point(side, 1), point(side, 0)),
                      other = minus(point(side, 2), point(side, 0));
    const double c = length(edge), x = dot(edge, other) / c;
    return {c, x, length(cross(edge, other)) / c};
  }

  /// Positive where the corner across is below the plane of the face.
  double bend(const Side& side) const
  {
    const auto normal = [this](const Side& s) {
      return cross(minus(point(s, 1), point(s, 0)), minus(point(s, 2), point(s, 0)));
    };
    const test::Point n = normal(side), m = normal(opposite(side));
    const double angle = std::atan2(length(cross(n, m)), dot(n, m));
    return dot(n, minus(point(opposite(side), 2), point(side, 0))) < 0 ? angle : -angle;
  }

  /// A path that enters a face across an edge, at a place along it, at an angle to it.
  struct Path
  {
    Side side;
    double place, angle;
  };

  Path start(const Side& side) const { return {side, flattened(side).c / 2, std::acos(0.0)}; }

  /// The distance to the edge by which a path leaves its face, and the path as seen from there.
  std::pair<double, Path> leave(const Path& path) const
  {
    const Triangle t = flattened(path.side);
    const double dx = std::cos(path.angle), dy = std::sin(path.angle);
    const bool is_right =
      dx * t.y - dy * (t.x - path.place) > 0; // it leaves the third corner to the left
    const double px = is_right ? t.c : t.x, py = is_right ? 0 : t.y, qx = is_right ? t.x : 0,
                 qy = is_right ? t.y : 0;
    const double ex = qx - px, ey = qy - py, l = std::hypot(ex, ey);
    const double distance = (ex * py - ey * (px - path.place)) / (ex * dy - ey * dx);
    const double x = path.place + distance * dx, y = distance * dy;
    const Side exit{path.side.first, (path.side.second + (is_right ? 1 : 2)) % 3};
    return {distance, {exit, std::hypot(qx - x, qy - y), std::acos(-(dx * ex + dy * ey) / l)}};
  }

  double facet_height(const Side& side) const
  {
    double s = 0;
    Path path = start(side);
    for (int i = 0; i < most_crossings; ++i) {
      const auto [distance, next] = leave(path);
      s += distance;
      if (!has_opposite(next.side) || std::abs(bend(next.side)) > flat)
        break;
      path = {opposite(next.side), next.place, next.angle};
    }
    return std::max(s, flattened(side).y);
  }

  struct Section
  {
    double length, facet, curvature;
    bool is_open;
  };

  Section section(const Side& side, double reach) const
  {
    double s = 0, first_bend = -1, turn = 0;
    bool is_ended = false;
    Path path = start(side);
    for (int i = 0; i < most_crossings && !is_ended; ++i) {
      const auto [distance, next] = leave(path);
      if (s + distance >= reach) {
        s = reach;
        break;
      }
      s += distance;
      is_ended = !has_opposite(next.side) || std::abs(bend(next.side)) > crease;
      if (is_ended)
        break;
      turn += bend(next.side) * std::sin(next.angle) * (1 - s / reach);
      if (first_bend < 0 && std::abs(bend(next.side)) > flat)
        first_bend = s;
      path = {opposite(next.side), next.place, next.angle};
    }
    const double facet = first_bend < 0 ? s : first_bend;
    const double total = (s - facet / 2) - (s * s - facet * facet / 4) / (2 * reach);
    return {s, facet, total > 1e-3 * reach ? turn / total : 0, is_ended && first_bend < 0};
  }

  struct Joint
  {
    double curvatures[2] = {0, 0}, facets[2] = {0, 0}, length = 0;
  };

  Joint joint(const Side& side) const
  {
    Joint result;
    const double angle = bend(side);
    if (std::abs(angle) > crease)
      return result;
    const Side sides[] = {side, opposite(side)};
    double heights[2];
    for (int i : {0, 1})
      heights[i] = std::abs(angle) > radians(2) ? facet_height(sides[i]) : flattened(sides[i]).y;
    Section s[2];
    for (int i : {0, 1})
      s[i] = section(sides[i], 2.5 * std::min(heights[i], 3 * heights[1 - i]));
    result.length = std::min(s[0].length, s[1].length);
    for (int i : {0, 1}) {
      result.curvatures[i] = s[i].curvature;
      result.facets[i] = s[i].facet;
    }
    // A facet before a crease: half of its turn is at the edge, with half of that on the other
    // side.
    for (int i : {0, 1})
      if (s[i].is_open && !s[1 - i].is_open)
        result.curvatures[i] = (2 * angle - s[1 - i].curvature * s[1 - i].facet) / s[i].facet;
    return result;
  }

  const test::Soup& m_soup;
  std::map<std::pair<std::size_t, std::size_t>, Side> m_sides; // by their ends
  std::map<std::size_t, double> m_largest_curvature;           // on a face
};

} // namespace reference

#endif // CGAL_REGION_SEGMENTATION_TEST_REFERENCE_SMOOTHNESS_H
