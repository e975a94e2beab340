// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_segmentation.h"

#include "segmentation/Manifold.h"
#include "soup/Edge_list.h"

#include <CGAL/Region_segmentation/Graph/Number_range.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <queue>
#include <set>
#include <type_traits>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

using Mesh = Manifold::Mesh;

/// A `SegmentationVisitor` that hands on what it hears.
struct Stage_listener
{
  bool on_progress(const char* stage, double fraction)
  {
    return !listener || listener(stage, fraction);
  }

  const Progress_listener& listener;
};

/// `Smooth_faces` that keeps the faces that it finds.
struct Smooth_faces_with_memory : RS::Smooth_faces
{
  std::shared_ptr<RS::Surface_faces> found = std::make_shared<RS::Surface_faces>();

  Prepared prepare(const RS::Surface& surface, std::size_t number_of_segments = 0,
                   const RS::Execution& execution = RS::Execution()) const
  {
    Prepared prepared = RS::Smooth_faces::prepare(surface, number_of_segments, execution);
    *found = prepared.faces;
    return prepared;
  }
};

/// The number that was chosen, if the chooser would not choose a larger one, but the tree has more
/// regions than it, and fewer components.
template <typename Chooser>
std::optional<std::size_t> largest_number(const Chooser& chooser, std::size_t number,
                                          const RS::Merge_tree& tree)
{
  if constexpr (std::is_base_of<RS::Number_range, Chooser>::value) {
    const std::size_t number_of_components = tree.number_of_regions() - tree.merges().size();
    if (number == chooser.largest_number(tree) && number_of_components < number &&
        number < tree.number_of_regions())
      return number;
  }
  return std::nullopt;
}

template <typename SegmentationMethod>
Segmentation segment_by(const SegmentationMethod& method, const Polygon_soup& soup,
                        const Marks& marks, const Segmentation_settings& settings,
                        const Progress_listener& listener)
{
  constexpr bool needs_number = std::is_same<SegmentationMethod, RS::Two_step>::value;
  const std::size_t number_of_faces = soup.polygons.size();
  Segmentation result;
  result.segment_of_face.resize(number_of_faces);
  result.region_of_face.resize(number_of_faces);
  std::vector<std::size_t> seeds = marks.seed_of_face;
  seeds.resize(number_of_faces, no_seed);
  Stage_listener visitor{listener};
  const auto segment = [&](const auto& np) {
    return RS::segment_polygon_soup<CGAL::Parallel_if_available_tag>(
      soup.points, soup.polygons, result.segment_of_face,
      np.method(method)
        .region_map(boost::make_iterator_property_map(
          result.region_of_face.begin(), boost::typed_identity_property_map<std::size_t>()))
        .merge_tree(result.tree)
        .component_links(settings.links == Component_links::FOUND)
        .constrained_edges(marks.constrained_edges)
        .face_seed_map(seeds)
        .visitor(std::ref(visitor)));
  };
  if (needs_number || settings.number_of_segments) // by default no region is merged
    result.number_of_segments = segment(
      RS::parameters::number_of_segments(settings.number_of_segments.value_or(number_of_faces)));
  else if constexpr (!needs_number)
    result.number_of_segments = segment(RS::parameters::default_values());
  if constexpr (!needs_number)
    if (!settings.number_of_segments)
      result.largest_number = largest_number(method.chooser, result.number_of_segments,
                                             result.tree);
  result.number_of_regions = result.tree.number_of_regions();
  return result;
}

Segmentation segment(const Polygon_soup& soup, const Marks& marks,
                     const Segmentation_settings& settings, const Progress_listener& listener)
{
  const auto by = [&](const auto& method) {
    return segment_by(method, soup, marks, settings, listener);
  };
  switch (settings.method) {
  case Method::TWO_STEP: {
    RS::Two_step method;
    method.maximum_angle = settings.maximum_angle;
    method.feature_convexity = settings.features;
    return by(method);
  }
  case Method::SMOOTH_FACES: {
    Smooth_faces_with_memory method;
    method.tolerance = settings.tolerance;
    Segmentation result = by(method);
    result.part_faces = method.found;
    return result;
  }
  case Method::VISIBILITY:
    return by(RS::Visibility_merging());
  case Method::LEARNED:
    break;
  }
  return by(RS::Learned_merging());
}

