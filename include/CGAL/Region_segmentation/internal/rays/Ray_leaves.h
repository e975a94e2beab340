// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/for_each_in_part.h>
#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>

#include <array>
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
        for (const Index corner : corners_of(mesh, f))
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

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
