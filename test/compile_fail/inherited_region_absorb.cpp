// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionData that adds data members to those of its base class needs its own absorb()
#include "common.h"
struct Region_data : RS::Region_geometry
{
  double added = 0;
  void add_face(const RS::Flat_mesh& mesh, std::size_t face)
  {
    RS::Region_geometry::add_face(mesh, face);
    ++added;
  }
#ifndef WITH_FAULT
  template <typename Section>
  void absorb(const Region_data& other, const Section& between)
  {
    RS::Region_geometry::absorb(other, between);
    added += other.added;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  auto graph = RS::build_region_adjacency_graph(mesh, labels, RS::Geometry_annotator<Region_data>());
  RS::merge_regions(graph, RS::Smallest_region_first(), 1, RS::Stop_at_count{1});
}
