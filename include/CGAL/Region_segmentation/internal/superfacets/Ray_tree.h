// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_RAY_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_RAY_TREE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>
#include <CGAL/Region_segmentation/internal/surface/Box_tree.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

using Float_3 = std::array<float, 3>;

/// A ray and the first face hit so far.
struct Ray
{
  using Index = Surface::Index;
  static constexpr Index no_face = Surface::none;

  Float_3 source, direction, inverse;     // of the direction, infinite for 0
  std::array<std::size_t, 3> entry, exit; // by which of the six bounds it enters and leaves a box
  Index skipped;                          // is not hit
  Index face = no_face;
  float distance = (std::numeric_limits<float>::max)();

  Ray(const Float_3& source_, const Float_3& direction_, Index skipped_)
    : source(source_)
    , direction(direction_)
    , skipped(skipped_)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      inverse[k] = 1 / direction[k];
      entry[k] = inverse[k] < 0 ? 3 + k : k;
      exit[k] = inverse[k] < 0 ? k : 3 + k;
    }
  }

  /// Intersects the ray with a triangle of a face; of faces at the same distance the lowest is hit.
  /// Moeller and Trumbore 1997, with a margin of one millionth against gaps.
  void intersect(const Float_3& corner, const Float_3& second, const Float_3& third, Index f)
  {
    constexpr float rim = -1e-6f;
    const Float_3 a = difference(second, corner), b = difference(third, corner),
                  p = product(direction, b);
    const float determinant = dot(a, p), scale = 1 / determinant;
    const Float_3 from_corner = difference(source, corner);
    const float u = dot(from_corner, p) * scale;
    if (u < rim || u > 1 - rim)
      return;
    const Float_3 q = product(from_corner, a);
    const float v = dot(direction, q) * scale, t = dot(b, q) * scale;
    const bool is_hit = !(u < rim) && !(v < rim) && !(u + v > 1 - rim) && determinant != 0 && t > 0;
    if (is_hit && f != skipped && (t < distance || (t == distance && f < face))) {
      distance = t;
      face = f;
    }
  }

