// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_ORACLES_H
#define CGAL_REGION_SEGMENTATION_TEST_ORACLES_H

// What must hold for labels, told from polygon soups alone, and how to get labels from the package.

#include "meshes.h"
#include "reference_two_step.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test {

using Labels = std::vector<std::size_t>; // by face
using Edge_flags = std::map<Edge, bool>; // every edge

// Predicates

/// The labels are 0 .. n-1, and in this order where they come first.
::testing::AssertionResult is_numbered_by_first_face(const Labels& labels, std::size_t n);
/// The faces of each label hang together across edges, none of which is in `uncrossed`.
::testing::AssertionResult is_connected(const Soup& soup, const Labels& labels,
                                        const std::set<Edge>& uncrossed = {});
/// Every label of `fine` lies in one label of `coarse`.
::testing::AssertionResult nests(const Labels& fine, const Labels& coarse);
/// The two sides of every such edge that has two faces, of different regions, have different
/// labels.
::testing::AssertionResult separates(const Soup& soup, const std::set<Edge>& edges,
                                     const Labels& regions, const Labels& labels);

/// The same partition with labels by first face.
Labels renumbered(const Labels& labels);
std::map<Edge, std::vector<std::size_t>> faces_of_edges(const Soup& soup);
std::size_t number_of_components(const Soup& soup);

/// Faces that are not degenerate: whose area is above 1e-12 times the square of the longest edge.
std::size_t number_of_proper_faces(const Soup& soup);
std::size_t count(const Edge_flags& flags);
/// Some edges, borders among them.
std::set<Edge> random_edges(const Soup& soup, std::size_t one_of, std::mt19937& random);

// Repeated checks

/// Calls `check(soup, seed)` for random meshes of each family.
template <typename Families, typename Check>
void for_each_random_mesh(const Families& families, unsigned number_of_seeds, const Check& check)
{
  for (Family family : families)
    for (unsigned seed = 1; seed <= number_of_seeds; ++seed) {
      SCOPED_TRACE(name(family) + ", seed " + std::to_string(seed));
      check(random_mesh(family, seed), seed);
    }
}

/// The name of a family in that of a parameterized test.
inline std::string family_in_name(Family family)
{
  std::string result = name(family);
  std::replace(result.begin(), result.end(), ' ', '_');
  return result;
}

/// The message of the error that `call()` throws, or "taken".
template <typename Error = CGAL::Region_segmentation::Invalid_input, typename Call>
std::string message_of(const Call& call)
{
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "taken";
}

inline bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// Ranks

/// The vertices and faces of a mesh of any type, numbered by iteration.
template <typename Mesh>
struct Ranks
{
  using Traits = boost::graph_traits<Mesh>;

  explicit Ranks(const Mesh& mesh)
    : m_mesh(&mesh)
    , m_rank_of(get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh))
  {
    std::size_t rank = 0;
    for (auto v : vertices(mesh))
      put(m_rank_of, v, rank++);
  }

  std::size_t operator()(typename Traits::vertex_descriptor v) const { return get(m_rank_of, v); }

  Edge operator()(typename Traits::edge_descriptor e) const
  {
    return make_edge((*this)(source(e, *m_mesh)), (*this)(target(e, *m_mesh)));
  }

private:
  const Mesh* m_mesh;
  typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type
    m_rank_of;
};

/// The soup of a mesh of any type, in the order of iteration.
template <typename Mesh>
Soup soup_of(const Mesh& mesh)
{
  Soup soup;
  const Ranks<Mesh> rank(mesh);
  const auto point_map = get(CGAL::vertex_point, mesh);
  for (auto v : vertices(mesh)) {
    const auto& p = get(point_map, v);
    soup.points.push_back({double(p[0]), double(p[1]), double(p[2])});
  }
  for (auto f : faces(mesh)) {
    soup.polygons.emplace_back();
    const auto start = halfedge(f, mesh);
    auto h = start;
    do {
      soup.polygons.back().push_back(rank(source(h, mesh)));
      h = next(h, mesh);
    } while (h != start);
  }
  return soup;
}

template <typename Mesh, typename Map>
Labels labels_of(const Mesh& mesh, const Map& map)
{
  Labels labels;
  for (auto f : faces(mesh))
    labels.push_back(get(map, f));
  return labels;
}

template <typename Mesh, typename Map>
Edge_flags flags_of(const Mesh& mesh, const Map& map)
{
  Edge_flags flags;
  const Ranks<Mesh> rank(mesh);
  for (auto e : edges(mesh))
    flags[rank(e)] = bool(get(map, e));
  return flags;
}

template <typename Mesh, typename Map>
std::set<Edge> marked_edges(const Mesh& mesh, const Map& map)
{
  std::set<Edge> result;
  for (const auto& [edge, is_marked] : flags_of(mesh, map))
    if (is_marked)
      result.insert(edge);
  return result;
}

/// A map of the mesh's own with the given value for every edge.
template <typename Mesh>
auto edge_map(const Mesh& mesh, std::uint8_t value = 0)
{
  auto map = get(CGAL::dynamic_edge_property_t<std::uint8_t>(), mesh);
  for (auto e : edges(mesh))
    put(map, e, value);
  return map;
}

template <typename Mesh>
auto edge_map(const Mesh& mesh, const std::set<Edge>& marked)
{
  auto map = edge_map(mesh);
  const Ranks<Mesh> rank(mesh);
  for (auto e : edges(mesh))
    put(map, e, std::uint8_t(marked.count(rank(e))));
  return map;
}

