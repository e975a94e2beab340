// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_segmentation.h"

#include "segmentation/Manifold.h"

#include <CGAL/number_type_config.h>

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
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <queue>
#include <set>
#include <type_traits>
#include <utility>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

using Mesh = Manifold::Mesh;

/// A `SegmentationVisitor` that times the stages, and hands on what it hears.
class Stage_clock
{
public:
  explicit Stage_clock(const Progress_listener& listener)
    : m_listener(listener)
  {}

  bool on_progress(const char* stage, double fraction)
  {
    if (m_starts.empty() || m_starts.back().stage != stage)
      m_starts.push_back({stage, Clock::now()});
    return !m_listener || m_listener(stage, fraction);
  }

  /// From the first word of the first stage to now.
  double seconds() const
  {
    return m_starts.empty() ? 0 : between(m_starts.front().time, Clock::now());
  }

  /// A stage lasts until the next one starts, the last one until now.
  std::vector<Stage_time> stages() const
  {
    std::vector<Stage_time> result;
    for (std::size_t i = 0; i < m_starts.size(); ++i) {
      const Clock::time_point end = i + 1 < m_starts.size() ? m_starts[i + 1].time : Clock::now();
      result.push_back({m_starts[i].stage, between(m_starts[i].time, end)});
    }
    return result;
  }

private:
  using Clock = std::chrono::steady_clock;

  struct Start
  {
    std::string stage;
    Clock::time_point time;
  };

  static double between(Clock::time_point from, Clock::time_point to)
  {
    return std::chrono::duration<double>(to - from).count();
  }

  const Progress_listener& m_listener;
  std::vector<Start> m_starts;
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

/// Fills `result`. `segment(np, result)` calls the library with more named parameters: its input
/// and its maps.
template <typename SegmentationMethod, typename Segment>
void segment_by(const SegmentationMethod& method, const Segment& segment,
                const Segmentation_settings& settings, const Progress_listener& listener,
                Segmentation& result)
{
  Stage_clock clock(listener);
  const auto segment_with = [&](const auto& np) {
    return segment(np.method(method)
                     .merge_tree(result.tree)
                     .component_links(settings.links == Component_links::FOUND)
                     .visitor(std::ref(clock)),
                   result);
  };
  if (settings.number_of_segments)
    result.number_of_segments = segment_with(
      RS::parameters::number_of_segments(*settings.number_of_segments));
  else if constexpr (std::is_same<SegmentationMethod, RS::Two_step>::value)
    result.number_of_segments = segment_with(
      RS::parameters::number_of_segments(result.segment_of_face.size())); // no region is merged
  else {
    result.number_of_segments = segment_with(RS::parameters::default_values());
    result.largest_number = largest_number(method.chooser, result.number_of_segments, result.tree);
  }
  result.number_of_regions = result.tree.number_of_regions();
  result.seconds = clock.seconds();
  result.stages = clock.stages();
}

template <typename Segment>
Segmentation run_method(std::size_t number_of_faces, const Segment& segment,
                        const Segmentation_settings& settings, const Progress_listener& listener)
{
  Segmentation result;
  result.segment_of_face.resize(number_of_faces);
  result.region_of_face.resize(number_of_faces);
  switch (settings.method) {
  case Method::TWO_STEP: {
    result.features = {settings.maximum_angle.value_or(RS::default_maximum_angle),
                       settings.features};
    RS::Two_step method;
    method.maximum_angle = result.features->maximum_angle;
    method.feature_convexity = result.features->convexity;
    segment_by(method, segment, settings, listener, result);
    break;
  }
  case Method::SMOOTH_FACES: {
    Smooth_faces_with_memory method;
    method.tolerance = settings.tolerance;
    segment_by(method, segment, settings, listener, result);
    result.part_faces = method.found;
    break;
  }
  case Method::VISIBILITY:
    segment_by(RS::Visibility_merging(), segment, settings, listener, result);
    break;
  case Method::LEARNED:
    segment_by(RS::Learned_merging(), segment, settings, listener, result);
    break;
  }
  return result;
}

/// The seeds of faces; none if the list is empty.
struct Seeds_of_faces
{
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  friend std::size_t get(const Seeds_of_faces& map, std::size_t f)
  {
    return map.seeds->empty() ? no_seed : (*map.seeds)[f];
  }

