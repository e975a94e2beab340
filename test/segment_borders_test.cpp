// SPDX-License-Identifier: GPL-3.0-or-later

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/segment_borders.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace segment_borders_test {

using Border = RS::Segment_border<Surface_mesh, std::size_t>;

std::vector<Border> borders_of(const Surface_mesh& mesh, const Labels& labels)
{
  std::vector<Border> borders;
  RS::extract_segment_borders(mesh, face_labels(mesh, labels), std::back_inserter(borders));
  return borders;
}

/// The edges with two faces of different labels.
std::set<Edge> edges_between(const Soup& soup, const Labels& labels)
{
  std::set<Edge> result;
  for (const auto& [edge, both] : faces_of_edges(soup))
    if (both.size() == 2 && labels[both[0]] != labels[both[1]])
      result.insert(edge);
  return result;
}

/// The vertices where lines must end.
std::set<std::size_t> junctions(const Soup& soup, const Labels& labels)
{
  std::map<std::size_t, std::size_t> degree;
  for (const auto& [u, v] : edges_between(soup, labels)) {
    ++degree[u];
    ++degree[v];
  }
  std::set<std::size_t> result;
  for (const auto& [vertex, number] : degree)
    if (number != 2)
      result.insert(vertex);
  for (const auto& [edge, both] : faces_of_edges(soup))
    if (both.size() == 1) {
      result.insert(edge.first);
      result.insert(edge.second);
    }
  return result;
}

void check_borders(const Soup& soup, const Labels& labels)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  const std::set<std::size_t> ends = junctions(soup, labels);
  std::set<Edge> covered;
  const auto first = [&](std::size_t label) {
    return std::find(labels.begin(), labels.end(), label);
  };
  for (const Border& border : borders_of(mesh, labels)) {
    EXPECT_NE(border.segment, std::size_t(RS::no_segment));
    EXPECT_TRUE(border.opposite_segment == RS::no_segment ||
                first(border.segment) < first(border.opposite_segment));
    std::vector<std::size_t> line = {source(border.halfedges.front(), mesh)};
    for (auto h : border.halfedges) {
      EXPECT_EQ(source(h, mesh), Surface_mesh::Vertex_index(unsigned(line.back())));
      line.push_back(target(h, mesh));
      EXPECT_EQ(labels[mesh.face(h)], border.segment);
      EXPECT_EQ(labels[mesh.face(mesh.opposite(h))], border.opposite_segment);
      EXPECT_TRUE(covered.insert(make_edge(line[line.size() - 2], line.back())).second) << "twice";
    }
    if (border.is_closed)
      EXPECT_EQ(line.front(), line.back());
    else
      EXPECT_TRUE(ends.count(line.front()) && ends.count(line.back()));
    for (std::size_t i = border.is_closed ? 0 : 1; i + 1 < line.size(); ++i)
      EXPECT_FALSE(ends.count(line[i]));
  }
  EXPECT_EQ(covered, edges_between(soup, labels));
}

TEST(Extract_segment_borders_test, covers_every_edge_once_from_junction_to_junction)
{
  for_each_random_mesh(all_families, 6, [&](const Soup& soup, unsigned seed) {
    check_borders(soup, random_labels(soup, 2 + seed, seed));
  });
}

} // namespace segment_borders_test
