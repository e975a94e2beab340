// SPDX-License-Identifier: GPL-3.0-or-later

#include "segments.h"

#include <CGAL/Region_segmentation/Segments/split_into_segments.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace split_into_segments_test {

/// Splits a mesh, and checks the pieces against the soup.
template <typename Mesh, typename Piece_mesh>
void check_pieces(const Soup& soup, const Labels& labels)
{
  const Mesh mesh = to_mesh<Mesh>(soup);
  std::vector<RS::Segment_piece<Piece_mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments<Piece_mesh>(mesh, face_labels(mesh, labels), std::back_inserter(pieces));
  const Ranks<Mesh> rank(mesh);
  std::map<typename boost::graph_traits<Mesh>::face_descriptor, std::size_t> rank_of_face;
  for (auto f : faces(mesh))
    rank_of_face.emplace(f, rank_of_face.size());

  auto expected = count_segments(soup, labels);
  std::size_t previous_first = 0;
  for (const auto& piece : pieces) {
    ASSERT_TRUE(CGAL::is_valid_polygon_mesh(piece.mesh));
    ASSERT_TRUE(expected.count(piece.segment));
    const Segment_counts counts = expected[piece.segment];
    expected.erase(piece.segment);
    EXPECT_EQ(piece.faces.size(), counts.faces);
    EXPECT_EQ(faces(piece.mesh).size(), counts.faces);
    EXPECT_EQ(edges(piece.mesh).size(), counts.edges);
    EXPECT_EQ(vertices(piece.mesh).size(), counts.vertices);
    ASSERT_EQ(piece.vertices.size(), counts.vertices);

    const std::size_t first = rank_of_face[piece.faces.front()];
    EXPECT_TRUE(&piece == &pieces.front() || first > previous_first);
    previous_first = first;
    const Soup copy = soup_of(piece.mesh);
    for (std::size_t v = 0; v < copy.points.size(); ++v)
      EXPECT_EQ(copy.points[v], soup.points[rank(piece.vertices[v])]);
    for (std::size_t f = 0; f < copy.polygons.size(); ++f) {
      const std::size_t original = rank_of_face[piece.faces[f]];
      EXPECT_EQ(labels[original], piece.segment);
      Polygon polygon;
      for (std::size_t v : copy.polygons[f])
        polygon.push_back(rank(piece.vertices[v]));
      Polygon same = soup.polygons[original];
      std::rotate(same.begin(), std::find(same.begin(), same.end(), polygon[0]), same.end());
      EXPECT_EQ(polygon, same);
    }
  }
  EXPECT_TRUE(expected.empty());
}

using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Other_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST(Split_into_segments_test, copies_every_segment_of_random_meshes)
{
  for_each_random_mesh(all_families, 5, [&](const Soup& soup, unsigned seed) {
    const Labels labels = random_labels(soup, 2 + seed, seed);
    check_pieces<Surface_mesh, Surface_mesh>(soup, labels);
    check_pieces<Polyhedron, Polyhedron>(soup, labels);
    check_pieces<Surface_mesh, Polyhedron>(soup, labels);
    check_pieces<Surface_mesh, Other_mesh>(soup, labels);
  });
}

} // namespace split_into_segments_test
