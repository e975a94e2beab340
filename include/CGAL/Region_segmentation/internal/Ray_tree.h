// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAY_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAY_TREE_H

#include <CGAL/Region_segmentation/internal/Box_partition.h>
#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/Float_4.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the face that a ray hits first: a tree of bounding boxes over the triangles of a mesh
/// (polygons as fans). In float, relative to the first point of the mesh and in units of its extent:
/// what is wanted are distances to a few digits. (CGAL's AABB tree is exact, and GPL.)
///
/// A node has four children and a leaf four triangles, coordinate by coordinate, so that compilers make one
/// instruction of what is done to all four; what the processor cannot foresee is met once for four.
///
/// About 70 bytes a triangle, 36 more while it is built; O(T log T) to build, O(log T) a ray in practice.
class Ray_tree
{
  using Index = Flat_mesh::Index;
  using Float_3 = std::array<float, 3>;

public:
  struct Hit
  {
    Index face;
    double distance; // in units of the mesh
  };
  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  /// \pre the mesh was read with its points
  explicit Ray_tree(const Flat_mesh& mesh)
  {
    if (mesh.number_of_points() > 0)
      m_origin = mesh.point(0);
    for (std::size_t v = 0; v < mesh.number_of_points(); ++v)
      m_unit = (std::max)(m_unit, norm(mesh.point(v) - m_origin));
    if (m_unit == 0)
      m_unit = 1;
    std::vector<Triangle> triangles = make_triangles(mesh);
    if (triangles.empty())
      return;
    Box_partition boxes;
    boxes.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
      boxes.add(box_of(triangles[t]), Index(t));
    m_leaves.reserve(triangles.size() / 3);
    m_nodes.reserve(triangles.size() / 7);
    add_node(boxes, triangles, boxes.whole(), 0);
  }

  /// The first face other than `skipped` that is hit in front of `source`; `direction` has length 1.
  Hit first_hit(const Vector_3& source, const Vector_3& direction, Index skipped) const
  {
    Search search;
    search.source = relative(source);
    search.direction = to_float(direction);
    for (int k = 0; k < 3; ++k) {
      search.inverse[k] = 1 / search.direction[k]; // infinite for 0, as the slab test wants it
      search.entered[k] = search.inverse[k] < 0 ? 1 : 0;
    }
    search.skipped = skipped;
    if (!m_nodes.empty())
      descend(search);
    return {search.face, search.face == no_face ? 0.0 : double(search.distance) * m_unit};
  }

private:
  static constexpr int width = 4; // children of a node, triangles of a leaf
  static_assert(width == Box_partition::leaf_size, "parts of this size become leaves");
  static constexpr int maximum_depth_of_cheap_splits = 48;

  template <typename T>
  using Lanes = std::array<T, width>;
  using Float_4_3 = std::array<Float_4, 3>;

  struct Triangle
  {
    Float_3 corner, edge_1, edge_2;
    Index face;
  };
  /// Triangles, with edges of length 0 where there are fewer.
  struct Leaf
  {
    Float_4_3 corner, edge_1, edge_2;
    Lanes<Index> face;
  };
  /// Twice the index of a node, or twice that of a leaf and one.
  using Child = Index;
  struct Node
  {
    std::array<Float_4_3, 2> bounds; // lower and upper ones; upside down where there are fewer children
    Lanes<Child> child;
  };
  struct Search
  {
    Float_3 source, direction, inverse;
    std::array<int, 3> entered; // by which of the two bounds the ray enters a box, by axis
    Index skipped, face = no_face;
    float distance = (std::numeric_limits<float>::max)();
  };

