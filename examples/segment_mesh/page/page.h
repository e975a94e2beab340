// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PAGE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PAGE_H

#include "segmentation/Segmentation_details.h"
#include "segmentation/run_segmentation.h"
#include "soup/Polygon_soup.h"
#include "view/choose_viewpoint.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iosfwd>
#include <string>

namespace segment_mesh {

/// What a page shows. References: it lives within one call.
struct Page_content
{
  const std::string& name; ///< of the input
  const Polygon_soup& soup;
  const Segmentation& segmentation;
  const Segmentation_details& details;
  Coloring coloring = Coloring::SEGMENTS; ///< at first
  Up_direction up = {};                   ///< at first
};

/// The same as the scripts of a page read it (`read_arrays.js`).
struct Page_data
{
  nlohmann::ordered_json content; ///< also of what is in `arrays`
  std::string arrays;             ///< bytes
};

/// Without descriptions of shapes, which take longer than all else.
Page_data page_data(const Page_content& content);

/// The shape of a segment that is a node of the merge tree.
nlohmann::ordered_json shape_json(const Segment_description& shape);

/// The shapes of the segments that the slider shows first.
nlohmann::ordered_json shapes_json(const Page_content& content);

/// On one line; U+FFFD stands for what is not UTF-8.
std::string text_of(const nlohmann::ordered_json& json);

/// Whether the program was built with three.js.
bool can_write_pages();

/// Writes a page of HTML that needs no other file and no network: the mesh to view and rotate,
/// every number of segments that the merge tree has, and segments to split and to join. It needs a
/// browser with WebGL and `DecompressionStream` (of 2023). \pre `can_write_pages()`
void write_page(std::ostream& out, const Page_content& content);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PAGE_H
