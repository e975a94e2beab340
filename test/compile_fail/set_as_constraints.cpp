// SPDX-License-Identifier: GPL-3.0-or-later
// expect: CGAL::Boolean_property_map<decltype(s)>(s)
#include "common.h"
void test(const Mesh& mesh, std::set<Mesh::Edge_index> s)
{
  Labels labels;
#ifdef WITH_FAULT
  const auto map = s;
#else
  const auto map = CGAL::Boolean_property_map<decltype(s)>(s);
#endif
  RS::segment(mesh, labels, RS::parameters::edge_is_constrained_map(map));
}