/// The edges of which both ends satisfy a predicate of points.
template <typename Mesh, typename Predicate>
std::set<Edge> edges_where(const Mesh& mesh, const Predicate& is_on)
{
  const auto point_map = get(CGAL::vertex_point, mesh);
  const Ranks<Mesh> rank(mesh);
  std::set<Edge> result;
  for (auto e : edges(mesh))
    if (is_on(get(point_map, source(e, mesh))) && is_on(get(point_map, target(e, mesh))))
      result.insert(rank(e));
  return result;
}

template <typename Mesh>
auto face_map(const Mesh& mesh, std::size_t value = 12345)
{
  auto map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  for (auto f : faces(mesh))
    put(map, f, value);
  return map;
}

/// Labels in the order of the faces as a property map.
template <typename Mesh>
auto face_labels(const Mesh& mesh, const Labels& labels)
{
  auto map = face_map(mesh);
  std::size_t i = 0;
  for (auto f : faces(mesh))
    put(map, f, labels[i++]);
  return map;
}

// Partitions

inline Labels labels_of(const CGAL::Region_segmentation::Partition& partition)
{
  return Labels(partition.begin(), partition.end());
}

/// The labels of faces whose regions are dealt out to segments.
inline Labels labels_of(const Labels& regions,
                        const CGAL::Region_segmentation::Partition& segment_of_region)
{
  Labels labels;
  for (std::size_t r : regions)
    labels.push_back(segment_of_region[r]);
  return labels;
}

// The pipeline with all its outputs

struct Result
{
  Labels segments, regions;
  Edge_flags features; // those that remain after growing; of the method of the paper alone
  CGAL::Region_segmentation::Merge_tree tree;
  std::size_t number_of_segments = 0;
};

inline void expect_same(const Result& a, const Result& b)
{
  EXPECT_EQ(a.number_of_segments, b.number_of_segments);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.segments, b.segments);
  EXPECT_EQ(a.features, b.features);
}

template <typename Mesh, typename Parameters>
Result run(const Mesh& mesh, const Parameters& np)
{
  Result result;
  // Stale values everywhere: what is not written shows.
  auto segment_map = face_map(mesh), region_map = face_map(mesh);
  result.number_of_segments = CGAL::Region_segmentation::segment(
    mesh, segment_map, np.region_map(region_map).merge_tree(std::ref(result.tree)));
  result.segments = labels_of(mesh, segment_map);
  result.regions = labels_of(mesh, region_map);
  return result;
}

/// The same with seeds, or a method, that have no merge tree.
template <typename Mesh, typename Parameters>
Labels segments_of(const Mesh& mesh, const Parameters& np)
{
  auto segment_map = face_map(mesh);
  const std::size_t n = CGAL::Region_segmentation::segment(mesh, segment_map, np);
  const Labels labels = labels_of(mesh, segment_map);
  EXPECT_TRUE(is_numbered_by_first_face(labels, n));
  return labels;
}

/// The options of the reference implementation, and the same as a method and as named parameters.
struct Options : reference::Two_step_options
{
  Options(std::size_t k_, reference::Convexity convexity_ = reference::Convexity::concave,
          double maximum_angle_ = 180. - 3.12 * 180. / reference::pi)
  {
    k = k_;
    convexity = convexity_;
    maximum_angle = maximum_angle_;
  }

  CGAL::Region_segmentation::Feature_convexity feature_convexity() const
  {
    using CGAL::Region_segmentation::Feature_convexity;
    return convexity == reference::Convexity::convex    ? Feature_convexity::CONVEX
           : convexity == reference::Convexity::concave ? Feature_convexity::CONCAVE
                                                        : Feature_convexity::ALL;
  }

  CGAL::Region_segmentation::Two_step method() const
  {
    CGAL::Region_segmentation::Two_step method;
    method.beta = beta;
    method.gamma = gamma;
    method.factor = factor;
    method.maximum_angle = maximum_angle;
    method.feature_convexity = feature_convexity();
    return method;
  }

  /// Of segment().
  auto named() const
  {
    return CGAL::Region_segmentation::parameters::number_of_segments(k)
      .method(method())
      .component_links(false);
  }

  Feature_options features() const { return {maximum_angle, feature_convexity()}; }
};

/// The method of the paper, and its feature edges by the stage functions. `with(np)` adds to a pack
/// what all of these take: the maps of the mesh, and constrained edges.
template <typename Mesh, typename With>
Result run(const Mesh& mesh, const Options& options, const With& with)
{
  namespace RS = CGAL::Region_segmentation;
  Result result = run(mesh, with(options.named()));
  auto features = edge_map(mesh, std::uint8_t(1));
  auto regions = face_map(mesh);
  const auto np = with(RS::parameters::component_links(false));
  test::detect_feature_edges(mesh, features, options.features(), np);
  test::grow_regions(mesh, features, regions, np);
  EXPECT_EQ(labels_of(mesh, regions), result.regions) << "the stages and segment() differ";
  result.features = flags_of(mesh, features);
  return result;
}

template <typename Mesh>
Result run(const Mesh& mesh, const Options& options)
{
  if (options.constrained_edges.empty())
    return run(mesh, options, [](const auto& np) { return np; });
  const auto constrained = edge_map(mesh, options.constrained_edges);
  return run(mesh, options,
             [&](const auto& np) { return np.edge_is_constrained_map(constrained); });
}

/// Angle bounds and convexities in turn.
Options random_options(std::mt19937& random);

Result run(const Soup& soup, const Options& options);

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_ORACLES_H
