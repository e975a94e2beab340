// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a NumberChooser needs: std::size_t operator()(const Merge_tree&, const Surface&) const
#include "common.h"
struct Chooser
{
#ifdef WITH_FAULT
  std::size_t operator()(const RS::Merge_tree&) const
  {
    return 3;
  }
#else
  std::size_t operator()(const RS::Merge_tree&, const RS::Surface&) const
  {
    return 3;
  }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  const RS::Visibility_merging visibility;
  const RS::Superfacet_merging method{visibility.annotator, visibility.policy, Chooser()};
  RS::segment(mesh, labels, RS::parameters::method(method));
}
