// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scalar of the user's faces in the cost of merging: here a gray, by which borders follow paint,
// too.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Methods/Scalar_cost.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto gray = mesh.add_property_map<Mesh::Face_index, double>("f:gray").first;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  for (auto f : faces(mesh)) // one half is painted
    gray[f] = mesh.point(target(halfedge(f, mesh), mesh)).y() < (box.ymin() + box.ymax()) / 2 ? 0
                                                                                              : 1;

  const auto edges_of_paint_within_segments = [&](double weight) {
    const RS::Superfacet_merging method{RS::Scalar_annotator(RS::face_values(mesh, gray)),
                                        RS::Lowest_cost_first(RS::Scalar_cost(weight)),
                                        RS::Number_from_costs(-19.5)};
    RS::segment(mesh, segment_id, RS::parameters::number_of_segments(8).method(method));
    std::size_t number = 0;
    for (auto e : edges(mesh)) {
      const auto h = halfedge(e, mesh);
      if (!is_border(e, mesh) &&
          segment_id[face(h, mesh)] == segment_id[face(opposite(h, mesh), mesh)])
        number += gray[face(h, mesh)] != gray[face(opposite(h, mesh), mesh)];
    }
    return number;
  };
  const std::size_t by_shape = edges_of_paint_within_segments(0),
                    by_both = edges_of_paint_within_segments(20);
  std::cout << by_shape << " edges of the paint within 8 segments, " << by_both
            << " with the scalar in the cost\n";
  return by_both < by_shape ? EXIT_SUCCESS : EXIT_FAILURE;
}
