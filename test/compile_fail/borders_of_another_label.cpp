// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the output iterator takes values of another type: their Label is the value type of the
// map of segments
#include "common.h"
#include <iterator>
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  using Label = int;
#else
  using Label = std::size_t;
#endif
  std::vector<RS::Segment_border<Mesh, Label>> borders;
  RS::extract_segment_borders(mesh, labels, std::back_inserter(borders));
}
