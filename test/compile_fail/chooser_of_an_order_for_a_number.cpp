// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a method whose order of merges depends on the number of segments has no NumberChooser
#include "common.h"
struct Chooser
{
  std::size_t operator()(const RS::Merge_tree&) const { return 3; }
};
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  const RS::Two_step_merging policy;
#else
  const RS::Smallest_region_first policy;
#endif
  const auto method = RS::Two_step().with_policy(policy).with_chooser(Chooser());
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(method));
}
