// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "oracles.h"

#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#endif

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace Segmenter_test {

namespace RS = CGAL::Region_segmentation;
using namespace test;
using Face = Surface_mesh::Face_index;

/// The default method with few first regions, so that there are some of several faces on a small
/// mesh.
RS::Visibility_merging visibility(std::size_t number_of_regions = 40)
{
  RS::Visibility_merging method;
  method.superfacets.number = number_of_regions;
  return method;
}

RS::Two_step two_step(double maximum_angle = 5)
{
  RS::Two_step method;
  method.maximum_angle = maximum_angle;
  method.feature_convexity = RS::Feature_convexity::ALL;
  return method;
}

/// A map into labels by the index of the face.
auto index_map(Labels& labels)
{
  return boost::make_iterator_property_map(labels.begin(),
                                           boost::typed_identity_property_map<Face>());
}

template <typename Segmenter>
Labels labels(const Segmenter& segmenter, std::size_t k)
{
  Labels result(segmenter.surface().number_of_faces(), 12345);
  const std::size_t n = segmenter.segment(index_map(result), k);
  EXPECT_TRUE(is_numbered_by_first_face(result, n)) << k;
  return result;
}

/// A finely divided bar between two cubes, in triangles.
Surface_mesh fine_dumbbell()
{
  std::vector<Voxel> voxels = voxel_block({0, 0, 0}, {8, 8, 8});
  for (const auto& part : {voxel_block({8, 3, 3}, {16, 5, 5}), voxel_block({16, 0, 0}, {24, 8, 8})})
    voxels.insert(voxels.end(), part.begin(), part.end());
  return to_surface_mesh(triangulated(voxel_surface(voxels)));
}

/// The edges of the plane of this x: the loop around a bar along the x axis.
std::set<Edge> loop_at(const Surface_mesh& mesh, double x)
{
  return edges_where(mesh, [x](const Kernel::Point_3& p) { return p.x() == x; });
}

// Asking

TEST(Segmenter_test, gives_what_segment_gives)
{
  for_each_random_mesh(all_families, 3, [](const Soup& soup, unsigned) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    const RS::Segmenter by_visibility(mesh, RS::parameters::method(visibility()));
    const RS::Segmenter by_two_step(mesh, RS::parameters::method(two_step()));
    const RS::Segmenter by_default(mesh);
    RS::Merge_tree tree;
    const auto expect_equal = [&](const auto& segmenter, std::size_t k, const auto& method) {
      const auto np = RS::parameters::number_of_segments(k).method(method);
      // Alone, borders are moved for this number only; with the tree, for all.
      EXPECT_EQ(labels(segmenter, k), segments_of(mesh, np)) << k;
      EXPECT_EQ(labels(segmenter, k), segments_of(mesh, np.merge_tree(std::ref(tree)))) << k;
    };
    for (std::size_t k : {1, 2, 3, 7, 20, 39, 60, 1000}) {
      const auto np = RS::parameters::number_of_segments(k);
      expect_equal(RS::Segmenter(mesh, np), k, RS::Learned_merging());
      EXPECT_EQ(segments_of(mesh, np), labels(RS::Segmenter(mesh, np), k)) << "by default";
      expect_equal(RS::Segmenter(mesh, np.method(visibility())), k, visibility());
      if (k <= 20) { // There are as many regions without a number.
        expect_equal(by_default, k, RS::Learned_merging());
        expect_equal(by_visibility, k, visibility());
      }
      EXPECT_EQ(labels(by_two_step, k),
                segments_of(mesh, RS::parameters::method(two_step()).number_of_segments(k)));
    }
    auto map = face_map(mesh);
    by_visibility.segment(map);
    EXPECT_EQ(labels_of(mesh, map), segments_of(mesh, RS::parameters::method(visibility())));
  });
}

