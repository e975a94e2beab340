// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SectionData is default and copy constructible, and needs: void add_adjacency
#include "common.h"
struct Section_data
{
  double length = 0;
#ifndef WITH_FAULT
  void add_adjacency(const RS::Surface&, std::size_t) {}
#endif
  void absorb(const Section_data&) {}
};
struct Region_data
{
  void add_face(const RS::Surface&, std::size_t) {}
  void add_border(const RS::Surface&, std::size_t) {}
  void absorb(const Region_data&, const Section_data&) {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph<Region_data, Section_data>(mesh, labels);
}
