// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAY_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAY_TREE_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the face that a ray hits first: a tree of bounding boxes over the triangles of a mesh
/// (polygons as fans). In float, relative to the first point of the mesh and in units of its extent:
/// what is wanted are distances to a few digits. (CGAL's AABB tree is exact, and GPL.)
///
/// About 60 bytes a triangle; O(T log T) to build, O(log T) a ray in practice.
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
    add_triangles(mesh);
    if (!m_triangles.empty()) {
      m_nodes.reserve(m_triangles.size());
      m_nodes.emplace_back();
      split(0, 0, m_triangles.size(), 0);
    }
  }

  /// The first face other than `skipped` that is hit in front of `source`; `direction` has length 1.
  Hit first_hit(const Vector_3& source, const Vector_3& direction, Index skipped) const
  {
    const Vector_3 relative = (1 / m_unit) * (source - m_origin);
    Search search{to_float(relative), to_float(direction), {}, skipped, no_face,
                  (std::numeric_limits<float>::max)()};
    for (int i = 0; i < 3; ++i)
      search.inverse[i] = 1 / search.direction[i]; // infinite for 0, as the slab test wants it
    if (!m_nodes.empty())
      descend(search);
    return {search.face, search.face == no_face ? 0.0 : double(search.distance) * m_unit};
  }

