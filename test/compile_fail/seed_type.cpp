// SPDX-License-Identifier: GPL-3.0-or-later
// expect: face_seed_map has an integral value type
#include "common.h"
#ifdef WITH_FAULT
using Seed = double;
#else
using Seed = int;
#endif
void test(const Mesh& mesh, Labels labels, Mesh::Property_map<Mesh::Face_index, Seed> seeds)
{
  RS::segment(mesh, labels, RS::parameters::number_of_segments(3).face_seed_map(seeds));
}
