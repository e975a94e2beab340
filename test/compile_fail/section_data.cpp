// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SectionData needs: void add_edge
#include "common.h"
struct Section_data
{
  double length = 0;
#ifndef WITH_FAULT
  void add_edge(const RS::Flat_mesh&, std::size_t, std::size_t) {}
#endif
  void absorb(const Section_data&) {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph(mesh, labels, RS::Geometry_annotator<RS::Region_geometry, Section_data>());
}
