// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_segmentation.h"

#include <CGAL/Region_segmentation/Graph/Number_range.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

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
  const auto start = std::chrono::steady_clock::now();
  if (needs_number || settings.number_of_segments) // by default no region is merged
    result.number_of_segments = segment(
      RS::parameters::number_of_segments(settings.number_of_segments.value_or(number_of_faces)));
  else if constexpr (!needs_number)
    result.number_of_segments = segment(RS::parameters::default_values());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if constexpr (!needs_number)
    if (!settings.number_of_segments)
      result.largest_number = largest_number(method.chooser, result.number_of_segments,
                                             result.tree);
  result.number_of_regions = result.tree.number_of_regions();
  return result;
}

} // namespace

Segmentation run_segmentation(const Polygon_soup& soup, const Marks& marks,
                              const Segmentation_settings& settings,
                              const Progress_listener& listener)
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
