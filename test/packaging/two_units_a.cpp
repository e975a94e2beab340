// SPDX-License-Identifier: GPL-3.0-or-later

// With two_units_b.cpp: everything in the headers may be in two translation units of one program.

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

#if defined CGAL_REGION_SEGMENTATION_PARAMETERS || defined CGAL_REGION_SEGMENTATION_ADD ||         \
  defined CGAL_add_named_parameter
#error "a macro of the named parameters is left defined"
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

std::size_t segments_of_other_unit(const Mesh& mesh);

int main()
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  auto labels = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
  const std::size_t n = CGAL::Region_segmentation::segment(
    mesh, labels, CGAL::Region_segmentation::parameters::number_of_segments(1));
  return n == 1 && segments_of_other_unit(mesh) == 1 ? 0 : 1;
}
