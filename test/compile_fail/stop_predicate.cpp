// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a predicate that stops merging needs: bool operator()
#include "common.h"
struct Stop
{
#ifdef WITH_FAULT
  bool operator()(const Graph&) const
  {
    return true;
  }
#else
  bool operator()(const Graph&, double) const
  {
    return true;
  }
#endif
};
void test(Graph& graph)
{
  RS::Two_step_merging policy;
  RS::merge_regions(graph, policy, 3, Stop());
}
