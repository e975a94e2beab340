// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Surface_face_cost.h>
#include <CGAL/Region_segmentation/Methods/number_choosers.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Segments/Surface_faces.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/concepts/Method_calls.h>
#include <CGAL/Region_segmentation/internal/faces/find_faces.h>
#include <CGAL/Region_segmentation/internal/graph/build_graph.h>
#include <CGAL/Region_segmentation/internal/support/check_constants.h>
#include <CGAL/Region_segmentation/requested_regions.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationMethods
/// The faces of a machine part as its designer drew them: planes, cylinders, cones, spheres, tori,
/// and freeform faces, by `find_surface_faces()`. A model of `SegmentationMethod`. It needs Eigen.
///
/// No number is required: the segments are the faces. With a lower one, faces are merged in the
/// order of `Surface_face_cost`, blends into what they blend first. There are at most as many
/// segments as faces, unless constraints or seeds divide them.
struct Smooth_faces
{
  /// The largest distance of a vertex from the surface of its face, in units of the mesh; 0: found
  /// from the mesh.
  double tolerance = 0;
  Surface_face_cost cost;
  Number_below_cost chooser = {0.5}; ///< stops where all pieces of faces are merged

  struct Prepared
  {
    Surface_faces faces;
  };

  Prepared prepare(const Surface& surface, const Execution& execution = Execution()) const
  {
    internal::check_constant("Smooth_faces: tolerance", tolerance, 0);
    chooser.check_constants();
    return {internal::find_faces(surface, tolerance / surface.unit(), execution.stage("regions"))};
  }

  Hierarchy merge(const Surface& surface, const Prepared& prepared, const Request& request,
                  const Execution& execution = Execution()) const
  {
    Requested_regions requested = requested_regions(surface, prepared.faces.partition,
                                                    request.seeds);
    auto graph = internal::build_graph<Surface_face_region_data, Surface_face_section_data>(
      surface, requested.regions, execution.stage("graph"));
    annotate_surface_faces(graph, surface, requested.regions, prepared.faces);
    Merge_tree tree = merge_requested_regions(surface, requested, graph,
                                              Lowest_cost_first<Surface_face_cost>(cost), 1,
                                              execution.stage("merging"));
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments
                                                              : chooser(tree, surface);
    return Hierarchy(std::move(requested.regions), std::move(tree), number);
  }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Smooth_faces>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMOOTH_FACES_H
