// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EVALUATION_EVALUATION_H
#define CGAL_REGION_SEGMENTATION_EVALUATION_EVALUATION_H

/// \file evaluation.h
/// The dissimilarity of two segmentations of one mesh: the four measures of the Princeton
/// Segmentation Benchmark. 0 means equal, less is better.
///
/// | measure               | counts      | symmetric             | a refinement scores |
/// |-----------------------|-------------|-----------------------|---------------------|
/// | `rand_index_distance` | face pairs  | yes                   | above 0             |
/// | `hamming_distance`    | area        | yes, its rates swap   | above 0             |
/// | `consistency_error`   | faces, area | yes                   | 0                   |
/// | `cut_discrepancy`     | cut lines   | yes                   | above 0             |
///
/// Labels only identify segments: they may be of any integral type, sparse or negative, and the two
/// maps need not use the same ones. A segment is the set of faces of one label, connected or not.
///
/// Source: X. Chen, A. Golovinskiy, T. Funkhouser, "A Benchmark for 3D Mesh Segmentation", ACM
/// Trans. Graph. 28(3), 2009; where its text and its evaluator differ, the evaluator is followed.

#include <CGAL/Region_segmentation/Evaluation/cut_discrepancy.h>
#include <CGAL/Region_segmentation/Evaluation/overlap_measures.h>

#endif // CGAL_REGION_SEGMENTATION_EVALUATION_EVALUATION_H
