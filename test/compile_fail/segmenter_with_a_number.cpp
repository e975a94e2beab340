// SPDX-License-Identifier: GPL-3.0-or-later
// expect: this method merges for each number: give it to segment(segment_map, number_of_segments)
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()).number_of_segments(5));
#else
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#endif
  segmenter.segment(labels, 5);
}
