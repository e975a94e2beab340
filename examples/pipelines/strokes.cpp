// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user draws strokes on parts: faces under one stroke end in one segment, those under different
// strokes in different ones.

#include "../example_mesh.h"

#include <CGAL/region_segmentation.h>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto stroke = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:stroke", std::size_t(-1))
                  .first;
  RS::Segmenter segmenter(mesh);

  // Instead of a mouse: two faces and those around them.
  const Mesh::Face_index first = *faces(mesh).begin(), last = *std::prev(faces(mesh).end());
  std::size_t number = 0;
  for (auto drawn : {first, last}) {
    for (auto f : CGAL::faces_around_face(halfedge(drawn, mesh), mesh))
      if (f != Mesh::null_face() && stroke[f] == std::size_t(-1))
        stroke[f] = number;
    stroke[drawn] = number++;
  }
  segmenter.set_seeds(stroke);
  std::cout << segmenter.segment(segment_id, 2) << " segments; the strokes are in "
            << segment_id[first] << " and " << segment_id[last] << '\n';
  write_colored(mesh, segment_id, "strokes.ply");
}
