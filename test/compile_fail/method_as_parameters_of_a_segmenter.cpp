// SPDX-License-Identifier: GPL-3.0-or-later
// expect: this argument is a pack of named parameters: pass a method by parameters::method()
#include "common.h"
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  RS::Segmenter segmenter(mesh, RS::Learned_merging());
#else
  RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Learned_merging()));
#endif
}
