// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_H

/// \file region_segmentation.h
/// `segment()` and `Segmenter` with all methods but `Smooth_faces`, which needs Eigen. The single
/// stages are in `region_segmentation_stages.h`, what follows a segmentation in the headers of the
/// folder `Segments`, measures in `Region_segmentation/Evaluation/evaluation.h`.

#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Support/version.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#endif // CGAL_REGION_SEGMENTATION_H
