// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a RegionInitializer needs: Partition operator()
#include "common.h"
struct Initializer
{
#ifdef WITH_FAULT
  void operator()(const RS::Flat_mesh&, std::vector<int>&) const {}
#else
  RS::Partition operator()(const RS::Flat_mesh&) const { return {}; }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels,
              RS::parameters::number_of_segments(3).method(RS::Two_step().with_initializer(Initializer())));
}
