// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/for_each_in_part.h>
#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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

/// The triangles (polygons as fans) of the leaves of a `Ray_tree`, which are patches.
///
/// Those of a mesh of few faces are stored four by four, 40 bytes each, by coarse patches (gathered
/// for each ray, tree and rays take 1.26 times as long at 3,000 faces, 1.28 times at 28,000, 1.9
/// times at 160,000). On large meshes this would be a quarter of the memory of a segmentation, for
/// rays that meet each triangle once or never: there they are gathered from the mesh, by fine
/// patches. Else 10 bytes a face.
class Ray_leaves
{
  using Index = Surface::Index;
  using Box = Axis_box;

public:
  static constexpr std::size_t most_stored_faces = std::size_t(1) << 19;

  /// `origin`, `scale`: of the relative coordinates; `most_stored`: triangles of meshes of more
  /// faces are gathered
  Ray_leaves(const Surface& mesh, const Surface_patches& patches, const Double_3& origin,
             double scale, std::size_t most_stored, const Execution& execution)
    : m_origin(origin)
    , m_scale(scale)
    , m_points(mesh.number_of_vertices())
  {
    const bool are_stored = mesh.number_of_faces() <= most_stored;
    const Leaf_of_face leaf_of_face(patches, are_stored);
    for_each_index(execution, m_points.size(),
                   [&](std::size_t v) { m_points[v] = relative(mesh.point(v)); });
    find_boxes(mesh, leaf_of_face, execution);
    m_faces = Grouped_items<Index>(leaf_of_face.number_of_parts(), [&](const auto& add) {
      for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
        if (!mesh.is_crumb(f)) // rays pass through crumbs
          add(leaf_of_face[f], Index(f));
    });
    if (are_stored)
      store(mesh);
  }

  std::size_t size() const { return m_faces.number_of_groups(); }

  Float_3 relative(const Double_3& point) const
  {
    const Double_3 v = m_scale * (point - m_origin);
    return {float(v.x), float(v.y), float(v.z)};
  }

  /// Around the corners of the faces of each leaf. Can be called once.
  std::vector<Box> take_boxes() { return std::move(m_boxes); }

  /// Calls `f(p, q, r, face)` for the triangles of a leaf: the first corner of a fan, and two
  /// others.
  template <typename F>
  void for_each_triangle(const Surface& mesh, std::size_t leaf, const F& f) const
  {
    for (const Index face : m_faces[leaf]) {
      const std::size_t n = mesh.number_of_corners(face), first = first_of_fan(mesh, face);
      const auto corner = [&](std::size_t i) -> const Float_3& {
        return m_points[mesh.corner(face, i < n ? i : i - n)];
      };
      for (std::size_t i = 1; i + 1 < n; ++i)
        f(corner(first), corner(first + i), corner(first + i + 1), face);
    }
  }

  /// Intersects a ray with the triangles of a leaf. `mesh`: that of the leaves
  void intersect(const Surface& mesh, std::size_t leaf, Ray& ray) const
  {
    if (m_stored.empty())
      for_each_group(mesh, leaf, [&](const Four_triangles& group) { group.intersect(ray); });
    else
      for (std::size_t i = m_first[leaf]; i < m_first[leaf + 1]; ++i)
        m_stored[i].intersect(ray);
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

  void store(const Surface& mesh)
  {
    m_stored.reserve(mesh.number_of_faces() / 4 + size());
    for (std::size_t leaf = 0; leaf < size(); ++leaf) {
      m_first.push_back(Index(m_stored.size()));
      for_each_group(mesh, leaf, [&](const Four_triangles& group) { m_stored.push_back(group); });
    }
    m_first.push_back(Index(m_stored.size()));
  }

  template <typename F>
  void for_each_group(const Surface& mesh, std::size_t leaf, const F& f) const
  {
    Four_triangles group;
    std::size_t lane = 0;
    for_each_triangle(mesh, leaf,
                      [&](const Float_3& p, const Float_3& q, const Float_3& r, Index face) {
                        group.set(lane, p, q, r, face);
                        if (++lane == 4) {
                          f(group);
                          group = Four_triangles();
                          lane = 0;
                        }
                      });
    if (lane > 0)
      f(group);
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
  std::vector<Index> m_first;    // by leaf: of its stored groups; and the end of the last one
  Large_array<Four_triangles> m_stored;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
