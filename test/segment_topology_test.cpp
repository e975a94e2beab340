// SPDX-License-Identifier: GPL-3.0-or-later

// compute_segment_topology(), and pieces that are cut open: against counts on polygon soups.

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace segment_topology_test {

using Topology = RS::Segment_topology<std::size_t>;

std::vector<Topology> topologies_of(const Soup& soup, const Labels& labels)
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  std::vector<Topology> result;
  RS::compute_segment_topology(mesh, face_labels(mesh, labels), std::back_inserter(result));
  return result;
}

Topology topology_of(const Soup& soup)
{
  return topologies_of(soup, Labels(soup.polygons.size(), 0)).front();
}

/// A sheet with square holes: labels of a grid, faces at odd columns and rows without a segment.
Labels holes(std::size_t nx, std::size_t ny)
{
  Labels labels;
  for (std::size_t y = 0; y < ny; ++y)
    for (std::size_t x = 0; x < nx; ++x)
      labels.push_back(x % 4 == 2 && y % 4 == 2 ? std::size_t(-1) : 0);
  return labels;
}

TEST(Compute_segment_topology_test, knows_the_usual_surfaces)
{
  const Topology sphere_ = topology_of(sphere(2));
  EXPECT_EQ(sphere_.euler_characteristic, 2);
  EXPECT_EQ(sphere_.number_of_border_loops, 0u);
  EXPECT_EQ(sphere_.genus(), 0u);
  EXPECT_FALSE(sphere_.is_disc());
  const Topology torus_ = topology_of(torus(9, 7));
  EXPECT_EQ(torus_.euler_characteristic, 0);
  EXPECT_EQ(torus_.genus(), 1u);
  const Topology disc = topology_of(grid(3, 2));
  EXPECT_TRUE(disc.is_disc());
  EXPECT_EQ(disc.genus(), 0u);
  const Topology two = topology_of(joined(sphere(1), grid(1, 1)));
  EXPECT_EQ(two.number_of_components, 2u);
  EXPECT_EQ(two.euler_characteristic, 3);
  const auto sheet = topologies_of(grid(9, 9), holes(9, 9)); // four holes
  ASSERT_EQ(sheet.size(), 1u);
  EXPECT_EQ(sheet[0].number_of_border_loops, 5u);
  EXPECT_EQ(sheet[0].euler_characteristic, -3);
}

/// Marks the edges that a spanning tree of the faces of each segment does not cross.
template <typename Mesh, typename EdgeMap>
void mark_all_but_trees(const Mesh& mesh, const Soup& soup, const Labels& labels, EdgeMap is_cut)
{
  std::vector<std::size_t> tree_of(soup.polygons.size());
  std::iota(tree_of.begin(), tree_of.end(), std::size_t(0));
  std::set<Edge> crossed;
  for (const auto& [edge, both] : faces_of_edges(soup))
    if (both.size() == 2 && labels[both[0]] == labels[both[1]] &&
        tree_of[both[0]] != tree_of[both[1]]) {
      std::replace(tree_of.begin(), tree_of.end(), std::size_t(tree_of[both[0]]),
                   std::size_t(tree_of[both[1]]));
      crossed.insert(edge);
    }
  const Ranks<Mesh> rank(mesh);
  for (auto e : edges(mesh))
    put(is_cut, e, crossed.count(rank(e)) == 0);
}

/// A disc for each component of a segment that is cut along such edges.
template <typename Mesh>
void expect_pieces_are_discs(const Soup& soup, const Labels& labels)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  auto is_cut = edge_map(mesh, std::uint8_t(0));
  mark_all_but_trees(mesh, soup, labels, is_cut);
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, face_labels(mesh, labels), std::back_inserter(pieces),
                          RS::parameters::edge_is_constrained_map(is_cut));
  auto counts = count_segments(soup, labels);
  ASSERT_EQ(pieces.size(), counts.size());
  for (const auto& piece : pieces) {
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(piece.mesh));
    const Topology topology = topology_of(soup_of(piece.mesh));
    EXPECT_EQ(topology.number_of_components, counts[piece.segment].components);
    EXPECT_EQ(topology.number_of_border_loops, topology.number_of_components);
    EXPECT_EQ(topology.euler_characteristic, std::ptrdiff_t(topology.number_of_components));
    EXPECT_EQ(piece.faces.size(), counts[piece.segment].faces);
    for (std::size_t v = 0; v < piece.vertices.size(); ++v)
      EXPECT_EQ(soup_of(piece.mesh).points[v], soup.points[Ranks<Mesh>(mesh)(piece.vertices[v])]);
  }
}

TEST(Split_into_segments_test, pieces_are_cut_open_along_marked_edges)
{
  expect_pieces_are_discs<Surface_mesh>(sphere(2), Labels(128, 0));
  expect_pieces_are_discs<Surface_mesh>(torus(9, 7), Labels(63, 0));
  expect_pieces_are_discs<Surface_mesh>(grid(9, 9), holes(9, 9));
  expect_pieces_are_discs<Surface_mesh>(triangulated(cube()), Labels(12, 0));
  expect_pieces_are_discs<Surface_mesh>(Soup(), {});
  for_each_random_mesh(all_families, 4, [&](const Soup& soup, unsigned seed) {
    expect_pieces_are_discs<Surface_mesh>(soup, random_labels(soup, 1 + seed, seed));
    expect_pieces_are_discs<CGAL::Polyhedron_3<Kernel>>(soup, Labels(soup.polygons.size(), 0));
  });
}

} // namespace segment_topology_test