private:
  static constexpr int maximum_depth_of_cheap_splits = 48;

  struct Triangle
  {
    Float_3 corner, edge_1, edge_2;
    Index face;
  };
  struct Node
  {
    Float_3 low, high;
    Index first;                // the first triangle of a leaf, or the first of two children
    std::uint32_t size;         // of a leaf; 0 for an inner node
  };
  struct Search
  {
    Float_3 source, direction, inverse;
    Index skipped, face;
    float distance;
  };

  static Float_3 to_float(const Vector_3& v) { return {float(v.x), float(v.y), float(v.z)}; }
  static Float_3 minus(const Float_3& a, const Float_3& b)
  {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static float dot(const Float_3& a, const Float_3& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Float_3 cross(const Float_3& a, const Float_3& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  void add_triangles(const Flat_mesh& mesh)
  {
    const auto relative = [&](std::size_t f, std::size_t i) {
      return to_float((1 / m_unit) * (mesh.point(mesh.corner(f, i)) - m_origin));
    };
    m_triangles.reserve(mesh.number_of_faces());
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Float_3 a = relative(f, 0);
      for (std::size_t i = 2; i < mesh.number_of_corners(f); ++i)
        m_triangles.push_back(
          {a, minus(relative(f, i - 1), a), minus(relative(f, i), a), Index(f)});
    }
  }

  /// Three times the centroid of a triangle, along one axis.
  static float position(const Triangle& t, int axis)
  {
    return 3 * t.corner[axis] + t.edge_1[axis] + t.edge_2[axis];
  }

  struct Box
  {
    Float_3 low, high;

    Box()
    {
      low.fill((std::numeric_limits<float>::max)());
      high.fill(std::numeric_limits<float>::lowest());
    }

    void add(const Float_3& point)
    {
      for (int k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], point[k]);
        high[k] = (std::max)(high[k], point[k]);
      }
    }

    void add(const Box& other)
    {
      for (int k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], other.low[k]);
        high[k] = (std::max)(high[k], other.high[k]);
      }
    }

    float half_area() const
    {
      const Float_3 side = minus(high, low);
      return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
    }
  };

  static Box box_of(const Triangle& t)
  {
    Box box;
    box.add(t.corner);
    box.add({t.corner[0] + t.edge_1[0], t.corner[1] + t.edge_1[1], t.corner[2] + t.edge_1[2]});
    box.add({t.corner[0] + t.edge_2[0], t.corner[1] + t.edge_2[1], t.corner[2] + t.edge_2[2]});
    return box;
  }

  /// Splits a node until its leaves hold at most four triangles.
  void split(std::size_t n, std::size_t first, std::size_t last, int depth)
  {
    Box box, positions;
    for (std::size_t i = first; i < last; ++i) {
      box.add(box_of(m_triangles[i]));
      positions.add(Float_3{position(m_triangles[i], 0), position(m_triangles[i], 1), position(m_triangles[i], 2)});
    }
    m_nodes[n] = {box.low, box.high, Index(first), std::uint32_t(last - first)};
    if (last - first <= 4)
      return;
    const Float_3 side = minus(positions.high, positions.low);
    const int axis = int(std::max_element(side.begin(), side.end()) - side.begin());
    std::size_t middle = first;
    if (depth < maximum_depth_of_cheap_splits && side[axis] > 0)
      middle = split_cheaply(first, last, axis, positions.low[axis], side[axis]);
    if (middle == first || middle == last)
      middle = split_at_median(first, last, axis);
    const std::size_t child = m_nodes.size();
    m_nodes.resize(child + 2);
    m_nodes[n].first = Index(child);
    m_nodes[n].size = 0;
    split(child, first, middle, depth + 1);
    split(child + 1, middle, last, depth + 1);
  }

  /// Where a ray is expected to meet the fewest triangles: of the bounds between slices of equal width, the
  /// one with the lowest sum over both sides of surface area times number of triangles (Wald 2007).
  std::size_t split_cheaply(std::size_t first, std::size_t last, int axis, float low, float width)
  {
    constexpr int slices = 16;
    struct Slice
    {
      Box box;
      std::size_t size = 0;
    };
    const auto slice_of = [=](const Triangle& t) {
      return (std::min)(slices - 1, int(float(slices) * ((position(t, axis) - low) / width)));
    };
    std::array<Slice, slices> slice;
    for (std::size_t i = first; i < last; ++i) {
      Slice& s = slice[slice_of(m_triangles[i])];
      s.box.add(box_of(m_triangles[i]));
      ++s.size;
    }
    std::array<float, slices> cost; // of what is behind each bound
    Slice behind, before;
    for (int i = slices - 1; i > 0; --i) {
      behind.box.add(slice[i].box);
      behind.size += slice[i].size;
      cost[i] = behind.size > 0 ? behind.box.half_area() * float(behind.size) : 0;
    }
    int best = 1;
    float best_cost = (std::numeric_limits<float>::max)();
    for (int i = 1; i < slices; ++i) {
      before.box.add(slice[i - 1].box);
      before.size += slice[i - 1].size;
      const float sum = cost[i] + (before.size > 0 ? before.box.half_area() * float(before.size) : 0);
      if (sum < best_cost && before.size > 0 && before.size < last - first) {
        best_cost = sum;
        best = i;
      }
    }
    return std::size_t(std::partition(m_triangles.begin() + first, m_triangles.begin() + last,
                                      [&](const Triangle& t) { return slice_of(t) < best; }) -
                       m_triangles.begin());
  }

  std::size_t split_at_median(std::size_t first, std::size_t last, int axis)
  {
    const std::size_t middle = first + (last - first) / 2;
    std::nth_element(m_triangles.begin() + first, m_triangles.begin() + middle,
                     m_triangles.begin() + last, [axis](const Triangle& a, const Triangle& b) {
                       const float p = position(a, axis), q = position(b, axis);
                       return p != q ? p < q : a.face < b.face;
                     });
    return middle;
  }

  /// Where the ray enters a box; beyond everything if it misses it or the box is behind the best hit.
  static float entry(const Node& node, const Search& s)
  {
    float in = 0, out = s.distance;
    for (int k = 0; k < 3; ++k) {
      const float a = (node.low[k] - s.source[k]) * s.inverse[k];
      const float b = (node.high[k] - s.source[k]) * s.inverse[k];
      in = (std::max)(in, (std::min)(a, b)); // comparisons with NaN (0 * infinity) leave it as it is
      out = (std::min)(out, (std::max)(a, b));
    }
    return in <= out ? in : (std::numeric_limits<float>::infinity)();
  }

  void descend(Search& s) const
  {
    struct Waiting
    {
      Index node;
      float entry;
    };
    std::array<Waiting, maximum_depth_of_cheap_splits + 34> stack; // below them halves, of at most 2^32
    std::size_t size = 0;
    stack[size++] = {0, entry(m_nodes[0], s)};
    while (size > 0) {
      const Waiting w = stack[--size];
      if (!(w.entry < s.distance))
        continue;
      const Node& node = m_nodes[w.node];
      for (Index i = node.first; i < node.first + node.size; ++i)
        intersect(m_triangles[i], s);
      if (node.size > 0)
        continue;
      const Waiting a{node.first, entry(m_nodes[node.first], s)};
      const Waiting b{node.first + 1, entry(m_nodes[node.first + 1], s)};
      stack[size++] = a.entry <= b.entry ? b : a; // the nearer one goes first
      stack[size++] = a.entry <= b.entry ? a : b;
    }
  }

  /// Moeller and Trumbore 1997, with a rim of one millionth against gaps.
  static void intersect(const Triangle& t, Search& s)
  {
    constexpr float rim = 1e-6f;
    const Float_3 p = cross(s.direction, t.edge_2);
    const float determinant = dot(t.edge_1, p);
    if (t.face == s.skipped || determinant == 0)
      return;
    const float inverse = 1 / determinant;
    const Float_3 to_source = minus(s.source, t.corner);
    const float u = dot(to_source, p) * inverse;
    const Float_3 q = cross(to_source, t.edge_1);
    const float v = dot(s.direction, q) * inverse;
    if (u < -rim || v < -rim || u + v > 1 + rim)
      return;
    const float distance = dot(t.edge_2, q) * inverse;
    if (distance > 0 && (distance < s.distance || (distance == s.distance && t.face < s.face))) {
      s.distance = distance;
      s.face = t.face;
    }
  }

  std::vector<Triangle> m_triangles;
  std::vector<Node> m_nodes;
  Vector_3 m_origin;
  double m_unit = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAY_TREE_H
