// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Segmentation_details.h"

#include "../shapes_with_faces.h"
#include "read/read_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace Segmentation_details_test {

using namespace segment_mesh;

/// Each node of the top of the tree against a description of that partition alone.
TEST(Segmentation_details, describe_nodes_as_segments_of_partitions)
{
  const Polygon_soup soup = read_mesh(FIGURE).soup;
  Segmentation_settings settings;
  settings.method = Method::TWO_STEP;
  settings.number_of_segments = 10;
  const Segmentation segmentation = run_segmentation(soup, {}, settings, {});
  constexpr std::size_t greatest = 14;
  const std::vector<Segment_description> nodes = Segmentation_details(soup, settings, segmentation)
                                                   .nodes(greatest);
  std::size_t number_of_found = 0;
  const std::size_t least = segmentation.number_of_regions - segmentation.tree.merges().size();
  for (std::size_t k = least; k <= greatest; ++k) {
    Segmentation partitioned = segmentation;
    const auto partition = segmentation.tree.partition_at_count(k);
    for (std::size_t f = 0; f < partitioned.segment_of_face.size(); ++f)
      partitioned.segment_of_face[f] = partition[segmentation.region_of_face[f]];
    partitioned.number_of_segments = k;
    for (const Segment_description& segment :
         Segmentation_details(soup, settings, partitioned).segments())
      number_of_found += std::any_of(
        nodes.begin(), nodes.end(), [&](const Segment_description& node) {
          return node.number_of_faces == segment.number_of_faces && node.area == segment.area &&
                 node.extents == segment.extents; // a volume depends on the other segments, by
                                                  // the caps
        });
  }
  EXPECT_EQ(number_of_found, (least + greatest) * (greatest - least + 1) / 2);
  EXPECT_EQ(nodes.size(), 2 * greatest - least);
}

/// A cone on a cylinder, closed by planes.
TEST(Segmentation_details, colors_tell_kinds)
{
  const auto shape = shapes_with_faces::revolved({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}}, 32);
  Polygon_soup soup;
  for (const auto& p : shape.points)
    soup.points.push_back({p.x, p.y, p.z});
  for (const auto& t : shape.triangles)
    soup.polygons.push_back({t[0], t[1], t[2]});
  const auto colors = [&](std::optional<std::size_t> number, Coloring coloring) {
    Segmentation_settings settings;
    settings.method = Method::SMOOTH_FACES;
    settings.number_of_segments = number;
    const Segmentation s = run_segmentation(soup, {}, settings, {});
    return Segmentation_details(soup, settings, s)
      .colors(coloring, s.segment_of_face, s.number_of_segments);
  };
  EXPECT_EQ(colors({}, Coloring::KINDS), (std::vector<std::size_t>{0, 1, 2, 0}));
  EXPECT_EQ(colors({}, Coloring::SEGMENTS), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(colors(1, Coloring::KINDS), std::vector<std::size_t>{color_of_no_kind});
}

} // namespace Segmentation_details_test