TEST(Segmenter_test, writes_regions_and_tree)
{
  const Surface_mesh mesh = fine_dumbbell();
  auto regions = face_map(mesh);
  RS::Merge_tree tree;
  const RS::Segmenter segmenter(
    mesh, RS::parameters::method(visibility()).region_map(regions).merge_tree(tree));
  EXPECT_EQ(labels_of(mesh, regions),
            Labels(segmenter.regions().begin(), segmenter.regions().end()));
  EXPECT_EQ(tree.number_of_regions(), 40u);
  EXPECT_EQ(tree.merges().size(), 39u);
  EXPECT_EQ(segmenter.merge_tree().merges().size(), 39u);
  EXPECT_EQ(segmenter.surface().number_of_faces(), num_faces(mesh));
}

TEST(Segmenter_test, can_be_moved_copied_and_held_by_type)
{
  const Surface_mesh mesh = fine_dumbbell();
  RS::Segmenter first(mesh, RS::parameters::method(two_step()));
  const Labels before = labels(first, 3);
  const auto copy = first;
  const auto moved = std::move(first);
  EXPECT_EQ(labels(copy, 3), before);
  EXPECT_EQ(labels(moved, 3), before);
  RS::Segmenter by_default(mesh);
  const Labels by_default_before = labels(by_default, 4);
  std::optional<RS::Segmenter<Surface_mesh>> held; // with the default method
  held.emplace(std::move(by_default));
  EXPECT_EQ(labels(*held, 4), by_default_before);
  const RS::Segmenter<Surface_mesh> named(mesh);
  EXPECT_EQ(labels(named, 4), by_default_before);
  const Soup soup = soup_of(mesh);
  const RS::Polygon_soup_segmenter<> of_soup(soup.points, soup.polygons);
  Labels of_polygons(soup.polygons.size());
  of_soup.segment(of_polygons, 4);
  EXPECT_EQ(of_polygons, by_default_before);
}

