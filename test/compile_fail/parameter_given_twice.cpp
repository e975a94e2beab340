// SPDX-License-Identifier: GPL-3.0-or-later
// expect: one of the named parameters is given twice
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
  const auto np = RS::parameters::number_of_segments(short(8));
#ifdef WITH_FAULT
  RS::segment(mesh, labels, np.number_of_segments(9));
#else
  RS::segment(mesh, labels, np);
#endif
}
