// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EDGE_LIST_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EDGE_LIST_H

#include "soup/Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
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

/// The edges whose faces have several labels, in ascending order. `edge(a, b)` is that of a side.
template <typename Labels, typename Edge>
std::vector<Vertex_pair> borders_of_labels(const Polygon_soup& soup, const Labels& labels,
                                           const Edge& edge)
{
  std::vector<std::pair<Vertex_pair, std::int64_t>> sides;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon polygon = soup.polygons[f];
    for (std::size_t i = 0; i < polygon.size(); ++i)
      sides.push_back({edge(polygon[i], polygon[(i + 1) % polygon.size()]), labels[f]});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Vertex_pair> result;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto& [border, label] = sides[i];
    if (border == sides[i - 1].first && label != sides[i - 1].second &&
        (result.empty() || result.back() != border))
      result.push_back(border);
  }
  return result;
}

/// Those where points at the same place are one.
template <typename Labels>
std::vector<Vertex_pair> borders_of_labels(const Polygon_soup& soup, const Labels& labels)
{
  const Edge_list edges(soup);
  return borders_of_labels(soup, labels,
                           [&](std::size_t a, std::size_t b) { return edges.edge(a, b); });
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EDGE_LIST_H