/// By edge of the mesh. Points of the soup may be several at one place.
std::vector<char> constrained_edges(const Manifold& manifold, const Polygon_soup& soup,
                                    const Marks& marks)
{
  const Edge_list edges(soup);
  std::set<Vertex_pair> constrained;
  for (const auto& [a, b] : marks.constrained_edges)
    constrained.insert(edges.edge(a, b));
  const auto point = [&](Mesh::Vertex_index v) { return manifold.point_of_mesh_point[v]; };
  std::vector<char> result;
  for (const auto e : manifold.mesh.edges())
    result.push_back(constrained.count(edges.edge(point(manifold.mesh.vertex(e, 0)),
                                                  point(manifold.mesh.vertex(e, 1)))) > 0);
  return result;
}

/// Gives each face whose segment is not that of its region the region of the nearest face, across
/// edges, that stayed in its segment: so every region lies in one segment.
void nest_regions(const Mesh& mesh, const std::vector<std::size_t>& segment_of_region,
                  const std::vector<std::size_t>& segments, std::vector<std::size_t>& regions)
{
  const auto has_moved = [&](std::size_t f) {
    return segment_of_region[regions[f]] != segments[f];
  };
  std::queue<Mesh::Face_index> front;
  for (const auto f : mesh.faces())
    if (!has_moved(f))
      front.push(f);
  for (; !front.empty(); front.pop()) {
    const auto f = front.front();
    for (const auto g : CGAL::faces_around_face(mesh.halfedge(f), mesh))
      if (g != Mesh::null_face() && has_moved(g) && segments[g] == segments[f]) {
        regions[g] = regions[f];
        front.push(g);
      }
  }
}

/// Moves the borders between the segments by minimum cuts, on `make_manifold()` of the soup.
void smooth_borders(const Polygon_soup& soup, const Marks& marks, const Progress_listener& listener,
                    Segmentation& segmentation)
{
  const Manifold manifold = make_manifold(soup);
  const std::vector<char> is_constrained = constrained_edges(manifold, soup, marks);
  std::vector<std::size_t> segments = manifold.values_of_mesh_faces(segmentation.segment_of_face),
                           regions = manifold.values_of_mesh_faces(segmentation.region_of_face),
                           segment_of_region(segmentation.number_of_regions);
  for (std::size_t f = 0; f < segmentation.region_of_face.size(); ++f)
    segment_of_region[segmentation.region_of_face[f]] = segmentation.segment_of_face[f];
  Stage_listener visitor{listener};
  RS::smooth_borders<CGAL::Parallel_if_available_tag>(
    manifold.mesh, face_map(manifold.mesh, segments), {},
    RS::parameters::visitor(std::ref(visitor))
      .edge_is_constrained_map(boost::make_iterator_property_map(
        is_constrained.begin(), get(boost::edge_index, manifold.mesh))));
  nest_regions(manifold.mesh, segment_of_region, segments, regions);
  for (std::size_t f = 0; f < manifold.face_of_mesh_face.size(); ++f) {
    segmentation.segment_of_face[manifold.face_of_mesh_face[f]] = segments[f];
    segmentation.region_of_face[manifold.face_of_mesh_face[f]] = regions[f];
  }
}

} // namespace

Segmentation run_segmentation(const Polygon_soup& soup, const Marks& marks,
                              const Segmentation_settings& settings,
                              const Progress_listener& listener)
{
  const auto start = std::chrono::steady_clock::now();
  Segmentation result = segment(soup, marks, settings, listener);
  if (settings.borders == Border_treatment::SMOOTHING)
    smooth_borders(soup, marks, listener, result);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

Segmentation segmentation_from_labels(const std::vector<std::int64_t>& labels)
{
  std::vector<std::int64_t> different = labels;
  std::sort(different.begin(), different.end());
  different.erase(std::unique(different.begin(), different.end()), different.end());
  const auto none = std::find(different.begin(), different.end(), std::int64_t(RS::no_segment));
  const bool has_none = none != different.end();
  if (has_none)
    different.erase(none);

  Segmentation result;
  const std::size_t n = different.size();
  result.number_of_segments = n;
  result.number_of_regions = n + has_none;
  for (std::int64_t label : labels) {
    const auto i = std::size_t(std::lower_bound(different.begin(), different.end(), label) -
                               different.begin());
    result.segment_of_face.push_back(label == RS::no_segment ? std::size_t(RS::no_segment) : i);
    result.region_of_face.push_back(label == RS::no_segment ? n : i);
  }
  result.tree = CGAL::Region_segmentation::Merge_tree(result.number_of_regions);
  return result;
}

} // namespace segment_mesh
