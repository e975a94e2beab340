// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider over the number of segments, and the buttons beside it: split, join, undo. The mesh is
// prepared once.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Graph/Partition_editor.h>
#include <CGAL/region_segmentation.h>

#include <chrono>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const RS::Segmenter segmenter(mesh);
  RS::Partition_editor editor(segmenter.merge_tree());

  const auto start = std::chrono::steady_clock::now();
  std::size_t changes = 0;
  const auto show = [&] {
    ++changes;
    RS::write_face_values(mesh, RS::composed(segmenter.regions(), editor.partition()), segment_id);
  };
  for (std::size_t k = 2; k <= 20; ++k) {
    editor.set_count(k);
    show();
  }
  const std::size_t clicked = segment_id[*faces(mesh).begin()];
  editor.split(clicked);
  show();
  editor.join(0, 1);
  show();
  while (editor.number_of_segments() != 8 && editor.undo())
    show();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  std::cout << changes << " changes in " << time.count() << " ms; " << editor.number_of_segments()
            << " segments\n";
}
