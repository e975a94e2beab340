// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the NumberChooser is in the units of another cost
#include "common.h"
struct Cost : RS::Visibility_cost
{};
void test(const Mesh& mesh, Labels labels)
{
  const auto method = RS::Visibility_merging().with_policy(RS::Lowest_cost_first<Cost>());
#ifdef WITH_FAULT
  const RS::Number_from_costs<RS::Visibility_cost> chooser(-10);
#else
  const RS::Number_from_costs<Cost> chooser(-10);
#endif
  RS::segment(mesh, labels, RS::parameters::method(method.with_chooser(chooser)));
}
