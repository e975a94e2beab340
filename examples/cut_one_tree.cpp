// SPDX-License-Identifier: GPL-3.0-or-later
//
// A policy whose order does not depend on the wanted number gives every number from one run.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto region_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;

  RS::Merge_tree tree;
  RS::segment(mesh, segment_id,
              RS::parameters::number_of_segments(1)
                .maximum_angle(0.5)
                .feature_convexity(RS::Feature_convexity::ALL)
                .merging_policy(RS::Smallest_region_first())
                .region_map(region_id)
                .merge_tree(std::ref(tree)));

  for (std::size_t k : {100, 10, 3}) {
    const auto cut = tree.cut_at_count(k);
    std::cout << cut.number_of_segments << " segments of " << tree.number_of_regions()
              << " regions; that of the first face holds region 0 and";
    std::size_t others = 0;
    for (std::size_t r = 1; r < cut.of_region.size(); ++r)
      others += cut.of_region[r] == cut.of_region[region_id[*faces(mesh).begin()]];
    std::cout << ' ' << others << " more\n";
  }
}
