// SPDX-License-Identifier: GPL-3.0-or-later
// expect: one of the named parameters is not taken by this function (constants of a method are
// members of its parts)
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).maximum_angle(5));
#else
  RS::Two_step method;
  method.maximum_angle = 5;
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(method));
#endif
}
