// SPDX-License-Identifier: GPL-3.0-or-later
//
// Materials, or any other categories of faces, as borders: no segment has two of them, whatever
// that costs. And seeds from points in space.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Segments/find_nearest_faces.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto material = mesh.add_property_map<Mesh::Face_index, int>("f:material").first;
  auto is_border = mesh.add_property_map<Mesh::Edge_index, bool>("e:border").first;
  auto seed = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:seed", std::size_t(-1)).first;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  for (auto f : faces(mesh)) // one half is of another material
    material[f] = mesh.point(target(halfedge(f, mesh), mesh)).y() < (box.ymin() + box.ymax()) / 2;

  RS::mark_segment_borders(mesh, material, is_border);
  const std::vector<Point> clicked = {{box.xmin(), box.ymin(), box.zmin()},
                                      {box.xmax(), box.ymin(), box.zmin()}};
  std::vector<Mesh::Face_index> nearest;
  RS::find_nearest_faces(mesh, clicked, std::back_inserter(nearest));
  for (std::size_t i = 0; i < nearest.size(); ++i)
    seed[nearest[i]] = i;

  RS::segment(
    mesh, segment_id,
    RS::parameters::number_of_segments(8).edge_is_constrained_map(is_border).face_seed_map(seed));
  std::cout << "the clicked faces are in the segments " << segment_id[nearest[0]] << " and "
            << segment_id[nearest[1]] << '\n';
  write_colored(mesh, segment_id, "materials.ply");
}
