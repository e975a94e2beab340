// SPDX-License-Identifier: GPL-3.0-or-later
// expect: it has no tree for all numbers, use segment(segment_map, number_of_segments)
#include "common.h"
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  const RS::Two_step method;
#else
  const RS::Visibility_merging method;
#endif
  const RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  segmenter.merge_tree();
}
