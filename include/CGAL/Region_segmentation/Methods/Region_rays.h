// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H
#define CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/superfacets/Ray_tree.h>
#include <CGAL/Region_segmentation/internal/superfacets/Region_shapes.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The rays that `Visibility_annotator` casts from every region into the body.
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

  /// The hits of the rays of a region; rays that are not cast hit none.
  using Hits = std::array<Ray_tree::Hit, rays_per_region>;

  /// `shapes`: of the regions; `tree`: of the mesh
  Inward_rays(const Surface& mesh, const Patches& patches, const Partition& regions,
              const Region_shapes& shapes, const Ray_tree& tree)
    : m_mesh(mesh)
    , m_shapes(shapes)
    , m_tree(tree)
  {
    std::vector<bool> has_center(regions.number_of_parts());
    for (std::size_t p = 0; p < patches.size(); ++p)
      has_center[regions[patches[p].center]] = true;
    const bool have_all = std::find(has_center.begin(), has_center.end(), false) ==
                          has_center.end();
    m_candidates = Grouped_items<Candidate>(has_center.size(), [&](const auto& add) {
      const auto add_face = [&](std::size_t f) {
        const Index r = regions[f];
        add(r, {squared_norm(mesh.centroid(f) - shapes.regions[r].centroid), Index(f)});
      };
      for (std::size_t p = 0; p < patches.size(); ++p)
        add_face(patches[p].center);
      for (std::size_t f = have_all ? regions.size() : 0; f < regions.size(); ++f)
        if (!has_center[regions[f]])
          add_face(f);
    });
    std::size_t rays = 1;
    for (const Region_shape& region : shapes.regions)
      rays += number_of_rays(region.area / mesh.area());
    m_visits_of_ray = most_visits / rays;
  }

  /// The hits by region. Can be called once.
  std::vector<Hits> trace(const Execution& execution)
  {
    std::vector<Hits> hits(m_candidates.number_of_groups());
    for_each_block(
      execution, hits.size(),
      [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
          hits[r] = hits_of(r);
      },
      16);
    return hits;
  }

private:
  /// Of nodes of the tree, by all rays together: a bound of the time where thousands of triangles
  /// overlap.
  static constexpr std::size_t most_visits = std::size_t(1) << 26;

  /// The squared distance of its centroid to that of its region, and the face.
  using Candidate = std::pair<double, Index>;

  Hits hits_of(std::size_t region)
  {
    Hits hits;
    hits.fill({Ray_tree::no_face, 0});
    auto [begin, end] = m_candidates[region];
    const std::size_t number = number_of_rays(m_shapes.regions[region].area / m_mesh.area()),
                      size = std::size_t(end - begin),
                      samples = number < rays_per_region ? 1 : (std::min)(size, faces_per_region),
                      rays_of_sample = rays_per_region / samples;
    auto first = begin;
    for (std::size_t k = 0; k * rays_of_sample < number; ++k) {
      const auto sample = begin + k * size * 9 / (10 * samples);
      std::nth_element(std::exchange(first, sample), sample, end);
      const std::size_t i = k * rays_of_sample;
      trace(sample->second, k, rays_of_sample, hits.data() + i,
            hits.data() + (std::min)(i + rays_of_sample, number));
    }
    return hits;
  }

  /// Traces the first ones of the `rays` of the candidate `k`, from `hit` to `end`: directions
  /// around the inward normal, on a spiral of the golden angle, turned from candidate to candidate.
  void trace(Index face, std::size_t k, std::size_t rays, Ray_tree::Hit* hit,
             const Ray_tree::Hit* end) const
  {
    constexpr double golden_angle = 2.399963229728653, half_cone = 0.9; // radian
    if (m_mesh.is_degenerate(face))
      return;
    const Double_3 source = m_mesh.centroid(face), inward = -1.0 * m_mesh.normal(face);
    const Double_3 u = start_of_spiral(face, source, inward), v = cross(inward, u);
    for (std::size_t i = 0; hit != end; ++i) {
      const double away = half_cone * std::sqrt(double(i) / double(rays - 1)),
                   around = golden_angle * double(i) + double(k);
      const Double_3 aside = std::cos(around) * u + std::sin(around) * v;
      *hit++ = m_tree.first_hit(source, std::cos(away) * inward + std::sin(away) * aside, face,
                                m_visits_of_ray);
    }
  }

  /// A unit vector in the plane of a face: away from the centroid of the surface; or, where the
  /// face is orthogonal to that, to its first corner.
  Double_3 start_of_spiral(Index face, const Double_3& source, const Double_3& inward) const
  {
    constexpr double smallest_part = 1e-3; // in the plane
    const auto in_plane = [&](const Double_3& v) { return v - dot(v, inward) * inward; };
    const Double_3 away = source - m_shapes.surface_centroid;
    Double_3 u = in_plane(away);
    if (!(norm(u) > smallest_part * norm(away)))
      u = in_plane(m_mesh.point(m_mesh.corner(face, 0)) - source);
    return (1 / norm(u)) * u;
  }

  const Surface& m_mesh;
  const Region_shapes& m_shapes; // of the regions
  const Ray_tree& m_tree;
  Grouped_items<Candidate> m_candidates; // faces from which rays start, by region
  std::size_t m_visits_of_ray;
};

} // namespace internal

/// \ingroup PkgRegionSegmentationParts
/// The rays that regions of a surface cast into the body, see `Visibility_annotator`, and where
/// they end.
class Region_rays
{
public:
  using Hits = internal::Inward_rays::Hits;

  Region_rays() = default;

  /// Makes the tree that finds hits, and traces the rays of all regions.
  Region_rays(const Surface& surface, const Surface_patches& patches, const Partition& regions,
              const Execution& execution = Execution())
  {
    if (surface.area() == 0)
      return;
    m_shapes = internal::Region_shapes(surface, regions, execution);
    const internal::Ray_tree tree(surface, patches, m_shapes.surface_centroid);
    execution.report(0.6);
    m_hits = internal::Inward_rays(surface, patches.fine, regions, m_shapes, tree)
               .trace(execution.step(0.6, 1));
  }

  /// By region; none of a surface without area.
  const std::vector<Hits>& hits() const { return m_hits; }
  /// The shapes of the regions; none of a surface without area.
  const internal::Region_shapes& shapes() const { return m_shapes; }

private:
  internal::Region_shapes m_shapes;
  std::vector<Hits> m_hits;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_REGION_RAYS_H
