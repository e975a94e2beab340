// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the SectionCost names RegionData or SectionData that are not those of the graph
#include "common.h"
// A cost that reads the data of another graph.
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  auto graph = RS::build_region_adjacency_graph(mesh, labels);
#else
  auto graph = RS::build_region_adjacency_graph<RS::Visibility_region_data,
                                                RS::Visibility_section_data>(mesh, labels);
#endif
  RS::merge_regions(graph, RS::Lowest_cost_first<RS::Visibility_cost>(), 3);
}
