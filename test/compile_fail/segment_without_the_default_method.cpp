// SPDX-License-Identifier: GPL-3.0-or-later
// expect: The default method needs #include <CGAL/region_segmentation.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#ifndef WITH_FAULT
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#endif
#include <CGAL/Region_segmentation/segment.h>
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
void test(const Mesh& mesh, Mesh::Property_map<Mesh::Face_index, std::size_t> labels)
{
  CGAL::Region_segmentation::segment(mesh, labels);
}
