// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a NumberChooser needs: std::size_t operator()(const Merge_tree&) const
#include "common.h"
struct Chooser
{
#ifdef WITH_FAULT
  std::size_t operator()(const Graph&) const { return 3; }
#else
  std::size_t operator()(const RS::Merge_tree&) const { return 3; }
#endif
};
void test(const Mesh& mesh, Labels labels)
{
  RS::segment(mesh, labels, RS::parameters::method(RS::Visibility_merging().with_chooser(Chooser())));
}
