// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_H

/// \file region_segmentation.h
/// `segment()` and `Segmenter` with all methods but `Smooth_faces`, which needs Eigen. The single
/// stages are in `region_segmentation_stages.h`, what follows a segmentation in the headers of the
/// folder `Segments`, measures in `Region_segmentation/evaluation.h`.

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/Region_segmentation/version.h>

#endif // CGAL_REGION_SEGMENTATION_H
