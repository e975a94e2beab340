// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each segment becomes a closed mesh, as for printing: every hole is filled with a cap.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  RS::segment(mesh, segment_id, RS::parameters::number_of_segments(6));
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, segment_id, std::back_inserter(pieces));
  bool are_closed = true;
  for (auto& piece : pieces) {
    std::vector<Mesh::Halfedge_index> holes;
    CGAL::Polygon_mesh_processing::extract_boundary_cycles(piece.mesh, std::back_inserter(holes));
    for (auto hole : holes) {
      std::vector<Point> points;
      for (auto h : CGAL::halfedges_around_face(hole, piece.mesh))
        points.push_back(piece.mesh.point(target(h, piece.mesh)));
      CGAL::Euler::fill_hole(hole, piece.mesh);
      const auto to_center = CGAL::Euler::add_center_vertex(hole, piece.mesh);
      piece.mesh.point(target(to_center, piece.mesh)) = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
    }
    are_closed = are_closed && CGAL::is_closed(piece.mesh) && CGAL::is_valid_polygon_mesh(piece.mesh);
    std::cout << "segment " << piece.segment << ": " << holes.size() << " holes, " << num_faces(piece.mesh) << " faces\n";
  }
  return are_closed ? EXIT_SUCCESS : EXIT_FAILURE;
}
