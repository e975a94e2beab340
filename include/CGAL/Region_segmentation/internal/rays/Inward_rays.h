// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_INWARD_RAYS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_INWARD_RAYS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/rays/Ray_tree.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The rays that `Visibility_annotator` casts from every region into the body.
///
/// Bytes, while they are traced: 16 per face, 304 per region.
class Inward_rays
{
  using Index = Flat_mesh::Index;

public:
  static constexpr std::size_t faces_per_region = 3, rays_per_region = 18;

  /// The hits of the rays of a region.
  using Hits = std::array<Ray_tree::Hit, rays_per_region>;

  /// `centroids`: of the regions; `tree`: of the mesh
  /// \pre the mesh was read with its points and centroids
  Inward_rays(const Flat_mesh& mesh, const Partition& regions, const std::vector<Double_3>& centroids,
              const Ray_tree& tree)
    : m_mesh(mesh)
    , m_regions(regions)
    , m_centroids(centroids)
    , m_tree(tree)
    , m_faces(regions.number_of_parts())
    , m_spirals{make_spirals(1), make_spirals(2), make_spirals(3)}
  {}

  /// Computes the missing hits of regions. Can be called once.
  template <typename ConcurrencyTag>
  void trace(std::vector<std::optional<Hits>>& hits, const Execution<ConcurrencyTag>& execution)
  {
    group_faces(hits);
    for_each_block(
      execution, hits.size(),
      [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
          if (!hits[r])
            hits[r] = hits_of(r);
      },
      16);
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

  /// Of those regions of which hits are missing.
  void group_faces(const std::vector<std::optional<Hits>>& hits)
  {
    for (Index r : m_regions)
      if (!hits[r])
        m_faces.count(r);
    m_faces.end_counting();
    for (std::size_t f = 0; f < m_regions.size(); ++f)
      if (const Index r = m_regions[f]; !hits[r])
        m_faces.add(r, {squared_norm(m_mesh.centroid(f) - m_centroids[r]), Index(f)});
  }

  Hits hits_of(std::size_t region)
  {
    Hits hits;
    hits.fill({Ray_tree::no_face, 0});
    auto [begin, end] = m_faces[region];
    const std::size_t size = std::size_t(end - begin);
    const std::size_t samples = (std::min)(size, faces_per_region);
    const Spirals& spirals = m_spirals[samples - 1];
    const std::size_t rays = rays_per_region / samples; // of a face
    for (std::size_t k = samples; k-- > 0;) {
      // Faces behind a place in the order are not needed for those before it.
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
    const Double_3 source = m_mesh.centroid(face), inward = -1.0 * m_mesh.normal(face);
    const Mesh_points& points = m_mesh.points();
    const Double_3 along = points[points.corner(face, 1)] - points[points.corner(face, 0)];
    const Double_3 in_plane = along - dot(along, inward) * inward;
    const double length = norm(in_plane);
    const Double_3 u = length > 0 ? (1 / length) * in_plane : in_plane, v = cross(inward, u);
    for (std::size_t i = 0; i < number; ++i) {
      const Spiral& s = spirals[i];
      const Double_3 direction =
        length > 0 ? s.cos_away * inward + s.sin_away * (s.cos_around * u + s.sin_around * v) : inward;
      hits[i] = m_tree.first_hit(source, direction, face);
    }
  }

  const Flat_mesh& m_mesh;
  const Partition& m_regions;
  const std::vector<Double_3>& m_centroids; // of the regions
  const Ray_tree& m_tree;
  Grouped_items<Face_at_distance> m_faces; // by region
  const std::array<Spirals, faces_per_region> m_spirals;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_INWARD_RAYS_H
