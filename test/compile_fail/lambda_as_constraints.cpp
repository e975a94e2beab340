// SPDX-License-Identifier: GPL-3.0-or-later
// expect: make_function_property_map<edge_descriptor>(f)
#include "common.h"
void test(const Mesh& mesh, Labels labels)
{
  const auto is_border = [&](Mesh::Edge_index e) { return mesh.is_border(e); };
#ifdef WITH_FAULT
  const auto map = is_border;
#else
  const auto map = boost::make_function_property_map<Mesh::Edge_index>(is_border);
#endif
  RS::segment(mesh, labels, RS::parameters::edge_is_constrained_map(map));
}
