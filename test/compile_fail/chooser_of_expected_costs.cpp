// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the NumberChooser is in the units of another cost
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
  const RS::Number_from_expected_costs<RS::Expected_merge_cost> chooser;
#ifdef WITH_FAULT
  const RS::Visibility_merging method;
#else
  const RS::Learned_merging method;
#endif
  RS::segment(mesh, labels, RS::parameters::method(method.with_chooser(chooser)));
}
