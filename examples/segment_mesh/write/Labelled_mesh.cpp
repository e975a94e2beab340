// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Labelled_mesh.h"

#include <algorithm>

namespace segment_mesh {

std::vector<std::vector<std::size_t>>
faces_of_segments(const std::vector<std::size_t>& segment_of_face, std::size_t number_of_segments)
{
  std::vector<std::vector<std::size_t>> faces(number_of_segments);
  for (std::size_t f = 0; f < segment_of_face.size(); ++f)
    if (segment_of_face[f] < number_of_segments)
      faces[segment_of_face[f]].push_back(f);
  return faces;
}

Polygon_soup extract_faces(const Polygon_soup& soup, const std::vector<std::size_t>& faces)
{
  Polygon_soup part;
  std::vector<std::size_t> used;
  for (std::size_t f : faces) {
    part.polygons.push_back(soup.polygons[f]);
    used.insert(used.end(), soup.polygons[f].begin(), soup.polygons[f].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::size_t i : used)
    part.points.push_back(soup.points[i]);
  part.polygons.renumber(
    [&](std::size_t i) { return std::lower_bound(used.begin(), used.end(), i) - used.begin(); });
  return part;
}

} // namespace segment_mesh
