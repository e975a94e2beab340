// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a MergingPolicy is copy constructible, and needs: void initialize
#include "common.h"
struct Policy
{
  void initialize(const Graph&) {}
#ifdef WITH_FAULT
  std::optional<Graph::section_descriptor> next(const Graph&)
  {
    return std::nullopt;
  }
#else
  std::optional<RS::Merge_candidate> next(const Graph&)
  {
    return std::nullopt;
  }
#endif
  void on_merge(const Graph&, const Graph::Merge&) {}
};
void test(Graph& graph)
{
  Policy policy;
  RS::merge_regions(graph, policy, 3);
}
