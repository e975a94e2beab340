// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Segment_triangles.h"

#include <algorithm>

namespace segment_mesh {

std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh)
{
  std::vector<Segment_triangles> result;
  const std::vector<std::size_t>& labels = mesh.segment_of_face;
  std::size_t number_of_segments = 0; // no_segment and 1 are 0
  for (std::size_t label : labels)
    number_of_segments = (std::max)(number_of_segments, label + 1);
  const auto faces = faces_of_segments(labels, number_of_segments);
  for (std::size_t segment = 0; segment < number_of_segments; ++segment) {
    Polygon_soup part = extract_faces(mesh.soup, faces[segment]);
    Segment_triangles triangles{
      "segment_" + std::to_string(segment), segment_color(segment), {}, {}};
    for (const Polygon_soup::Polygon& polygon : part.polygons)
      triangulate_polygon(part.points, polygon, triangles.triangles);
    triangles.triangles.erase(
      std::remove_if(triangles.triangles.begin(), triangles.triangles.end(),
                     [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
      triangles.triangles.end());
    triangles.points = std::move(part.points);
    if (!triangles.triangles.empty())
      result.push_back(std::move(triangles));
  }
  return result;
}

} // namespace segment_mesh
