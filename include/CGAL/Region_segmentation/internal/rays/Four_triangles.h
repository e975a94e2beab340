// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FOUR_TRIANGLES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FOUR_TRIANGLES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Float_4.h>

#include <array>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

using Float_3 = std::array<float, 3>;
using Float_4_3 = std::array<Float_4, 3>; ///< four vectors, coordinate by coordinate

inline Float_4_3 all_lanes(const Float_3& v)
{
  return {all_lanes(v[0]), all_lanes(v[1]), all_lanes(v[2])};
}

inline Float_4_3 operator-(const Float_4_3& a, const Float_4_3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Float_4 dot(const Float_4_3& a, const Float_4_3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Float_4_3 cross(const Float_4_3& a, const Float_4_3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A ray and the first face hit so far.
struct Ray
{
  using Index = Flat_mesh::Index;
  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  Float_3 source, direction;
  Index skipped; ///< is not hit
  Index face = no_face;
  float distance = (std::numeric_limits<float>::max)();
};

/// Up to four triangles of a mesh; missing ones have edges of length 0, as after `Four_triangles()`. 160 bytes.
class Four_triangles
{
public:
  using Index = Flat_mesh::Index;

  void set(std::size_t lane, const std::array<Float_3, 3>& corners, Index face)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      m_corner[k][lane] = corners[0][k];
      m_edge_1[k][lane] = corners[1][k] - corners[0][k];
      m_edge_2[k][lane] = corners[2][k] - corners[0][k];
    }
    m_face[lane] = face;
  }

  /// Moeller and Trumbore 1997, with a margin of one millionth against gaps. Of faces at the same distance the lowest
  /// is hit.
  void intersect(Ray& ray) const
  {
    const Float_4 rim = all_lanes(-1e-6f), zero = all_lanes(0), one = all_lanes(1);
    const Float_4_3 direction = all_lanes(ray.direction);
    const Float_4_3 p = cross(direction, m_edge_2);
    const Float_4 determinant = dot(m_edge_1, p);
    const Float_4 inverse = one / determinant;
    const Float_4_3 to_source = all_lanes(ray.source) - m_corner;
    const Float_4 u = dot(to_source, p) * inverse;
    const Float_4_3 q = cross(to_source, m_edge_1);
    const Float_4 v = dot(direction, q) * inverse;
    const Float_4 distance = dot(m_edge_2, q) * inverse;
    const Mask_4 is_outside = (u < rim) | (v < rim) | (u + v > one - rim);
    const Mask_4 is_in_front = (determinant != zero) & (distance > zero);
    const Float_4 none = all_lanes(std::numeric_limits<float>::infinity());
    const Float_4 distances = select(is_outside, none, select(is_in_front, distance, none));
    for (std::size_t i = 0; i < 4; ++i)
      if (distances[i] <= ray.distance && m_face[i] != ray.skipped &&
          (distances[i] < ray.distance || m_face[i] < ray.face)) {
        ray.distance = distances[i];
        ray.face = m_face[i];
      }
  }

private:
  Float_4_3 m_corner, m_edge_1, m_edge_2;
  std::array<Index, 4> m_face;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FOUR_TRIANGLES_H
