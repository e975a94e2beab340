// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionData needs: void absorb(const RegionData& other, const SectionData& between)
#include "common.h"
struct Region_data
{
  void add_face(const RS::Surface&, std::size_t) {}
  void add_border(const RS::Surface&, std::size_t) {}
#ifdef WITH_FAULT
  void absorb(const Region_data&) {}
#else
  template <typename Section>
  void absorb(const Region_data&, const Section&)
  {}
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::build_region_adjacency_graph<Region_data>(mesh, labels);
}
