// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <limits>
#include <list>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace evaluation_test {

using namespace test;
using Point_3 = Kernel::Point_3;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Face = Surface_mesh::Face_index;
using Labels = std::vector<int>; // not test::Labels

// ---------------------------------------------------------------------------------- fixtures

/// A strip of quads, with a border; face f has width 1, 2, 3, 4 and height 2:
///
///   5---6------7---------8------------9  y = 2
///   | 0 |  1   |    2    |     3      |
///   0---1------2---------3------------4  y = 0
///   x=0 1      3         6            10
Soup strip()
{
  return mapped(grid(4, 1), [](const Point& p) {
    return Point{p[0] * (p[0] + 1) / 2, 2 * p[1], 0};
  });
}

/// A closed surface of quads that are not flat.
Soup bumpy_torus()
{
  return random_mesh(Family::TORUS, 1);
}

/// Labels in the order of the faces.
template <typename Mesh, typename Label>
auto on(const Mesh& mesh, const std::vector<Label>& labels)
{
  auto map = get(CGAL::dynamic_face_property_t<Label>(), mesh);
  auto label = labels.begin();
  for (auto f : faces(mesh))
    put(map, f, *label++);
  return map;
}

/// All that the four measures say of two labelings.
struct Scores
{
  double rand;
  RS::Hamming_distance hamming;
  RS::Consistency_error consistency;
  std::optional<double> cut;
};

template <typename Mesh, typename MapA, typename MapB>
Scores scores(const Mesh& mesh, const MapA& a, const MapB& b)
{
  return {RS::rand_index_distance(mesh, a, b), RS::hamming_distance(mesh, a, b),
          RS::consistency_error(mesh, a, b), RS::cut_discrepancy(mesh, a, b)};
}

template <typename Mesh>
Scores scores(const Mesh& mesh, const Labels& a, const Labels& b)
{
  return scores(mesh, on(mesh, a), on(mesh, b));
}

/// All of them, with -1 where there is no cut discrepancy.
std::vector<double> numbers(const Scores& s)
{
  return {s.rand,
          s.hamming.distance,
          s.hamming.missing_rate,
          s.hamming.false_alarm_rate,
          s.consistency.global,
          s.consistency.local,
          s.consistency.global_by_area,
          s.consistency.local_by_area,
          s.cut.value_or(-1)};
}

void expect_near(const Scores& a, const Scores& b, double tolerance)
{
  for (std::size_t i = 0; i < numbers(a).size(); ++i)
    EXPECT_NEAR(numbers(a)[i], numbers(b)[i], tolerance) << "measure " << i;
}

Labels random_labels(std::size_t size, int number_of_labels, std::mt19937& random)
{
  Labels labels(size);
  for (int& label : labels)
    label = int(random() % unsigned(number_of_labels));
  return labels;
}

/// Calls `f(a, b, seed)` for pairs of random labelings, coarse and fine.
template <typename F>
void for_random_labelings(std::size_t size, F f)
{
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const int ka = 1 + int(random() % 9), kb = 1 + int(random() % 60);
    const Labels a = random_labels(size, ka, random), b = random_labels(size, kb, random);
    f(a, b);
  }
}

// ------------------------------------------------------------------- oracles: the definitions

double rand_by_pairs_of_faces(const Labels& a, const Labels& b)
{
  std::size_t pairs = 0, differ = 0;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t g = 0; g < f; ++g) {
      ++pairs;
      differ += (a[f] == a[g]) != (b[f] == b[g]);
    }
  return pairs == 0 ? 0 : double(differ) / double(pairs);
}

/// Areas of triangles and plane or nearly plane quads, by their diagonals.
std::vector<double> areas_of(const Surface_mesh& mesh)
{
  std::vector<double> areas;
  for (Face f : faces(mesh)) {
    std::vector<Point_3> p;
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      p.push_back(mesh.point(v));
    const auto n = CGAL::cross_product(p[2] - p[0], p.back() - p[1]);
    areas.push_back(p.size() == 3 ? std::sqrt(CGAL::squared_area(p[0], p[1], p[2]))
                                  : std::sqrt(n.squared_length()) / 2);
  }
  return areas;
}

