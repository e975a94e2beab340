// SPDX-License-Identifier: GPL-3.0-or-later
// expect: merge() of a SegmentationMethod returns a Hierarchy or a Segmentation
#include "common.h"
struct Method
{
  int prepare(const RS::Surface&, const RS::Execution&) const { return 0; }
#ifdef WITH_FAULT
  RS::Partition merge(const RS::Surface&, int, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
#else
  RS::Segmentation merge(const RS::Surface&, int, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).method(Method()));
}
