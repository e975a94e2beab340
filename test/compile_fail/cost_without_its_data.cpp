// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the RegionMergingPolicy reads RegionData or SectionData that the annotator of the graph does not provide
#include "common.h"
// A cost that reads the data of another annotator.
void test(const Mesh& mesh, Labels labels)
{
  const RS::Lowest_cost_first<RS::Visibility_cost> policy;
#ifdef WITH_FAULT
  const auto method = RS::Two_step().with_policy(policy);
#else
  const auto method = RS::Two_step().with_annotator(RS::Visibility_annotator()).with_policy(policy);
#endif
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(method));
}
