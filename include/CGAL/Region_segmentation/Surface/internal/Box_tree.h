// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_BOX_TREE_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_BOX_TREE_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An axis-parallel box; empty by default. Coordinates are rounded, which keeps their order: boxes
/// of points that overlap still overlap. Coordinates that are not numbers are ignored.
struct Axis_box
{
  using Coordinates = std::array<float, 3>;

  Coordinates low = all(std::numeric_limits<float>::infinity());
  Coordinates high = all(-std::numeric_limits<float>::infinity());

  static constexpr Coordinates all(float x) { return {x, x, x}; }

  static Coordinates rounded(const Double_3& p) { return {float(p.x), float(p.y), float(p.z)}; }

  void add_point(const Double_3& p) { add(rounded(p), rounded(p)); }
  void add(const Axis_box& b) { add(b.low, b.high); }
  void add(const Coordinates& other_low, const Coordinates& other_high)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], other_low[i]);
      high[i] = (std::max)(high[i], other_high[i]);
    }
  }
  float extent(std::size_t axis) const { return high[axis] - low[axis]; }
  float center(std::size_t axis) const { return low[axis] + extent(axis) / 2; }
  std::size_t longest_axis() const
  {
    const std::size_t axis = extent(1) > extent(0) ? 1 : 0;
    return extent(2) > extent(axis) ? 2 : axis;
  }
};

/// A lower bound of the squared distance of what the boxes were made of, whose coordinates were
/// rounded: each by at most half of the distance to the next float.
inline double squared_gap(const Axis_box& a, const Axis_box& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto gap_of = [i](const Axis_box& lower, const Axis_box& upper) {
      const double high = lower.high[i], low = upper.low[i];
      return low - high - 6e-8 * (std::abs(low) + std::abs(high));
    };
    const double gap = (std::max)({gap_of(a, b), gap_of(b, a), 0.0});
    sum += gap * gap;
  }
  return sum;
}

inline double squared_distance_of_centers(const Axis_box& a, const Axis_box& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double difference = b.center(i) - a.center(i);
    sum += difference * difference;
  }
  return sum;
}

/// The smallest box around the points of an array.
template <typename Points>
Axis_box box_of(const Points& points)
{
  Axis_box result;
  for (const Double_3& p : points)
    result.add_point(p);
  return result;
}

/// The three corners of a triangle, which may be degenerate.
using Triangle = std::array<Double_3, 3>;

inline double in_unit_interval(double x)
{
  return (std::min)((std::max)(x, 0.0), 1.0);
}

/// The squared distance of a point from a line segment.
inline double squared_distance(const Double_3& p, const Double_3& a, const Double_3& b)
{
  const Double_3 along = b - a;
  const double squared_length = squared_norm(along);
  const double x = squared_length > 0 ? in_unit_interval(dot(p - a, along) / squared_length) : 0;
  return squared_norm(p - a - x * along);
}

/// Whether the projection of a point to the plane of a triangle with the given area vector is in
/// the triangle.
inline bool is_above(const Double_3& p, const Triangle& t, const Double_3& n)
{
  return dot(cross(t[1] - t[0], p - t[0]), n) >= 0 && dot(cross(t[2] - t[1], p - t[1]), n) >= 0 &&
         dot(cross(t[0] - t[2], p - t[2]), n) >= 0;
}

/// The squared distance of a point from a triangle.
inline double squared_distance(const Double_3& p, const Triangle& t)
{
  const Double_3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double nn = squared_norm(n);
  if (nn > 0 && is_above(p, t, n)) {
    const double h = dot(p - t[0], n);
    return h / nn * h;
  }
  return (std::min)({squared_distance(p, t[0], t[1]), squared_distance(p, t[1], t[2]),
                     squared_distance(p, t[2], t[0])});
}

/// The x for which a + x (b - a) is the point of the segment a, b nearest to the segment c, d.
inline double nearest_parameter(const Double_3& a, const Double_3& b, const Double_3& c,
                                const Double_3& d)
{
  const Double_3 u = b - a, v = d - c, w = a - c;
  const double uu = squared_norm(u), uv = dot(u, v), vv = squared_norm(v), uw = dot(u, w),
               vw = dot(v, w);
  const double determinant = uu * vv - uv * uv;
  const double x = determinant > 1e-14 * uu * vv
                     ? in_unit_interval((uv * vw - vv * uw) / determinant)
                     : 0;
  const double y = vv > 0 ? (uv * x + vw) / vv : 0;
  if (y >= 0 && y <= 1)
    return x;
  return uu > 0 ? in_unit_interval((uv * in_unit_interval(y) - uw) / uu) : 0;
}

