// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_FIND_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_FIND_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_faces.h>
#include <CGAL/Region_segmentation/Support/Execution.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Region_segmentation {
/// \ingroup PkgRegionSegmentationSegments
/// finds the faces of a machine part, each with its surface: planes, cylinders, cones, spheres,
/// tori, and freeform faces.
///
/// Vertices deviate from the surfaces of a part by a standard deviation \f$\sigma\f$: by rounding,
/// few digits, or noise. Whatever is asked of a face, one rule answers: a vertex is on a surface if
/// it is within the prediction interval of its fit, \f$|d| \le 5\,\sigma \sqrt{1 + h}\f$. Here
/// \f$h = j (J^T J)^{-1} j^T\f$ is the leverage of the vertex, \f$J\f$ the derivatives of the
/// distances by the parameters of the surface. The normal of a face is known within an angle of
/// \f$6 \sigma\f$ over its height, and not at all where that exceeds 1.
///
/// -# *Error.* \f$\sigma\f$ is not below \f$2 \cdot 10^{-7}\f$ of the diagonal of the bounding
///    box, nor .35 of the step of the coordinates: of fixed decimals, of fixed digits, or two of
///    those of `float` at the largest one. Above, it is measured: from the best fits of up to 80
///    patches of some 40 vertices, where these are on both sides by chance, and from the gap
///    between the heights of vertices over the triangles beside theirs in flat and in bent pairs.
/// -# *Facets.* Planes grow from the largest faces on.
/// -# *Curved faces.* Patches of all that goes on smoothly, of 80, 24 and 12 vertices, and strips
///    of facets are fitted with cylinders, cones, spheres and tori, by Levenberg and Marquardt's
///    method. A surface that fits grows over all faces that lie on it. Of those with evidence, of
///    lines of vertices and of tangent ends, the one that explains most vertices is a face.
///    Neighbors that lie on one surface are one. A single row of facets that goes on smoothly to
///    faces on no surface only osculates a freeform face, and is dropped.
/// -# *Planes* are facets of four and more vertices that do not go on smoothly to others that are
///    left, and components of at most two facets.
/// -# *Competition.* Faces at borders go to the surface from which the midpoints of their sides
///    deviate least.
/// -# *Freeform faces* are what is left, between creases.
///
/// Faces of the result are connected across edges. The deviation of none is above the tolerance;
/// faces of the mesh that lie on no surface, as those across a crease, do not count.
///
/// \param surface the surface of the part
/// \param tolerance the largest distance of a vertex from its surface, \f$5 \sigma\f$, in units of
///        the mesh; 0: found from the mesh
/// \param execution reports the progress
///
/// Deterministic. Complexity: near linear in the number of faces. \throws Segmentation_cancelled if
/// the visitor cancels
inline Surface_faces find_surface_faces(const Surface& surface, double tolerance = 0,
                                        const Execution& execution = Execution())
{
  CGAL_precondition_msg(tolerance >= 0, "tolerance is not negative");
  return internal::find_faces(surface, tolerance / surface.unit(), execution);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_FIND_SURFACE_FACES_H
