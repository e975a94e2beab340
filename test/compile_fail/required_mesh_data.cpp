// SPDX-License-Identifier: GPL-3.0-or-later
// expect: required_mesh_data is a static constexpr Mesh_data
#include "common.h"
struct Initializer
{
#ifdef WITH_FAULT
  static constexpr int required_mesh_data = 3;
#else
  static constexpr RS::Mesh_data required_mesh_data = RS::Mesh_data::POINTS;
#endif
  RS::Partition operator()(const RS::Flat_mesh&) const { return {}; }
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels,
              RS::parameters::number_of_segments(3).method(RS::Two_step().with_initializer(Initializer())));
}
