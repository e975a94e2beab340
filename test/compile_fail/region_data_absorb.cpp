// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionData needs: void absorb(const RegionData& other, const SectionData& between)
#include "common.h"
struct Region_data
{
  void add_face(const RS::Flat_mesh&, std::size_t) {}
  void add_border_edge(const RS::Flat_mesh&, std::size_t, std::size_t) {}
#ifdef WITH_FAULT
  void absorb(const Region_data&) {}
#else
  template <typename Section>
  void absorb(const Region_data&, const Section&)
  {
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph(mesh, labels, RS::Geometry_annotator<Region_data>());
}
