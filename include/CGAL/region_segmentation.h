// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_H
#define CGAL_REGION_SEGMENTATION_H

/// \file region_segmentation.h
/// Everything of the package but the measures (`evaluation.h`), and `Spectral_partitioner` and
/// `describe_segments()`, which need Eigen.

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Feature_convexity.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Graph/Partition_editor.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/IO/labels.h>
#include <CGAL/Region_segmentation/Mesh_data.h>
#include <CGAL/Region_segmentation/Mesh_patches.h>
#include <CGAL/Region_segmentation/Methods/Geometry_annotator.h>
#include <CGAL/Region_segmentation/Methods/Border_straightening.h>
#include <CGAL/Region_segmentation/Methods/Learned_annotator.h>
#include <CGAL/Region_segmentation/Methods/Learned_cost.h>
#include <CGAL/Region_segmentation/Methods/Learned_data.h>
#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Least_compact_region_first.h>
#include <CGAL/Region_segmentation/Methods/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Methods/Lowest_cost_first.h>
#include <CGAL/Region_segmentation/Methods/Lowest_order_first.h>
#include <CGAL/Region_segmentation/Methods/Merge_features.h>
#include <CGAL/Region_segmentation/Methods/Number_below_cost.h>
#include <CGAL/Region_segmentation/Methods/Number_from_costs.h>
#include <CGAL/Region_segmentation/Methods/Number_from_expected_costs.h>
#include <CGAL/Region_segmentation/Methods/Number_range.h>
#include <CGAL/Region_segmentation/Methods/Policy_sequence.h>
#include <CGAL/Region_segmentation/Methods/Region_growing.h>
#include <CGAL/Region_segmentation/Methods/Scalar_annotator.h>
#include <CGAL/Region_segmentation/Methods/Scalar_cost.h>
#include <CGAL/Region_segmentation/Methods/Segmentation_method.h>
#include <CGAL/Region_segmentation/Methods/Smallest_region_first.h>
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_annotator.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_cost.h>
#include <CGAL/Region_segmentation/Methods/Smoothness_data.h>
#include <CGAL/Region_segmentation/Methods/Superfacets.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_annotator.h>
#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>
#include <CGAL/Region_segmentation/Methods/Visibility_data.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Segments/Fitted_primitive.h>
#include <CGAL/Region_segmentation/Segments/Seam_cost.h>
#include <CGAL/Region_segmentation/Segments/Segment_description.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/extract_segment_borders.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_borders.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_seams.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/detect_feature_edges.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/extract_feature_lines.h>
#include <CGAL/Region_segmentation/face_values.h>
#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/merge_regions.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/Region_segmentation/smooth_borders.h>
#include <CGAL/Region_segmentation/version.h>

#endif // CGAL_REGION_SEGMENTATION_H
