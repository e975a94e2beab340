// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SegmentationVisitor needs: bool go_further
#include "common.h"
struct Visitor
{
#ifdef WITH_FAULT
  void operator()(double) {}
#else
  bool go_further(const char*, double)
  {
    return true;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  Visitor visitor;
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).visitor(std::ref(visitor)));
}
