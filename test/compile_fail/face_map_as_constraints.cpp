// SPDX-License-Identifier: GPL-3.0-or-later
// expect: a property map of the edges is needed
#include "common.h"
#ifdef WITH_FAULT
using Key = Mesh::Face_index;
#else
using Key = Mesh::Edge_index;
#endif
void test(const Mesh& mesh, Labels labels, Mesh::Property_map<Key, bool> drawn)
{
  RS::segment(mesh, labels, RS::parameters::edge_is_constrained_map(drawn).number_of_segments(8));
}
