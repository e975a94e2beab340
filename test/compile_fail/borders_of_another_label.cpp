// SPDX-License-Identifier: GPL-3.0-or-later
// expect: whose Label is the value type of the map of segments
#include "common.h"
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
