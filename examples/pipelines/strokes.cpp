// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user draws strokes on parts: faces under one stroke end in one segment, those under different
// strokes in different ones.

#include "input_mesh.h"

#include <CGAL/region_segmentation.h>

#include <algorithm>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto stroke = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:stroke", std::size_t(-1))
                  .first;
  RS::Segmenter segmenter(mesh);

  // Instead of a mouse: a few adjacent faces at both ends along x.
  std::vector<Mesh::Face_index> by_x(faces(mesh).begin(), faces(mesh).end());
  std::sort(by_x.begin(), by_x.end(), [&](auto f, auto g) {
    return mesh.point(target(halfedge(f, mesh), mesh)) <
           mesh.point(target(halfedge(g, mesh), mesh));
  });
  for (std::size_t s : {0, 1}) {
    const auto face_of_stroke = s == 0 ? by_x.front() : by_x.back();
    for (auto f : CGAL::faces_around_face(halfedge(face_of_stroke, mesh), mesh))
      if (f != Mesh::null_face() && stroke[f] == std::size_t(-1))
        stroke[f] = s;
    stroke[face_of_stroke] = s;
  }
  segmenter.set_seeds(stroke);
  const std::size_t n = segmenter.segment(segment_id, 2);

  const bool are_kept_apart = segment_id[by_x.front()] != segment_id[by_x.back()];
  std::cout << n << " segments; the strokes are in "
            << (are_kept_apart ? "different ones\n" : "one\n");
  return are_kept_apart ? EXIT_SUCCESS : EXIT_FAILURE;
}
