// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FOUR_TRIANGLES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FOUR_TRIANGLES_H

#include <CGAL/Region_segmentation/Surface.h>

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

using Float_3 = std::array<float, 3>;

/// Values of four boxes or triangles. Compilers vectorize loops over them, but not where these are
/// inlined: tree and rays take 1.6 times as long then at 13,000 faces, 1.7 times at 160,000.
using Lanes = std::array<float, 4>;

/// A ray and the first face hit so far.
struct Ray
{
  using Index = Surface::Index;
  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

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
};

/// Triangles that are tested together, none at first. 160 bytes.
class Four_triangles
{
public:
  using Index = Surface::Index;

  void set(std::size_t lane, const Float_3& p, const Float_3& q, const Float_3& r, Index face)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      m_corner[k][lane] = p[k];
      m_edge_1[k][lane] = q[k] - p[k];
      m_edge_2[k][lane] = r[k] - p[k];
    }
    m_face[lane] = face;
  }

  /// Of faces at the same distance the lowest is hit.
  void intersect(Ray& ray) const
  {
    const Lanes distances = distances_of(ray);
    for (std::size_t i = 0; i < 4; ++i)
      if (distances[i] <= ray.distance && m_face[i] != ray.skipped &&
          (distances[i] < ray.distance || m_face[i] < ray.face)) {
        ray.distance = distances[i];
        ray.face = m_face[i];
      }
  }

private:
  /// Moeller and Trumbore 1997, with a margin of one millionth against gaps; infinite where a ray
  /// does not hit.
  BOOST_NOINLINE Lanes distances_of(const Ray& ray) const
  {
    constexpr float rim = -1e-6f;
    const auto [dx, dy, dz] = ray.direction;
    const auto [source_x, source_y, source_z] = ray.source;
    Lanes distances;
    for (std::size_t i = 0; i < 4; ++i) {
      const float ax = m_edge_1[0][i], ay = m_edge_1[1][i], az = m_edge_1[2][i];
      const float bx = m_edge_2[0][i], by = m_edge_2[1][i], bz = m_edge_2[2][i];
      const float px = dy * bz - dz * by, py = dz * bx - dx * bz, pz = dx * by - dy * bx;
      const float determinant = ax * px + ay * py + az * pz, inverse = 1 / determinant;
      const float x = source_x - m_corner[0][i], y = source_y - m_corner[1][i],
                  z = source_z - m_corner[2][i];
      const float u = (x * px + y * py + z * pz) * inverse;
      const float qx = y * az - z * ay, qy = z * ax - x * az, qz = x * ay - y * ax;
      const float v = (dx * qx + dy * qy + dz * qz) * inverse;
      const float distance = (bx * qx + by * qy + bz * qz) * inverse;
      const bool is_hit = !(u < rim) & !(v < rim) & !(u + v > 1 - rim) & (determinant != 0) &
                          (distance > 0);
      distances[i] = is_hit ? distance : std::numeric_limits<float>::infinity();
    }
    return distances;
  }

  // Coordinate by coordinate; edges of length 0 are not hit.
  std::array<Lanes, 3> m_corner{}, m_edge_1{}, m_edge_2{};
  std::array<Index, 4> m_face{};
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_FOUR_TRIANGLES_H
