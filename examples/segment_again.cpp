// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh is prepared once and asked often, as for a slider over the number of segments, and for a
// click on one segment that splits it: all that is shown comes from the merge tree.

#include "example_mesh.h"

#include <CGAL/region_segmentation.h>

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
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;

  const RS::Segmenter segmenter(mesh); // reads, prepares and merges
  for (std::size_t k : {2, 6, 8})      // each in the time of writing labels
    std::cout << segmenter.segment(segment_id, k) << " segments\n";

  const RS::Merge_tree& tree = segmenter.merge_tree();
  const RS::Partition finer = split(tree, tree.partition_at_count(8),
                                    segment_id[*faces(mesh).begin()]);
  RS::write_face_values(mesh, RS::composed(segmenter.regions(), finer), segment_id);
  std::cout << finer.number_of_parts() << " segments after the first one was split\n";
  write_colored(mesh, segment_id, "segment_again.ply");
}