/// Whether an edge of `s` goes through `t`.
inline bool is_pierced(const Triangle& s, const Triangle& t)
{
  const Double_3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double h[3] = {dot(s[0] - t[0], n), dot(s[1] - t[0], n), dot(s[2] - t[0], n)};
  for (std::size_t i = 0; i < 3; ++i)
    if (const std::size_t j = (i + 1) % 3;
        (h[i] > 0) != (h[j] > 0) && is_above(s[i] + (h[i] / (h[i] - h[j])) * (s[j] - s[i]), t, n))
      return true;
  return false;
}

/// The square of the gap between two triangles along the line through their centroids, which is at
/// most their distance.
inline double squared_separation(const Triangle& s, const Triangle& t)
{
  const Double_3 along = (t[0] - s[0]) + (t[1] - s[1]) + (t[2] - s[2]);
  const auto position = [&](const Double_3& p) { return dot(along, p - s[0]); };
  const double gap = (std::min)({position(t[0]), position(t[1]), position(t[2])}) -
                     (std::max)({0.0, position(s[1]), position(s[2])});
  return gap > 0 ? gap / squared_norm(along) * gap : 0;
}

/// The squared distance of two triangles.
inline double squared_distance(const Triangle& s, const Triangle& t)
{
  if (is_pierced(s, t) || is_pierced(t, s))
    return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    least = (std::min)({least, squared_distance(s[i], t), squared_distance(t[i], s)});
    for (std::size_t j = 0; j < 3; ++j) {
      const Double_3 &a = s[i], &b = s[(i + 1) % 3], &c = t[j], &d = t[(j + 1) % 3];
      const double x = nearest_parameter(a, b, c, d);
      least = (std::min)(least, squared_distance(a + x * (b - a), c, d));
    }
  }
  return least;
}

/// A balanced binary tree of boxes. A leaf has one item; a node is divided at the median of the
/// centers of its items, along the axis where these are farthest from each other. Building takes
/// O(n log n).
///
/// Nodes are numbered from the root, 0: a node, what is below its first child, what is below its
/// second child.
///
/// Bytes: 64 per item.
class Box_tree
{
public:
  using Index = std::uint32_t;

  Box_tree() = default;
  /// Builds the tree of the items 0 to `size - 1` with the boxes `box_of(item)`.
  template <typename BoxOf>
  Box_tree(std::size_t size, const BoxOf& box_of)
  {
    std::vector<Node> leaves;
    leaves.reserve(size);
    for (Index i = 0; i < size; ++i)
      leaves.push_back({box_of(i), 0, i});
    m_nodes.reserve(2 * size);
    if (size > 0)
      add(leaves.begin(), leaves.end());
  }

  const Axis_box& box(Index node) const { return m_nodes[node].box; }
  bool is_leaf(Index node) const { return m_nodes[node].past == node + 1; }
  /// \pre the node is a leaf
  Index item(Index node) const { return m_nodes[node].item; }
  /// \pre the node is no leaf
  std::pair<Index, Index> children(Index node) const { return {node + 1, m_nodes[node + 1].past}; }

  /// A value for each node: `of_leaf(leaf)`, `combine(value, value)` of others.
  template <typename OfLeaf, typename Combine>
  auto values(const OfLeaf& of_leaf, const Combine& combine) const
  {
    std::vector<decltype(of_leaf(Index()))> result(m_nodes.size());
    for (Index node = Index(m_nodes.size()); node-- > 0;)
      result[node] = is_leaf(node) ? of_leaf(node)
                                   : combine(result[node + 1], result[m_nodes[node + 1].past]);
    return result;
  }

  /// Calls `f(node)` for the nodes that are `wanted(node)` and below none that is.
  template <typename Wanted, typename F>
  void for_each_topmost(const Wanted& wanted, const F& f) const
  {
    for (Index node = 0; node < m_nodes.size();) {
      const bool is_wanted = wanted(node);
      if (is_wanted)
        f(node);
      node = is_wanted ? m_nodes[node].past : node + 1;
    }
  }

  /// Calls `f(leaf)` for the leaves in nodes with `key(node) < bound`, which `f` may lower; below
  /// the child of lower key first.
  template <typename Key, typename F>
  void search(const Key& key, const double& bound, const F& f, Index node = 0) const
  {
    if (is_leaf(node))
      return f(node);
    auto [first, second] = children(node);
    double first_key = key(first), second_key = key(second);
    if (second_key < first_key) {
      std::swap(first, second);
      std::swap(first_key, second_key);
    }
    if (first_key < bound)
      search(key, bound, f, first);
    if (second_key < bound)
      search(key, bound, f, second);
  }

