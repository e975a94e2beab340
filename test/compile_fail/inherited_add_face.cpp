// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionData of Geometry_annotator that adds data members to those of its base class needs its own add_face()
#include "common.h"
struct Region_data : RS::Region_geometry
{
  double added = 0;
#ifndef WITH_FAULT
  void add_border_edge(const RS::Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    RS::Region_geometry::add_border_edge(mesh, lower_face, edge);
    ++added;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph(mesh, labels, RS::Geometry_annotator<Region_data>());
}