/// The full contingency table.
struct Table
{
  std::map<std::pair<int, int>, double> cells;
  std::map<int, double> rows, columns;

  Table(const Labels& a, const Labels& b, const std::vector<double>& weights)
  {
    for (std::size_t f = 0; f < a.size(); ++f) {
      cells[{a[f], b[f]}] += weights[f];
      rows[a[f]] += weights[f];
      columns[b[f]] += weights[f];
    }
  }
};

RS::Hamming_distance hamming_by_definition(const Labels& a, const Labels& b,
                                           const std::vector<double>& areas)
{
  const Table t(a, b, areas);
  double total = 0, rm = 1, rf = 1;
  for (const auto& [i, area] : t.rows)
    total += area;
  for (const auto& [j, of_column] : t.columns) {
    double largest = 0;
    for (const auto& [ij, area] : t.cells)
      if (ij.second == j)
        largest = (std::max)(largest, area);
    rm -= largest / total;
  }
  for (const auto& [i, of_row] : t.rows) {
    double largest = 0;
    for (const auto& [ij, area] : t.cells)
      if (ij.first == i)
        largest = (std::max)(largest, area);
    rf -= largest / total;
  }
  return {(rm + rf) / 2, rm, rf};
}

/// GCE and LCE, face by face.
std::pair<double, double> consistency_by_faces(const Labels& a, const Labels& b,
                                               const std::vector<double>& weights)
{
  Table t(a, b, weights);
  double ab = 0, ba = 0, local = 0;
  for (std::size_t f = 0; f < a.size(); ++f) {
    const double cell = t.cells[{a[f], b[f]}];
    const double e_ab = 1 - cell / t.rows[a[f]], e_ba = 1 - cell / t.columns[b[f]];
    ab += e_ab;
    ba += e_ba;
    local += (std::min)(e_ab, e_ba);
  }
  const double n = double(a.size());
  return {(std::min)(ab, ba) / n, local / n};
}

