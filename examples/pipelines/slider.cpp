// SPDX-License-Identifier: GPL-3.0-or-later
//
// A slider over the number of segments, and a button that splits the one that was clicked. The mesh
// is prepared once; all that is shown comes from its merge tree.

#include "input_mesh.h"

#include <CGAL/region_segmentation.h>

#include <chrono>
#include <vector>

namespace RS = CGAL::Region_segmentation;

/// The segments with one of them split as the tree splits it first.
RS::Partition split(const RS::Merge_tree& tree, const RS::Partition& segments, std::size_t clicked)
{
  for (std::size_t k = segments.number_of_parts() + 1; k <= segments.size(); ++k) {
    const RS::Partition finer = tree.partition_at_count(k);
    std::vector<std::size_t> labels(segments.begin(), segments.end());
    for (std::size_t r = 0; r < labels.size(); ++r)
      if (labels[r] == clicked)
        labels[r] = segments.size() + finer[r];
    const RS::Partition result = RS::Partition::from_labels(labels);
    if (result.number_of_parts() > segments.number_of_parts())
      return result;
  }
  return segments; // it is a single region
}

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const RS::Segmenter segmenter(mesh);
  const RS::Merge_tree& tree = segmenter.merge_tree();

  const auto start = std::chrono::steady_clock::now();
  for (std::size_t k = 2; k <= 8; ++k)
    segmenter.segment(segment_id, k);
  const RS::Partition segments = tree.partition_at_count(8);
  const RS::Partition finer = split(tree, segments, segment_id[*faces(mesh).begin()]);
  RS::write_face_values(mesh, RS::composed(segmenter.regions(), finer), segment_id);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  std::cout << segments.number_of_parts() << " segments, then " << finer.number_of_parts()
            << ", in " << time.count() << " ms\n";
}
