// SPDX-License-Identifier: GPL-3.0-or-later

// The methods on an index-based mesh, the other functions on one of pointers whose coordinates are
// float.

#include "every_function.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#ifdef CGAL_LINKED_WITH_TBB
using Tag = CGAL::Parallel_tag;
#else
using Tag = CGAL::Sequential_tag;
#endif

void use_methods(
  const CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>& mesh)
{
  test::use_methods<Tag>(mesh);
}

void use_functions(const CGAL::Polyhedron_3<CGAL::Simple_cartesian<float>>& mesh)
{
  test::use_stages(mesh);
  test::use_segments(mesh);
}

void use_polygons()
{
  test::use_polygons<Tag>();
}
