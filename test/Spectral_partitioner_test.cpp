// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Methods/Spectral_partitioner.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/evaluation.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace test;

namespace Spectral_partitioner_test {

// A graph whose sections know their affinity.

struct Nothing
{
  template <typename Section>
  void absorb(const Nothing&, const Section&)
  {}
};

struct Bond
{
  double affinity = 0;
  void absorb(const Bond& other) { affinity += other.affinity; }
};

struct Minus_logarithm
{
  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    return graph[s].affinity > 0 ? -std::log(graph[s].affinity)
                                 : std::numeric_limits<double>::quiet_NaN();
  }
};

using Graph = RS::Region_adjacency_graph<Nothing, Bond>;
using Partitioner = RS::Spectral_partitioner<Minus_logarithm>;

Graph graph_of(std::size_t regions)
{
  Graph graph;
  for (std::size_t r = 0; r < regions; ++r)
    graph.add_region();
  return graph;
}

/// Groups of `size` regions, each joined to all of its group, in a row: the last of one to the
/// first of the next by a weak link.
Graph row_of_cliques(std::uint32_t number, std::uint32_t size, double weak)
{
  Graph graph = graph_of(number * size);
  for (std::uint32_t c = 0; c < number; ++c) {
    for (std::uint32_t i = 0; i < size; ++i)
      for (std::uint32_t j = i + 1; j < size; ++j)
        graph.add_section(c * size + i, c * size + j, {1});
    if (c > 0)
      graph.add_section(c * size - 1, c * size, {weak});
  }
  return graph;
}

/// A sheet of regions; bonds between 1 and 2, and weak ones where a column ends a block.
Graph sheet(std::uint32_t nx, std::uint32_t ny, std::uint32_t block, double weak, unsigned seed = 1)
{
  std::mt19937 random(seed);
  Graph graph = graph_of(nx * ny);
  for (std::uint32_t y = 0; y < ny; ++y)
    for (std::uint32_t x = 0; x < nx; ++x) {
      const double bond = 1 + double(random() % 64) / 64;
      if (x + 1 < nx)
        graph.add_section(y * nx + x, y * nx + x + 1, {(x + 1) % block ? bond : weak});
      if (y + 1 < ny)
        graph.add_section(y * nx + x, (y + 1) * nx + x, {3 - bond});
    }
  return graph;
}

bool is_each_connected(const Graph& graph, const RS::Partition& segments)
{
  RS::internal::Lowest_root_forest forest(graph.index_bound_of_regions());
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto a = graph.source(*range.first), b = graph.target(*range.first);
    if (segments[a] == segments[b] && graph.is_mergeable(*range.first))
      forest.unite(a, b);
  }
  return forest.take_partition().number_of_parts() == segments.number_of_parts();
}

TEST(Additive_visibility_cost_test, is_proportional_to_the_length_whatever_the_areas)
{
  using Visibility_graph = RS::Region_adjacency_graph<RS::Visibility_region_data,
                                                      RS::Visibility_section_data>;
  const auto affinity = [](double area, double other_area, double length) {
    Visibility_graph graph;
    for (double a : {area, other_area}) {
      RS::Visibility_region_data region;
      region.area = a;
      region.visibility = 1;
      graph.add_region(region);
    }
    RS::Visibility_section_data section;
    section.length = length;
    section.concave = 0.5 * length;
    const auto s = graph.add_section(0, 1, section);
    return std::exp(-RS::Additive_visibility_cost()(graph, s));
  };
  // The depth counts squared; regions are equally thick, and do not see each other.
  const double expected = 0.25 / std::pow(0.5 + 0.05, 2) / 0.18 * std::pow(0.01, 0.195);
  for (double area : {0.1, 0.3, 0.6}) {
    EXPECT_NEAR(affinity(area, 0.4, 0.25), expected, 1e-12);
    EXPECT_NEAR(affinity(area, 0.4, 0.5), 2 * expected, 1e-12);
  }
}

TEST(Spectral_partitioner_test, two_cliques_part_at_the_weak_link)
{
  const auto segments = Partitioner()(row_of_cliques(2, 3, 0.1), 2);
  EXPECT_EQ(segments.number_of_parts(), 2u);
  EXPECT_EQ(labels_of(segments), (Labels{0, 0, 0, 1, 1, 1}));
}

TEST(Spectral_partitioner_test, cliques_in_a_row_part_at_all_weak_links)
{
  // Small ones go to the dense solver, large ones to the sparse one.
  for (std::uint32_t size : {3u, 5u, 25u}) {
    const auto segments = Partitioner()(row_of_cliques(5, size, 0.05), 5);
    EXPECT_EQ(segments.number_of_parts(), 5u);
    for (std::uint32_t r = 0; r < 5 * size; ++r)
      EXPECT_EQ(segments[r], r / size);
  }
}

