// SPDX-License-Identifier: LGPL-3.0-or-later

// The one translation unit with the code of the methods: target CGAL::Region_segmentation_compiled.

#define CGAL_REGION_SEGMENTATION_EXTERN

#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#if __has_include(<Eigen/Core>)
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#endif
