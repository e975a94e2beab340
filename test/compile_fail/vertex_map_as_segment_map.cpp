// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a property map of the faces is needed
#include "common.h"
#ifdef WITH_FAULT
using Map = Mesh::Property_map<Mesh::Vertex_index, std::size_t>;
#else
using Map = Labels;
#endif
void test(const Mesh& mesh, Map map)
{
  RS::segment(mesh, map, RS::parameters::number_of_segments(8));
}
