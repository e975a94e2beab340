// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_STAGES_H
#define CGAL_REGION_SEGMENTATION_STAGES_H

/// \file region_segmentation_stages.h
/// The stages of a segmentation, one by one.

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>
#include <CGAL/Region_segmentation/Surface/edge_values.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/extract_feature_lines.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#endif // CGAL_REGION_SEGMENTATION_STAGES_H