  static Float_3 to_float(const Vector_3& v) { return {float(v.x), float(v.y), float(v.z)}; }
  static Float_4_3 all_lanes(const Float_3& v)
  {
    return {internal::all_lanes(v[0]), internal::all_lanes(v[1]), internal::all_lanes(v[2])};
  }
  static Float_4 all_lanes(float v) { return internal::all_lanes(v); }
  template <typename T>
  static std::array<T, 3> minus(const std::array<T, 3>& a, const std::array<T, 3>& b)
  {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  template <typename T>
  static T dot(const std::array<T, 3>& a, const std::array<T, 3>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  template <typename T>
  static std::array<T, 3> cross(const std::array<T, 3>& a, const std::array<T, 3>& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Float_3 relative(const Vector_3& point) const { return to_float((1 / m_unit) * (point - m_origin)); }

  std::vector<Triangle> make_triangles(const Flat_mesh& mesh) const
  {
    const auto corner = [&](std::size_t f, std::size_t i) { return relative(mesh.point(mesh.corner(f, i))); };
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.number_of_faces());
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Float_3 a = corner(f, 0);
      for (std::size_t i = 2; i < mesh.number_of_corners(f); ++i)
        triangles.push_back({a, minus(corner(f, i - 1), a), minus(corner(f, i), a), Index(f)});
    }
    return triangles;
  }

  /// Somewhat too large, so that rounding hides no triangle: which one is hit does not depend on the tree.
  static Box box_of(const Triangle& t)
  {
    const auto sum = [](const Float_3& a, const Float_3& b) { return Float_4{a[0] + b[0], a[1] + b[1], a[2] + b[2], 0}; };
    Box box;
    box.add(sum(t.corner, {0, 0, 0}));
    box.add(sum(t.corner, t.edge_1));
    box.add(sum(t.corner, t.edge_2));
    box.low = box.low - all_lanes(5e-7f);
    box.high = box.high + all_lanes(5e-7f);
    return box;
  }

  /// Adds a node for a part, and what is below it.
  Child add_node(Box_partition& boxes, const std::vector<Triangle>& triangles, const Box_partition::Part& part,
                 int depth)
  {
    std::array<Box_partition::Part, width> parts{part, {}, {}, {}};
    int size = 1;
    while (size < width) {
      int largest = -1;
      for (int i = 0; i < size; ++i)
        if (parts[i].size() > width &&
            (largest < 0 || parts[i].box.half_area() > parts[largest].box.half_area()))
          largest = i;
      if (largest < 0)
        break;
      std::tie(parts[largest], parts[size]) =
        depth < maximum_depth_of_cheap_splits ? boxes.split(parts[largest]) : boxes.split_at_median(parts[largest]);
      ++size;
    }
    const std::size_t n = m_nodes.size();
    m_nodes.emplace_back();
    for (int i = 0; i < width; ++i)
      for (int k = 0; k < 3; ++k) {
        m_nodes[n].bounds[0][k][i] = parts[i].box.low[k];
        m_nodes[n].bounds[1][k][i] = parts[i].box.high[k];
      }
    for (int i = 0; i < size; ++i) {
      const Child child = parts[i].size() > width ? add_node(boxes, triangles, parts[i], depth + 1)
                                                  : add_leaf(boxes, triangles, parts[i]);
      m_nodes[n].child[i] = child;
    }
    return Child(2 * n);
  }

  Child add_leaf(const Box_partition& boxes, const std::vector<Triangle>& triangles,
                 const Box_partition::Part& part)
  {
    Leaf leaf{};
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Triangle& t = triangles[boxes.number(part.first + i)];
      for (int k = 0; k < 3; ++k) {
        leaf.corner[k][i] = t.corner[k];
        leaf.edge_1[k][i] = t.edge_1[k];
        leaf.edge_2[k][i] = t.edge_2[k];
      }
      leaf.face[i] = t.face;
    }
    m_leaves.push_back(leaf);
    return Child(2 * (m_leaves.size() - 1) + 1);
  }

  // Where a ray enters a box, as the bits of a float that is not negative, which are ordered as it; and below
  // them the child.
  using Waiting = std::uint64_t;
  static constexpr Waiting never = Waiting(0x7f800000) << 32;

