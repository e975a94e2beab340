// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SegmentationVisitor is not copied: pass it as visitor(std::ref(v))
#include "common.h"
struct Visitor_by_value
{
  bool go_further(const char*, double) { return true; }
};
void test(const Mesh& mesh, Labels labels)
{
  Visitor_by_value visitor;
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).visitor(visitor));
#else
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).visitor(std::ref(visitor)));
#endif
}
