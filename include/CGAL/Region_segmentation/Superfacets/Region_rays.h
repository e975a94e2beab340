// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_REGION_RAYS_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_REGION_RAYS_H

#include <CGAL/Region_segmentation/Graph/Patches.h>
#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Superfacets/internal/Ray_tree.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
/// \ingroup PkgRegionSegmentationParts
/// A ray into the body that hits a face.
struct Inward_ray
{
  Surface::Index source, hit; ///< faces
  double distance;            ///< in units of the surface
  double weight;              ///< the share of the area of the surface that it stands for
};

namespace internal {

/// Casts the rays that `Visibility_annotator` describes from regions of the faces, each a union of
/// fine patches.
class Inward_rays
{
  using Index = Surface::Index;

public:
  static constexpr std::size_t faces_per_region = 3, rays_per_region = 12;

  /// The number of rays that a region of a share of the area of the surface casts. Small regions
  /// cast one or none, so that thousands of components cast less than 12 * 6,400 + 25,600 rays
  /// together.
  static std::size_t number_of_rays(double share)
  {
    constexpr double smallest_of_all_rays = 1. / 6400, smallest_of_a_ray = 1. / 25600;
    return share < smallest_of_a_ray ? 0 : share < smallest_of_all_rays ? 1 : rays_per_region;
  }

  Inward_rays(const Surface& mesh, const Surface_patches& patches, const Partition& regions)
    : m_mesh(mesh)
    , m_shapes(mesh, patches.fine, regions)
    , m_tree(mesh, patches, m_shapes.centroid(m_shapes.surface))
    , m_candidates(regions.number_of_parts(), [&](const auto& add) {
      for (std::size_t p = 0; p < patches.fine.size(); ++p) {
        const Index f = patches.fine[p].center, r = regions[f];
        add(r,
            {squared_norm(mesh.centroid(f) - m_shapes.centroid(m_shapes.regions[r].moments)), f});
      }
    })
  {
    std::size_t rays = 1;
    for (const Region_shape& region : m_shapes.regions)
      rays += number_of_rays(region.moments.weight);
    m_visits_of_ray = most_visits / rays;
  }

  /// The rays that hit a face, by region. Can be called once.
  std::vector<Inward_ray> trace(const Execution& execution)
  {
    std::vector<std::array<Inward_ray, rays_per_region>> rays(m_candidates.number_of_groups());
    for_each_block(
      execution, rays.size(),
      [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
          rays[r] = rays_of(r);
      },
      16);
    std::vector<Inward_ray> result;
    for (const auto& rays_of_region : rays)
      std::copy_if(rays_of_region.begin(), rays_of_region.end(), std::back_inserter(result),
                   [](const Inward_ray& ray) { return ray.hit != Ray_tree::no_face; });
    return result;
  }

private:
  /// Of nodes of the tree, by all rays together: a bound of the time where thousands of triangles
  /// overlap.
  static constexpr std::size_t most_visits = std::size_t(1) << 26;

  /// The squared distance of its centroid to that of its region, and the face.
  using Candidate = std::pair<double, Index>;

  /// Rays that are not cast hit none.
  std::array<Inward_ray, rays_per_region> rays_of(std::size_t region)
  {
    const double share = m_shapes.regions[region].moments.weight;
    auto [begin, end] = m_candidates[region];
    const std::size_t number = number_of_rays(share), size = std::size_t(end - begin),
                      samples = number < rays_per_region ? 1 : (std::min)(size, faces_per_region),
                      rays_of_sample = rays_per_region / samples;
    std::array<Inward_ray, rays_per_region> rays;
    rays.fill({Surface::none, Ray_tree::no_face, 0, number > 0 ? share / double(number) : 0});
    auto first = begin;
    for (std::size_t k = 0; k * rays_of_sample < number; ++k) {
      const auto sample = begin + k * size * 9 / (10 * samples);
      std::nth_element(std::exchange(first, sample), sample, end);
      const std::size_t i = k * rays_of_sample;
      trace(sample->second, k, rays_of_sample, rays.data() + i,
            rays.data() + (std::min)(i + rays_of_sample, number));
    }
    return rays;
  }

  /// Traces the first ones of the `rays` of the candidate `k`, from `ray` to `end`: directions
  /// around the inward normal, on a spiral of the golden angle, turned from candidate to candidate.
  void trace(Index face, std::size_t k, std::size_t rays, Inward_ray* ray,
             const Inward_ray* end) const
  {
    constexpr double golden_angle = 2.399963229728653, half_cone = 0.9; // radian
    if (m_mesh.is_degenerate(face))
      return;
    const Double_3 source = m_mesh.centroid(face), inward = -1.0 * m_mesh.normal(face);
    const Double_3 u = start_of_spiral(face, source, inward), v = cross(inward, u);
    for (std::size_t i = 0; ray != end; ++i, ++ray) {
      const double away = half_cone * std::sqrt(double(i) / double(rays - 1)),
                   around = golden_angle * double(i) + double(k);
      const Double_3 aside = std::cos(around) * u + std::sin(around) * v;
      const Ray_tree::Hit hit = m_tree.first_hit(
        source, std::cos(away) * inward + std::sin(away) * aside, face, m_visits_of_ray);
      ray->source = face;
      ray->hit = hit.face;
      ray->distance = hit.distance;
    }
  }

  /// A unit vector in the plane of a face: away from the centroid of the surface; or, where the
  /// face is orthogonal to that, to its first corner.
  Double_3 start_of_spiral(Index face, const Double_3& source, const Double_3& inward) const
  {
    constexpr double smallest_part = 1e-3; // in the plane
    const auto in_plane = [&](const Double_3& v) { return v - dot(v, inward) * inward; };
    const Double_3 away = source - m_shapes.centroid(m_shapes.surface);
    Double_3 u = in_plane(away);
    if (!(norm(u) > smallest_part * norm(away)))
      u = in_plane(m_mesh.point(m_mesh.corner(face, 0)) - source);
    return (1 / norm(u)) * u;
  }

  const Surface& m_mesh;
  const Region_shapes m_shapes; // of the regions
  const Ray_tree m_tree;
  Grouped_items<Candidate> m_candidates; // faces from which rays start, by region
  std::size_t m_visits_of_ray;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationParts
/// The rays of a surface, see `Visibility_annotator`, and the shapes of regions.
struct Region_rays
{
  const std::vector<Inward_ray>& rays; ///< none of a surface without area
  Region_shapes shapes;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_REGION_RAYS_H
