// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scalar of the user's faces in the cost of merging: here a gray, by which borders follow paint,
// too.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Superfacets/Scalar_cost.h>
#include <CGAL/region_segmentation.h>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto gray = mesh.add_property_map<Mesh::Face_index, double>("f:gray").first;
  for (auto f : faces(mesh)) // one half is painted
    gray[f] = mesh.point(target(halfedge(f, mesh), mesh)).x() < 0 ? 0 : 1;

  for (double weight : {0, 20}) {
    const RS::Superfacet_merging method{RS::Scalar_annotator(RS::face_values(mesh, gray)),
                                        RS::Lowest_cost_first(RS::Scalar_cost(weight)),
                                        RS::Number_from_costs(-19.5)};
    RS::segment(mesh, segment_id, RS::parameters::number_of_segments(12).method(method));
    std::size_t number = 0;
    for (auto h : halfedges(mesh)) {
      const auto f = face(h, mesh), g = face(opposite(h, mesh), mesh);
      number += f < g && g != Mesh::null_face() && gray[f] != gray[g] &&
                segment_id[f] == segment_id[g];
    }
    std::cout << number << " edges of the paint within segments with weight " << weight << '\n';
  }
  write_colored(mesh, segment_id, "scalar.ply");
}
