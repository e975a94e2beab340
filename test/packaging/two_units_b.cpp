// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Region_segmentation/Graph/Partition_editor.h>
#include <CGAL/Region_segmentation/IO/labels.h>
#include <CGAL/Region_segmentation/Methods/Scalar_annotator.h>
#include <CGAL/Region_segmentation/Methods/Scalar_cost.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/extract_segment_borders.h>
#include <CGAL/Region_segmentation/Segments/find_nearest_faces.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_borders.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_seams.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/Region_segmentation/evaluation.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

std::size_t segments_of_other_unit(const Mesh& mesh)
{
  auto labels = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  return CGAL::Region_segmentation::segment(
    mesh, labels, CGAL::Region_segmentation::parameters::number_of_segments(1));
}
