// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_FIND_COMMON_SURFACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_FIND_COMMON_SURFACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

constexpr double tolerances_of_common_surfaces = 10;

/// For each of n things, the first one that it is equal to, of those that are equal to no earlier
/// one.
template <typename Are_equal>
std::vector<Partition::Index> first_equal_ones(std::size_t n, const Are_equal& are_equal)
{
  std::vector<Partition::Index> result, firsts;
  for (Partition::Index i = 0; i < n; ++i) {
    const auto first = std::find_if(firsts.begin(), firsts.end(),
                                    [&](Partition::Index j) { return are_equal(j, i); });
    result.push_back(first == firsts.end() ? i : *first);
    if (first == firsts.end())
      firsts.push_back(i);
  }
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// finds the faces of a machine part that lie on one surface, such as those that a groove
/// separates.
///
/// \returns for each face the first one on the same surface, which may be itself: the vertices of
///          one of the two lie on the surface of the other, within 10 times `faces.tolerance`. A
///          freeform face is alone.
///
/// Complexity: O(F + n m) in practice, n faces on m surfaces.
inline std::vector<Partition::Index> find_common_surfaces(const Surface& surface,
                                                          const Surface_faces& faces)
{
  const double tolerance = internal::tolerances_of_common_surfaces * faces.tolerance;
  std::vector<std::vector<Surface::Index>> facets(faces.surfaces.size());
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    facets[faces.partition[f]].push_back(f);
  const std::vector<internal::Surface_distance> distances(faces.surfaces.begin(),
                                                          faces.surfaces.end());
  const auto lies_on = [&](std::size_t part, std::size_t other) {
    const internal::Surface_distance& distance = distances[other];
    return std::all_of(facets[part].begin(), facets[part].end(), [&](Surface::Index f) {
      for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
        if (std::fabs(distance(surface.point(surface.corner(f, i)))) > tolerance)
          return false;
      return true;
    });
  };
  return internal::first_equal_ones(faces.surfaces.size(), [&](std::size_t i, std::size_t j) {
    const Fitted_surface<>&s = faces.surfaces[i], &t = faces.surfaces[j];
    return s.kind == t.kind && s.kind != Surface_kind::FREEFORM && (lies_on(j, i) || lies_on(i, j));
  });
}

/// \ingroup PkgRegionSegmentationSegments
/// finds the cylinders, cones and tori of a machine part that have one axis.
///
/// \returns for each face the first one with the same axis, which may be itself: where one of the
///          two faces begins and ends along its axis, it is within 10 times `faces.tolerance` of
///          the axis of the other. A face of another kind is alone.
///
/// Complexity: O(n m), n faces with m axes.
inline std::vector<Partition::Index> find_common_axes(const Surface_faces& faces)
{
  const double tolerance = internal::tolerances_of_common_surfaces * faces.tolerance;
  const auto is_on_axis = [&](const Fitted_surface<>& s, const Fitted_surface<>& of) {
    const auto distance = [&](double z) {
      return internal::meridian_point(of, s.point + z * s.direction).r;
    };
    return distance(s.lowest) <= tolerance && distance(s.highest) <= tolerance;
  };
  return internal::first_equal_ones(faces.surfaces.size(), [&](std::size_t i, std::size_t j) {
    const Fitted_surface<>&s = faces.surfaces[i], &t = faces.surfaces[j];
    return s.has_axis() && t.has_axis() && is_on_axis(s, t) && is_on_axis(t, s);
  });
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_FIND_COMMON_SURFACES_H
