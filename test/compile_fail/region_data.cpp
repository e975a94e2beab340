// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionData is default and copy constructible, and needs: void add_face
#include "common.h"
struct Region_data
{
#ifndef WITH_FAULT
  void add_face(const RS::Surface&, std::size_t) {}
#endif
  void add_border(const RS::Surface&, std::size_t) {}
  template <typename Section>
  void absorb(const Region_data&, const Section&)
  {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph<Region_data>(mesh, labels);
}
