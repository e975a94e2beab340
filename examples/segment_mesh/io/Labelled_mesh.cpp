// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Labelled_mesh.h"

namespace segment_mesh {

Polygon_soup extract_segment(const Labelled_mesh& mesh, std::size_t segment)
{
  Polygon_soup part;
  std::vector<std::size_t> new_index(mesh.soup.points.size());
  for (std::size_t f = 0; f < mesh.soup.polygons.size(); ++f) {
    if (mesh.segment_of_face[f] != segment)
      continue;
    part.polygons.push_back(mesh.soup.polygons[f]);
    for (std::size_t i : mesh.soup.polygons[f])
      new_index[i] = 1; // it is used
  }
  for (std::size_t i = 0; i < new_index.size(); ++i)
    if (new_index[i] == 1) {
      new_index[i] = part.points.size();
      part.points.push_back(mesh.soup.points[i]);
    }
  for (Polygon_soup::Polygon& polygon : part.polygons)
    for (std::size_t& i : polygon)
      i = new_index[i];
  return part;
}

} // namespace segment_mesh
