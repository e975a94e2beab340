// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_MESH_PATCHES_H
#define CGAL_REGION_SEGMENTATION_MESH_PATCHES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Intrinsic_frame.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

namespace internal {
template <typename ConcurrencyTag>
class Patch_builder;
}

/// \ingroup PkgRegionSegmentationData
/// A partition of elements, the faces of a mesh or smaller patches, into connected patches, and the adjacency of these.
class Patches
{
public:
  using Index = Partition::Index;

  struct Patch
  {
    Double_3 centroid; ///< the mean of the centroids of its faces, by area
    Double_3 normal;   ///< the mean normal by area, of length 1, or zero
    double area;
    /// The element whose centroid is nearest to that of the patch, not a degenerate face if possible; of several, that of the
    /// lowest position.
    Index center;
  };

  /// Two adjacent patches, and the length of the edges between them that are not constrained.
  struct Adjacency
  {
    Index lower, higher;
    double length;
  };

  std::size_t size() const { return m_patches.size(); }
  const Patch& operator[](std::size_t patch) const { return m_patches[patch]; }
  /// The patch of each element. Unlike other partitions it is numbered by the positions of patches.
  const Partition& of_elements() const { return m_of_elements; }
  /// By the lower, then by the higher patch.
  const internal::Large_array<Adjacency>& adjacencies() const { return m_adjacencies; }

  /// The angle between the normals of two adjacent patches, in radians, if they face each other, else 0; 0, too, if one has no
  /// normal. `i`: of their adjacency
  double concave_deviation(std::size_t i) const { return m_concave_deviations[i]; }

private:
  template <typename ConcurrencyTag>
  friend class internal::Patch_builder;

  Partition m_of_elements;
  internal::Large_array<Patch> m_patches;
  internal::Large_array<Adjacency> m_adjacencies;
  internal::Large_array<double> m_concave_deviations; // by adjacency
};

/// \ingroup PkgRegionSegmentationData
/// Two partitions of the faces of a mesh into small flat patches, a fine one and a coarse one of its patches: what stages work on
/// whose cost must not grow with the resolution of the mesh.
///
/// The *position* of a patch is where its centroid lies along a direction that depends on the shape of the surface alone, see
/// `internal::Intrinsic_frame`. Steps, areas, and the distances of centers are compared as numbers of 13 significant bits (see
/// `internal::coarse_bits()`), so that those that are equal but for rounding are equal.
///
/// Patches are connected, and not joined across constrained edges. At first each face is a patch; then patches are
/// joined in rounds:
/// -# Each patch selects the adjacent patch with the smallest step
///    \f$|c_i - c_j| / \sqrt{A} + w \, |n_i - n_j|\f$, among those with which its area is at most
///    `maximum_area`; of several, that of the lowest position. \f$c\f$ are the centroids, \f$n\f$ the unit normals (zero for a
///    degenerate face), \f$A\f$ the area of the surface.
/// -# The selections form trees. A root is a patch that selects none, or of two that select each other the larger one by
///    area, of equal ones that of the lower position. A patch of odd depth is joined to its parent, and a leaf of even depth to its
///    grandparent; the others of even depth, the root (of depth 0) among them, keep what is joined to them.
/// -# Joined patches are numbered by the lowest one of each. The centroid of a union is the mean of the centroids,
///    weighted by area (without area, that of the lowest one); its normal is the sum of the normals of its faces, weighted by area, scaled to length 1
///    (zero where it is below 1e-9 of the area).
///
/// Rounds end when one joins none of `n` patches, or has joined less than `n / 32` (rounded down). Then the coarse patches are made
/// of the fine ones in the same way, with `maximum_coarse_area`. So a mesh of few large faces has a patch for each face, and a fine one
/// some twenty to sixty thousand patches and four to five thousand coarse ones. In the end both are numbered by their positions. They do
/// not depend on motion, scale, and the numbering of faces and vertices, except where two patches have one position, or the
/// symmetries of the surface leave a choice of the direction: then another choice gives what a symmetry makes of it.
///
/// Complexity: O(F) in practice. Deterministic. Parallel with `Parallel_tag`, with bitwise equal results.
class Mesh_patches : public Patches
{
public:
  static constexpr double maximum_area = 1. / 60000;       ///< of two patches that are joined, share of the surface
  static constexpr double maximum_coarse_area = 1. / 4000; ///< of two coarse patches that are joined
  static constexpr double deviation_weight = 0.4;          ///< w, relative length per radian

  Mesh_patches() = default;
  explicit Mesh_patches(Patches fine, Patches coarse = Patches(),
                        const internal::Intrinsic_frame& frame = internal::Intrinsic_frame())
    : Patches(std::move(fine)), m_coarse(std::move(coarse)), m_frame(frame)
  {}

  /// The patch of each face.
  const Partition& of_faces() const { return of_elements(); }
  /// The coarse patches: their elements are the patches.
  const Patches& coarse() const { return m_coarse; }
  /// In which positions are measured.
  const internal::Intrinsic_frame& frame() const { return m_frame; }

private:
  Patches m_coarse;
  internal::Intrinsic_frame m_frame;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_MESH_PATCHES_H
