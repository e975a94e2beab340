// SPDX-License-Identifier: GPL-3.0-or-later
//
// Another mesh type, another kernel, and maps that are no part of the mesh: the same call.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <unordered_map>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Polyhedron_3<Kernel>; // its faces have no ids: none are needed
using Face = boost::graph_traits<Mesh>::face_descriptor;
namespace RS = CGAL::Region_segmentation;

int main()
{
  const Mesh mesh = make_dumbbell<Mesh, Kernel::Point_3>();

  std::unordered_map<Face, int> labels;
  const std::size_t n = RS::segment(mesh, boost::make_assoc_property_map(labels),
                                    RS::parameters::number_of_segments(3));

  std::cout << labels.size() << " faces in " << n << " segments\n";
}
