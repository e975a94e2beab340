// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_BOXES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_BOXES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Box_partition.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The triangles of the patches of a mesh (polygons as fans), relative to an origin, in float.
class Patch_triangles
{
public:
  using Index = Flat_mesh::Index;

  /// `scale`: of the relative coordinates
  Patch_triangles(const Flat_mesh& mesh, const Double_3& origin, double scale)
    : m_mesh(mesh), m_origin(origin), m_scale(scale), m_faces(mesh.patches().size())
  {
    const Partition& patches = mesh.patches().of_faces();
    for (const Index patch : patches)
      m_faces.count(patch);
    m_faces.end_counting();
    for (std::size_t f = 0; f < patches.size(); ++f)
      m_faces.add(patches[f], Index(f));
  }

  std::size_t number_of_patches() const { return m_faces.number_of_groups(); }
  /// Of a patch, relative.
  double area(std::size_t patch) const { return m_mesh.patches()[patch].area * m_scale * m_scale; }
  /// The root of the area of the surface, relative.
  double unit() const { return m_mesh.relative_unit() * m_scale; }

  /// Calls `f(corners, face)` for the triangles of a patch: the first corner of a fan, and two others.
  template <typename F>
  void for_each(std::size_t patch, const F& f) const
  {
    const Mesh_points& points = m_mesh.points();
    for (const Index face : m_faces[patch]) {
      const std::size_t n = points.number_of_corners(face), first = first_of_fan(face);
      const auto corner = [&](std::size_t i) { return relative(points[points.corner(face, i < n ? i : i - n)]); };
      for (std::size_t i = 1; i + 1 < n; ++i)
        f(std::array<Float_3, 3>{corner(first), corner(first + i), corner(first + i + 1)}, face);
    }
  }

private:
  /// The corner of a polygon farthest from its centroid, of several the first: so that polygons that are not flat do not
  /// depend on the numbering of vertices.
  std::size_t first_of_fan(Index face) const
  {
    const Mesh_points& points = m_mesh.points();
    std::size_t first = 0;
    double farthest = -1;
    for (std::size_t i = 0; points.number_of_corners(face) > 3 && i < points.number_of_corners(face); ++i)
      if (const double d = squared_norm(points[points.corner(face, i)] - m_mesh.centroid(face)); d > farthest) {
        farthest = d;
        first = i;
      }
    return first;
  }

  Float_3 relative(const Double_3& point) const
  {
    const Double_3 v = m_scale * (point - m_origin);
    return {float(v.x), float(v.y), float(v.z)};
  }

  const Flat_mesh& m_mesh;
  const Double_3 m_origin;
  const double m_scale;
  Grouped_items<Index> m_faces; // by patch
};

/// The boxes of patches, slightly enlarged, so that rounding misses no triangle. A box that is large for the area in it,
/// as that of a needle that is not parallel to an axis, would be entered by most rays: it is replaced by those of slices
/// of the patch.
///
///     +-------+     +--+
///     |     / |     | /+-+
///     |  /    |     +-+ /|
///     +-------+       +--+
///
/// Without slices tracing takes 8 times as long on a cone of 40,000 triangles, and 10 times on 20,000 needles through
/// one point. Surfaces of usual triangles have none.
class Patch_boxes
{
public:
  static Box_partition make(const Patch_triangles& triangles)
  {
    Patch_boxes boxes(triangles);
    boxes.limit_slices();
    Box_partition result;
    result.reserve(triangles.number_of_patches());
    for (std::size_t patch = 0; patch < triangles.number_of_patches(); ++patch)
      boxes.add(patch, result);
    return result;
  }

private:
  static constexpr float margin = 5e-7f; // relative to the distance from the origin, and to the size of the surface
  static constexpr double largest_ratio = 16; // of half the area of a box to that of the patch; above that of any triangle
                                              // with angles of at least 10 degrees
  static constexpr std::uint32_t most_triangles = 64; // of a patch in slices: each of these tests all of them
  static constexpr float finest_slice = 1.f / 32; // of relative coordinates, which are of magnitude 1
  static constexpr std::size_t triangles_to_add = std::size_t(1) << 18; // at least; or as many as there are