  static Waiting make_waiting(float entry, Child child)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &entry, sizeof bits);
    return (Waiting(bits) << 32) | child;
  }
  static float entry(Waiting w)
  {
    const std::uint32_t bits = std::uint32_t(w >> 32);
    float entry;
    std::memcpy(&entry, &bits, sizeof entry);
    return entry;
  }

  void descend(Search& s) const
  {
    // A node leaves at most three more waiting than it found; below the cheap splits are halves, of at most 2^32.
    std::array<Waiting, 3 * (maximum_depth_of_cheap_splits + 32) + 2> stack;
    std::size_t size = 0;
    stack[size++] = make_waiting(0, 0);
    while (size > 0) {
      const Waiting w = stack[--size];
      if (!(entry(w) <= s.distance))
        continue;
      const Child child = Child(w);
      if (child % 2 == 1) {
        intersect(m_leaves[child / 2], s);
        continue;
      }
      for (Waiting next : children(m_nodes[child / 2], s)) {
        stack[size] = next;
        size += next < never ? 1 : 0;
      }
    }
  }

  /// The children that the ray enters before its best hit, the nearest last; `never` for the others.
  static Lanes<Waiting> children(const Node& node, const Search& s)
  {
    Float_4 in = all_lanes(0), out = all_lanes(s.distance);
    for (int k = 0; k < 3; ++k) {
      const Float_4 source = all_lanes(s.source[k]), inverse = all_lanes(s.inverse[k]);
      const Float_4 near = (node.bounds[s.entered[k]][k] - source) * inverse;
      const Float_4 far = (node.bounds[1 - s.entered[k]][k] - source) * inverse;
      in = larger(near, in); // a bound that is not a number (0 * infinity) is none
      out = smaller(far, out);
    }
    const Float_4 entries = select(in <= out, in, all_lanes(std::numeric_limits<float>::infinity()));
    Lanes<Waiting> w;
    for (int i = 0; i < width; ++i)
      w[i] = make_waiting(entries[i], node.child[i]);
    const auto order = [&](int i, int j) {
      const Waiting a = w[i], b = w[j];
      w[i] = a > b ? a : b;
      w[j] = a > b ? b : a;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    return w;
  }

  /// Moeller and Trumbore 1997, with a rim of one millionth against gaps.
  static void intersect(const Leaf& leaf, Search& s)
  {
    const Float_4 rim = all_lanes(-1e-6f), zero = all_lanes(0), one = all_lanes(1);
    const Float_4_3 direction = all_lanes(s.direction);
    const Float_4_3 p = cross(direction, leaf.edge_2);
    const Float_4 determinant = dot(leaf.edge_1, p);
    const Float_4 inverse = one / determinant;
    const Float_4_3 to_source = minus(all_lanes(s.source), leaf.corner);
    const Float_4 u = dot(to_source, p) * inverse;
    const Float_4_3 q = cross(to_source, leaf.edge_1);
    const Float_4 v = dot(direction, q) * inverse;
    const Float_4 distance = dot(leaf.edge_2, q) * inverse;
    const Mask_4 is_outside = (u < rim) | (v < rim) | (u + v > one - rim);
    const Mask_4 is_hit = (determinant != zero) & (distance > zero);
    const Float_4 none = all_lanes(std::numeric_limits<float>::infinity());
    const Float_4 distances = select(is_outside, none, select(is_hit, distance, none));
    for (int i = 0; i < width; ++i)
      if (distances[i] <= s.distance && leaf.face[i] != s.skipped &&
          (distances[i] < s.distance || leaf.face[i] < s.face)) {
        s.distance = distances[i];
        s.face = leaf.face[i];
      }
  }

  std::vector<Node> m_nodes;
  std::vector<Leaf> m_leaves;
  Vector_3 m_origin;
  double m_unit = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAY_TREE_H
