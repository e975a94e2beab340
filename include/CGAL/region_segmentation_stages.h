// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_STAGES_H
#define CGAL_REGION_SEGMENTATION_STAGES_H

/// \file region_segmentation_stages.h
/// The stages of a segmentation, one by one.

#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/detect_feature_edges.h>
#include <CGAL/Region_segmentation/extract_feature_lines.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/merge_regions.h>
#include <CGAL/Region_segmentation/smooth_borders.h>

#endif // CGAL_REGION_SEGMENTATION_STAGES_H
