// SPDX-License-Identifier: GPL-3.0-or-later
// expect: segment() with this method needs the named parameter number_of_segments
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::parameters::method(RS::Two_step()));
#else
  RS::segment(mesh, labels, RS::parameters::method(RS::Two_step()).number_of_segments(3));
#endif
}
