// SPDX-License-Identifier: GPL-3.0-or-later
// expect: Parallel_tag needs TBB

#include "common.h"

#ifdef WITH_FAULT
using Tag = CGAL::Parallel_tag;
#else
using Tag = CGAL::Sequential_tag;
#endif

void test(const Mesh& mesh, Labels labels)
{
  RS::segment<Tag>(mesh, labels, RS::parameters::number_of_segments(3));
}
