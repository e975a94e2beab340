// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SegmentationMethod needs the members initializer, annotator, and either policy and chooser or partitioner
#include "common.h"
struct Method
{
  RS::Region_growing initializer;
#ifndef WITH_FAULT
  RS::Geometry_annotator<> annotator;
#endif
  RS::Two_step_merging policy;
  RS::No_number_chooser chooser;
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(Method()));
}
