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
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The rays that `Visibility_annotator` casts from every region into the body.
///
/// Bytes, while they are traced: 16 per patch, and per face of the regions without the center of a
/// patch; 208 per region.
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

  /// The hits of the rays of a region; those of degenerate faces, which cast none, hit none.
  using Hits = std::array<Ray_tree::Hit, rays_per_region>;

  /// `shapes`: of the regions; `tree`: of the mesh
  Inward_rays(const Surface& mesh, const Patches& patches, const Partition& regions,
              const Region_shapes& shapes, const Ray_tree& tree)
    : m_mesh(mesh)
    , m_patches(patches)
    , m_regions(regions)
    , m_shapes(shapes)
    , m_tree(tree)
    , m_spirals{make_spirals(1), make_spirals(2), make_spirals(3)}
  {}

  /// The hits by region. Can be called once.
  std::vector<Hits> trace(const Execution& execution)
  {
    group_faces();
    std::vector<Hits> hits(m_regions.number_of_parts());
    std::size_t rays = 1;
    for (const Region_shape& region : m_shapes.regions)
      rays += number_of_rays(region.area / m_mesh.area());
    m_visits_of_ray = most_visits / rays;
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
  /// Of nodes and leaves of the tree, by all rays together: a bound of the time where thousands of
  /// triangles overlap. (Of 5,760 rays none took more than 352 on meshes of 300 to 50,000 faces.)
  static constexpr std::size_t most_visits = std::size_t(1) << 25;

  using Face_at_distance = std::pair<double, Index>; // to the centroid of its region, squared

  /// A direction around the inward normal of a face: the angles away from it, and around it.
  struct Spiral
  {
    double cos_away, sin_away, cos_around, sin_around;
  };
  using Spirals = std::array<Spiral, rays_per_region>;

  /// The directions of the rays of a region, by the number of faces that they start from: on a
  /// spiral of the golden angle, turned from face to face.
  static Spirals make_spirals(std::size_t samples)
  {
    constexpr double golden_angle = 2.399963229728653, half_cone = 0.9; // radian
    static_assert(rays_per_region % 6 == 0 && faces_per_region == 3, "1, 2 or 3 faces share them");
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

  /// The faces at the centers of patches; all faces of a region that contains no such center.
  void group_faces()
  {
    std::vector<bool> wants_all(m_regions.number_of_parts(), true);
    for (std::size_t p = 0; p < m_patches.size(); ++p)
      wants_all[m_regions[m_patches[p].center]] = false;
    const bool any_wants_all = std::find(wants_all.begin(), wants_all.end(), true) !=
                               wants_all.end();
    m_faces = Grouped_items<Face_at_distance>(m_regions.number_of_parts(), [&](const auto& add) {
      const auto add_face = [&](std::size_t face) {
        const Index r = m_regions[face];
        add(r, {squared_norm(m_mesh.centroid(face) - m_shapes.regions[r].centroid), Index(face)});
      };
      for (std::size_t p = 0; p < m_patches.size(); ++p)
        add_face(m_patches[p].center);
      for (std::size_t face = 0; any_wants_all && face < m_regions.size(); ++face)
        if (wants_all[m_regions[face]])
          add_face(face);
    });
  }

  Hits hits_of(std::size_t region)
  {
    Hits hits;
    hits.fill({Ray_tree::no_face, 0});
    auto [begin, end] = m_faces[region];
    const std::size_t number = number_of_rays(m_shapes.regions[region].area / m_mesh.area());
    if (number < rays_per_region) {
      trace_from(std::min_element(begin, end)->second, m_spirals[0].data(), number, hits.data());
      return hits;
    }
    const std::size_t size = std::size_t(end - begin), samples = (std::min)(size, faces_per_region);
    const std::size_t rays_per_face = rays_per_region / samples;
    for (std::size_t k = samples; k-- > 0;) {
      // Faces behind a place in the order are not needed for those before it.
      const auto sample = begin + k * size * 9 / (10 * samples);
      std::nth_element(begin, sample, end);
      end = sample;
      const std::size_t first = k * rays_per_face;
      trace_from(sample->second, m_spirals[samples - 1].data() + first, rays_per_face,
                 hits.data() + first);
    }
    return hits;
  }

  void trace_from(Index face, const Spiral* spirals, std::size_t number, Ray_tree::Hit* hits) const
  {
    if (m_mesh.is_degenerate(face))
      return;
    const Double_3 source = m_mesh.centroid(face), inward = -1.0 * m_mesh.normal(face);
    const Double_3 u = start_of_spiral(face, source, inward), v = cross(inward, u);
    for (std::size_t i = 0; i < number; ++i) {
      const Spiral& s = spirals[i];
      const Double_3 direction = s.cos_away * inward +
                                 s.sin_away * (s.cos_around * u + s.sin_around * v);
      hits[i] = m_tree.first_hit(m_mesh, source, direction, face, m_visits_of_ray);
    }
  }

  /// A unit vector in the plane of a face that depends on the shape of the surface alone: away from
  /// its centroid; or, where the face is orthogonal to that, to its corner farthest from its own
  /// centroid.
  Double_3 start_of_spiral(Index face, const Double_3& source, const Double_3& inward) const
  {
    constexpr double smallest_part = 1e-3; // in the plane
    const auto in_plane = [&](const Double_3& v) { return v - dot(v, inward) * inward; };
    const Double_3 away = source - m_shapes.surface_centroid, u = in_plane(away);
    if (const double length = norm(u); length > smallest_part * norm(away))
      return (1 / length) * u;
    Double_3 farthest{0, 0, 0};
    for (std::size_t i = 0; i < m_mesh.number_of_corners(face); ++i)
      if (const Double_3 w = in_plane(m_mesh.point(m_mesh.corner(face, i)) - source);
          squared_norm(w) > squared_norm(farthest))
        farthest = w;
    return (1 / norm(farthest)) * farthest;
  }

  const Surface& m_mesh;
  const Patches& m_patches;
  const Partition& m_regions;
  const Region_shapes& m_shapes; // of the regions
  const Ray_tree& m_tree;
  Grouped_items<Face_at_distance> m_faces; // by region
  const std::array<Spirals, faces_per_region> m_spirals;
  std::size_t m_visits_of_ray = 0;
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
    const internal::Ray_tree tree(surface, patches, m_shapes.surface_centroid,
                                  execution.step(0, 0.6));
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