  const std::vector<std::size_t>* seeds;
};

/// The constrained edges, by coordinates: points of the soup may be several at one place.
std::vector<char> constrained_edges(const Mesh& mesh, const Polygon_soup& soup, const Marks& marks)
{
  const auto sorted = [](std::array<Point, 2> ends) {
    std::sort(ends.begin(), ends.end());
    return ends;
  };
  std::set<std::array<Point, 2>> edges;
  for (const Vertex_pair& edge : marks.constrained_edges)
    edges.insert(sorted({soup.points[edge[0]], soup.points[edge[1]]}));
  std::vector<char> result(mesh.number_of_edges());
  const auto point = [&](auto v) {
    return Point{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
  };
  for (const auto e : mesh.edges())
    result[e] = edges.count(sorted({point(mesh.vertex(e, 0)), point(mesh.vertex(e, 1))})) > 0;
  return result;
}

/// Labels of the faces of the mesh.
struct Labels
{
  std::vector<std::size_t> segment_of_face, region_of_face;
};

void nest_regions(const Mesh& mesh, const std::vector<std::size_t>& segment_of_region,
                  Labels& labels)
{
  const auto has_moved = [&](std::size_t f) {
    return segment_of_region[labels.region_of_face[f]] != labels.segment_of_face[f];
  };
  std::queue<Mesh::Face_index> front;
  for (const auto f : mesh.faces())
    if (!has_moved(f))
      front.push(f);
  for (; !front.empty(); front.pop()) {
    const auto f = front.front();
    for (const auto g : CGAL::faces_around_face(mesh.halfedge(f), mesh))
      if (g != Mesh::null_face() && has_moved(g) &&
          labels.segment_of_face[g] == labels.segment_of_face[f]) {
        labels.region_of_face[g] = labels.region_of_face[f];
        front.push(g);
      }
  }
}

/// Moves the borders between the segments by minimum cuts, on `make_manifold()` of the soup. A face
/// that changed its segment gets the region of the nearest face, across edges, that stayed in that
/// segment, so that again every region lies in one segment.
void smooth_borders(const Polygon_soup& soup, const Marks& marks, const Progress_listener& listener,
                    Segmentation& segmentation)
{
  const Manifold manifold = make_manifold(soup);
  const std::vector<char> is_constrained = constrained_edges(manifold.mesh, soup, marks);
  Labels labels = {manifold.values_of_mesh_faces(segmentation.segment_of_face),
                   manifold.values_of_mesh_faces(segmentation.region_of_face)};
  std::vector<std::size_t> segment_of_region(segmentation.number_of_regions);
  for (std::size_t f = 0; f < segmentation.region_of_face.size(); ++f)
    segment_of_region[segmentation.region_of_face[f]] = segmentation.segment_of_face[f];

  Stage_clock clock(listener);
  RS::smooth_borders<CGAL::Parallel_if_available_tag>(
    manifold.mesh, face_map(manifold.mesh, labels.segment_of_face), {},
    RS::parameters::visitor(std::ref(clock))
      .edge_is_constrained_map(boost::make_iterator_property_map(
        is_constrained.begin(), get(boost::edge_index, manifold.mesh))));
  segmentation.seconds += clock.seconds();
  for (Stage_time& time : clock.stages())
    segmentation.stages.push_back(std::move(time));

  nest_regions(manifold.mesh, segment_of_region, labels);
  for (std::size_t f = 0; f < manifold.face_of_mesh_face.size(); ++f) {
    segmentation.segment_of_face[manifold.face_of_mesh_face[f]] = labels.segment_of_face[f];
    segmentation.region_of_face[manifold.face_of_mesh_face[f]] = labels.region_of_face[f];
  }
}

} // namespace

Segmentation run_on_soup(const Polygon_soup& soup, const Marks& marks,
                         const Segmentation_settings& settings, const Progress_listener& listener)
{
  const auto segment = [&](const auto& np, Segmentation& result) {
    return RS::segment_polygon_soup<CGAL::Parallel_if_available_tag>(
      soup.points, soup.polygons, result.segment_of_face,
      np
        .region_map(boost::make_iterator_property_map(
          result.region_of_face.begin(), boost::typed_identity_property_map<std::size_t>()))
        .constrained_edges(marks.constrained_edges)
        .face_seed_map(Seeds_of_faces{&marks.seed_of_face}));
  };
  return run_method(soup.polygons.size(), segment, settings, listener);
}

Segmentation run_segmentation(const Polygon_soup& soup, const Marks& marks,
                              const Segmentation_settings& settings,
                              const Progress_listener& listener)
{
  Segmentation result = run_on_soup(soup, marks, settings, listener);
  if (settings.borders == Border_treatment::SMOOTHING)
    smooth_borders(soup, marks, listener, result);
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