TEST(Spectral_partitioner_test, a_path_parts_at_its_weak_link)
{
  Graph path = graph_of(9);
  for (std::uint32_t r = 1; r < 9; ++r)
    path.add_section(r - 1, r, {r == 3 ? 0.05 : 1.0});
  EXPECT_EQ(labels_of(Partitioner()(path, 2)), (Labels{0, 0, 0, 1, 1, 1, 1, 1, 1}));
}

TEST(Spectral_partitioner_test, weighs_a_cut_against_what_it_cuts_off)
{
  // The last region hangs by the weakest link, but it alone is not worth a cut: the normalized cut
  // is 0.3 (1 / 0.3 + 1 / 25.1) = 1.01 there, and 0.4 (1 / 12.4 + 1 / 13) = 0.06 between the
  // cliques.
  Graph graph = row_of_cliques(2, 4, 0.4);
  const auto last = graph.add_region();
  graph.add_section(7, last, {0.3});
  EXPECT_EQ(labels_of(Partitioner()(graph, 2)), (Labels{0, 0, 0, 0, 1, 1, 1, 1, 1}));
}

TEST(Spectral_partitioner_test, finds_the_second_eigenvector_of_a_path)
{
  // Of L y = lambda D y on a path of n nodes: lambda = 1 - cos(pi / (n - 1)), y_i = cos(pi i / (n -
  // 1)).
  for (std::size_t n : {10, 300}) {
    std::vector<RS::internal::Affinity> bonds;
    for (std::size_t i = 1; i < n; ++i)
      bonds.push_back({i - 1, i, 0.25});
    const Eigen::MatrixXd points = RS::internal::commute_time_embedding<RS::internal::Eigen_solver>(
      n, bonds, 4);
    ASSERT_EQ(points.cols(), 4);
    const double angle = CGAL_PI / double(n - 1), scale = points(0, 1);
    // y^T D y = 1, D = 1/2 but for the ends, and the coordinate is y over the root of lambda.
    EXPECT_NEAR(scale * scale * (1 - std::cos(angle)) * double(n - 1) / 4, 1, 1e-5);
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(points(Eigen::Index(i), 1) / scale, std::cos(angle * double(i)), 1e-5);
  }
}

TEST(Spectral_partitioner_test, dense_and_sparse_solvers_agree)
{
  const std::size_t n = 200;
  std::mt19937 random(1);
  std::vector<Eigen::Triplet<double, Eigen::Index>> entries;
  for (std::size_t i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1 + double(random() % 1000) / 1000);
    if (i > 0) {
      entries.emplace_back(i, i - 1, -0.5);
      entries.emplace_back(i - 1, i, -0.5);
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const auto dense = RS::internal::dense_lowest_eigenpairs(matrix, 6);
  const auto any = RS::internal::Eigen_solver()(matrix, 6);
  for (Eigen::Index j = 0; j < 6; ++j) {
    EXPECT_NEAR(dense.values[j], any.values[j], 1e-9);
    EXPECT_NEAR(std::abs(dense.vectors.col(j).dot(any.vectors.col(j))), 1, 1e-6);
  }
}

TEST(Spectral_partitioner_test, finds_as_many_eigenpairs_as_asked_for_where_many_are_equal)
{
  // Paths of three nodes, whose eigenvalues are 0, 1 and 2. (Spectra 1.0.1 finds only 13 of 71
  // nodes.)
  for (std::size_t n : {64, 71, 90}) {
    std::vector<RS::internal::Affinity> bonds;
    for (std::size_t i = 0; i + 1 < n; ++i)
      if ((i + 1) % 3 != 0)
        bonds.push_back({i, i + 1, 1});
    const Eigen::MatrixXd points = RS::internal::commute_time_embedding<RS::internal::Eigen_solver>(
      n, bonds, 14);
    EXPECT_EQ(std::size_t(points.rows()), n);
    EXPECT_EQ(points.cols(), 14) << n;
    EXPECT_TRUE(points.allFinite()) << n;
  }
}

TEST(Spectral_partitioner_test, segments_are_connected_and_as_many_as_wanted)
{
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Graph graph = sheet(17, 9, 6, 0.1, seed);
    for (std::size_t k : {1, 2, 3, 7, 40, 152, 153, 400}) {
      SCOPED_TRACE(k);
      const auto segments = Partitioner()(graph, k);
      EXPECT_EQ(segments.number_of_parts(), std::min<std::size_t>(k, 153));
      EXPECT_TRUE(is_numbered_by_first_face(labels_of(segments), segments.number_of_parts()));
      EXPECT_TRUE(is_each_connected(graph, segments));
      EXPECT_EQ(Partitioner()(graph, k), segments);
    }
  }
}

TEST(Spectral_partitioner_test, does_not_depend_on_the_scale_of_affinities)
{
  for (double scale : {std::exp2(-500), std::exp2(500)}) {
    Graph graph = sheet(12, 8, 4, 0.1);
    const auto expected = Partitioner()(graph, 5);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      graph[*range.first].affinity *= scale;
    EXPECT_EQ(Partitioner()(graph, 5), expected);
  }
}

