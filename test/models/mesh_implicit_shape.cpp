// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/Implicit_shape.h"
#include "models/Surface_relaxation.h"
#include "soup/vector_algebra.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace segment_mesh {

namespace {

/// A corner of a grid of cubes, or the cube whose lowest corner it is.
using Node = std::array<int, 3>;
using Edge = std::pair<Node, Node>; // the lower corner first

Node moved(Node node, std::size_t axis, int by)
{
  node[axis] += by;
  return node;
}

Edge edge_between(const Node& a, const Node& b)
{
  return {(std::min)(a, b), (std::max)(a, b)};
}

/// Dual marching cubes: a point for each piece of the surface in a cube, a quad for each edge that
/// the surface crosses. The result is closed and oriented. Of the cubes that the surface crosses,
/// those are visited that are connected through faces with the first one that is found.
///
/// Source: Nielson 2004.
class Dual_marching_cubes
{
public:
  Dual_marching_cubes(const Implicit_shape& shape, const Point& inside, double spacing)
    : m_shape(shape)
    , m_origin(inside)
    , m_spacing(spacing)
  {}

  Polygon_soup run()
  {
    Node first = {0, 0, 0};
    while (is_inside(moved(first, 0, 1)))
      first = moved(first, 0, 1);
    visit(first);
    for (std::size_t i = 0; i < m_cubes.size(); ++i) // grows meanwhile
      add_points_in(Node(m_cubes[i]));
    for (const Node& cube : m_cubes)
      for (std::size_t axis = 0; axis < 3; ++axis)
        add_quad_across(cube, axis);
    return std::move(m_soup);
  }

private:
  Point position(const Node& node) const
  {
    return plus(m_origin, times(m_spacing, {double(node[0]), double(node[1]), double(node[2])}));
  }

  double value(const Node& node)
  {
    const auto entry = m_value_at.emplace(node, 0);
    if (entry.second)
      entry.first->second = m_shape(position(node));
    return entry.first->second;
  }

  bool is_inside(const Node& node) { return value(node) < 0; }

  void visit(const Node& cube)
  {
    if (m_is_visited.insert(cube).second)
      m_cubes.push_back(cube);
  }

  /// The surface leaves a cube through its faces. Along their boundaries, counterclockwise from
  /// outside, each edge into the shape is linked to the next one out of it; so links form a cycle
  /// around each piece. At a face with four such edges both cubes connect the same ones.
  void add_points_in(const Node& cube)
  {
    std::map<Edge, Edge> next;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        const Node low = moved(cube, axis, side);
        const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3,
                          v = (axis + (side == 1 ? 2 : 1)) % 3;
        const std::array<Node, 4> ring = {low, moved(low, u, 1), moved(moved(low, u, 1), v, 1),
                                          moved(low, v, 1)};
        if (link_around(ring, next))
          visit(moved(cube, axis, 2 * side - 1));
      }
    while (!next.empty())
      add_point(cube, next);
  }

  /// Returns whether the surface crosses the face.
  bool link_around(const std::array<Node, 4>& ring, std::map<Edge, Edge>& next)
  {
    bool is_crossed = false;
    for (std::size_t i = 0; i < 4; ++i)
      if (!is_inside(ring[i]) && is_inside(ring[(i + 1) % 4])) {
        std::size_t j = i + 1;
        while (is_inside(ring[(j + 1) % 4]))
          ++j;
        next[edge_between(ring[i], ring[(i + 1) % 4])] = edge_between(ring[j % 4],
                                                                      ring[(j + 1) % 4]);
        is_crossed = true;
      }
    return is_crossed;
  }

  /// At the mean of the crossings of a cycle, which is removed.
  void add_point(const Node& cube, std::map<Edge, Edge>& next)
  {
    Point sum = {0, 0, 0};
    double number = 0;
    for (auto link = next.begin(); link != next.end(); ++number) {
      sum = plus(sum, crossing(link->first));
      m_point_of[{cube, link->first}] = m_soup.points.size();
      const Edge following = link->second;
      next.erase(link);
      link = next.find(following);
    }
    m_soup.points.push_back(times(1 / number, sum));
  }

  Point crossing(const Edge& edge)
  {
    const double a = value(edge.first), b = value(edge.second), t = a / (a - b);
    return plus(times(1 - t, position(edge.first)), times(t, position(edge.second)));
  }

  /// As two triangles. Each edge is the lowest one along its axis of one cube.
  void add_quad_across(const Node& low, std::size_t axis)
  {
    const Node high = moved(low, axis, 1);
    if (is_inside(low) == is_inside(high))
      return;
    // Counterclockwise from the high side.
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Node cubes[] = {moved(moved(low, u, -1), v, -1), moved(low, v, -1), low,
                          moved(low, u, -1)};
    std::vector<std::size_t> quad;
    for (const Node& cube : cubes)
      quad.push_back(m_point_of.at({cube, {low, high}}));
    if (!is_inside(low))
      std::reverse(quad.begin(), quad.end());
    m_soup.polygons.push_back({quad[0], quad[1], quad[2]});
    m_soup.polygons.push_back({quad[0], quad[2], quad[3]});
  }

  const Implicit_shape& m_shape;
  Point m_origin;
  double m_spacing;
  std::map<Node, double> m_value_at;
  std::set<Node> m_is_visited;
  std::vector<Node> m_cubes;                               // in the order of the visits
  std::map<std::pair<Node, Edge>, std::size_t> m_point_of; // of the piece of the surface that
                                                           // crosses the edge
  Polygon_soup m_soup;
};

} // namespace

Polygon_soup mesh_implicit_shape(const Implicit_shape& shape, const Point& inside,
                                 double edge_length)
{
  const int number_of_steps = 10;
  const double side_of_cubes = 1.2 * edge_length; // a cube holds about one point
  Polygon_soup soup = Dual_marching_cubes(shape, inside, side_of_cubes).run();
  Surface_relaxation relaxation(shape, soup, edge_length);
  for (int i = 0; i < number_of_steps; ++i) {
    relaxation.move_points();
    relaxation.flip_edges();
  }
  return soup;
}

} // namespace segment_mesh