  /// Calls `f(leaf, other)` for the pairs of leaves below `a` and `b`, but those below nodes with
  /// `is_left_out(node, other)`; below the nearer child first.
  template <typename IsLeftOut, typename F>
  void for_each_pair(Index a, Index b, const IsLeftOut& is_left_out, const F& f) const
  {
    if (is_left_out(a, b))
      return;
    if (is_leaf(a) && is_leaf(b))
      return f(a, b);
    const bool divides_first = is_leaf(b) || (!is_leaf(a) && longest(a) >= longest(b));
    auto [first, second] = children(divides_first ? a : b);
    const Axis_box& other = box(divides_first ? b : a);
    if (squared_distance_of_centers(box(second), other) <
        squared_distance_of_centers(box(first), other))
      std::swap(first, second);
    for (const Index child : {first, second})
      for_each_pair(divides_first ? child : a, divides_first ? b : child, is_left_out, f);
  }

private:
  struct Node
  {
    Axis_box box;
    Index past; ///< the first node that is not below this one
    Index item; ///< the item of a leaf
  };
  using Iterator = std::vector<Node>::iterator;

  double longest(Index node) const { return box(node).extent(box(node).longest_axis()); }

  /// Adds the node above some leaves, and all nodes below it.
  void add(Iterator begin, Iterator end)
  {
    const std::size_t node = m_nodes.size();
    m_nodes.push_back({begin->box, Index(node + 1), begin->item});
    if (end - begin == 1)
      return;
    Axis_box centers;
    for (Iterator i = begin; i != end; ++i)
      centers.add_point({i->box.center(0), i->box.center(1), i->box.center(2)});
    const std::size_t axis = centers.longest_axis();
    const Iterator median = begin + (end - begin) / 2;
    std::nth_element(begin, median, end, [&](const Node& a, const Node& b) {
      return std::make_pair(a.box.center(axis), a.item) <
             std::make_pair(b.box.center(axis), b.item);
    });
    add(begin, median);
    const std::size_t second = m_nodes.size();
    add(median, end);
    m_nodes[node].box = m_nodes[node + 1].box;
    m_nodes[node].box.add(m_nodes[second].box);
    m_nodes[node].past = Index(m_nodes.size());
  }

  std::vector<Node> m_nodes;
};

/// The faces of a surface, divided into triangles from their first corner, and a tree of their
/// boxes. These are relative to an origin on the surface, so that their coordinates, which are
/// rounded, have the digits that tell the faces apart, also far from the origin of the mesh.
class Face_tree
{
public:
  using Index = Surface::Index;

  explicit Face_tree(const Surface& surface)
    : m_surface(surface)
    , m_origin(surface.number_of_faces() > 0 ? surface.point(surface.corner(0, 0)) : Double_3{})
    , m_triangles(fan_triangles(surface))
    , m_tree(m_triangles.size(), [&](Index item) {
      auto [a, b, c] = triangle(m_triangles[item]);
      return box_of(Triangle{a - m_origin, b - m_origin, c - m_origin});
    })
  {}

  const Box_tree& boxes() const { return m_tree; }
  /// The point of the surface to which the boxes are relative.
  const Double_3& origin() const { return m_origin; }

  /// The face that the triangle of a leaf is a part of.
  Index face(Index leaf) const { return m_triangles[m_tree.item(leaf)].face; }
  /// (It is not turned with its face.)
  Triangle triangle(Index leaf) const { return triangle(m_triangles[m_tree.item(leaf)]); }

private:
  struct Fan_triangle
  {
    Index face, second, third; // vertices
  };

  static std::vector<Fan_triangle> fan_triangles(const Surface& surface)
  {
    std::vector<Fan_triangle> result;
    result.reserve(surface.number_of_faces());
    for (Index f = 0; f < surface.number_of_faces(); ++f)
      for (std::size_t i = 1, last = surface.number_of_corners(f) - 1; i == 1 || i < last; ++i)
        result.push_back(
          {f, surface.corner(f, (std::min)(i, last)), surface.corner(f, (std::min)(i + 1, last))});
    return result;
  }

  Triangle triangle(const Fan_triangle& t) const
  {
    return {m_surface.point(m_surface.corner(t.face, 0)), m_surface.point(t.second),
            m_surface.point(t.third)};
  }

  const Surface& m_surface;
  Double_3 m_origin;
  std::vector<Fan_triangle> m_triangles;
  Box_tree m_tree;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_BOX_TREE_H