std::vector<std::size_t> cut_vertices_of(const Surface_mesh& mesh, const Labels& labels)
{
  std::vector<std::size_t> result;
  for (auto e : edges(mesh))
    if (!is_border(e, mesh) && labels[face(halfedge(e, mesh), mesh).idx()] !=
                                 labels[face(opposite(halfedge(e, mesh), mesh), mesh).idx()]) {
      result.push_back(source(e, mesh).idx());
      result.push_back(target(e, mesh).idx());
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Distances along edges between all pairs of vertices (Floyd and Warshall).
std::vector<std::vector<double>> all_distances(const Surface_mesh& mesh)
{
  const std::size_t n = num_vertices(mesh);
  std::vector<std::vector<double>> d(
    n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t v = 0; v < n; ++v)
    d[v][v] = 0;
  for (auto e : edges(mesh)) {
    const auto v = source(e, mesh), w = target(e, mesh);
    d[v.idx()][w.idx()] = d[w.idx()][v.idx()] = std::sqrt(
      CGAL::squared_distance(mesh.point(v), mesh.point(w)));
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        d[i][j] = (std::min)(d[i][j], d[i][k] + d[k][j]);
  return d;
}

/// The mean distance of points of the surface from its centroid, by the centers of faces.
double mean_radius(const Surface_mesh& mesh)
{
  const std::vector<double> areas = areas_of(mesh);
  std::vector<Kernel::Vector_3> centers;
  Kernel::Vector_3 center(0, 0, 0);
  for (Face f : faces(mesh)) {
    Kernel::Vector_3 sum(0, 0, 0);
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      sum = sum + (mesh.point(v) - CGAL::ORIGIN);
    centers.push_back(sum / double(mesh.degree(f)));
    center = center + areas[f.idx()] * centers.back();
  }
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  double sum = 0;
  for (std::size_t f = 0; f < areas.size(); ++f)
    sum += areas[f] * std::sqrt((centers[f] - center / area).squared_length());
  return sum / area;
}

/// The mean over all cut vertices, if both sides have some.
std::optional<double> cut_by_definition(const Surface_mesh& mesh,
                                        const std::vector<std::vector<double>>& distances,
                                        const Labels& a, const Labels& b)
{
  const std::vector<std::size_t> of_a = cut_vertices_of(mesh, a), of_b = cut_vertices_of(mesh, b);
  if (of_a.empty() || of_b.empty())
    return std::nullopt;
  double sum = 0;
  for (const auto& [from, to] : {std::make_pair(of_a, of_b), std::make_pair(of_b, of_a)})
    for (std::size_t v : from) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t w : to)
        nearest = (std::min)(nearest, distances[v][w]);
      sum += nearest;
    }
  return sum / double(of_a.size() + of_b.size()) / mean_radius(mesh);
}

// ---------------------------------------------------------------------------- hand-computed

/// a: | 0 | 0    | 1       | 1          |    cut at x = 3
/// b: | 0 | 1    | 1       | 1          |    cut at x = 1
///
///   n_ij  j=0 j=1        a_ij / 2  j=0 j=1
///   i=0    1   1    2    i=0        1   2    3
///   i=1    0   2    2    i=1        0   7    7
///          1   3    4               1   9   10
TEST(Measures, a_strip_by_hand)
{
  const Surface_mesh mesh = to_surface_mesh(strip());
  const Scores s = scores(mesh, {0, 0, 1, 1}, {0, 1, 1, 1});

  // E^ab: 1/2, 1/2, 0; E^ba: 0, 2/3, 1/3; weights 1, 1, 2; by area: E^ab: 2/3, 1/3, 0; E^ba: 0,
  // 7/9, 2/9. Each of the 2 + 2 cut vertices is 2 from the other cut. Face centers are at x = 0.5,
  // 2, 4.5, 8 and the centroid is at x = 5: R = (1 * 4.5 + 2 * 3 + 3 * 0.5 + 4 * 3) / 10 = 2.4.
  expect_near(s,
              {(2 + 3 - 2 * 1) / 6.,
               {0.15, 1 - (1 + 7) / 10., 1 - (2 + 7) / 10.},
               {1 / 4., 1 / 8., 1 / 4., 1 / 12.},
               2 / 2.4},
              1e-15);
}

TEST(Measures, a_mesh_without_faces_or_with_one)
{
  const Surface_mesh empty;
  const Scores none = scores(empty, Labels{}, Labels{});
  EXPECT_EQ(numbers(none), (std::vector<double>{0, 0, 0, 0, 0, 0, 0, 0, -1}));

  const Surface_mesh triangle = to_surface_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Scores one = scores(triangle, {7}, {-3});
  EXPECT_EQ(numbers(none), numbers(one));
}

TEST(Rand_index_distance, takes_ranges_of_any_kind)
{
  EXPECT_EQ(RS::rand_index_distance(Labels{}, Labels{}), 0);
  EXPECT_EQ(RS::rand_index_distance(Labels{1}, Labels{2}), 0);
  const std::list<signed char> a = {-1, -1, 1, 1};
  const std::vector<bool> b = {false, true, true, true};
  const std::uint64_t c[] = {0, ~0ull, ~0ull, ~0ull};
  EXPECT_EQ(RS::rand_index_distance(a, b), 0.5);
  EXPECT_EQ(RS::rand_index_distance(a, c), 0.5);
  EXPECT_EQ(RS::rand_index_distance(b, c), 0);
}

TEST(Rand_index_distance, tells_labels_of_different_number)
{
  EXPECT_EQ(message_of([] {
              RS::rand_index_distance(Labels{1, 2, 3}, Labels{1, 2});
            }),
            "two labelings have 3 and 2 labels");
}

/// Two labels against two halves: every n_ij is F / 4. The numbers of pairs need more than 32 bits.
TEST(Rand_index_distance, is_exact_and_fast_on_10_million_faces)
{
  const std::uint64_t n = 10'000'000;
  std::vector<int> a(n);
  std::vector<std::int64_t> b(n);
  for (std::uint64_t f = 0; f < n; ++f) {
    a[f] = int(f % 2);
    b[f] = f < n / 2 ? -1'000'000'000'000 : 1'000'000'000'000;
  }
  const std::clock_t start = std::clock(); // CPU time, whatever else the machine does
  const double distance = RS::rand_index_distance(a, b);
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;

  const auto pairs = [](std::uint64_t m) { return m * (m - 1) / 2; };
  EXPECT_EQ(distance, double(4 * pairs(n / 2) - 8 * pairs(n / 4)) / double(pairs(n)));
  RecordProperty("milliseconds", int(1000 * seconds));
#if defined(__OPTIMIZE__) || defined(NDEBUG)
  EXPECT_LT(seconds, 2);
#endif
}

/// A million segments on either side: nothing may be quadratic in their number.
TEST(Rand_index_distance, takes_a_segment_a_face)
{
  const std::size_t n = 1'000'000;
  std::vector<std::uint64_t> small(n), large(n);
  for (std::size_t f = 0; f < n; ++f) {
    small[f] = n - f;
    large[f] = f * 0x9e3779b97f4a7c15ull; // an odd factor: all different
  }
  EXPECT_EQ(RS::rand_index_distance(small, large), 0);
  large[0] = large[1];
  EXPECT_DOUBLE_EQ(RS::rand_index_distance(small, large), 2. / (double(n) * double(n - 1)));
}

// ------------------------------------------------------------------------- against the oracles

TEST(Measures, agree_with_their_definitions)
{
  const Surface_mesh mesh = to_surface_mesh(bumpy_torus());
  const std::vector<double> areas = areas_of(mesh), ones(num_faces(mesh), 1);
  const auto distances = all_distances(mesh);
  for_random_labelings(num_faces(mesh), [&](const Labels& a, const Labels& b) {
    const Scores s = scores(mesh, a, b);
    const auto [global, local] = consistency_by_faces(a, b, ones);
    const auto [global_by_area, local_by_area] = consistency_by_faces(a, b, areas);
    expect_near(s,
                {rand_by_pairs_of_faces(a, b),
                 hamming_by_definition(a, b, areas),
                 {global, local, global_by_area, local_by_area},
                 cut_by_definition(mesh, distances, a, b)},
                1e-12);
  });
}

/// Few compact segments, so that cuts are far from each other, on a mesh with a border.
TEST(Measures, cut_discrepancy_follows_shortest_paths)
{
  const std::size_t nx = 12, ny = 9;
  std::mt19937 random(11);
  Soup soup = triangulated(grid(nx, ny));
  bump(soup, 0.25, random);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto distances = all_distances(mesh);

  // Two half planes each: the cuts are two lines across the mesh.
  const auto half_plane = [&] {
    const double angle = double(random() % 1000), x = double(random() % nx),
                 y = double(random() % ny);
    Labels labels;
    for (std::size_t f = 0; f < num_faces(mesh); ++f)
      labels.push_back((double(f / 2 % nx) - x) * std::cos(angle) +
                         (double(f / 2 / nx) - y) * std::sin(angle) >
                       0);
    return labels;
  };
  for (int i = 0; i < 200; ++i) {
    const Labels a = half_plane(), b = half_plane();
    const std::optional<double> expected = cut_by_definition(mesh, distances, a, b);
    EXPECT_NEAR(scores(mesh, a, b).cut.value_or(-1), expected.value_or(-1), 1e-12);
  }
}

// ---------------------------------------------------------------------------------- properties

TEST(Measures, do_not_depend_on_the_names_of_segments)
{
  const Surface_mesh mesh = to_surface_mesh(bumpy_torus());
  for_random_labelings(num_faces(mesh), [&](const Labels& a, const Labels& b) {
    std::vector<std::int64_t> sparse;
    for (int label : a)
      sparse.push_back((std::int64_t(label) - 3) * 0x123456789abcdef);
    std::vector<unsigned char> reversed;
    for (int label : b)
      reversed.push_back(static_cast<unsigned char>(255 - label));
    EXPECT_EQ(numbers(scores(mesh, a, b)),
              numbers(scores(mesh, on(mesh, sparse), on(mesh, reversed))));
  });
}

// ------------------------------------------------------------------------- meshes and maps

TEST(Measures, are_the_same_bits_on_every_mesh_type)
{
  const Surface_mesh mesh = to_surface_mesh(bumpy_torus());
  const Polyhedron polyhedron = to_mesh<Polyhedron>(bumpy_torus());
  for_random_labelings(num_faces(mesh), [&](const Labels& a, const Labels& b) {
    EXPECT_EQ(numbers(scores(mesh, a, b)), numbers(scores(polyhedron, a, b)));
  });
}

TEST(Measures, do_not_depend_on_scale)
{
  const Surface_mesh mesh = to_surface_mesh(bumpy_torus());
  std::mt19937 random(5);
  const Labels a = random_labels(num_faces(mesh), 4, random),
               b = random_labels(num_faces(mesh), 6, random);
  const Scores expected = scores(mesh, a, b);
  // Squares of lengths leave the range of double; at -1000 small coordinates lose bits.
  for (int exponent : {-1000, -600, -7, 600, 1000}) {
    const Soup soup = scaled(bumpy_torus(), std::ldexp(1, exponent));
    SCOPED_TRACE(exponent);
    expect_near(scores(to_surface_mesh(soup), a, b), expected, exponent > -1000 ? 0 : 1e-12);
  }
}

TEST(Measures, read_points_by_the_map_that_is_given)
{
  const Surface_mesh mesh = to_surface_mesh(strip());
  const auto a = on(mesh, Labels{0, 0, 1, 1}), b = on(mesh, Labels{0, 1, 1, 1});
  // All faces get width 1: x = 0, 1, 3, 6, 10 becomes 0, 1, 2, 3, 4. Values are returned.
  const auto map = boost::make_function_property_map<Surface_mesh::Vertex_index>(
    [&](Surface_mesh::Vertex_index v) {
      return Point_3(double(v.idx() % 5), mesh.point(v).y(), 0);
    });
  const auto np = RS::parameters::vertex_point_map(map);
  EXPECT_DOUBLE_EQ(RS::hamming_distance(mesh, a, b, np).distance, 0.25);
  EXPECT_DOUBLE_EQ(RS::consistency_error(mesh, a, b, np).local_by_area, 0.125);
  // R = (1.5 + 0.5 + 0.5 + 1.5) / 4 = 1.
  EXPECT_DOUBLE_EQ(RS::cut_discrepancy(mesh, a, b, np).value(), 1);
  EXPECT_DOUBLE_EQ(RS::cut_discrepancy(mesh, a, b, CGAL::parameters::vertex_point_map(map)).value(),
                   1);
}

/// Nothing of a face that was removed, or of a vertex without faces, counts.
TEST(Measures, ignore_what_was_removed)
{
  Surface_mesh mesh = to_surface_mesh(bumpy_torus());
  auto a = mesh.add_property_map<Face, int>("f:a").first;
  auto b = mesh.add_property_map<Face, int>("f:b").first;
  for (Face f : mesh.faces()) {
    a[f] = int(f.idx() % 4);
    b[f] = int(f.idx() / 9);
  }
  for (std::size_t i : {0, 5, 30, 31})
    CGAL::Euler::remove_face(halfedge(Face(Surface_mesh::size_type(i)), mesh), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  const Scores before = scores(mesh, a, b);
  mesh.add_vertex(Point_3(1e300, 0, 0));
  EXPECT_EQ(numbers(scores(mesh, a, b)), numbers(before));

  Labels in_order_a, in_order_b;
  for (Face f : mesh.faces()) {
    in_order_a.push_back(a[f]);
    in_order_b.push_back(b[f]);
  }
  EXPECT_EQ(before.rand, rand_by_pairs_of_faces(in_order_a, in_order_b));
  mesh.collect_garbage();
  const Scores after = scores(mesh, a, b); // faces may have moved: other orders of sums
  expect_near(before, after, 1e-14);
}

// ------------------------------------------------------------------------------- special cases

TEST(Cut_discrepancy, there_is_none_when_a_side_has_no_cut)
{
  const Surface_mesh mesh = to_surface_mesh(strip());
  EXPECT_EQ(scores(mesh, {0, 0, 0, 0}, {0, 1, 1, 1}).cut, std::nullopt);
  EXPECT_EQ(scores(mesh, {0, 1, 1, 1}, {0, 0, 0, 0}).cut, std::nullopt);
  EXPECT_EQ(scores(mesh, {0, 0, 0, 0}, {1, 1, 1, 1}).cut, std::nullopt);
}

/// Two pieces, of two triangles each; a cut in one has no path to a cut in the other.
TEST(Cut_discrepancy, there_is_none_without_a_path)
{
  const Surface_mesh mesh = to_surface_mesh(
    triangulated(joined(grid(1, 1), translated(grid(1, 1), 10, 0, 0))));
  EXPECT_EQ(scores(mesh, {0, 1, 2, 2}, {0, 0, 2, 3}).cut, std::nullopt);
  EXPECT_EQ(scores(mesh, {0, 1, 2, 3}, {0, 1, 2, 2}).cut, std::nullopt);
  EXPECT_EQ(scores(mesh, {0, 1, 2, 2}, {0, 1, 2, 2}).cut, 0);
}

TEST(Measures, a_surface_without_area)
{
  Surface_mesh mesh = to_surface_mesh(strip());
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 2, 3)}) {
    for (auto v : vertices(mesh))
      mesh.point(v) = p;
    EXPECT_EQ(numbers(scores(mesh, {0, 0, 1, 1}, {0, 1, 1, 1})),
              (std::vector<double>{0.5, 0, 0, 0, 0.25, 0.125, 0, 0, -1}));
  }
}

