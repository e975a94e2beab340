// SPDX-License-Identifier: GPL-3.0-or-later
// expect: this method has no NumberChooser: use segment(segment_map, number_of_segments)
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
  const auto method = RS::Visibility_merging().with_chooser(RS::No_number_chooser());
  const RS::Segmenter segmenter(mesh, RS::parameters::method(method));
#ifdef WITH_FAULT
  segmenter.segment(labels);
#else
  segmenter.segment(labels, 3);
#endif
}