TEST(Segmenter_test, can_be_asked_from_several_threads)
{
  const Surface_mesh mesh = fine_dumbbell();
  const RS::Segmenter by_visibility(mesh, RS::parameters::method(visibility()));
  const RS::Segmenter by_two_step(mesh, RS::parameters::method(two_step()));
  std::vector<Labels> expected;
  for (std::size_t k = 2; k < 10; ++k) {
    expected.push_back(labels(by_visibility, k));
    expected.push_back(labels(by_two_step, k));
  }
  std::vector<std::vector<Labels>> found(4);
  std::vector<std::thread> threads;
  for (auto& of_thread : found)
    threads.emplace_back([&] {
      for (std::size_t k = 2; k < 10; ++k) {
        of_thread.push_back(labels(by_visibility, k));
        of_thread.push_back(labels(by_two_step, k));
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& of_thread : found)
    EXPECT_EQ(of_thread, expected);
}

TEST(Segmenter_test, reads_coordinates_once)
{
  Surface_mesh mesh = fine_dumbbell();
  RS::Segmenter segmenter(mesh, RS::parameters::method(visibility()));
  const Labels before = labels(segmenter, 6);
  for (auto v : mesh.vertices())
    mesh.point(v) = Kernel::Point_3(0, 0, 0);
  EXPECT_EQ(labels(segmenter, 6), before);
  segmenter.add_constraints(edge_map(mesh, loop_at(mesh, -1)));
  EXPECT_EQ(labels(segmenter, 6), before) << "no edge is constrained";
}

struct Cancelling_visitor
{
  std::string stage;
  double fraction;

  bool on_progress(const char* s, double f) { return s != stage || f < fraction; }
};

TEST(Segmenter_test, can_be_cancelled)
{
  const Surface_mesh mesh = fine_dumbbell();
  const auto map = face_map(mesh);
  for (const char* stage : {"reading", "regions", "rays", "draws", "borders"}) {
    Cancelling_visitor visitor{stage, 0.5};
    EXPECT_THROW(RS::Segmenter(mesh, RS::parameters::visitor(std::ref(visitor)).region_map(map)),
                 RS::Segmentation_cancelled)
      << stage;
  }
  RS::Segmenter segmenter(mesh, RS::parameters::method(two_step()));
  Cancelling_visitor visitor{"merging", 0};
  EXPECT_THROW(segmenter.segment(map, 2, RS::parameters::visitor(std::ref(visitor))),
               RS::Segmentation_cancelled);
  EXPECT_EQ(labels_of(mesh, map), Labels(num_faces(mesh), 12345)) << "nothing is written";
}

// Constraints

TEST(Segmenter_test, edges_that_separate_nothing_have_no_effect)
{
  const Surface_mesh mesh = fine_dumbbell();
  RS::Segmenter segmenter(mesh, RS::parameters::method(visibility(5)));
  const Labels before = labels(segmenter, 3);
  const Labels regions(segmenter.regions().begin(), segmenter.regions().end());
  std::set<Edge> within; // each edge alone within a region
  for (auto e : mesh.edges()) {
    const auto f = mesh.face(mesh.halfedge(e)), g = mesh.face(mesh.opposite(mesh.halfedge(e)));
    if (regions[f] == regions[g]) {
      within.insert(make_edge(mesh.vertex(e, 0), mesh.vertex(e, 1)));
      break;
    }
  }
  segmenter.add_constraints(edge_map(mesh, within));
  EXPECT_EQ(Labels(segmenter.regions().begin(), segmenter.regions().end()), regions);
  EXPECT_EQ(labels(segmenter, 3), before);
}

template <typename Method>
void test_late_constraints(const Method& method)
{
  for_each_random_mesh(all_families, 2, [&](const Soup& soup, unsigned seed) {
    const Surface_mesh mesh = to_surface_mesh(soup);
    std::mt19937 random(seed);
    RS::Segmenter segmenter(mesh, RS::parameters::method(method));
    std::set<Edge> drawn;
    for (int round = 0; round < 2; ++round) {
      for (const Edge& e : random_edges(soup, 8, random))
        drawn.insert(e);
      segmenter.add_constraints(edge_map(mesh, drawn));
      const auto early = RS::parameters::method(method).edge_is_constrained_map(
        edge_map(mesh, drawn));
      for (std::size_t k : {1, 5, 7})
        EXPECT_EQ(labels(segmenter, k), segments_of(mesh, early.number_of_segments(k)))
          << "round " << round;
    }
  });
}

TEST(Segmenter_test, later_constraints_give_the_labels_of_a_new_segmenter)
{
  test_late_constraints(RS::Learned_merging());
  test_late_constraints(visibility(15));
#ifdef TEST_EIGEN
  test_late_constraints(RS::Smooth_faces());
#endif
  test_late_constraints(two_step());
}

// Noise is smoothed once, and only for a method that wants it.
TEST(Segmenter_test, later_constraints_do_not_smooth_noise_again)
{
  const Surface_mesh mesh = to_surface_mesh(with_noise(sphere(4), 0.02, 1));
  const auto first_point = [&](const auto& segmenter) { return segmenter.surface().point(0); };
  RS::Segmenter segmenter(mesh);
  const RS::Segmenter unsmoothed(mesh, RS::parameters::method(two_step()));
  const auto smoothed = first_point(segmenter);
  EXPECT_GT(norm(smoothed - first_point(unsmoothed)), 0);
  segmenter.add_constraints(edge_map(mesh, loop_at(mesh, 0)));
  EXPECT_EQ(norm(smoothed - first_point(segmenter)), 0);
}

TEST(Segmenter_test, constraints_that_are_cancelled_change_nothing)
{
  const Surface_mesh mesh = fine_dumbbell();
  const std::set<Edge> loop = loop_at(mesh, 11);
  RS::Segmenter segmenter(mesh, RS::parameters::method(visibility()));
  const Labels before = labels(segmenter, 4);
  Cancelling_visitor visitor{"draws", 0.5};
  EXPECT_THROW(
    segmenter.add_constraints(edge_map(mesh, loop), RS::parameters::visitor(std::ref(visitor))),
    RS::Segmentation_cancelled);
  EXPECT_EQ(labels(segmenter, 4), before);
  segmenter.add_constraints(edge_map(mesh, loop));
  const auto faces = labels_of(RS::Partition::into_single_elements(num_faces(mesh)));
  EXPECT_TRUE(separates(soup_of(mesh), loop, faces, labels(segmenter, 4)));
}

// Seeds

constexpr std::size_t no_seed = std::size_t(-1);

/// The face whose corners are nearest to a point.
Face face_near(const Surface_mesh& mesh, double x, double y, double z)
{
  const auto distance = [&](Face f) {
    double sum = 0;
    for (auto v : vertices_around_face(mesh.halfedge(f), mesh))
      sum += squared_distance(mesh.point(v), Kernel::Point_3(x, y, z));
    return sum;
  };
  return *std::min_element(mesh.faces().begin(), mesh.faces().end(),
                           [&](Face a, Face b) { return distance(a) < distance(b); });
}

/// Whether faces of one seed share a label, and faces of two do not.
::testing::AssertionResult follows_seeds(const Labels& labels,
                                         const std::vector<std::size_t>& seeds)
{
  for (std::size_t f = 0; f < seeds.size(); ++f)
    for (std::size_t g = f + 1; g < seeds.size(); ++g)
      if (seeds[f] != no_seed && seeds[g] != no_seed &&
          (seeds[f] == seeds[g]) != (labels[f] == labels[g]))
        return ::testing::AssertionFailure()
               << "faces " << f << " and " << g << " with seeds " << seeds[f] << ", " << seeds[g];
  return ::testing::AssertionSuccess();
}

template <typename Method>
void test_seeds_on_dumbbell(const Method& method)
{
  const Surface_mesh mesh = fine_dumbbell();
  auto seeds = face_map(mesh, no_seed);
  // One seed in both cubes, on paths over the bar, and others on the first cube and on the bar.
  put(seeds, face_near(mesh, 0, 0, 0), 7);
  put(seeds, face_near(mesh, 24, 8, 8), 7);
  put(seeds, face_near(mesh, 0, 8, 8), 3);
  put(seeds, face_near(mesh, 12, 5, 5), 1000000);
  const auto values = labels_of(mesh, seeds);

  RS::Segmenter segmenter(mesh, RS::parameters::method(method));
  segmenter.set_seeds(seeds);
  for (std::size_t k : {1, 2, 3, 4, 6, 20, 500}) {
    const Labels after = labels(segmenter, k);
    EXPECT_TRUE(follows_seeds(after, values)) << k;
    EXPECT_TRUE(is_connected(soup_of(mesh), after)) << k;
    const std::size_t n = std::set<std::size_t>(after.begin(), after.end()).size();
    EXPECT_GE(n, 3u);
    if (k <= 3) {
      EXPECT_EQ(n, 3u);
    }
  }
  EXPECT_EQ(
    labels(segmenter, 5),
    segments_of(mesh, RS::parameters::method(method).face_seed_map(seeds).number_of_segments(5)));

  segmenter.set_seeds(face_map(mesh, no_seed));
  const RS::Segmenter without(mesh, RS::parameters::method(method));
  for (std::size_t k : {5, 500})
    EXPECT_EQ(labels(segmenter, k), labels(without, k)) << "seeds are gone";
}

TEST(Segmenter_test, seeds_join_and_part)
{
  test_seeds_on_dumbbell(visibility(200));
  test_seeds_on_dumbbell(visibility(10));
  test_seeds_on_dumbbell(two_step());
}

// Borders are straightened, so that there are fewer regions than before.
TEST(Segmenter_test, seeds_hold_for_numbers_above_that_of_the_regions)
{
  const Soup soup = mapped(torus(60, 30), [](const Point& p) {
    const double u = std::atan2(p[1], p[0]), v = std::atan2(p[2], std::hypot(p[0], p[1]) - 1);
    const double s = 1 + 0.05 * std::sin(5 * u) * std::cos(3 * v);
    return Point{s * p[0], s * p[1], s * p[2]};
  });
  std::vector<std::size_t> values(soup.polygons.size(), no_seed);
  std::fill(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 3), 0);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto seeds = face_labels(mesh, values);
  const auto check = [&](const auto& method) {
    const RS::Segmenter segmenter(mesh, RS::parameters::face_seed_map(seeds).method(method));
    for (std::size_t k : {100, 300, 320, 350, 400, 480, 5000})
      EXPECT_TRUE(follows_seeds(labels(segmenter, k), values)) << k;
  };
  check(RS::Learned_merging());
  check(RS::Visibility_merging());
}

TEST(Segmenter_test, paths_between_equal_seeds_do_not_depend_on_scale)
{
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Soup soup = random_mesh(Family::BLOCKS, seed);
    std::mt19937 random(seed);
    std::vector<std::size_t> values(soup.polygons.size(), no_seed);
    values[random() % values.size()] = values[random() % values.size()] = 0;
    values[random() % values.size()] = 1;
    std::vector<Labels> found;
    for (double factor : {1. / 64, 64.}) {
      const Surface_mesh mesh = to_surface_mesh(scaled(soup, factor));
      RS::Segmenter segmenter(mesh, RS::parameters::method(visibility(60)));
      segmenter.set_seeds(face_labels(mesh, values));
      found.push_back(labels(segmenter, 40));
    }
    EXPECT_EQ(found[0], found[1]);
  }
}

