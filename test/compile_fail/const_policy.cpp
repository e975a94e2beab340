// SPDX-License-Identifier: GPL-3.0-or-later
// expect: merging changes the policy
#include "common.h"
void test(Graph& graph)
{
#ifdef WITH_FAULT
  const RS::Two_step_merging policy;
  RS::merge_regions(graph, policy, 3);
#else
  RS::merge_regions(graph, RS::Two_step_merging(), 3);
#endif
}
