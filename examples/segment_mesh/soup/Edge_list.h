// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EDGE_LIST_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EDGE_LIST_H

#include "soup/Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace segment_mesh {

/// The edges of polygons. Points at the same place are one.
class Edge_list
{
public:
  explicit Edge_list(const Polygon_soup& soup)
  {
    std::map<Point, std::size_t> first;
    for (std::size_t i = 0; i < soup.points.size(); ++i)
      m_first.push_back(first.emplace(soup.points[i], i).first->second);
    for (const Polygon_soup::Polygon& polygon : soup.polygons)
      for (std::size_t i = 0; i < polygon.size(); ++i)
        m_edges.push_back(edge(polygon[i], polygon[(i + 1) % polygon.size()]));
    std::sort(m_edges.begin(), m_edges.end());
  }

  bool has(std::size_t a, std::size_t b) const
  {
    return std::binary_search(m_edges.begin(), m_edges.end(), edge(a, b));
  }

  /// The edge between the first points at the places of two points, the lower one first.
  Vertex_pair edge(std::size_t a, std::size_t b) const
  {
    const auto [low, high] = std::minmax(m_first[a], m_first[b]);
    return {low, high};
  }

private:
  std::vector<std::size_t> m_first; // for each point the first one at its place
  std::vector<Vertex_pair> m_edges;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EDGE_LIST_H
