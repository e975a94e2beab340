// SPDX-License-Identifier: GPL-3.0-or-later
// expect: this method needs the number of segments: use segment(segment_map, number_of_segments)
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#ifdef WITH_FAULT
  segmenter.segment(labels);
#else
  segmenter.segment(labels, 3);
#endif
}
