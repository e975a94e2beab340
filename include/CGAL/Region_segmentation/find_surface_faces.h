// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/faces/compete_at_borders.h>
#include <CGAL/Region_segmentation/internal/faces/find_face_roles.h>
#include <CGAL/Region_segmentation/internal/faces/find_faces_from_patches.h>
#include <CGAL/Region_segmentation/internal/faces/find_small_planes.h>
#include <CGAL/Region_segmentation/internal/faces/join_tori_to_freeform.h>
#include <CGAL/Region_segmentation/internal/faces/merge_equal_surfaces.h>
#include <CGAL/Region_segmentation/internal/faces/separate_components.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// The surfaces of the parts, with what their faces say: deviation and extent.
inline std::vector<Fitted_surface> measured_surfaces(const Face_search& search,
                                                     const Partition& partition)
{
  const Surface& surface = search.surface;
  std::vector<Fitted_surface> result;
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f) {
    const auto z = [&](std::size_t i) {
      const Fitted_surface& s = result[partition[f]];
      return dot(surface.point(surface.corner(f, i)) - s.point, s.direction);
    };
    if (partition[f] == result.size()) { // parts are numbered by their first faces
      result.push_back(search.surface_of(f));
      result.back().lowest = result.back().highest = z(0);
    }
    Fitted_surface& s = result[partition[f]];
    if (s.kind == Surface_kind::FREEFORM)
      continue;
    s.deviation = (std::max)(s.deviation, search.test.largest_distance(s, f));
    for (std::size_t i = 0; i < surface.number_of_corners(f); ++i) {
      s.lowest = (std::min)(s.lowest, z(i));
      s.highest = (std::max)(s.highest, z(i));
    }
  }
  return result;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// The faces of a machine part: a partition of the faces of its mesh, and what is known of each
/// part. Their neighbors, and which of these they meet smoothly, are a graph:
/// `build_region_adjacency_graph<Surface_face_region_data, Surface_face_section_data>()`, filled by
/// `annotate_surface_faces()`.
struct Surface_faces
{
  Partition partition;                  ///< of the faces of the mesh
  std::vector<Fitted_surface> surfaces; ///< by part, in units of the surface
  std::vector<Face_role> roles;         ///< by part
  double tolerance = 0;                 ///< that was used, in units of the surface
};

/// \ingroup PkgRegionSegmentationSegments
/// finds the faces of a machine part, each with its surface: planes, cylinders, cones, spheres,
/// tori, and freeform faces.
///
/// -# *Tolerance.* Vertices of a tessellation lie on the exact surface, to rounding: the tolerance
///    is \f$10^{-6}\f$ of the square root of the area, if at least 1/20 of the area is flat to
///    that. Otherwise it is 5 times the standard deviation of the vertices from the surfaces that
///    fit patches of 24 of them best, a low quantile of 300 patches; at most 1/100 of that root.
/// -# *Surfaces from patches.* From each face that is not found yet, the largest first, a patch of
///    neighbors is collected. The simplest surface on which its vertices lie grows over all faces
///    that lie on it, and is fitted again whenever their number has doubled. Smaller patches
///    follow, then planes of few vertices.
/// -# *Competition.* Neighbors of which one's surface is also that of the other are one; faces at
///    borders go to the surface from which the midpoints of their sides deviate least.
/// -# *Freeform faces* are what is left, between creases. A torus that osculates one is a part of
///    it; so are tori that osculate one tube.
///
/// Faces without a normal of their own, such as slivers, belong to the surface on which their
/// vertices lie. Faces of the result are connected across edges and seams.
///
/// \param surface the surface of the part
/// \param tolerance the largest distance of a vertex from its surface, in units of the mesh; 0:
/// found from the mesh
/// \param execution reports the progress
///
/// Deterministic. Independent of motion, scale and the order of faces, where no two candidates are
/// equal to rounding. Complexity: near linear in the number of faces.
/// \throws Segmentation_cancelled if the visitor cancels
inline Surface_faces find_surface_faces(const Surface& surface, double tolerance = 0,
                                        const Execution& execution = Execution())
{
  CGAL_precondition_msg(tolerance >= 0, "tolerance is not negative");
  internal::Face_search search(surface, tolerance / surface.unit());
  internal::find_faces_from_patches(search, execution.step(0, 0.7));
  internal::find_small_planes(search, execution.step(0.7, 0.85));
  internal::find_pairs_of_planes(search, execution.step(0.85, 0.9));
  internal::merge_equal_surfaces(search);
  internal::compete_at_borders(search);
  internal::separate_components(search, execution.step(0.9, 1));
  internal::join_tori_to_freeform(search);

  Surface_faces result;
  result.partition = Partition::from_labels(search.labels);
  result.surfaces = internal::measured_surfaces(search, result.partition);
  result.roles = internal::find_face_roles(surface, result.partition, result.surfaces);
  result.tolerance = search.test.tolerance();
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
