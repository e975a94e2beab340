// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the NumberChooser is in the units of another cost
#include "common.h"
// A policy that does not name its cost.
struct Policy
{
  template <typename AnyGraph>
  void initialize(const AnyGraph&)
  {}
  template <typename AnyGraph>
  std::optional<RS::Merge_candidate> next(const AnyGraph&)
  {
    return std::nullopt;
  }
  template <typename AnyGraph>
  void on_merge(const AnyGraph&, const typename AnyGraph::Merge&)
  {}
#ifndef WITH_FAULT
  using MergeCost = RS::Visibility_cost;
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::method(RS::Visibility_merging().with_policy(Policy())));
}
