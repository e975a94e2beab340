// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_INWARD_RAYS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_INWARD_RAYS_H

#include <CGAL/Region_segmentation/internal/Ray_tree.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The rays that `Sight` sends from every region into the body.
///
/// Bytes, while they are traced: those of `Ray_tree`, 16 a face, 296 a region.
class Inward_rays
{
  using Index = Flat_mesh::Index;

public:
  static constexpr std::size_t faces_per_region = 3, rays_per_region = 18;

  /// What the rays of a region hit.
  using Hits = std::array<Ray_tree::Hit, rays_per_region>;

  /// `centroids`: of the regions
  /// \pre the mesh was read with its points; every region has a face
  Inward_rays(const Flat_mesh& mesh, const Region_labels& regions, const std::vector<Vector_3>& centroids)
    : m_mesh(mesh)
    , m_tree(mesh)
    , m_first(regions.number_of_regions + 2, 0)
    , m_faces(mesh.number_of_faces())
    , m_spirals{make_spirals(1), make_spirals(2), make_spirals(3)}
  {
    // Counted two places further on, so that filling moves each start to where it belongs.
    for (Index r : regions.of_face)
      ++m_first[r + 2];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
      const Index r = regions.of_face[f];
      m_faces[m_first[r + 1]++] = {squared_norm(mesh.centroid(f) - centroids[r]), Index(f)};
    }
    m_first.pop_back();
  }

  /// What they hit, by region.
  template <typename ConcurrencyTag>
  std::vector<Hits> trace()
  {
    std::vector<Hits> hits(m_first.size() - 1);
    for_each_block<ConcurrencyTag>(
      hits.size(),
      [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
          hits[r] = hits_of(r);
      },
      16);
    return hits;
  }

private:
  using Face_at_distance = std::pair<double, Index>; // to the centroid of its region, squared

  /// A direction around the inward normal of a face: the angles away from it, and around it.
  struct Spiral
  {
    double cos_away, sin_away, cos_around, sin_around;
  };
  using Spirals = std::array<Spiral, rays_per_region>;

  /// The directions of the rays of a region, by the number of faces that they start from: on a spiral of the golden
  /// angle, turned from face to face.
  static Spirals make_spirals(std::size_t samples)
  {
    constexpr double golden_angle = 2.399963229728653, half_cone = 0.9; // radian
    const std::size_t rays = rays_per_region / samples; // of a face
    Spirals spirals;
    for (std::size_t i = 0; i < rays_per_region; ++i) {
      const std::size_t k = i / rays, q = i % rays;
      const double away = half_cone * std::sqrt(double(q) / double(rays - 1));
      const double around = golden_angle * double(q) + double(k);
      spirals[i] = {std::cos(away), std::sin(away), std::cos(around), std::sin(around)};
    }
    return spirals;
  }

  Hits hits_of(std::size_t region)
  {
    Hits hits;
    hits.fill({Ray_tree::no_face, 0});
    const std::size_t size = m_first[region + 1] - m_first[region];
    const std::size_t samples = (std::min)(size, faces_per_region);
    const Spirals& spirals = m_spirals[samples - 1];
    const std::size_t rays = rays_per_region / samples; // of a face
    auto begin = m_faces.begin() + m_first[region], end = begin + size;
    for (std::size_t k = samples; k-- > 0;) {
      // What is behind a place in the order is not looked at for those before it.
      const auto sample = begin + k * size * 9 / (10 * samples);
      std::nth_element(begin, sample, end);
      end = sample;
      trace_from(sample->second, spirals.data() + k * rays, rays, hits.data() + k * rays);
    }
    return hits;
  }

  void trace_from(Index face, const Spiral* spirals, std::size_t number, Ray_tree::Hit* hits) const
  {
    if (m_mesh.is_degenerate(face))
      return;
    const Vector_3 source = m_mesh.centroid(face), inward = -1.0 * m_mesh.normal(face);
    const Vector_3 along = m_mesh.point(m_mesh.corner(face, 1)) - m_mesh.point(m_mesh.corner(face, 0));
    const Vector_3 in_plane = along - dot(along, inward) * inward;
    const double length = norm(in_plane);
    const Vector_3 u = length > 0 ? (1 / length) * in_plane : in_plane, v = cross(inward, u);
    for (std::size_t i = 0; i < number; ++i) {
      const Spiral& s = spirals[i];
      const Vector_3 direction =
        length > 0 ? s.cos_away * inward + s.sin_away * (s.cos_around * u + s.sin_around * v) : inward;
      hits[i] = m_tree.first_hit(source, direction, face);
    }
  }

  const Flat_mesh& m_mesh;
  const Ray_tree m_tree;
  std::vector<std::size_t> m_first; // of a region in the next; and the end
  std::vector<Face_at_distance> m_faces;
  const std::array<Spirals, faces_per_region> m_spirals;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_INWARD_RAYS_H
