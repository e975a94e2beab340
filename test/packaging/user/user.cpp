// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/region_segmentation.h>

int main()
{
  namespace RS = CGAL::Region_segmentation;
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0),
                         Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 0, 1), mesh);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  RS::Two_step method;
  method.feature_convexity = RS::Feature_convexity::ALL;
  const std::size_t n = RS::segment(mesh, segment_id,
                                    RS::parameters::number_of_segments(3).method(method));
  const std::size_t chosen = RS::segment(mesh, segment_id);
  return n == 3 && chosen >= 1 ? 0 : 1;
}