template <typename Segmenter, typename Map>
std::string refusal(Segmenter& segmenter, const Map& seeds)
{
  return message_of([&] { segmenter.set_seeds(seeds); });
}

TEST(Segmenter_test, paths_between_equal_seeds_avoid_valleys)
{
  // A wall across the middle of a plate: over it 5 squares, around it 13, but the way over it leads
  // through two valleys.
  std::vector<Voxel> voxels = voxel_block({0, 0, 0}, {9, 11, 3});
  for (const Voxel& v : voxel_block({4, 1, 3}, {5, 10, 4}))
    voxels.push_back(v);
  const Surface_mesh mesh = to_surface_mesh(voxel_surface(voxels));
  Labels values(num_faces(mesh), no_seed);
  const Face first = face_near(mesh, 3.5, 5.5, 3), second = face_near(mesh, 5.5, 5.5, 3);
  values[first] = values[second] = 0;
  const RS::Partition regions = RS::requested_regions(
                                  RS::make_surface(mesh),
                                  RS::Partition::into_single_elements(values.size()),
                                  RS::Seeds::from_values(values))
                                  .regions;
  ASSERT_EQ(regions[first], regions[second]);
  std::size_t number = 0;
  for (Face f : mesh.faces())
    if (regions[f] == regions[first]) {
      ++number;
      for (auto v : vertices_around_face(mesh.halfedge(f), mesh))
        EXPECT_LE(mesh.point(v).z(), 3) << "on the wall";
    }
  EXPECT_EQ(number, 13u);
}

