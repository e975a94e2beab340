// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a SegmentationMethod needs: Prepared prepare(const Surface&, const Execution&) const
#include "common.h"
struct Method
{
#ifdef WITH_FAULT
  int prepare(const RS::Surface&) const
  {
    return 0;
  }
#else
  int prepare(const RS::Surface&, const RS::Execution&) const
  {
    return 0;
  }
#endif
  RS::Hierarchy merge(const RS::Surface&, int, const RS::Request&, const RS::Execution&) const
  {
    return {};
  }
};
void test(const Mesh& mesh)
{
  const RS::Segmenter segmenter(mesh, RS::parameters::method(Method()));
}
