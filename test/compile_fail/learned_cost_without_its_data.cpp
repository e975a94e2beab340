// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the MergingPolicy reads RegionData or SectionData that the annotator of the graph does
// not provide
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  const RS::Visibility_annotator annotator;
#else
  const RS::Learned_annotator annotator;
#endif
  const RS::Learned_merging learned;
  const RS::Superfacet_merging method{annotator, learned.policy, learned.chooser};
  RS::segment(mesh, labels, RS::parameters::method(method));
}
