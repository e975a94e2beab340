// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionMergingPolicy needs: void initialize
#include "common.h"
struct Policy
{
#ifdef WITH_FAULT
  void initialize(const Graph&) {}
#else
  void initialize(const Graph&, std::size_t) {}
#endif
  std::optional<RS::Merge_candidate> next(const Graph&)
  {
    return std::nullopt;
  }
  void on_merge(const Graph&, const Graph::Merge&) {}
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).merging_policy(Policy()));
}
