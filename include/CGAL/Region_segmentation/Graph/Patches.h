// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_PATCHES_H
#define CGAL_REGION_SEGMENTATION_GRAPH_PATCHES_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Support/Partition.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

namespace internal {
class Patch_builder;
} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// A partition of elements, the faces of a mesh or smaller patches, into connected patches, and the
/// adjacency of these.
class Patches
{
public:
  using Index = Partition::Index;

  struct Patch
  {
    Double_3 centroid; ///< the mean of the centroids of its faces, weighted by area
    Double_3 normal;   ///< the mean of the normals of its faces, weighted by area: of length 1, or
                       ///< zero
    double area;
    /// The element whose centroid is nearest to that of the patch, not a degenerate face if
    /// possible; of several, the lower one.
    Index center;
  };

  /// Two patches that are adjacent across edges, seams or links, and the length of these.
  struct Adjacency
  {
    Index lower, higher;
    double length;
  };

  std::size_t size() const { return m_patches.size(); }
  const Patch& operator[](std::size_t patch) const { return m_patches[patch]; }
  /// The patch of each element.
  const Partition& of_elements() const { return m_of_elements; }
  /// The adjacencies across edges, sorted by the lower, then by the higher patch.
  const Large_array<Adjacency>& adjacencies() const { return m_adjacencies; }
  /// The adjacencies across seams and links, in the same order.
  const Large_array<Adjacency>& contacts() const { return m_contacts; }

  /// The adjacencies of the surface between two patches of its faces, in order.
  const Large_array<Index>& borders() const { return m_borders; }

  /// The angle between the normals of two adjacent patches, in radians, if they face each other;
  /// else, or if one of them has no normal, 0.
  double concave_deviation(const Adjacency& adjacency) const
  {
    const Patch &a = m_patches[adjacency.lower], &b = m_patches[adjacency.higher];
    if (!(dot(b.normal - a.normal, b.centroid - a.centroid) < 0) || squared_norm(a.normal) == 0 ||
        squared_norm(b.normal) == 0)
      return 0;
    return std::acos((std::max)(-1.0, (std::min)(1.0, dot(a.normal, b.normal))));
  }

private:
  friend class internal::Patch_builder;

  Partition m_of_elements;
  Large_array<Patch> m_patches;
  Large_array<Adjacency> m_adjacencies, m_contacts;
  Large_array<Index> m_borders;
};

/// \ingroup PkgRegionSegmentationData
/// Two partitions of the faces of a mesh into small flat patches, a fine one and a coarse one of
/// its patches: what stages work on whose cost must not grow with the resolution of the mesh.
///
/// Patches are connected across edges. At first each face, in order, joins a patch of lower faces
/// that are adjacent to it: the one whose first face is nearest, of several that of the lowest of
/// these faces, among those with which
/// - the centroid of the first face is less than `maximum_radius` \f$\sqrt{A}\f$ away, \f$A\f$ the
///   area of the surface,
/// - the unit normal of the first face differs by a vector of length at most `maximum_deviation`,
/// and
/// - its area is at most `maximum_area`.
///
/// A face without such a patch begins one. Then patches are joined in rounds:
/// -# Each patch selects the adjacent patch with the smallest step
///    \f$|c_i - c_j| / \sqrt{A} + w \, |n_i - n_j|\f$, rounded to `float`, among those with which
///    its area is at most `maximum_area`; of several, the lower one. \f$c\f$ are the centroids,
///    \f$n\f$ the unit normals (zero for a degenerate face).
/// -# The selections form trees. A root is a patch that selects none, or the larger one by area of
///    two that select each other, of equal ones the lower one. A patch of odd depth is joined to
///    its parent, and a leaf of even depth to its grandparent; the others of even depth, the root
///    (of depth 0) among them, keep what is joined to them.
/// -# Joined patches are numbered by the lowest one of each. The centroid of a union is the mean of
///    the centroids, weighted by area (without area, that of the lowest one); its normal is the sum
///    of the normals of its faces, weighted by area, scaled to length 1.
///
/// Rounds end when one joins none of `n` patches, or has joined less than `n / 32` (rounded down).
/// Then the coarse patches are made of the fine ones in the same way, with `maximum_coarse_area`.
/// So a mesh of few large faces has a patch for each face, and a fine one some twenty to sixty
/// thousand patches and four to five thousand coarse ones. They depend on the order of faces that
/// are smaller than `maximum_radius`, but not on that of others and of vertices, ties excepted.
///
/// Complexity: O(F) in practice. Deterministic.
struct Surface_patches
{
  static constexpr double maximum_area = 1. / 60000; ///< of two patches that are joined, share of
                                                     ///< the surface
  static constexpr double maximum_radius = 0.0015;   ///< relative length
  static constexpr double maximum_deviation = 0.06;
  static constexpr double maximum_coarse_area = 1. / 4000; ///< of two coarse patches that are
                                                           ///< joined
  static constexpr double deviation_weight = 0.4;          ///< w, relative length per radian

  Patches fine;   ///< their elements are the faces
  Patches coarse; ///< their elements are the fine patches
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_PATCHES_H
