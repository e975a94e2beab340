// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/rays/Patch_triangles.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/prefetch.h>

#include <CGAL/Iterator_range.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The triangles in the leaves of a `Ray_tree`, which are patches, four by four.
///
/// Those of a mesh of few faces are stored, 40 bytes each, by coarse patches. On large meshes this would be a quarter of the memory
/// of a segmentation, for rays that meet each triangle once or never: there they are gathered from the mesh when a ray comes, by
/// fine patches.
class Ray_leaves
{
  using Index = Flat_mesh::Index;

public:
  static constexpr std::size_t most_stored_faces = std::size_t(1) << 19;

  /// `origin`, `scale`: of relative coordinates; `most_stored`: triangles of meshes of more faces are gathered
  Ray_leaves(const Flat_mesh& mesh, const Double_3& origin, double scale, std::size_t most_stored)
    : m_are_stored(mesh.number_of_faces() <= most_stored)
    , m_triangles(mesh, m_are_stored ? Patch_level::COARSE : Patch_level::FINE, origin, scale)
  {}

  const Patch_triangles& triangles() const { return m_triangles; }

  /// To be called before rays are traced.
  template <typename ConcurrencyTag>
  void store(const Flat_mesh& mesh, const Execution<ConcurrencyTag>& execution)
  {
    if (!m_are_stored)
      return;
    const std::size_t leaves = m_triangles.patches(mesh).size();
    m_first.resize(leaves + 1);
    m_first[0] = 0;
    for_each_block(execution.step(0, 0.2), leaves, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t leaf = begin; leaf < end; ++leaf)
        m_first[leaf + 1] = Index((m_triangles.number_of_triangles(mesh, leaf) + 3) / 4);
    });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_stored.resize(m_first.back());
    for_each_block(execution.step(0.2, 1), leaves, [&](std::size_t, std::size_t begin, std::size_t end) {
      Four_triangles* group = m_stored.data() + m_first[begin];
      for (std::size_t leaf = begin; leaf < end; ++leaf)
        for_each_group(mesh, leaf, [&](const Four_triangles& g) { *group++ = g; });
    }, 256);
  }

  /// A ray in a leaf.
  struct Visit
  {
    Ray* ray;
    Index leaf;
  };

  /// Intersects each ray with the triangles of its leaf. `mesh`: that of the leaves
  void intersect(const Flat_mesh& mesh, Iterator_range<const Visit*> visits) const
  {
    if (m_are_stored) {
      for (const Visit& visit : visits)
        for (const Four_triangles& group : stored(visit.leaf))
          prefetch(&group);
      for (const Visit& visit : visits)
        for (const Four_triangles& group : stored(visit.leaf))
          group.intersect(*visit.ray);
    } else {
      m_triangles.prefetch(mesh, visits, [](const Visit& visit) { return visit.leaf; });
      for (const Visit& visit : visits)
        for_each_group(mesh, visit.leaf, [&](const Four_triangles& group) { group.intersect(*visit.ray); });
    }
  }

private:
  template <typename F>
  void for_each_group(const Flat_mesh& mesh, std::size_t leaf, const F& f) const
  {
    Four_triangles group{};
    std::size_t lane = 0;
    m_triangles.for_each(mesh, leaf, [&](const std::array<Float_3, 3>& corners, Index face) {
      group.set(lane, corners, face);
      if (++lane == 4) {
        f(group);
        group = Four_triangles();
        lane = 0;
      }
    });
    if (lane > 0)
      f(group);
  }

  Iterator_range<const Four_triangles*> stored(Index leaf) const
  {
    return {m_stored.data() + m_first[leaf], m_stored.data() + m_first[leaf + 1]};
  }

  bool m_are_stored;
  Patch_triangles m_triangles;
  std::vector<Index> m_first; // by leaf: of its groups; and the end of the last one
  Large_array<Four_triangles> m_stored;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
