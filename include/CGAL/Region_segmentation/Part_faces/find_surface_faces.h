// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_FIND_SURFACE_FACES_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_FIND_SURFACE_FACES_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/coordinate_resolution.h>
#include <CGAL/Region_segmentation/Part_faces/internal/find_faces.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/surface_evidence.h>
#include <CGAL/Region_segmentation/Support/Execution.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Fits the surfaces to the points of their faces. Sets their deviations and extents. Where
/// vertices lie on surfaces to rounding, one that misses a vertex of its face is dropped.
inline void fit_surfaces(const Surface& surface, Surface_faces& faces)
{
  const bool is_exact = faces.tolerance <= 1.5 * tolerance_of_rounding(surface);
  std::vector<std::vector<Double_3>> points(faces.surfaces.size());
  for (const auto& [part, vertex] : labels_of_vertices(surface, faces.partition))
    points[part].push_back(surface.point(vertex));
  for (std::size_t part = 0; part < points.size(); ++part)
    if (Fitted_surface<>& s = faces.surfaces[part]; s.kind != Surface_kind::FREEFORM) {
      Fitted_surface<> fitted = s;
      refine_surface(fitted, points[part], faces.tolerance, 0);
      measure(fitted, points[part]);
      measure(s, points[part]);
      if (fitted.deviation <= faces.tolerance || fitted.deviation <= s.deviation || !is_exact)
        s = fitted;
      if (is_exact && s.deviation > faces.tolerance) {
        s = Fitted_surface<>();
        faces.roles[part] = Face_role::NONE;
      }
    }
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// finds the faces of a machine part, each with its surface: planes, cylinders, cones, spheres,
/// tori, and freeform faces.
///
/// -# *Tolerance.* Vertices of a tessellation lie on the exact surface, to rounding: the tolerance
///    is \f$10^{-6}\f$ of the size, the square root of the area, or the step of which all
///    coordinates in the largest decade are multiples, if that is larger: a power of ten, at most
///    1/1000 of the size, or the precision of `float`. If less than a twentieth of what is not
///    plane is on curved surfaces then, vertices may be noisy, or were moved by remeshing along the
///    facets of a tessellation: then the steps that follow are taken for \f$64 \cdot 10^{-4}, 32
///    \cdot 10^{-4}, \ldots, 10^{-4}\f$, until more than half of the area is freeform, or the
///    description of the faces is more than 1.8 times as long as the shortest one. Its length is
///    1/8 a face, plus the mean over the vertices of \f$\log_2(\sigma / 10^{-6})\f$, \f$\sigma\f$
///    the standard deviation of those of a face from its surface, over the size; 1/250 for freeform
///    faces. The faces of the shortest one of these are the result if it is shorter than that of
///    the faces before, and either .45 of the edges on curved surfaces have ends on opposite sides
///    of them, or .1 have and there are at most 1.6 times as many faces: a freeform part, too, can
///    be covered by surfaces.
/// -# *Surfaces from patches.* All faces that go on smoothly, then those around each face that is
///    not found yet, the largest first, are a patch. The simplest surface on which its vertices lie
///    grows over all faces that lie on it and do not deviate much more than most, and is fitted
///    again whenever their number has doubled. Growing crosses no creases, edges of three faces, or
///    constrained edges. A surface needs evidence, of lines of vertices and of tangent ends; where
///    the mesh leaves it little by little, less than a plane tangent to it there, it only osculates
///    a freeform face and is dropped. Smaller patches follow, then strips, then planes of few
///    vertices.
/// -# *Faces between others.* Of what is left, faces of which all vertices are on faces that are
///    found go to the neighbor from whose surface they deviate least: if their vertices lie on it,
///    and their normal is within 53 degrees of its; with a tolerance above rounding always, since
///    they cross a crease. Then, a surface needs as many vertices that are not on faces found
///    before as it has degrees of freedom.
/// -# *Competition.* Neighbors of which one's surface is also that of the other are one; faces at
///    borders go to the surface from which the midpoints of their sides deviate least. Surfaces of
///    single rows of facets are dropped if most of their border goes on smoothly to what fits none.
/// -# *Freeform faces* are what is left, between creases.
///
/// Faces without a normal of their own, such as slivers, belong to the surface on which their
/// vertices lie. Half of a narrow strip has a normal. Faces of the result are connected across
/// edges and seams. Where vertices lie on surfaces to rounding, the deviation of none is above the
/// tolerance.
///
/// \param surface the surface of the part
/// \param tolerance the largest distance of a vertex from its surface, in units of the mesh; 0:
///        found from the mesh
/// \param execution reports the progress
///
/// Deterministic. Complexity: near linear in the number of faces; up to eight searches where
/// vertices do not lie on curved surfaces to rounding. \throws Segmentation_cancelled if the
/// visitor cancels
inline Surface_faces find_surface_faces(const Surface& surface, double tolerance = 0,
                                        const Execution& execution = Execution())
{
  CGAL_precondition_msg(tolerance >= 0, "tolerance is not negative");
  Surface_faces result = internal::find_faces(surface, tolerance / surface.unit(), execution);
  internal::fit_surfaces(surface, result);
  return result;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_FIND_SURFACE_FACES_H
