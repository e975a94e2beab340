// SPDX-License-Identifier: GPL-3.0-or-later
// expect: the Segmenter is of another type than the method: omit its template arguments
#include "common.h"
void test(const Mesh& mesh)
{
#ifdef WITH_FAULT
  using Segmenter = decltype(RS::Segmenter(mesh)); // of the default method
  const Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#else
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Two_step()));
#endif
}
