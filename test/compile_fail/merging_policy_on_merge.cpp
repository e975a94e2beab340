// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a MergingPolicy needs: void on_merge
#include "common.h"
struct Policy
{
  void initialize(const Graph&) {}
  std::optional<RS::Merge_candidate> next(const Graph&) { return std::nullopt; }
#ifndef WITH_FAULT
  void on_merge(const Graph&, const Graph::Merge&) {}
#endif
};
void test(Graph& graph)
{
  Policy policy;
  RS::merge_regions(graph, policy, 3);
}
