// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SectionData of Geometry_annotator that adds data members to those of its base class needs its own add_edge()
#include "common.h"
struct Section_data : RS::Section_geometry
{
#ifdef WITH_FAULT
  double added = 0;
#else
  double twice_the_length() const { return 2 * length; } // adds no data, and inherits all
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph(mesh, labels, RS::Geometry_annotator<RS::Region_geometry, Section_data>());
}
