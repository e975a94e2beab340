// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_TEST_SEGMENTS_H

// Segments of meshes for the tests of what comes after a segmentation, and what they are, told from
// polygon soups.

#include "meshes.h"
#include "oracles.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace test {

/// Labels of random balls of faces, a few single faces of other labels, and a few without a
/// segment: segments of several components, and such that touch themselves.
inline Labels random_labels(const Soup& soup, std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  Labels labels(soup.polygons.size());
  std::vector<Point> centers(number);
  for (Point& center : centers)
    center = soup.points[random() % soup.points.size()];
  for (std::size_t f = 0; f < labels.size(); ++f) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < number; ++i) {
      const Point &p = soup.points[soup.polygons[f][0]], &q = centers[i];
      const double d = (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                       (p[2] - q[2]) * (p[2] - q[2]);
      if (d < nearest) {
        nearest = d;
        labels[f] = 10 * i;
      }
    }
    if (random() % 10 == 0)
      labels[f] = 10 * (random() % number);
    if (random() % 40 == 0)
      labels[f] = std::size_t(-1);
  }
  return labels;
}

/// By a coordinate of the middle of each face: the number of limits below it.
inline Labels labels_along(std::size_t axis, const Soup& soup, const std::vector<double>& limits)
{
  Labels labels;
  for (const Polygon& polygon : soup.polygons) {
    double middle = 0;
    for (std::size_t v : polygon)
      middle += soup.points[v][axis] / double(polygon.size());
    labels.push_back(
      std::size_t(std::upper_bound(limits.begin(), limits.end(), middle) - limits.begin()));
  }
  return labels;
}

/// A segment as a surface: its edges, and a vertex for each fan of its faces.
struct Segment_counts
{
  std::size_t faces = 0, edges = 0, vertices = 0, components = 0, loops = 0;

  std::ptrdiff_t euler_characteristic() const
  {
    return std::ptrdiff_t(vertices) - std::ptrdiff_t(edges) + std::ptrdiff_t(faces);
  }
};

/// By brute force: corners of the faces of a segment are united across the edges inside it.
inline std::map<std::size_t, Segment_counts> count_segments(const Soup& soup, const Labels& labels)
{
  using Corner = std::pair<std::size_t, std::size_t>; // face, vertex
  std::map<Corner, Corner> parent;
  std::map<std::size_t, std::size_t> parent_of_face;
  const auto root = [](auto& parents, auto x) {
    while (parents.at(x) != x)
      x = parents.at(x);
    return x;
  };
  for (std::size_t f = 0; f < labels.size(); ++f) {
    parent_of_face[f] = f;
    for (std::size_t v : soup.polygons[f])
      parent[{f, v}] = {f, v};
  }
  std::map<std::size_t, Segment_counts> result;
  for (std::size_t f = 0; f < labels.size(); ++f) {
    Segment_counts& counts = result[labels[f]];
    ++counts.faces;
  }
  // One entry for each edge: faces that share two edges are united across both.
  std::map<Edge, std::vector<std::size_t>> sides;
  for (std::size_t f = 0; f < labels.size(); ++f)
    for (std::size_t i = 0; i < soup.polygons[f].size(); ++i)
      sides[make_edge(soup.polygons[f][i], soup.polygons[f][(i + 1) % soup.polygons[f].size()])]
        .push_back(f);
  std::vector<std::pair<std::size_t, Edge>> border; // halfedges: face, vertices
  for (const auto& [edge, both] : sides) {
    const bool is_inside = both.size() == 2 && labels[both[0]] == labels[both[1]];
    if (is_inside) {
      ++result[labels[both[0]]].edges;
      for (std::size_t v : {edge.first, edge.second}) {
        const Corner a = root(parent, Corner(both[0], v)), b = root(parent, Corner(both[1], v));
        parent[a] = b;
      }
      const std::size_t a = root(parent_of_face, both[0]), b = root(parent_of_face, both[1]);
      parent_of_face[a] = b;
    } else
      for (std::size_t f : both) {
        ++result[labels[f]].edges;
        border.push_back({f, edge});
      }
  }
  for (const auto& [corner, above] : parent)
    result[labels[corner.first]].vertices += corner == above;
  for (const auto& [face, above] : parent_of_face)
    result[labels[face]].components += face == above;
  // Border edges are joined where they share a fan; each component of them is a loop.
  std::map<Corner, Corner> parent_of_fan;
  for (const auto& [f, edge] : border)
    for (std::size_t v : {edge.first, edge.second})
      parent_of_fan[root(parent, Corner(f, v))] = root(parent, Corner(f, v));
  for (const auto& [f, edge] : border) {
    const Corner a = root(parent_of_fan, root(parent, Corner(f, edge.first))),
                 b = root(parent_of_fan, root(parent, Corner(f, edge.second)));
    parent_of_fan[a] = b;
  }
  for (const auto& [fan, above] : parent_of_fan)
    result[labels[fan.first]].loops += fan == above;
  result.erase(std::size_t(-1));
  return result;
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_SEGMENTS_H
