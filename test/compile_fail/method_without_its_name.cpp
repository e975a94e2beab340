// SPDX-License-Identifier: GPL-3.0-or-later
// expect: this argument is a pack of named parameters: pass a method by parameters::method()
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
#ifdef WITH_FAULT
  RS::segment(mesh, labels, RS::Visibility_merging());
#else
  RS::segment(mesh, labels, RS::parameters::method(RS::Visibility_merging()));
#endif
}
