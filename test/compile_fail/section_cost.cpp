// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SectionCost needs: double operator()
#include "common.h"
struct Cost
{
#ifdef WITH_FAULT
  double operator()(Graph::section_descriptor) const
  {
    return 0;
  }
#else
  double operator()(const Graph&, Graph::section_descriptor) const
  {
    return 0;
  }
#endif
};
void test(Graph& graph)
{
  RS::Lowest_cost_first<Cost> policy;
  RS::merge_regions(graph, policy, 3);
}
