// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SegmentationMethod needs: Prepared prepare(const Surface&, const Execution&) const
#include "common.h"
struct Method
{
  int prepare(const RS::Surface&, const RS::Execution&) const { return 0; }
#ifdef WITH_FAULT
  RS::Hierarchy merge(const RS::Surface&, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
#else
  RS::Hierarchy merge(const RS::Surface&, int, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(Method()));
}
