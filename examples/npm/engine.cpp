// SPDX-License-Identifier: GPL-3.0-or-later
//
// The library as WebAssembly: see index.mjs, which calls it, and build.sh.

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segmenter.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using emscripten::val;

namespace {

using Indices = std::vector<std::uint32_t>;

struct Soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<Indices> polygons;
};

Soup make_soup(const val& request)
{
  Soup soup;
  const auto coordinates = emscripten::convertJSArrayToNumberVector<double>(request["points"]);
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    soup.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  const auto corners = emscripten::convertJSArrayToNumberVector<std::uint32_t>(request["corners"]);
  std::size_t begin = 0;
  for (std::uint32_t n :
       emscripten::convertJSArrayToNumberVector<std::uint32_t>(request["sizes"])) {
    soup.polygons.emplace_back(corners.begin() + begin, corners.begin() + begin + n);
    begin += n;
  }
  return soup;
}

/// `request`: `points` and `corners` one after another; `sizes` of faces; `numberOfSegments`, 0 for
/// one that the method chooses; `constrainedEdges`, corners two by two; `seeds`, empty for none.
template <typename Method>
std::vector<std::uint32_t> segment_by(const Method& method, const val& request)
{
  const Soup soup = make_soup(request);
  RS::Polygon_soup_segmenter segmenter(
    soup.points, soup.polygons,
    RS::parameters::method(method).component_links(request["componentLinks"].as<bool>()));
  const auto ends = emscripten::convertJSArrayToNumberVector<std::uint32_t>(
    request["constrainedEdges"]);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    edges.emplace_back(ends[i], ends[i + 1]);
  if (!edges.empty())
    segmenter.add_constraints(edges);
  const auto seeds = emscripten::convertJSArrayToNumberVector<std::int32_t>(request["seeds"]);
  if (!seeds.empty())
    segmenter.set_seeds(seeds);

  std::vector<std::uint32_t> labels(soup.polygons.size());
  if (const std::size_t number = request["numberOfSegments"].as<unsigned>())
    segmenter.segment(labels, number);
  else if constexpr (decltype(segmenter)::needs_number)
    throw std::invalid_argument("method two-step needs numberOfSegments");
  else
    segmenter.segment(labels);
  return labels;
}

std::vector<std::uint32_t> segment_by_name(const std::string& method, const val& request)
{
  if (method == "learned")
    return segment_by(RS::Learned_merging(), request);
  if (method == "visibility")
    return segment_by(RS::Visibility_merging(), request);
  if (method == "two-step")
    return segment_by(RS::Two_step(), request);
  if (method == "smooth-faces")
    return segment_by(RS::Smooth_faces(), request);
  throw std::invalid_argument("method: not learned, visibility, two-step or smooth-faces");
}

/// The labels as a Uint32Array, or the reason why there are none.
val segment(const std::string& method, const val& request)
{
  try {
    const std::vector<std::uint32_t> labels = segment_by_name(method, request);
    return val::global("Uint32Array")
      .new_(val(emscripten::typed_memory_view(labels.size(), labels.data()))); // a copy
  } catch (const std::exception& error) {
    return val(std::string(error.what()));
  }
}

} // namespace

EMSCRIPTEN_BINDINGS(engine)
{
  emscripten::function("segment", &segment);
}