// -1 of the type of the map, whatever its width and sign.
TEST(Segmenter_test, seeds_of_all_types_have_no_seed)
{
  const Soup soup = sphere(3);
  const auto labels_with = [&](auto none) {
    std::vector<decltype(none)> seeds(soup.polygons.size(), none);
    seeds[3] = 0;
    seeds[90] = 1;
    Labels labels(seeds.size());
    EXPECT_EQ(RS::segment_polygon_soup(soup.points, soup.polygons, labels,
                                       RS::parameters::number_of_segments(2).face_seed_map(seeds)),
              2u);
    return labels;
  };
  const Labels expected = labels_with(std::size_t(-1));
  EXPECT_EQ(labels_with(-1), expected);
  EXPECT_EQ(labels_with((signed char)(-1)), expected);
  EXPECT_EQ(labels_with((unsigned char)(-1)), expected);
  EXPECT_EQ(labels_with(unsigned(-1)), expected);
  EXPECT_EQ(labels_with(-1ll), expected);
}

TEST(Segmenter_test, seeds_that_cannot_be_joined_are_refused_by_name)
{
  const Surface_mesh two = to_surface_mesh(joined(sphere(2), translated(sphere(2), 5, 0, 0)));
  auto seeds = face_map(two, no_seed);
  put(seeds, Face(3), 42);
  put(seeds, Face(200), 42);
  RS::Segmenter of_two(two, RS::parameters::component_links(false));
  EXPECT_EQ(refusal(of_two, seeds).rfind("the faces of seed 42 cannot be joined", 0), 0u);
  const auto apart = RS::parameters::component_links(false).face_seed_map(seeds);
  EXPECT_THROW(RS::Segmenter(two, apart), RS::Invalid_input);
  EXPECT_THROW(RS::Segmenter(two, apart.method(RS::Two_step())), RS::Invalid_input);

  const Surface_mesh bar = fine_dumbbell();
  const auto loop = edge_map(bar, loop_at(bar, 11));
  auto ends = face_map(bar, no_seed);
  put(ends, face_near(bar, 0, 0, 0), 1);
  put(ends, face_near(bar, 24, 0, 0), 1);
  RS::Segmenter with_loop(bar, RS::parameters::edge_is_constrained_map(loop));
  EXPECT_NE(refusal(with_loop, ends), "taken");
  RS::Segmenter with_seeds(bar, RS::parameters::face_seed_map(ends));
  const Labels before = labels(with_seeds, 4);
  EXPECT_THROW(with_seeds.add_constraints(loop), RS::Invalid_input);
  EXPECT_EQ(labels(with_seeds, 4), before) << "nothing has changed";

  // Two seeds that alternate around the border of a square cannot both be connected.
  const Surface_mesh sheet = to_surface_mesh(triangulated(grid(6, 6)));
  auto corners = face_map(sheet, no_seed);
  put(corners, face_near(sheet, 0, 0, 0), 0);
  put(corners, face_near(sheet, 6, 6, 0), 0);
  put(corners, face_near(sheet, 6, 0, 0), 1);
  put(corners, face_near(sheet, 0, 6, 0), 1);
  RS::Segmenter of_sheet(sheet);
  EXPECT_NE(refusal(of_sheet, corners), "taken");
}