TEST(Spectral_partitioner_test, keeps_pieces_and_barred_sections_apart)
{
  Graph graph = row_of_cliques(4, 4, 1);
  graph.forbid_merge(*graph.section(7, 8));
  graph[*graph.section(3, 4)].affinity = 0; // no connection either
  EXPECT_EQ(labels_of(Partitioner()(graph, 1)),
            (Labels{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2}));
  const auto four = Partitioner()(graph, 4);
  EXPECT_EQ(four.number_of_parts(), 4u);
  EXPECT_TRUE(is_each_connected(graph, four));
  EXPECT_EQ(labels_of(Partitioner()(graph_of(3), 2)), (Labels{0, 1, 2}));
  EXPECT_EQ(labels_of(Partitioner()(graph_of(1), 2)), (Labels{0}));
  EXPECT_EQ(Partitioner()(Graph(), 2).number_of_parts(), 0u);
}

TEST(Spectral_partitioner_test, finds_the_balls_of_a_row)
{
  // Three balls in a row that overlap a little, of triangles: each point of a sphere goes out to
  // the union.
  Labels truth;
  const Soup soup = mapped(sphere(4), [](const Point& p) {
    const double x = 2.6 * std::asin(p[0]) / std::asin(1.0), away = std::hypot(p[1], p[2]);
    double radius = 0.02;
    for (double center : {-1.7, 0.0, 1.7})
      radius = std::max(radius, std::sqrt(std::max(0.0, 0.8 - (x - center) * (x - center))));
    return Point{x, away > 0 ? radius * p[1] / away : 0, away > 0 ? radius * p[2] / away : 0};
  });
  for (const Polygon& polygon : soup.polygons) {
    double x = 0;
    for (std::size_t v : polygon)
      x += soup.points[v][0] / double(polygon.size());
    truth.push_back(x < -0.85 ? 0 : x < 0.85 ? 1 : 2);
  }
  const auto np = RS::parameters::number_of_segments(3).method(RS::Spectral_partitioning<>());
  const Surface_mesh mesh = to_surface_mesh(soup);
  const Labels labels = segments_of(mesh, np);
  EXPECT_LT(RS::rand_index_distance(labels, truth), 0.06);
  EXPECT_TRUE(is_numbered_by_first_face(labels, 3));
  EXPECT_TRUE(is_connected(soup, labels));
  EXPECT_EQ(segments_of(to_mesh<CGAL::Polyhedron_3<Kernel>>(soup), np), labels);

  // Prepared once, asked for several numbers.
  const RS::Segmenter segmenter(mesh, RS::parameters::method(RS::Spectral_partitioning<>()));
  for (std::size_t k : {3, 2, 9, 3}) {
    auto map = face_map(mesh);
    EXPECT_EQ(segmenter.segment(map, k), k);
    EXPECT_EQ(labels_of(mesh, map), segments_of(mesh, RS::parameters::number_of_segments(k).method(
                                                        RS::Spectral_partitioning<>())));
  }
}

TEST(Spectral_partitioner_test, can_be_cancelled_before_it_starts)
{
  struct Visitor
  {
    bool go_further(const char* stage, double) const { return std::string(stage) != "merging"; }
  };
  const Surface_mesh mesh = to_surface_mesh(sphere(2));
  auto map = face_map(mesh);
  const auto np = RS::parameters::number_of_segments(3).method(RS::Spectral_partitioning<>());
  Visitor visitor;
  EXPECT_THROW(RS::segment(mesh, map, np.visitor(std::ref(visitor))), RS::Segmentation_cancelled);
  EXPECT_EQ(RS::segment(mesh, map, np), 3u);
}

TEST(Spectral_partitioning_test, takes_no_seeds)
{
  const Surface_mesh mesh = to_surface_mesh(sphere(2));
  auto map = face_map(mesh), seeds = face_map(mesh, std::size_t(-1));
  put(seeds, *faces(mesh).begin(), 0);
  const auto np = RS::parameters::number_of_segments(3)
                    .method(RS::Spectral_partitioning<>())
                    .face_seed_map(seeds);
  EXPECT_THROW(RS::segment(mesh, map, np), RS::Invalid_input);
  EXPECT_EQ(labels_of(mesh, map), Labels(num_faces(mesh), 12345)) << "nothing is written";
}

TEST(Spectral_partitioner_test, gives_connected_segments_on_random_meshes)
{
  for (Family family : all_families)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      const Soup soup = random_mesh(family, seed);
      std::mt19937 random(seed);
      const std::set<Edge> constrained = random_edges(soup, 8, random);
      const Surface_mesh mesh = to_surface_mesh(soup);
      const Labels labels = segments_of(mesh,
                                        RS::parameters::number_of_segments(6)
                                          .method(RS::Spectral_partitioning<>())
                                          .edge_is_constrained_map(edge_map(mesh, constrained))
                                          .component_links(false));
      EXPECT_GE(std::set<std::size_t>(labels.begin(), labels.end()).size(), 6u);
      EXPECT_TRUE(is_connected(soup, labels, constrained));
    }
}

} // namespace Spectral_partitioner_test
