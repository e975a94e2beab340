// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/faces/compete_at_borders.h>
#include <CGAL/Region_segmentation/internal/faces/find_face_roles.h>
#include <CGAL/Region_segmentation/internal/faces/find_faces_from_patches.h>
#include <CGAL/Region_segmentation/internal/faces/find_small_planes.h>
#include <CGAL/Region_segmentation/internal/faces/fit_surface.h>
#include <CGAL/Region_segmentation/internal/faces/join_by_curvature.h>
#include <CGAL/Region_segmentation/internal/faces/merge_equal_surfaces.h>
#include <CGAL/Region_segmentation/internal/faces/separate_components.h>
#include <CGAL/Region_segmentation/internal/surface/Intrinsic_surface.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The faces of a machine part: a partition of the faces of its mesh, and what is known of each
/// part. Their neighbors, and which of these they meet smoothly, are a graph:
/// `build_region_adjacency_graph<Surface_face_region_data, Surface_face_section_data>()`, filled by
/// `annotate_surface_faces()`.
struct Surface_faces
{
  Partition partition;                    ///< of the faces of the mesh
  std::vector<Fitted_surface<>> surfaces; ///< by part, in units of the surface
  std::vector<Face_role> roles;           ///< by part
  double tolerance = 0;                   ///< that was used, in units of the surface
};

namespace internal {

/// The faces of a surface as it is, without deviations and extents. `tolerance`: in units of the
/// surface
inline Surface_faces find_faces(const Surface& surface, double tolerance,
                                const Execution& execution)
{
  Face_search search(surface, tolerance);
  find_faces_from_patches(search, execution.step(0, 0.7));
  find_small_planes(search, execution.step(0.7, 0.85));
  find_pairs_of_planes(search, execution.step(0.85, 0.9));
  merge_equal_surfaces(search);
  compete_at_borders(search);
  separate_components(search, execution.step(0.9, 1));
  join_by_curvature(search);

  Surface_faces result;
  result.partition = Partition::from_labels(search.labels);
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    if (result.partition[f] == result.surfaces.size()) // parts are numbered by their first faces
      result.surfaces.push_back(search.surface_of(f));
  result.roles = find_face_roles(surface, result.partition, result.surfaces);
  result.tolerance = search.test.tolerance();
  return result;
}

/// A surface in a frame as one in space.
inline Fitted_surface<> in_space(const Fitted_surface<>& s, const Intrinsic_frame& frame)
{
  if (s.kind == Surface_kind::FREEFORM)
    return s;
  Fitted_surface<> result = scaled(s, frame.unit());
  result.point = frame.point(s.point);
  result.direction = frame.vector(s.direction);
  return result;
}

/// Fits the surfaces to the points of their faces: those of the search were rounded. Sets their
/// deviations and extents.
inline void fit_surfaces(const Surface& surface, Surface_faces& faces)
{
  std::vector<std::vector<Double_3>> points(faces.surfaces.size());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for (std::size_t i = 0; i < surface.number_of_corners(f); ++i)
      points[faces.partition[f]].push_back(surface.point(surface.corner(f, i)));
  for (std::size_t part = 0; part < points.size(); ++part)
    if (Fitted_surface<>& s = faces.surfaces[part]; s.kind != Surface_kind::FREEFORM) {
      refine_surface(s, points[part], faces.tolerance, 0);
      measure(s, points[part]);
    }
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// finds the faces of a machine part, each with its surface: planes, cylinders, cones, spheres,
/// tori, and freeform faces.
///
/// -# *Tolerance.* Vertices of a tessellation lie on the exact surface, to rounding: the tolerance
///    is \f$10^{-6}\f$ of the square root of the area, if at least 1/20 of the area is flat to
///    that, or some patch lies on its surface. Otherwise it is 5 times the standard deviation of
///    the vertices from the surfaces that fit patches of 24 of them: the least of 1.4 times that of
///    the best sixteenth of 300 patches, three times that of the best one, and 1/500 of that root.
/// -# *Surfaces from patches.* From each face that is not found yet, the largest first, a patch of
///    neighbors is collected. The simplest surface on which its vertices lie grows over all faces
///    that lie on it, and is fitted again whenever their number has doubled. Where the mesh leaves
///    it little by little, less than a plane tangent to it there, it only osculates a freeform face
///    and is dropped. Smaller patches follow, then planes of few vertices.
/// -# *Competition.* Neighbors of which one's surface is also that of the other are one; faces at
///    borders go to the surface from which the midpoints of their sides deviate least.
/// -# *Freeform faces* are what is left, between creases and borders where the curvature jumps.
///    Surfaces on few vertices across whose border it does not jump are places of them, if a
///    quarter of that border is neither sharp nor at surfaces that are certain.
///
/// Faces without a normal of their own, such as slivers, belong to the surface on which their
/// vertices lie. Faces of the result are connected across edges and seams.
///
/// \param surface the surface of the part
/// \param tolerance the largest distance of a vertex from its surface, in units of the mesh; 0:
///        found from the mesh
/// \param execution reports the progress
///
/// Deterministic. The faces are independent of motion, scale and the order of faces, up to 524,288
/// of them, see \ref RegionSegmentationTies. Complexity: near linear in the number of faces.
/// \throws Segmentation_cancelled if the visitor cancels
inline Surface_faces find_surface_faces(const Surface& surface, double tolerance = 0,
                                        const Execution& execution = Execution())
{
  CGAL_precondition_msg(tolerance >= 0, "tolerance is not negative");
  const internal::Intrinsic_surface intrinsic(surface);
  const Surface& shape = intrinsic.of(surface);
  const Surface_faces found = internal::find_faces(shape, tolerance / shape.unit(), execution);
  const std::vector<Partition::Index> numbers = intrinsic.new_numbers(found.partition);
  Surface_faces result;
  result.partition = intrinsic.of_given(found.partition, numbers);
  result.surfaces.resize(numbers.size());
  result.roles.resize(numbers.size());
  for (std::size_t part = 0; part < numbers.size(); ++part) {
    result.surfaces[numbers[part]] = internal::in_space(found.surfaces[part], intrinsic.frame());
    result.roles[numbers[part]] = found.roles[part];
  }
  result.tolerance = found.tolerance * intrinsic.frame().unit();
  internal::fit_surfaces(surface, result);
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_FIND_SURFACE_FACES_H
