// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_H

/// \file region_segmentation.h
/// Everything of the package but `Spectral_partitioner`, which needs Eigen.

#include <CGAL/Region_segmentation/Cut_cost.h>
#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/IO/labels.h>
#include <CGAL/Region_segmentation/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Merge_candidate.h>
#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/Number_from_costs.h>
#include <CGAL/Region_segmentation/Policy_sequence.h>
#include <CGAL/Region_segmentation/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Sight.h>
#include <CGAL/Region_segmentation/Smallest_region_first.h>
#include <CGAL/Region_segmentation/Superfacets.h>
#include <CGAL/Region_segmentation/best.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/choose_feature_convexity.h>
#include <CGAL/Region_segmentation/detect_feature_edges.h>
#include <CGAL/Region_segmentation/evaluation.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/extract_feature_lines.h>
#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/merge_regions.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/part_and_cut_data.h>
#include <CGAL/Region_segmentation/partition_into_segments.h>
#include <CGAL/Region_segmentation/region_and_section_data.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/Region_segmentation/smooth_borders.h>
#include <CGAL/Region_segmentation/two_step.h>
#include <CGAL/Region_segmentation/version.h>

#endif // CGAL_REGION_SEGMENTATION_H
