// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/rays/Box_partition.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/rays/Patch_triangles.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/prefetch.h>

#include <CGAL/Iterator_range.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The triangles in the leaves of a `Ray_tree`, four by four.
///
/// Those of a mesh of few faces are stored, 40 bytes each. On large meshes this would be a quarter of the memory of a
/// segmentation, for rays that meet each triangle once or never: there a leaf is a patch, whose triangles are
/// gathered from the mesh when a ray comes.
class Ray_leaves
{
  using Index = Flat_mesh::Index;

public:
  using Name = Box_partition::Name; ///< of a patch

  static constexpr std::size_t most_stored_faces = std::size_t(1) << 19;

  /// `most_stored`: triangles of meshes of more faces are gathered
  Ray_leaves(const Flat_mesh& mesh, Patch_triangles triangles, std::size_t most_stored)
    : m_triangles(std::move(triangles)), m_are_stored(mesh.number_of_faces() <= most_stored), m_first(1, 0)
  {}

  const Patch_triangles& triangles() const { return m_triangles; }

  /// Stores the triangles of all leaves, which are ranges of boxes of patches.
  template <typename ConcurrencyTag>
  void store(const Flat_mesh& mesh, const Box_partition& boxes, const std::vector<Box_partition::Range>& leaves,
             const Execution<ConcurrencyTag>& execution)
  {
    m_first.resize(leaves.size() + 1);
    for_each_block(execution.step(0, 0.2), leaves.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t leaf = begin; leaf < end; ++leaf) {
        std::size_t triangles = 0;
        for (const Name patch : patches_of(boxes, leaves[leaf]))
          triangles += m_triangles.number_of_triangles(mesh, patch);
        m_first[leaf + 1] = Index((triangles + 3) / 4);
      }
    });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_stored.resize(m_first.back());
    for_each_block(execution.step(0.2, 1), leaves.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t leaf = begin; leaf < end; ++leaf) {
        const Patches patches = patches_of(boxes, leaves[leaf]);
        Four_triangles* group = m_stored.data() + m_first[leaf];
        for_each_group(mesh, patches.data(), patches.data() + patches.size(), [&](const Four_triangles& g) { *group++ = g; });
      }
    }, 256);
  }

  bool are_stored() const { return m_are_stored; }

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
        for_each_group(mesh, &visit.leaf, &visit.leaf + 1, [&](const Four_triangles& group) { group.intersect(*visit.ray); });
    }
  }

private:
  using Patches = boost::container::static_vector<Name, Box_partition::leaf_size>;

  /// Each once: several slices of a patch may be in a leaf.
  static Patches patches_of(const Box_partition& boxes, const Box_partition::Range& leaf)
  {
    Patches result;
    for (std::size_t i = leaf.first; i < leaf.last; ++i)
      if (std::find(result.begin(), result.end(), boxes.name(i)) == result.end())
        result.push_back(boxes.name(i));
    return result;
  }

  template <typename F>
  void for_each_group(const Flat_mesh& mesh, const Name* begin, const Name* end, const F& f) const
  {
    Four_triangles group{};
    std::size_t lane = 0;
    for (; begin != end; ++begin)
      m_triangles.for_each(mesh, *begin, [&](const std::array<Float_3, 3>& corners, Index face) {
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

  Patch_triangles m_triangles;
  bool m_are_stored;
  std::vector<Index> m_first; // by leaf: of its groups; and the end of the last one
  Large_array<Four_triangles> m_stored;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_RAY_LEAVES_H