/// The square of its area underflows.
TEST(Measures, the_cut_discrepancy_of_a_surface_that_is_nearly_a_line_is_a_number)
{
  Surface_mesh mesh;
  constexpr double width = 1e-160;
  std::vector<Surface_mesh::Vertex_index> v;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j)
      v.push_back(mesh.add_vertex(Point_3(i, j * width, 0)));
  for (std::size_t i = 0; i < 3; ++i)
    mesh.add_face(v[2 * i], v[2 * i + 2], v[2 * i + 3], v[2 * i + 1]);
  // The cuts are at 1 and 2, the centroids at 1/2, 3/2 and 5/2: 1 / (2/3).
  const auto found = RS::cut_discrepancy(mesh, on(mesh, Labels{0, 1, 1}),
                                         on(mesh, Labels{0, 0, 1}));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, 1.5, 1e-2); // the area has few digits
}

TEST(Measures, tell_a_point_that_is_not_finite)
{
  Surface_mesh mesh = to_surface_mesh(strip());
  mesh.point(Surface_mesh::Vertex_index(3)) = Point_3(0, std::numeric_limits<double>::quiet_NaN(),
                                                      0);
  const auto a = on(mesh, Labels{0, 0, 1, 1});
  EXPECT_EQ(RS::rand_index_distance(mesh, a, a), 0); // does not look at points
  EXPECT_THROW(RS::hamming_distance(mesh, a, a), RS::Invalid_input);
  EXPECT_THROW(RS::consistency_error(mesh, a, a), RS::Invalid_input);
  EXPECT_EQ(message_of([&] { RS::cut_discrepancy(mesh, a, a); }),
            "the point of vertex 3 is not finite");
}

} // namespace evaluation_test
