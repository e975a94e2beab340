// SPDX-License-Identifier: GPL-3.0-or-later
// expect: Longest_flattest_section reads length and mean_angle() of SectionData
#include "common.h"
// A policy that reads the data of another annotator.
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  const RS::Two_step_merging policy;
#else
  const RS::Lowest_cost_first<RS::Visibility_cost> policy;
#endif
  const auto method = RS::Visibility_merging().with_policy(policy).with_chooser(RS::No_number_chooser());
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(method));
}
