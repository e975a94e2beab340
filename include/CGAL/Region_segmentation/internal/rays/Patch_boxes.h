// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_BOXES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_BOXES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Box_partition.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/rays/Patch_triangles.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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
  template <typename ConcurrencyTag>
  static Box_partition make(const Flat_mesh& mesh, const Patch_triangles& triangles)
  {
    Patch_boxes boxes(mesh, triangles);
    for_each_index<ConcurrencyTag>(
      boxes.m_extents.size(), [&](std::size_t patch) { boxes.m_extents[patch] = boxes.extent(patch); });
    boxes.limit_slices();
    Box_partition result;
    result.reserve(triangles.patches(mesh).size());
    for (std::size_t patch = 0; patch < triangles.patches(mesh).size(); ++patch)
      boxes.add(patch, result);
    return result;
  }

private:
  static constexpr float margin = 5e-7f; // relative to the distance from the origin, and to the size of the surface
  static constexpr double largest_ratio = 16; // of half the area of a box to that of the patch; above that of any triangle
                                              // with angles of at least 10 degrees
  static constexpr std::uint32_t most_triangles = 64; // of a patch in slices: each of these tests all of them
  static constexpr float finest_slice = 1.f / 32; // of relative coordinates, which are of magnitude 1
  static constexpr std::size_t triangles_to_add = std::size_t(1) << 18; // at most; or as many as there are
  static constexpr float most_slices = 128; // of a patch: more than one as long as the surface has

  struct Extent
  {
    Box box;
    std::uint32_t triangles = 0;
    std::size_t axis = 0;         // the longest
    bool is_large = false; // for the area in it

    float length() const { return box.high[axis] - box.low[axis]; }
  };

  Patch_boxes(const Flat_mesh& mesh, const Patch_triangles& triangles)
    : m_mesh(mesh)
    , m_triangles(triangles)
    , m_size(float(triangles.relative(mesh.relative_unit())))
    , m_extents(triangles.patches(mesh).size())
  {}

  Extent extent(std::size_t patch) const
  {
    Extent result;
    m_triangles.for_each(m_mesh, patch, [&](const std::array<Float_3, 3>& corners, Flat_mesh::Index) {
      for (const Float_3& c : corners)
        result.box.add(Float_4{c[0], c[1], c[2], 0});
      ++result.triangles;
    });
    const Float_4 side = result.box.high - result.box.low;
    result.axis = side[0] >= side[1] && side[0] >= side[2] ? 0 : side[1] >= side[2] ? 1 : 2;
    result.is_large = result.triangles <= most_triangles &&
                      double(result.box.half_area()) > largest_ratio * relative_area(patch);
    return result;
  }

  double relative_area(std::size_t patch) const
  {
    return m_triangles.relative(m_triangles.relative(m_triangles.patches(m_mesh)[patch].area));
  }

  std::size_t number_of_slices(const Extent& extent) const
  {
    return extent.is_large && extent.length() > m_slice
             ? std::size_t((std::min)(std::ceil(extent.length() / m_slice), most_slices))
             : 1;
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
      m_triangles.for_each(m_mesh, patch, [&](const std::array<Float_3, 3>& corners, Flat_mesh::Index) {
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

  const Flat_mesh& m_mesh;
  const Patch_triangles& m_triangles;
  const float m_size;             // of the surface
  std::vector<Extent> m_extents;  // by patch
  float m_slice = finest_slice;   // the greatest width of a slice
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_PATCH_BOXES_H