TEST(Segmenter_test, seeds_do_not_join_regions_with_a_constrained_edge_between_them)
{
  const Surface_mesh sheet = to_surface_mesh(grid(4, 2));
  const RS::Partition halves = RS::Partition::from_labels(Labels{0, 0, 1, 1, 0, 0, 1, 1});
  Labels values(8, no_seed);
  values.front() = values.back() = 7;
  const auto number_of_regions = [&](const std::set<Edge>& constrained) {
    const RS::Segmenter segmenter(
      sheet,
      RS::parameters::method(two_step()).edge_is_constrained_map(edge_map(sheet, constrained)));
    return RS::requested_regions(segmenter.surface(), halves, RS::Seeds::from_values(values))
      .regions.number_of_parts();
  };
  EXPECT_EQ(number_of_regions({}), 1u);
  EXPECT_THROW(number_of_regions({make_edge(2, 7)}), RS::Invalid_input);
}

TEST(Segmenter_test, seeds_within_one_region_split_it)
{
  const Surface_mesh mesh = to_surface_mesh(triangulated(grid(8, 8)));
  auto seeds = face_map(mesh, no_seed);
  put(seeds, face_near(mesh, 0, 0, 0), 0);
  put(seeds, face_near(mesh, 8, 8, 0), 1);
  RS::Segmenter segmenter(mesh, RS::parameters::method(two_step()));
  ASSERT_EQ(labels(segmenter, 1000), Labels(num_faces(mesh), 0))
    << "a flat sheet has no feature edge";
  segmenter.set_seeds(seeds);
  const Labels after = labels(segmenter, 1);
  EXPECT_TRUE(follows_seeds(after, labels_of(mesh, seeds)));
  const auto in_first = std::count(after.begin(), after.end(), 0);
  EXPECT_GT(in_first, 48);
  EXPECT_LT(in_first, 80) << "the faces are dealt out evenly";
}

} // namespace Segmenter_test