private:
  static Float_3 difference(const Float_3& a, const Float_3& b)
  {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static float dot(const Float_3& a, const Float_3& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Float_3 product(const Float_3& a, const Float_3& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
};

/// The leaf of a `Ray_tree` that each face belongs to: its fine patch, or the coarse patch of that.
class Leaf_of_face
{
public:
  Leaf_of_face(const Surface_patches& patches, bool are_coarse)
    : m_fine(patches.fine.of_elements())
    , m_coarse(are_coarse ? &patches.coarse.of_elements() : nullptr)
  {}

  std::size_t size() const { return m_fine.size(); }
  std::size_t number_of_parts() const { return (m_coarse ? *m_coarse : m_fine).number_of_parts(); }
  Partition::Index operator[](std::size_t face) const
  {
    return m_coarse ? (*m_coarse)[m_fine[face]] : m_fine[face];
  }

private:
  const Partition& m_fine;
  const Partition* m_coarse;
};

/// The triangles (polygons as fans) of the leaves of a `Ray_tree`: the coarse patches of a mesh of
/// few faces, else the fine ones. 16 bytes a vertex and 4 bytes a face, with its boxes.
class Ray_leaves
{
  using Index = Surface::Index;
  using Box = Axis_box;

public:
  static constexpr std::size_t few_faces = std::size_t(1) << 19;

  /// `origin`, `scale`: of the relative coordinates
  Ray_leaves(const Surface& mesh, const Surface_patches& patches, const Double_3& origin,
             double scale, const Execution& execution)
    : m_origin(origin)
    , m_scale(scale)
    , m_points(mesh.number_of_vertices())
  {
    const Leaf_of_face leaf_of_face(patches, mesh.number_of_faces() <= few_faces);
    for_each_index(execution, m_points.size(),
                   [&](std::size_t v) { m_points[v] = relative(mesh.point(v)); });
    find_boxes(mesh, leaf_of_face, execution);
    m_faces = Grouped_items<Index>(leaf_of_face.number_of_parts(), [&](const auto& add) {
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
        if (!mesh.is_crumb(f)) // rays pass through crumbs
          add(leaf_of_face[f], Index(f));
    });
  }

  Float_3 relative(const Double_3& point) const
  {
    const Double_3 v = m_scale * (point - m_origin);
    return {float(v.x), float(v.y), float(v.z)};
  }

  /// Around the corners of the faces of each leaf. Can be called once.
  std::vector<Box> take_boxes() { return std::move(m_boxes); }

  /// Intersects a ray with the triangles of a leaf. `mesh`: that of the leaves
  void intersect(const Surface& mesh, std::size_t leaf, Ray& ray) const
  {
    for (const Index face : m_faces[leaf]) {
      const std::size_t n = mesh.number_of_corners(face), first = first_of_fan(mesh, face);
      const auto corner = [&](std::size_t i) -> const Float_3& {
        return m_points[mesh.corner(face, i < n ? i : i - n)];
      };
      for (std::size_t i = 1; i + 1 < n; ++i)
        ray.intersect(corner(first), corner(first + i), corner(first + i + 1), face);
    }
  }

private:
  /// In the order of the faces: by leaf, rays of 3 million faces that are far apart in memory take
  /// 1.3 times as long.
  void find_boxes(const Surface& mesh, const Leaf_of_face& leaf_of_face, const Execution& execution)
  {
    m_boxes.resize(leaf_of_face.number_of_parts());
    for_each_in_part(execution, leaf_of_face, [&](std::size_t leaf, std::size_t f) {
      if (!mesh.is_crumb(f))
        for (const Index corner : mesh.corners(f))
          m_boxes[leaf].add_point(m_points[corner]);
    });
  }

  /// The corner of a polygon farthest from its centroid, of several the first: so that polygons
  /// that are not flat do not depend on the numbering of vertices.
  static std::size_t first_of_fan(const Surface& mesh, Index face)
  {
    if (mesh.number_of_corners(face) <= 3)
      return 0;
    const Double_3 centroid = mesh.centroid(face);
    std::size_t first = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < mesh.number_of_corners(face); ++i)
      if (const double d = squared_norm(mesh.point(mesh.corner(face, i)) - centroid);
          d > farthest) {
        farthest = d;
        first = i;
      }
    return first;
  }

  Double_3 m_origin;
  double m_scale;
  Large_array<Float_3> m_points; // of vertices, relative
  std::vector<Box> m_boxes;      // by leaf, until they are taken
  Grouped_items<Index> m_faces;  // by leaf
};

/// Finds the face that a ray hits first: a tree of bounding boxes over the patches of a mesh. In
/// float, relative to the centroid of the surface: distances are needed to a few digits only.
/// (CGAL's AABB tree is exact, and GPL.)
///
/// A node has four children, which are tested together. The leaves are patches, see `Ray_leaves`.
/// The hits depend neither on the shape of the tree nor on the patches.
///
/// Construction takes O(F + P log P) for P patches, a ray O(log P + F / P) in practice.
class Ray_tree
{
  using Index = Surface::Index;

public:
  struct Hit
  {
    Index face;
    double distance; // in units of the surface
  };
  static constexpr Index no_face = Ray::no_face;

  /// `origin`: the centroid of the surface
  Ray_tree(const Surface& mesh, const Surface_patches& patches, const Double_3& origin,
           const Execution& execution)
    : m_unit(unit_of(mesh, patches.fine, origin))
    , m_leaves(mesh, patches, origin, 1 / m_unit, execution)
  {
    execution.report(0.5);
    std::vector<Box> boxes = m_leaves.take_boxes();
    std::vector<Item> items;
    for (Box& box : boxes) {
      box = enlarged(box, float(mesh.length_unit() / m_unit));
      items.push_back({center_of(box), Index(items.size())});
    }
    if (!items.empty())
      add_node(items.data(), items.data() + items.size(), boxes);
    execution.report(1);
  }

  /// The first face of the mesh of the tree that a ray hits in front of its source, of several the
  /// lowest one, other than `skipped`; the first one found, if it takes more nodes and leaves than
  /// `most_visits`, as where thousands of triangles overlap. `direction` has length 1.
  Hit first_hit(const Surface& mesh, const Double_3& source, const Double_3& direction,
                Index skipped,
                std::size_t most_visits = (std::numeric_limits<std::size_t>::max)()) const
  {
    Ray ray(m_leaves.relative(source), {float(direction.x), float(direction.y), float(direction.z)},
            skipped);
    // Where the ray enters a box, and the child; the nearest last. A level leaves at most three,
    // whatever the ray.
    std::array<Float_key, 3 * maximum_depth + width> waiting;
    std::size_t size = 0;
    if (!m_nodes.empty())
      waiting[size++] = make_float_key(0, 0);
    for (std::size_t visits = 0; size > 0 && visits < most_visits; ++visits) {
      const Float_key next = waiting[--size];
      const Index child = index_of(next);
      if (!(value_of(next) <= ray.distance))
        continue;
      if (child % 2 == 1)
        m_leaves.intersect(mesh, child / 2, ray);
      else
        for (const Float_key key : children(m_nodes[child / 2], ray)) {
          waiting[size] = key;
          size += key < never ? 1 : 0;
        }
    }
    return {ray.face, ray.face == no_face ? 0.0 : double(ray.distance) * m_unit};
  }

private:
  static constexpr std::size_t width = 4;
  /// Values of the children of a node.
  using Lanes = std::array<float, width>;

  using Box = Axis_box;

  /// A leaf to be sorted into the tree.
  struct Item
  {
    Float_3 center; // of its box
    Index leaf;
  };

  /// A child has at most a quarter of the items of its parent, rounded up.
  static constexpr std::size_t maximum_depth = 17;

  struct Node
  {
    std::array<Lanes, 6> bounds;    // of the children, lower ones by axis, and upper ones
    std::array<Index, width> child; // twice the index of a node, or twice that of a leaf plus one
  };

  /// A power of two, so that it does not change any rounding.
  static double unit_of(const Surface& mesh, const Patches& patches, const Double_3& origin)
  {
    double largest = 0;
    for (std::size_t p = 0; p < patches.size(); ++p)
      largest = (std::max)(largest, squared_norm(patches[p].centroid - origin));
    return std::ldexp(1.0, std::ilogb((std::max)(std::sqrt(largest), mesh.length_unit())));
  }

  /// Slightly enlarged, so that rounding misses no triangle. `extent`: the size of the surface
  static Box enlarged(Box box, float extent)
  {
    constexpr float margin = 5e-7f; // relative to the distance from the origin, and to the size of
                                    // the surface
    if (!(box.low[0] <= box.high[0])) { // of crumbs alone
      constexpr Float_3 origin{0, 0, 0};
      box.add_point(origin);
    }
    for (std::size_t k = 0; k < 3; ++k)
      extent = (std::max)({extent, std::abs(box.low[k]), std::abs(box.high[k])});
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] -= margin * extent;
      box.high[k] += margin * extent;
    }
    return box;
  }

  /// Finite.
  static Float_3 center_of(const Box& box)
  {
    Float_3 c;
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = std::isfinite(box.low[k] + box.high[k]) ? (box.low[k] + box.high[k]) / 2 : 0;
    return c;
  }

  /// Adds a node for some items, and its descendants: halves of halves along the axis on which the
  /// centers differ most. Returns the box around them.
  Box add_node(Item* first, Item* last, const std::vector<Box>& boxes)
  {
    const std::size_t n = m_nodes.size();
    m_nodes.emplace_back();
    Item *middle = halve(first, last), *const ends[] = {first, halve(first, middle), middle,
                                                        halve(middle, last), last};
    Box all;
    for (std::size_t i = 0; i < width; ++i) {
      Box box;
      Index child = 1; // a leaf where there is none, since a ray that is not a number enters all
                       // children
      if (ends[i + 1] - ends[i] == 1) {
        child = 2 * ends[i]->leaf + 1;
        box = boxes[ends[i]->leaf];
      } else if (ends[i] != ends[i + 1]) {
        child = Index(2 * m_nodes.size());
        box = add_node(ends[i], ends[i + 1], boxes);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        m_nodes[n].bounds[k][i] = box.low[k];
        m_nodes[n].bounds[3 + k][i] = box.high[k];
      }
      m_nodes[n].child[i] = child;
      all.add(box);
    }
    return all;
  }

  static Item* halve(Item* first, Item* last)
  {
    Item* const middle = first + (last - first) / 2;
    Box centers;
    for (const Item* item = first; item != last; ++item)
      centers.add_point(item->center);
    const std::size_t axis = centers.longest_axis();
    std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
      return a.center[axis] < b.center[axis];
    });
    return middle;
  }

  static constexpr Float_key never = Float_key(0x7f800000) << 32; // infinity

  /// The children of a node, the one that the ray enters first last; without branches, which would
  /// be unpredictable.
  static std::array<Float_key, width> children(const Node& node, const Ray& ray)
  {
    const Lanes entries = entries_of(node, ray);
    std::array<Float_key, width> keys;
    for (std::size_t i = 0; i < width; ++i)
      keys[i] = make_float_key(entries[i], node.child[i]);
    const auto order = [&](std::size_t i, std::size_t j) {
      const Float_key a = keys[i], b = keys[j];
      keys[i] = a > b ? a : b;
      keys[j] = a > b ? b : a;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    return keys;
  }

  /// Where a ray enters the boxes of children; infinite where it does not. A loop over the axes
  /// takes twice as long.
  BOOST_NOINLINE static Lanes entries_of(const Node& node, const Ray& ray)
  {
    const Lanes &near_x = node.bounds[ray.entry[0]], &near_y = node.bounds[ray.entry[1]],
                &near_z = node.bounds[ray.entry[2]];
    const Lanes &far_x = node.bounds[ray.exit[0]], &far_y = node.bounds[ray.exit[1]],
                &far_z = node.bounds[ray.exit[2]];
    const auto [source_x, source_y, source_z] = ray.source;
    const auto [inverse_x, inverse_y, inverse_z] = ray.inverse;
    Lanes entries;
    for (std::size_t i = 0; i < width; ++i) {
      // One that is not a number (0 * infinity) is ignored.
      const auto larger = [](float a, float b) { return a > b ? a : b; };
      const auto smaller = [](float a, float b) { return a < b ? a : b; };
      float in = larger((near_x[i] - source_x) * inverse_x, 0);
      in = larger((near_y[i] - source_y) * inverse_y, in);
      in = larger((near_z[i] - source_z) * inverse_z, in);
      float out = smaller((far_x[i] - source_x) * inverse_x, ray.distance);
      out = smaller((far_y[i] - source_y) * inverse_y, out);
      out = smaller((far_z[i] - source_z) * inverse_z, out);
      entries[i] = in <= out ? in : std::numeric_limits<float>::infinity();
    }
    return entries;
  }

  double m_unit; // of relative coordinates
  Ray_leaves m_leaves;
  std::vector<Node> m_nodes; // the root is the first
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_RAY_TREE_H
