// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a MergingPolicy needs: void initialize
#include "common.h"
struct Policy
{
#ifdef WITH_FAULT
  void initialize(Graph&, int) {}
#else
  void initialize(const Graph&) {}
#endif
  std::optional<RS::Merge_candidate> next(const Graph&)
  {
    return std::nullopt;
  }
  void on_merge(const Graph&, const Graph::Merge&) {}
};
void test(Graph& graph)
{
  RS::merge_regions(graph, Policy(), 3);
}
