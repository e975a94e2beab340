// SPDX-License-Identifier: GPL-3.0-or-later

// compute_segment_topology(), mark_segment_seams(): against counts on polygon soups.

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_seams.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <map>
#include <random>
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

std::set<Edge> seams_of(const Soup& soup, const Labels& labels,
                        const RS::Border_cost& cost = RS::Border_cost{10, CGAL_PI})
{
  const Surface_mesh mesh = to_surface_mesh(soup);
  auto map = edge_map(mesh, std::uint8_t(1)); // stale
  const std::size_t number = RS::mark_segment_seams(mesh, face_labels(mesh, labels), map, cost);
  std::set<Edge> seams;
  for (const auto& [edge, is_marked] : flags_of(mesh, map))
    if (is_marked)
      seams.insert(edge);
  EXPECT_EQ(number, seams.size());
  return seams;
}

/// Those inside segments.
std::set<Edge> inner_seams_of(const Soup& soup, const Labels& labels,
                              const RS::Border_cost& cost = RS::Border_cost{10, CGAL_PI})
{
  std::set<Edge> seams = seams_of(soup, labels, cost);
  for (const auto& [edge, both] : faces_of_edges(soup))
    if (both.size() == 2 && labels[both[0]] != labels[both[1]]) {
      EXPECT_EQ(seams.erase(edge), 1u);
    }
  return seams;
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

TEST(Compute_segment_topology_test, counts_as_brute_force_does)
{
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      const Labels labels = random_labels(soup, 2 + seed, seed);
      auto expected = count_segments(soup, labels);
      for (const Topology& topology : topologies_of(soup, labels)) {
        ASSERT_TRUE(expected.count(topology.segment));
        const Segment_counts counts = expected[topology.segment];
        expected.erase(topology.segment);
        EXPECT_EQ(topology.euler_characteristic, counts.euler_characteristic());
        EXPECT_EQ(topology.number_of_border_loops, counts.loops);
        EXPECT_EQ(topology.number_of_components, counts.components);
      }
      EXPECT_TRUE(expected.empty());
    }
}

TEST(Mark_segment_seams_test, no_seam_ends_on_a_closed_surface_with_a_handle)
{
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::vector<std::size_t> new_vertex;
    Soup soup = torus(30, 12);
    for (Point& p : soup.points) // a horn, from whose tip the seams' tree grows
      p[2] *= p[0] > 0 && p[2] > 0 ? 1 + 3 * p[0] : 1;
    shuffle_vertices(soup, random, new_vertex);
    std::map<std::size_t, int> seams_at;
    for (const Edge& edge : seams_of(soup, Labels(soup.polygons.size(), 0))) {
      ++seams_at[edge.first];
      ++seams_at[edge.second];
    }
    EXPECT_FALSE(seams_at.empty());
    for (const auto& [vertex, number] : seams_at)
      EXPECT_GE(number, 2) << vertex;
  }
}

TEST(Mark_segment_seams_test, a_tube_is_opened_along_its_shortest_line)
{
  // Squares around the middle of a prism of 12 sides; one side is lower by a notch, so that the
  // tube is shorter there.
  Soup tube;
  constexpr std::size_t sides = 12, rings = 5;
  const double pi = std::acos(-1.0);
  for (std::size_t i = 0; i <= rings; ++i)
    for (std::size_t s = 0; s < sides; ++s)
      tube.points.push_back({std::cos(2 * pi * double(s) / sides),
                             std::sin(2 * pi * double(s) / sides), double(i) * (s == 7 ? 0.8 : 1)});
  for (std::size_t i = 0; i < rings; ++i)
    for (std::size_t s = 0; s < sides; ++s) {
      const std::size_t t = (s + 1) % sides;
      tube.polygons.push_back(
        {i * sides + s, i * sides + t, (i + 1) * sides + t, (i + 1) * sides + s});
    }
  std::set<Edge> expected;
  for (std::size_t i = 0; i < rings; ++i)
    expected.insert(make_edge(i * sides + 7, (i + 1) * sides + 7));
  EXPECT_EQ(inner_seams_of(tube, Labels(sides * rings, 0)), expected);

  // With a valley along side 2, whose edges are concave, the seam hides there, unless only length
  // counts.
  for (std::size_t i = 0; i <= rings; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      tube.points[i * sides + 2][c] *= 0.5;
  std::set<Edge> hidden;
  for (std::size_t i = 0; i < rings; ++i)
    hidden.insert(make_edge(i * sides + 2, (i + 1) * sides + 2));
  EXPECT_EQ(inner_seams_of(tube, Labels(sides * rings, 0)), hidden);
  EXPECT_EQ(inner_seams_of(tube, Labels(sides * rings, 0), RS::Border_cost{0}), expected);
}

/// Pieces cut along seams: a disc for each component of a segment.
template <typename Mesh>
void expect_pieces_are_discs(const Soup& soup, const Labels& labels)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  auto is_seam = edge_map(mesh, std::uint8_t(0));
  RS::mark_segment_seams(mesh, face_labels(mesh, labels), is_seam);
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, face_labels(mesh, labels), std::back_inserter(pieces),
                          RS::parameters::edge_is_constrained_map(is_seam));
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

TEST(Mark_segment_seams_test, pieces_cut_along_seams_are_discs)
{
  expect_pieces_are_discs<Surface_mesh>(sphere(2), Labels(128, 0));
  expect_pieces_are_discs<Surface_mesh>(torus(9, 7), Labels(63, 0));
  expect_pieces_are_discs<Surface_mesh>(grid(9, 9), holes(9, 9));
  expect_pieces_are_discs<Surface_mesh>(triangulated(cube()), Labels(12, 0));
  expect_pieces_are_discs<Surface_mesh>(Soup(), {});
  EXPECT_TRUE(inner_seams_of(grid(4, 4), Labels(16, 0)).empty());
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      expect_pieces_are_discs<Surface_mesh>(soup, random_labels(soup, 1 + seed, seed));
      expect_pieces_are_discs<CGAL::Polyhedron_3<Kernel>>(soup, Labels(soup.polygons.size(), 0));
    }
}

} // namespace segment_topology_test
