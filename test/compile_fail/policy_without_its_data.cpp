// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the MergingPolicy names RegionData or SectionData that are not those of the graph
#include "common.h"
// A policy that reads the data of another graph.
void test(Visibility_graph& graph)
{
#ifdef WITH_FAULT
  RS::merge_regions(graph, RS::Smallest_region_first(), 3);
#else
  RS::merge_regions(graph, RS::Lowest_cost_first<RS::Visibility_cost>(), 3);
#endif
}
