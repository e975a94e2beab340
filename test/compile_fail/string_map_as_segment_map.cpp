// SPDX-License-Identifier: GPL-3.0-or-later
// expect: labels are written to a map or range of an integral type
#include "common.h"
#ifdef WITH_FAULT
using Value = std::string;
#else
using Value = int;
#endif
void test(const Mesh& mesh, Mesh::Property_map<Mesh::Face_index, Value> map)
{
  RS::segment(mesh, map, RS::parameters::number_of_segments(8));
}
