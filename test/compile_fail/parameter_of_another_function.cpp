// SPDX-License-Identifier: GPL-3.0-or-later
// expect: one of the named parameters is not taken by this function
#include "common.h"
void test(const Mesh& mesh)
{
  const RS::Segmenter segmenter(mesh);
  auto labels = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
#ifdef WITH_FAULT
  segmenter.segment(labels, 3, RS::parameters::number_of_segments(3));
#else
  segmenter.segment(labels, 3);
#endif
}
