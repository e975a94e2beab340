// SPDX-License-Identifier: GPL-3.0-or-later
// expect: one of the named parameters is given twice
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
  const auto np = RS::parameters::method(RS::Two_step());
#ifdef WITH_FAULT
  RS::segment(mesh, labels, 8, np.number_of_segments(8));
#else
  RS::segment(mesh, labels, 8, np);
#endif
}