  struct Extent
  {
    Box box;
    std::uint32_t triangles = 0;
    std::size_t axis = 0;         // the longest
    bool is_large = false; // for the area in it

    float length() const { return box.high[axis] - box.low[axis]; }
  };

  explicit Patch_boxes(const Patch_triangles& triangles)
    : m_triangles(triangles), m_size(float(triangles.unit()))
  {
    m_extents.reserve(triangles.number_of_patches());
    for (std::size_t patch = 0; patch < triangles.number_of_patches(); ++patch)
      m_extents.push_back(extent(patch));
  }

  Extent extent(std::size_t patch) const
  {
    Extent result;
    m_triangles.for_each(patch, [&](const std::array<Float_3, 3>& corners, Flat_mesh::Index) {
      for (const Float_3& c : corners)
        result.box.add(Float_4{c[0], c[1], c[2], 0});
      ++result.triangles;
    });
    const Float_4 side = result.box.high - result.box.low;
    result.axis = side[0] >= side[1] && side[0] >= side[2] ? 0 : side[1] >= side[2] ? 1 : 2;
    result.is_large = result.triangles <= most_triangles &&
                      double(result.box.half_area()) > largest_ratio * m_triangles.area(patch);
    return result;
  }

  std::size_t number_of_slices(const Extent& extent) const
  {
    return extent.is_large && extent.length() > m_slice ? std::size_t(std::ceil(extent.length() / m_slice)) : 1;
  }

  /// Doubles the width of slices until they add few enough triangles to the leaves.
  void limit_slices()
  {
    std::size_t all = 0;
    for (const Extent& e : m_extents)
      all += e.triangles;
    for (m_slice = finest_slice;; m_slice *= 2) {
      std::size_t added = 0;
      for (const Extent& e : m_extents)
        added += (number_of_slices(e) - 1) * e.triangles;
      if (added <= (std::max)(all, triangles_to_add))
        return;
    }
  }

  void add(std::size_t patch, Box_partition& result) const
  {
    const Extent& e = m_extents[patch];
    const std::size_t number = number_of_slices(e);
    if (number == 1)
      return result.add(enlarged(e.box), Box_partition::Name(patch));
    for (std::size_t i = 0; i < number; ++i) {
      const auto bound = [&](std::size_t k) { return e.box.low[e.axis] + e.length() * float(k) / float(number); };
      const float low = i == 0 ? e.box.low[e.axis] : bound(i), high = i + 1 == number ? e.box.high[e.axis] : bound(i + 1);
      Box slice;
      m_triangles.for_each(patch, [&](const std::array<Float_3, 3>& corners, Flat_mesh::Index) {
        add_slice(slice, corners, e.axis, low, high);
      });
      if (slice.low[0] <= slice.high[0])
        result.add(enlarged(slice), Box_partition::Name(patch));
    }
  }

  /// Adds the part of a triangle between two planes: its corners there, and where its edges cross them.
  static void add_slice(Box& box, const std::array<Float_3, 3>& corners, std::size_t axis, float low, float high)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const Float_3 &p = corners[i], &q = corners[(i + 1) % 3];
      const Float_4 a = {p[0], p[1], p[2], 0}, b = {q[0], q[1], q[2], 0};
      if (p[axis] >= low && p[axis] <= high)
        box.add(a);
      for (const float plane : {low, high})
        if ((p[axis] < plane) != (q[axis] < plane))
          box.add(a + all_lanes((plane - p[axis]) / (q[axis] - p[axis])) * (b - a));
    }
  }

  Box enlarged(Box box) const
  {
    float extent = m_size;
    for (std::size_t k = 0; k < 3; ++k)
      extent = (std::max)({extent, std::abs(box.low[k]), std::abs(box.high[k])});
    box.low = box.low - all_lanes(margin * extent);
    box.high = box.high + all_lanes(margin * extent);
    return box;
  }

  const Patch_triangles& m_triangles;
  const float m_size;             // of the surface
  std::vector<Extent> m_extents;  // by patch
  float m_slice = finest_slice;   // the greatest width of a slice
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_BOXES_H
