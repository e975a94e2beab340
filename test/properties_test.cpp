// SPDX-License-Identifier: GPL-3.0-or-later

// What the manual promises of every polygon soup and of every mesh, over random ones by RapidCheck.
// A soup that fails is shrunk to a small one, which is printed, with the seed. RC_PARAMS in the
// environment, such as "seed=7 max_success=10000", draws other soups, and more.

#include "meshes.h"
#include "oracles.h"
#include "segments.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/region_segmentation.h>

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace test {

/// How RapidCheck prints a soup.
void showValue(const Soup& soup, std::ostream& out)
{
  out.precision(17);
  rc::show(soup.points, out);
  out << ", ";
  rc::show(soup.polygons, out);
}

} // namespace test

namespace properties_test {

namespace RS = CGAL::Region_segmentation;
namespace RP = CGAL::Region_segmentation::parameters;
namespace gen = rc::gen;
using namespace test;

constexpr std::size_t none = std::size_t(-1);

// The same soups in every run, unless the environment says otherwise.
const bool is_seeded = setenv("RC_PARAMS", "seed=1", 0) == 0;

// Random soups

/// One of some values; a failure is shrunk to the first one.
template <typename T, typename... Values>
rc::Gen<T> one_of(T first, Values... others)
{
  const std::vector<T> values = {first, T(others)...};
  return gen::map(gen::resize(100, gen::inRange<std::size_t>(0, values.size())),
                  [values](std::size_t i) { return values[i]; });
}

/// Polygons on a few points of a lattice: most of them share points and edges, some are the same,
/// some have no area, or corners that are equal.
rc::Gen<Soup> polygons()
{
  const auto point = gen::container<Point>(one_of(0., 1., 2., 3., -1., .5));
  const auto polygon = gen::suchThat(
    gen::container<Polygon>(gen::resize(100, gen::inRange<std::size_t>(0, 60))),
    [](const Polygon& corners) { return !corners.empty(); });
  return gen::apply(
    [](const std::vector<Point>& points, std::vector<Polygon> all) {
      for (Polygon& corners : all)
        for (std::size_t& i : corners)
          i %= points.size();
      return Soup{points, all};
    },
    gen::resize(10, gen::nonEmpty(gen::container<std::vector<Point>>(point))),
    gen::resize(25, gen::container<std::vector<Polygon>>(gen::resize(5, polygon))));
}

/// Shapes whose edges have at most two faces.
rc::Gen<Soup> manifold_shape()
{
  return one_of(grid(1, 1), cube(), triangulated(grid(2, 3)), sphere(0), sphere(1), l_shape(),
                cap(), needle_on_crease(), box_on_plate(), dumbbell(), grid(5, 4), torus(5, 4));
}

/// A shape that was moved, also by a million times its size, scaled, also to a tiny one, turned
/// inside out, or doubled with points of its own.
rc::Gen<Soup> placed(const rc::Gen<Soup>& shape)
{
  const auto offset = one_of(0., 0., 0., 1., 3., -2., 1e6);
  return gen::apply(
    [](Soup soup, double size, const Point& to, bool is_reversed, int doubled) {
      soup = translated(is_reversed ? reversed(soup) : soup, to[0], to[1], to[2]);
      soup = scaled(soup, size);
      return doubled == 0 ? soup : joined(soup, doubled == 1 ? soup : reversed(soup));
    },
    shape, one_of(1., 1., 1., .5, 3., 1e-7), gen::container<Point>(offset), gen::arbitrary<bool>(),
    one_of(0, 0, 0, 0, 1, 2));
}

rc::Gen<Soup> union_of(const rc::Gen<Soup>& part)
{
  return gen::map(gen::resize(4, gen::nonEmpty(gen::container<std::vector<Soup>>(part))),
                  [](const std::vector<Soup>& parts) { return joined(parts); });
}

/// The soup with some points where another one is.
rc::Gen<Soup> with_coinciding_points(const rc::Gen<Soup>& soup)
{
  const auto place = gen::resize(100, gen::inRange<std::size_t>(0, 1000));
  return gen::apply(
    [](Soup result, const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
      for (const auto& [from, to] : pairs)
        result.points[from % result.points.size()] = result.points[to % result.points.size()];
      return result;
    },
    soup,
    gen::resize(3, gen::container<std::vector<std::pair<std::size_t, std::size_t>>>(
                     gen::pair(place, place))));
}

/// The soup with some coordinates that are as large or as small as `double` can hold, or next to
/// others.
rc::Gen<Soup> with_wild_coordinates(const rc::Gen<Soup>& soup)
{
  const auto place = gen::resize(100, gen::inRange<std::size_t>(0, 3000));
  const auto number = one_of(0., -0., 1e-160, 1e154, -1e308, 1.7e308, 5e-324, 1 + 1e-15, -2.2e-308,
                             1e9);
  return gen::apply(
    [](Soup result, const std::vector<std::pair<std::size_t, double>>& coordinates) {
      for (const auto& [i, x] : coordinates)
        if (!result.points.empty())
          result.points[i / 3 % result.points.size()][i % 3] = x;
      return result;
    },
    soup,
    gen::resize(
      6, gen::container<std::vector<std::pair<std::size_t, double>>>(gen::pair(place, number))));
}

/// Equal points as one: parts share points, edges and faces.
Soup merged(const Soup& soup)
{
  Soup result;
  std::map<Point, std::size_t> index_of;
  for (const Polygon& polygon : soup.polygons) {
    result.polygons.emplace_back();
    for (const std::size_t i : polygon) {
      const auto [at, is_new] = index_of.emplace(soup.points[i], result.points.size());
      if (is_new)
        result.points.push_back(soup.points[i]);
      result.polygons.back().push_back(at->second);
    }
  }
  return result;
}

/// Soups of every kind with ordinary coordinates.
rc::Gen<Soup> tame_soup()
{
  const auto part = placed(gen::oneOf(polygons(), manifold_shape()));
  return gen::apply(
    [](const Soup& soup, bool is_merged) { return is_merged ? merged(soup) : soup; },
    with_coinciding_points(union_of(part)), gen::arbitrary<bool>());
}

rc::Gen<Soup> any_soup()
{
  return gen::oneOf(tame_soup(), with_wild_coordinates(tame_soup()));
}

rc::Gen<Soup> tame_manifold()
{
  return with_coinciding_points(union_of(placed(manifold_shape())));
}

rc::Gen<Soup> any_manifold()
{
  return gen::oneOf(tame_manifold(), with_wild_coordinates(tame_manifold()));
}

/// A few of the edges of a soup, which has some.
rc::Gen<std::set<Edge>> some_edges(const Soup& soup)
{
  std::vector<Edge> all;
  for (const auto& [edge, faces] : faces_of_edges(soup))
    if (edge.first != edge.second)
      all.push_back(edge);
  if (all.empty())
    return gen::just(std::set<Edge>());
  return gen::resize(10, gen::container<std::set<Edge>>(gen::elementOf(all)));
}

/// Seeds of a few polygons, 0, 1 or 2.
rc::Gen<Labels> some_seeds(const Soup& soup)
{
  const auto face = gen::resize(100, gen::inRange<std::size_t>(0, soup.polygons.size()));
  const auto seed = one_of<std::size_t>(0, 1, 2);
  return gen::map(gen::resize(5, gen::container<std::map<std::size_t, std::size_t>>(face, seed)),
                  [size = soup.polygons.size()](const std::map<std::size_t, std::size_t>& seeds) {
                    Labels labels(size, none);
                    for (const auto& [f, label] : seeds)
                      labels[f] = label;
                    return labels;
                  });
}

// What is checked

void require(const ::testing::AssertionResult& result)
{
  if (!result)
    RC_FAIL(result.message());
}

bool is_closed(const Soup& soup)
{
  const auto edges = faces_of_edges(soup);
  return std::all_of(edges.begin(), edges.end(),
                     [](const auto& e) { return e.second.size() == 2; });
}

/// Calls `f(method)`; a failure tells the last method that was called.
template <typename F>
void for_each_method(const F& f_of_method)
{
  const auto f = [&](const auto& method) {
    RC_LOG() << typeid(method).name() << std::endl;
    f_of_method(method);
  };
  RS::Two_step at_creases;
  at_creases.maximum_angle = 20;
  at_creases.feature_convexity = RS::Feature_convexity::ALL;
  f(RS::Two_step());
  f(at_creases);
  f(RS::Visibility_merging());
  f(RS::Learned_merging());
  f(RS::Smooth_faces());
}

template <typename Method>
constexpr bool is_two_step = std::is_same<Method, RS::Two_step>::value;
template <typename Method>
constexpr bool gives_any_number = !is_two_step<Method> &&
                                  !std::is_same<Method, RS::Smooth_faces>::value;

std::size_t number_of(const Labels& labels)
{
  return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
}

/// Faces that are neither degenerate nor doubled nor in crumbs.
std::size_t number_of_proper_faces(const RS::Surface& surface)
{
  std::size_t number = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    number += !surface.is_degenerate(f) && !surface.is_crumb(f);
  return number;
}

template <typename Parameters>
Labels segments_of_soup(const Soup& soup, const Parameters& np)
{
  Labels labels(soup.polygons.size(), 77);
  const std::size_t n = RS::segment_polygon_soup(soup.points, soup.polygons, labels, np);
  require(is_numbered_by_first_face(labels, n));
  return labels;
}

/// Equal seeds are in one segment, different ones in different ones.
void require_seeds(const Labels& seeds, const Labels& labels)
{
  std::map<std::size_t, std::size_t> segment_of_seed, seed_of_segment;
  for (std::size_t f = 0; f < seeds.size(); ++f)
    if (seeds[f] != none) {
      RC_ASSERT(segment_of_seed.emplace(seeds[f], labels[f]).first->second == labels[f]);
      RC_ASSERT(seed_of_segment.emplace(labels[f], seeds[f]).first->second == seeds[f]);
    }
}

// Soups

RC_GTEST_PROP(Soup_properties, every_polygon_has_a_segment, ())
{
  const Soup soup = *any_soup();
  const std::size_t k = *one_of<std::size_t>(1, 2, 3, 5, 12);
  const std::size_t proper = number_of_proper_faces(
    RS::make_surface_of_polygon_soup(soup.points, soup.polygons));
  for_each_method([&](const auto& method) {
    using Method = std::decay_t<decltype(method)>;
    const auto np = RP::method(method);
    Labels regions(soup.polygons.size());
    RS::Merge_tree tree;
    const Labels labels = segments_of_soup(
      soup, np.number_of_segments(k).region_map(std::ref(regions)).merge_tree(std::ref(tree)));
    const std::size_t n = number_of(labels);
    RC_ASSERT(n <= k);
    RC_ASSERT(soup.polygons.empty() || n >= 1u);
    if (gives_any_number<Method>)
      RC_ASSERT(n >= (std::min)(k, proper));
    require(is_numbered_by_first_face(regions, tree.number_of_regions()));
    RC_ASSERT(labels == labels_of(regions, tree.partition_at_count(n)));
    RC_ASSERT(labels == segments_of_soup(soup, np.number_of_segments(k)));
    if constexpr (!is_two_step<Method>) {
      Labels asked(soup.polygons.size());
      const RS::Polygon_soup_segmenter segmenter(soup.points, soup.polygons, np);
      segmenter.segment(asked);
      RC_ASSERT(asked == segments_of_soup(soup, np));
    }
  });
}

RC_GTEST_PROP(Soup_properties, size_first_corners_and_unused_points_do_not_matter, ())
{
  const Soup soup = *tame_soup();
  const int exponent = *one_of(0, 1, -30, -900, 900);
  const std::size_t corner = *one_of<std::size_t>(0, 1, 2, 3);
  Soup other = scaled(soup, std::ldexp(1, exponent));
  other.points.push_back({std::nan(""), 0, 0});
  for (Polygon& p : other.polygons)
    if (std::set<std::size_t>(p.begin(), p.end()).size() == p.size())
      std::rotate(p.begin(), p.begin() + std::ptrdiff_t(corner % p.size()), p.end());
  for_each_method([&](const auto& method) {
    const auto np = RP::number_of_segments(4).method(method);
    // The tolerance of Smooth_faces depends on the decimal digits of coordinates.
    if (exponent == 0 || !std::is_same<decltype(method), const RS::Smooth_faces&>::value)
      RC_ASSERT(segments_of_soup(soup, np) == segments_of_soup(other, np));
  });
}

// A degenerate face joins a neighbor across any edge.
RC_GTEST_PROP(Soup_properties, constraints_are_kept, ())
{
  const Soup soup = *gen::suchThat(tame_soup(), [](const Soup& s) {
    const RS::Surface surface = RS::make_surface_of_polygon_soup(s.points, s.polygons);
    return !s.polygons.empty() && number_of_proper_faces(surface) == s.polygons.size();
  });
  const std::set<Edge> constrained = *some_edges(soup);
  for_each_method([&](const auto& method) {
    Labels regions(soup.polygons.size());
    const Labels labels = segments_of_soup(soup, RP::number_of_segments(3)
                                                   .method(method)
                                                   .constrained_edges(constrained)
                                                   .region_map(std::ref(regions)));
    require(separates(soup, constrained, regions, labels));
  });
}

RC_GTEST_PROP(Soup_properties, seeds_are_kept, ())
{
  const Soup soup = *gen::suchThat(tame_soup(), [](const Soup& s) { return !s.polygons.empty(); });
  const Labels seeds = *some_seeds(soup);
  for_each_method([&](const auto& method) {
    const auto np = RP::number_of_segments(3).method(method);
    try {
      require_seeds(seeds, segments_of_soup(soup, np.face_seed_map(seeds)));
    } catch (const RS::Invalid_input&) { // they cannot be joined
    }
  });
}

RC_GTEST_PROP(Soup_properties, a_segmenter_is_given_constraints_and_seeds_later, ())
{
  const Soup soup = *gen::suchThat(any_soup(), [](const Soup& s) { return !s.polygons.empty(); });
  const std::set<Edge> constrained = *some_edges(soup);
  const Labels seeds = *some_seeds(soup);
  for_each_method([&](const auto& method) {
    using Segmenter = RS::Polygon_soup_segmenter<std::decay_t<decltype(method)>>;
    const auto np = RP::method(method);
    const auto segments_by = [&](const Segmenter& segmenter) {
      Labels labels(soup.polygons.size());
      segmenter.segment(labels, 3);
      return labels;
    };
    Segmenter segmenter(soup.points, soup.polygons, np);
    const Labels without = segments_by(segmenter);
    try {
      segmenter.set_seeds(seeds);
    } catch (const RS::Invalid_input&) {
      RC_ASSERT(segments_by(segmenter) == without);
      return;
    }
    try {
      segmenter.add_constraints(constrained);
      RC_ASSERT(segments_by(segmenter) ==
                segments_by(Segmenter(soup.points, soup.polygons,
                                      np.constrained_edges(constrained).face_seed_map(seeds))));
    } catch (const RS::Invalid_input&) {
      RC_ASSERT(segments_by(segmenter) ==
                segments_by(Segmenter(soup.points, soup.polygons, np.face_seed_map(seeds))));
    }
  });
}

// Whole or not at all

struct Cancelling_visitor
{
  std::size_t calls_left;
  bool on_progress(const char*, double) { return calls_left-- != 0; }
};

RC_GTEST_PROP(Soup_properties, nothing_is_written_by_what_fails, ())
{
  const Soup soup = *gen::suchThat(any_soup(), [](const Soup& s) { return !s.polygons.empty(); });
  const std::size_t calls = *one_of<std::size_t>(0, 1, 2, 5, 9, 14, 20);
  Soup bad_point = soup, bad_corner = soup;
  bad_point.points[soup.polygons.back().back()][1] = std::numeric_limits<double>::infinity();
  bad_corner.polygons.back().back() = soup.points.size();
  for_each_method([&](const auto& method) {
    const Labels untouched(soup.polygons.size(), 77);
    Labels labels(untouched), regions(untouched);
    RS::Merge_tree tree(2);
    const auto fails = [&](const Soup& s, auto visitor) {
      try {
        RS::segment_polygon_soup(s.points, s.polygons, labels,
                                 RP::number_of_segments(2)
                                   .method(method)
                                   .visitor(std::ref(visitor))
                                   .region_map(std::ref(regions))
                                   .merge_tree(std::ref(tree)));
        return false;
      } catch (const RS::Invalid_input&) {
      } catch (const RS::Segmentation_cancelled&) {
      }
      RC_ASSERT(labels == untouched);
      RC_ASSERT(regions == untouched);
      RC_ASSERT(tree.number_of_regions() == 2u);
      return true;
    };
    RC_ASSERT(fails(bad_point, Cancelling_visitor{none}));
    RC_ASSERT(fails(bad_corner, Cancelling_visitor{none}));
    fails(soup, Cancelling_visitor{calls});
  });
}

// Manifolds

// Open surfaces that touch share edges as polygons, but not as meshes.
RC_GTEST_PROP(Mesh_properties, are_those_of_the_soup, ())
{
  const Soup soup = *tame_manifold();
  RC_PRE(is_closed(soup) || is_manifold(merged(soup)));
  const Surface_mesh mesh = to_surface_mesh(soup);
  for_each_method([&](const auto& method) {
    const auto np = RP::number_of_segments(4).method(method);
    RC_ASSERT(segments_of(mesh, np) == segments_of_soup(soup, np));
  });
}

RC_GTEST_PROP(Mesh_properties, components_without_links_have_connected_segments, ())
{
  const Soup soup = *any_manifold();
  const Surface_mesh mesh = to_surface_mesh(soup);
  const std::size_t k = *one_of<std::size_t>(1, 3, 10), components = number_of_components(soup);
  const std::set<Edge> constrained = *some_edges(soup);
  const auto is_constrained = edge_map(mesh, constrained);
  for_each_method([&](const auto& method) {
    const auto np = RP::number_of_segments(k).method(method).component_links(false);
    const Labels labels = segments_of(mesh, np);
    require(is_connected(soup, labels));
    RC_ASSERT(number_of(labels) >= components);
    RC_ASSERT(number_of(labels) <= (std::max)(k, components));
    const Result with_borders = run(mesh, np.edge_is_constrained_map(is_constrained));
    require(is_connected(soup, with_borders.segments, constrained));
    require(separates(soup, constrained, with_borders.regions, with_borders.segments));
  });
}

RC_GTEST_PROP(Mesh_properties, part_faces_are_those_of_the_map, ())
{
  const Surface_mesh mesh = to_surface_mesh(*any_manifold());
  const auto map = face_map(mesh);
  std::vector<RS::Part_face<Kernel>> part_faces;
  const std::size_t n = RS::find_part_faces(mesh, map, std::back_inserter(part_faces));
  require(is_numbered_by_first_face(labels_of(mesh, map), n));
  RC_ASSERT(part_faces.size() == n);
}

// After a segmentation

/// Any labels of the faces, some of which have none.
rc::Gen<Labels> any_labels(const Soup& soup)
{
  return gen::container<Labels>(soup.polygons.size(),
                                one_of<std::size_t>(0, 0, 0, 7, 1000000000000, none));
}

using Piece = RS::Segment_piece<Surface_mesh, Surface_mesh, std::size_t>;

RC_GTEST_PROP(Segments_properties, borders_are_the_edges_between_segments, ())
{
  const Soup soup = *any_manifold();
  const Labels labels = *any_labels(soup);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto segment_map = face_labels(mesh, labels);
  const auto is_border = edge_map(mesh);
  std::size_t number = RS::mark_segment_borders(mesh, segment_map, is_border);
  const auto label_of = [&](auto h) { return get(segment_map, face(h, mesh)); };
  std::set<Surface_mesh::Edge_index> borders;
  for (const auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if (!is_border_edge(h, mesh) && label_of(h) != label_of(opposite(h, mesh)))
      borders.insert(e);
    RC_ASSERT(bool(get(is_border, e)) == (borders.count(e) != 0));
  }
  RC_ASSERT(number == borders.size());
  std::vector<RS::Segment_border<Surface_mesh, std::size_t>> lines;
  RS::extract_segment_borders(mesh, segment_map, std::back_inserter(lines));
  for (const auto& line : lines)
    for (const auto h : line.halfedges) {
      RC_ASSERT(borders.erase(edge(h, mesh)) == 1u);
      RC_ASSERT(label_of(h) == line.segment);
      RC_ASSERT(label_of(opposite(h, mesh)) == line.opposite_segment);
    }
  RC_ASSERT(borders.empty());
}

RC_GTEST_PROP(Segments_properties, pieces_and_solids_are_manifolds, ())
{
  const Soup soup = *any_manifold();
  const Labels labels = *any_labels(soup);
  const std::set<Edge> cut = *some_edges(soup);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const auto segment_map = face_labels(mesh, labels);
  std::vector<Piece> pieces, cut_pieces, solids;
  std::vector<RS::Segment_topology<std::size_t>> topologies;
  std::vector<RS::Segment_description<std::size_t, Kernel>> descriptions;
  RS::split_into_segments(mesh, segment_map, std::back_inserter(pieces));
  RS::split_into_segments(mesh, segment_map, std::back_inserter(cut_pieces),
                          RP::edge_is_constrained_map(edge_map(mesh, cut)));
  RS::close_segments(mesh, segment_map, std::back_inserter(solids));
  RS::compute_segment_topology(mesh, segment_map, std::back_inserter(topologies));
  RS::describe_segments(mesh, segment_map, std::back_inserter(descriptions));
  const auto counts = count_segments(soup, labels);
  for (const std::size_t number :
       {pieces.size(), cut_pieces.size(), solids.size(), topologies.size(), descriptions.size()})
    RC_ASSERT(number == counts.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Segment_counts& expected = counts.at(pieces[i].segment);
    RC_ASSERT(pieces[i].mesh.is_valid() && cut_pieces[i].mesh.is_valid());
    RC_ASSERT(solids[i].mesh.is_valid() && CGAL::is_closed(solids[i].mesh));
    RC_ASSERT(pieces[i].mesh.number_of_faces() == expected.faces);
    RC_ASSERT(pieces[i].mesh.number_of_edges() == expected.edges);
    RC_ASSERT(pieces[i].mesh.number_of_vertices() == expected.vertices);
    RC_ASSERT(cut_pieces[i].mesh.number_of_faces() == expected.faces);
    RC_ASSERT(topologies[i].euler_characteristic == expected.euler_characteristic());
    RC_ASSERT(topologies[i].number_of_border_loops == expected.loops);
    RC_ASSERT(topologies[i].number_of_components == expected.components);
    RC_ASSERT(descriptions[i].number_of_faces == expected.faces);
  }
}

RC_GTEST_PROP(Segments_properties, labels_are_moved_and_transferred_within_their_set, ())
{
  const Soup soup = *any_manifold();
  const Labels labels = *any_labels(soup);
  const Surface_mesh mesh = to_surface_mesh(soup);
  const std::set<std::size_t> all(labels.begin(), labels.end());
  const auto is_known = [&](std::size_t label) { return all.count(label) != 0; };
  const auto smoothed = face_labels(mesh, labels), transferred = face_map(mesh);
  RS::smooth_borders(mesh, smoothed);
  const std::size_t n = RS::transfer_labels(mesh, smoothed, mesh, transferred);
  const Labels moved = labels_of(mesh, smoothed), copied = labels_of(mesh, transferred);
  RC_ASSERT(std::all_of(moved.begin(), moved.end(), is_known));
  RC_ASSERT(std::set<std::size_t>(moved.begin(), moved.end()) == all);
  RC_ASSERT(std::all_of(copied.begin(), copied.end(), is_known));
  RC_ASSERT(std::set<std::size_t>(copied.begin(), copied.end()).size() == n);
}

} // namespace properties_test
