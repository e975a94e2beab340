// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the order of merges of this method depends on the number of segments: it has no tree for
// all numbers
#include "common.h"
using Float_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;
void test(const Float_mesh& mesh)
{
#ifdef WITH_FAULT
  const RS::Two_step method;
#else
  const RS::Visibility_merging method;
#endif
  RS::Merge_tree tree;
  const RS::Segmenter segmenter(mesh, RS::parameters::method(method).merge_tree(tree));
}
