// SPDX-License-Identifier: GPL-3.0-or-later
// expect: use of deleted function
#include "common.h"
Mesh make_mesh();
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  const RS::Segmenter segmenter(make_mesh());
#else
  const RS::Segmenter segmenter(mesh);
#endif
}
