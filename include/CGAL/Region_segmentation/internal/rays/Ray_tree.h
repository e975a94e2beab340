// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_TREE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Float_key.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds the face that a ray hits first: a tree of bounding boxes over the patches of a mesh. In float, relative to the
/// centroid of the surface: distances are needed to a few digits only. (CGAL's AABB tree is exact, and GPL.)
///
/// A node has four children, whose boxes are tested in loops that compilers vectorize. A leaf is a patch, a coarse one
/// on meshes of few faces; its triangles (polygons as fans) are read from the mesh. The hits depend neither on the shape
/// of the tree nor on the patches.
///
/// Bytes: 4 per face and some 80 per patch. Construction takes O(F + P log P) for P patches, a ray O(log P + F / P) in practice.
class Ray_tree
{
  using Index = Surface::Index;
  using Float_3 = std::array<float, 3>;

public:
  struct Hit
  {
    Index face;
    double distance; // in units of the mesh
  };
  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  /// `origin`: the centroid of the surface
  Ray_tree(const Surface& mesh, const Surface_patches& patches, const Double_3& origin,
           const Execution& execution)
    : m_origin(origin), m_unit(unit_of(mesh, patches.fine, origin)), m_faces(faces_by_patch(mesh, patches))
  {
    m_points.resize(mesh.number_of_vertices());
    for_each_block(execution.step(0, 0.5), m_points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        m_points[v] = relative(mesh.point(v));
    });
    std::vector<Box> boxes(m_faces.number_of_groups());
    std::vector<Item> items(m_faces.number_of_groups());
    for_each_block(execution.step(0, 0.5), items.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t patch = begin; patch < end; ++patch)
        boxes[patch] = box_of(mesh, patch), items[patch] = {boxes[patch].center(), Index(patch)};
    }, 256);
    if (!items.empty())
      add_node(items.data(), items.data() + items.size(), boxes);
    if (mesh.number_of_faces() <= most_stored_faces)
      store_groups(mesh);
    execution.report(1);
  }

  /// The first face of the mesh of the tree that a ray hits in front of its source, of several the lowest one, other
  /// than `skipped`. `direction` has length 1.
  Hit first_hit(const Surface& mesh, const Double_3& source, const Double_3& direction, Index skipped) const
  {
    Ray ray(relative(source), {float(direction.x), float(direction.y), float(direction.z)}, skipped);
    std::array<Float_key, 3 * maximum_depth + width> waiting; // where the ray enters a box, and the child; the nearest last
    std::size_t size = 0;
    if (!m_nodes.empty())
      waiting[size++] = make_float_key(0, 0);
    while (size > 0) {
      const Float_key next = waiting[--size];
      const Index child = index_of(next);
      if (!(value_of(next) <= ray.distance))
        continue;
      if (child % 2 == 1)
        for_each_group(mesh, child / 2, [&](const Four_triangles& group) { intersect(ray, group); });
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
  using Lanes = std::array<float, width>; // loops over these are vectorized

  struct Ray
  {
    Float_3 source, direction, inverse; // infinite for 0
    std::array<std::size_t, 3> entered; // by which of the two bounds it enters a box, by axis
    Index skipped;
    Index face = no_face; // the first one hit so far
    float distance = (std::numeric_limits<float>::max)();

    Ray(const Float_3& source_, const Float_3& direction_, Index skipped_)
      : source(source_), direction(direction_), skipped(skipped_)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        inverse[k] = 1 / direction[k];
        entered[k] = inverse[k] < 0 ? 1 : 0;
      }
    }
  };

  struct Four_triangles
  {
    std::array<Lanes, 3> corner, edge_1, edge_2;
    std::array<Index, width> face;

    void set(std::size_t lane, const Float_3& p, const Float_3& q, const Float_3& r, Index f)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k][lane] = p[k];
        edge_1[k][lane] = q[k] - p[k];
        edge_2[k][lane] = r[k] - p[k];
      }
      face[lane] = f;
    }
    void repeat(std::size_t lane)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k][lane] = corner[k][0];
        edge_1[k][lane] = edge_1[k][0];
        edge_2[k][lane] = edge_2[k][0];
      }
      face[lane] = face[0];
    }
  };

  /// Empty until a point is added; coordinates that are not numbers are ignored.
  struct Box
  {
    Float_3 low = all((std::numeric_limits<float>::max)()), high = all(std::numeric_limits<float>::lowest());

    static Float_3 all(float x) { return {x, x, x}; }

    /// Finite.
    Float_3 center() const
    {
      Float_3 c;
      for (std::size_t k = 0; k < 3; ++k)
        c[k] = std::isfinite(low[k] + high[k]) ? (low[k] + high[k]) / 2 : 0;
      return c;
    }

    void add(const Float_3& a, const Float_3& b)
    {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = a[k] < low[k] ? a[k] : low[k];
        high[k] = b[k] > high[k] ? b[k] : high[k];
      }
    }
  };

  struct Item
  {
    Float_3 center; // of its box
    Index patch;
  };

  static constexpr std::size_t most_stored_faces = std::size_t(1) << 19; // of more, triangles would be a quarter of the memory of a segmentation
  static constexpr std::size_t maximum_depth = 17; // each level has a quarter of the items of the one above, rounded up

  struct Node
  {
    std::array<std::array<Lanes, 3>, 2> bounds; // of the children, lower and upper ones
    std::array<Index, width> child;             // twice the index of a node, or twice that of a patch plus one
  };

  /// A power of two, so that it does not change any rounding.
  static double unit_of(const Surface& mesh, const Patches& patches, const Double_3& origin)
  {
    double largest = 0;
    for (std::size_t p = 0; p < patches.size(); ++p)
      largest = (std::max)(largest, squared_norm(patches[p].centroid - origin));
    return std::ldexp(1.0, std::ilogb((std::max)(std::sqrt(largest), mesh.length_unit())));
  }

  static Grouped_items<Index> faces_by_patch(const Surface& mesh, const Surface_patches& patches)
  {
    const Patches &fine = patches.fine, &coarse = patches.coarse;
    const bool is_coarse = mesh.number_of_faces() <= most_stored_faces;
    const auto patch_of = [&](Index p) { return is_coarse ? coarse.of_elements()[p] : p; };
    Grouped_items<Index> faces(is_coarse ? coarse.size() : fine.size());
    for (const Index p : fine.of_elements())
      faces.count(patch_of(p));
    faces.end_counting();
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      faces.add(patch_of(fine.of_elements()[f]), Index(f));
    return faces;
  }

  Float_3 relative(const Double_3& point) const
  {
    const Double_3 v = (1 / m_unit) * (point - m_origin);
    return {float(v.x), float(v.y), float(v.z)};
  }

  void store_groups(const Surface& mesh)
  {
    m_groups.reserve(mesh.number_of_faces() / width + m_faces.number_of_groups());
    for (std::size_t patch = 0; patch < m_faces.number_of_groups(); ++patch) {
      m_first_groups.push_back(Index(m_groups.size()));
      make_groups(mesh, patch, [&](const Four_triangles& group) { m_groups.push_back(group); });
    }
    m_first_groups.push_back(Index(m_groups.size()));
  }

  /// Calls `f(corners, face)` for the triangles of a patch: the first corner of a fan, and two others.
  template <typename F>
  void for_each_triangle(const Surface& mesh, std::size_t patch, const F& f) const
  {
    for (const Index face : m_faces[patch]) {
      const std::size_t n = mesh.number_of_corners(face), first = first_of_fan(mesh, face);
      const auto corner = [&](std::size_t i) -> const Float_3& { return m_points[mesh.corner(face, i < n ? i : i - n)]; };
      for (std::size_t i = 1; i + 1 < n; ++i)
        f(corner(first), corner(first + i), corner(first + i + 1), face);
    }
  }

  /// Calls `f(group)` for the triangles of a leaf four by four.
  template <typename F>
  void for_each_group(const Surface& mesh, std::size_t patch, const F& f) const
  {
    if (m_groups.empty())
      return make_groups(mesh, patch, f);
    for (std::size_t i = m_first_groups[patch]; i < m_first_groups[patch + 1]; ++i)
      f(m_groups[i]);
  }

  template <typename F>
  void make_groups(const Surface& mesh, std::size_t patch, const F& f) const
  {
    Four_triangles group;
    std::size_t lane = 0;
    for_each_triangle(mesh, patch, [&](const Float_3& p, const Float_3& q, const Float_3& r, Index face) {
      group.set(lane, p, q, r, face);
      if (++lane == width) {
        f(group);
        lane = 0;
      }
    });
    if (lane == 0)
      return;
    for (; lane < width; ++lane)
      group.repeat(lane);
    f(group);
  }

  /// The corner of a polygon farthest from its centroid, of several the first: so that polygons that are not flat do not
  /// depend on the numbering of vertices.
  static std::size_t first_of_fan(const Surface& mesh, Index face)
  {
    std::size_t first = 0;
    double farthest = -1;
    for (std::size_t i = 0; mesh.number_of_corners(face) > 3 && i < mesh.number_of_corners(face); ++i)
      if (const double d = squared_norm(mesh.point(mesh.corner(face, i)) - mesh.centroid(face)); d > farthest) {
        farthest = d;
        first = i;
      }
    return first;
  }

  /// Slightly enlarged, so that rounding misses no triangle.
  Box box_of(const Surface& mesh, std::size_t patch) const
  {
    constexpr float margin = 5e-7f; // relative to the distance from the origin, and to the size of the surface
    Box box;
    for_each_triangle(mesh, patch, [&](const Float_3& p, const Float_3& q, const Float_3& r, Index) {
      for (const Float_3* c : {&p, &q, &r})
        box.add(*c, *c);
    });
    float extent = float(mesh.length_unit() / m_unit);
    for (std::size_t k = 0; k < 3; ++k)
      extent = (std::max)({extent, std::abs(box.low[k]), std::abs(box.high[k])});
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] -= margin * extent;
      box.high[k] += margin * extent;
    }
    return box;
  }

  /// Adds a node for some items, and its descendants: halves of halves along the axis on which the centers differ most.
  /// Returns the box around them.
  Box add_node(Item* first, Item* last, const std::vector<Box>& boxes)
  {
    const std::size_t n = m_nodes.size();
    m_nodes.emplace_back();
    Item *middle = halve(first, last), *const ends[] = {first, halve(first, middle), middle, halve(middle, last), last};
    Box all;
    for (std::size_t i = 0; i < width; ++i) {
      Box box;
      Index child = 1; // a leaf where there is none: a ray that is not a number enters all children
      if (ends[i + 1] - ends[i] == 1) {
        child = 2 * ends[i]->patch + 1;
        box = boxes[ends[i]->patch];
      } else if (ends[i] != ends[i + 1]) {
        child = Index(2 * m_nodes.size());
        box = add_node(ends[i], ends[i + 1], boxes);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        m_nodes[n].bounds[0][k][i] = box.low[k];
        m_nodes[n].bounds[1][k][i] = box.high[k];
      }
      m_nodes[n].child[i] = child;
      all.add(box.low, box.high);
    }
    return all;
  }

  static Item* halve(Item* first, Item* last)
  {
    Item* const middle = first + (last - first) / 2;
    Box centers;
    for (const Item* item = first; item != last; ++item)
      centers.add(item->center, item->center);
    const auto side = [&](std::size_t k) { return centers.high[k] - centers.low[k]; };
    const std::size_t axis = side(0) >= side(1) && side(0) >= side(2) ? 0 : side(1) >= side(2) ? 1 : 2;
    std::nth_element(first, middle, last, [axis](const Item& a, const Item& b) {
      return a.center[axis] < b.center[axis];
    });
    return middle;
  }

  static constexpr Float_key never = Float_key(0x7f800000) << 32; // infinity

  /// The children of a node, the one that the ray enters first last; without branches, which would be unpredictable.
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

  /// Where a ray enters the boxes of children; infinite where it does not.
  BOOST_NOINLINE static Lanes entries_of(const Node& node, const Ray& ray)
  {
    const auto bounds = [&](std::size_t k, bool is_far) { return node.bounds[is_far ? 1 - ray.entered[k] : ray.entered[k]][k].data(); };
    const float *near_x = bounds(0, false), *near_y = bounds(1, false), *near_z = bounds(2, false);
    const float *far_x = bounds(0, true), *far_y = bounds(1, true), *far_z = bounds(2, true);
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

  /// Of faces at the same distance the lowest is hit.
  static void intersect(Ray& ray, const Four_triangles& group)
  {
    const Lanes distances = distances_of(group, ray);
    for (std::size_t i = 0; i < width; ++i)
      if (distances[i] <= ray.distance && group.face[i] != ray.skipped &&
          (distances[i] < ray.distance || group.face[i] < ray.face)) {
        ray.distance = distances[i];
        ray.face = group.face[i];
      }
  }

  /// Moeller and Trumbore 1997, with a margin of one millionth against gaps; infinite where a ray does not hit.
  BOOST_NOINLINE static Lanes distances_of(const Four_triangles& t, const Ray& ray)
  {
    constexpr float rim = -1e-6f;
    const auto [dx, dy, dz] = ray.direction;
    const auto [source_x, source_y, source_z] = ray.source;
    Lanes distances;
    for (std::size_t i = 0; i < width; ++i) {
      const float ax = t.edge_1[0][i], ay = t.edge_1[1][i], az = t.edge_1[2][i];
      const float bx = t.edge_2[0][i], by = t.edge_2[1][i], bz = t.edge_2[2][i];
      const float px = dy * bz - dz * by, py = dz * bx - dx * bz, pz = dx * by - dy * bx;
      const float determinant = ax * px + ay * py + az * pz, inverse = 1 / determinant;
      const float x = source_x - t.corner[0][i], y = source_y - t.corner[1][i], z = source_z - t.corner[2][i];
      const float u = (x * px + y * py + z * pz) * inverse;
      const float qx = y * az - z * ay, qy = z * ax - x * az, qz = x * ay - y * ax;
      const float v = (dx * qx + dy * qy + dz * qz) * inverse;
      const float distance = (bx * qx + by * qy + bz * qz) * inverse;
      const bool is_hit = !(u < rim) & !(v < rim) & !(u + v > 1 - rim) & (determinant != 0) & (distance > 0);
      distances[i] = is_hit ? distance : std::numeric_limits<float>::infinity();
    }
    return distances;
  }

  Double_3 m_origin;
  double m_unit; // of relative coordinates
  Large_array<Float_3> m_points; // relative
  Grouped_items<Index> m_faces; // by patch
  std::vector<Index> m_first_groups; // by patch, those that are stored
  Large_array<Four_triangles> m_groups;
  std::vector<Node> m_nodes;    // the root is the first
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_TREE_H
