// SPDX-License-Identifier: GPL-3.0-or-later

#include "demo/articulated_figure.h"

#include "soup/vector_algebra.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace segment_mesh {

namespace {

/// An ellipsoid of revolution.
struct Part
{
  Point from, to; ///< the ends of its axis
  double radius;
};

const Part parts[] = {
  {{0, -0.1, 0}, {0, 1.25, 0}, 0.38},           {{0, 1.1, 0}, {0, 1.75, 0}, 0.27},
  {{0.28, 0.98, 0}, {0.95, 0.75, 0}, 0.16},     {{-0.28, 0.98, 0}, {-0.95, 0.75, 0}, 0.16},
  {{0.85, 0.8, 0}, {1.5, 0.95, 0.2}, 0.13},     {{-0.85, 0.8, 0}, {-1.5, 0.95, 0.2}, 0.13},
  {{0.15, 0.2, 0}, {0.3, -0.8, 0}, 0.2},        {{-0.15, 0.2, 0}, {-0.3, -0.8, 0}, 0.2},
  {{0.29, -0.7, 0}, {0.38, -1.6, -0.05}, 0.16}, {{-0.29, -0.7, 0}, {-0.38, -1.6, -0.05}, 0.16}};

/// About the distance from an ellipsoid, negative inside: k (k - 1) / |grad k| for the factor k by
/// which the ellipsoid grows to contain the point.
double distance(const Part& part, const Point& p)
{
  const Point center = times(0.5, plus(part.from, part.to)), half_axis = minus(part.to, center),
              v = minus(p, center);
  const double half_length = std::sqrt(inner_product(half_axis, half_axis));
  const double along = inner_product(v, half_axis) / half_length,
               across = std::sqrt((std::max)(0.0, inner_product(v, v) - along * along));
  const double k = std::hypot(along / half_length, across / part.radius),
               gradient = std::hypot(along / (half_length * half_length),
                                     across / (part.radius * part.radius));
  return gradient > 0 ? k * (k - 1) / gradient : -part.radius;
}

/// The least distance from a part, less near two of them, which rounds the creases between them.
double distance(const Point& p)
{
  constexpr double softness = 0.06;
  double result = (std::numeric_limits<double>::max)();
  for (const Part& part : parts) {
    const double d = distance(part, p), overlap = (std::max)(0.0, softness - std::abs(result - d));
    result = (std::min)(result, d) - overlap * overlap / (4 * softness);
  }
  return result;
}

std::int64_t part_at(const Point& p)
{
  return std::min_element(
           std::begin(parts), std::end(parts),
           [&](const Part& a, const Part& b) { return distance(a, p) < distance(b, p); }) -
         parts;
}

using Node = std::array<int, 3>; ///< of a grid

/// The surface as a dual of a grid: a point in each cube that it crosses, a quadrilateral across
/// each edge that it crosses, which is divided into triangles. No cube is crossed twice: the grid
/// is fine enough.
class Surface_net
{
public:
  Polygon_soup run()
  {
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z)
          for (std::size_t axis = 0; axis < 3; ++axis)
            cross_edge({x, y, z}, axis);
    return std::move(m_soup);
  }

private:
  static constexpr double spacing = 0.06;
  static constexpr Node low = {-27, -29, -8}, high = {27, 31, 8}; ///< the figure is inside of these

  static Point position(const Node& node)
  {
    return {spacing * node[0], spacing * node[1], spacing * node[2]};
  }

  static Node moved(Node node, std::size_t axis, int by)
  {
    node[axis] += by;
    return node;
  }

  void cross_edge(const Node& node, std::size_t axis)
  {
    const double here = distance(position(node)), there = distance(position(moved(node, axis, 1)));
    if ((here < 0) == (there < 0))
      return;
    // The four cubes around the edge, counterclockwise as seen from where it leads.
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::size_t q[4] = {point_in(node), point_in(moved(node, u, -1)),
                        point_in(moved(moved(node, u, -1), v, -1)), point_in(moved(node, v, -1))};
    if (here >= 0)
      std::reverse(std::begin(q), std::end(q));
    const auto squared_length = [this](std::size_t i, std::size_t j) {
      const Point d = minus(m_soup.points[i], m_soup.points[j]);
      return inner_product(d, d);
    };
    const std::size_t s = squared_length(q[0], q[2]) <= squared_length(q[1], q[3]) ? 0
                                                                                   : 1; // the
                                                                                        // shorter
                                                                                        // diagonal
    m_soup.polygons.push_back({q[s], q[s + 1], q[s + 2]});
    m_soup.polygons.push_back({q[s], q[s + 2], q[(s + 3) % 4]});
  }

  /// The mean of where the surface crosses the edges of a cube.
  std::size_t point_in(const Node& cube)
  {
    const auto [entry, is_new] = m_point_in.try_emplace(cube, m_soup.points.size());
    if (!is_new)
      return entry->second;
    Point sum = {0, 0, 0};
    double number = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int i : {0, 1})
        for (const int j : {0, 1}) {
          const Node from = moved(moved(cube, (axis + 1) % 3, i), (axis + 2) % 3, j);
          const Point a = position(from), b = position(moved(from, axis, 1));
          const double at_a = distance(a), at_b = distance(b);
          if ((at_a < 0) == (at_b < 0))
            continue;
          sum = plus(sum, plus(a, times(at_a / (at_a - at_b), minus(b, a))));
          ++number;
        }
    m_soup.points.push_back(times(1 / number, sum));
    return entry->second;
  }

  Polygon_soup m_soup;
  std::map<Node, std::size_t> m_point_in;
};

} // namespace

Articulated_figure make_articulated_figure()
{
  Articulated_figure figure;
  figure.soup = Surface_net().run();
  for (const Polygon_soup::Polygon& polygon : figure.soup.polygons)
    figure.part_of_face.push_back(part_at(centroid(figure.soup, polygon)));
  figure.number_of_parts = std::size(parts);
  return figure;
}

} // namespace segment_mesh
