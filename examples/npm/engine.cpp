// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The library as WebAssembly: see index.mjs, which calls it, and build.sh.

#include "segmentation/Any_segmenter.h"
#include "segmentation/find_part_faces.h"
#include "soup/make_soup.h"

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using emscripten::val;
using nlohmann::json;

/// What `f()` returns, or the text of the error that it throws.
template <typename F>
val answer(const F& f)
{
  try {
    return val(f());
  } catch (const std::exception& error) {
    return val(std::string(error.what()));
  }
}

template <typename T>
val typed_array(const char* type, const std::vector<T>& values)
{
  return val::global(type).new_(
    val(emscripten::typed_memory_view(values.size(), values.data()))); // a copy
}

/// `points`, and `corners` and `sizes` of faces, of a request: each one after another.
segment_mesh::Polygon_soup soup_of(const val& request)
{
  const auto numbers = [&](const char* name) {
    return emscripten::convertJSArrayToNumberVector<double>(request[name]);
  };
  return segment_mesh::make_soup(numbers("points"), numbers("corners"), numbers("sizes"));
}

struct Segmenter
{
  segment_mesh::Any_segmenter segmenter;
  std::size_t size;

  /// The labels as a Uint32Array; 0 lets the method choose the number.
  val segment(unsigned number) const
  {
    return answer([&] {
      std::vector<std::uint32_t> labels(size);
      segmenter.segment(number == 0 ? std::nullopt : std::optional<std::size_t>(number), labels,
                        RS::parameters::default_values());
      return typed_array("Uint32Array", labels);
    });
  }
};

/// `request`: that of a soup; `constrainedEdges` one after another; `seeds`, empty for none;
/// `componentLinks`.
val prepare(const std::string& method, const val& request)
{
  return answer([&] {
    const auto soup = soup_of(request);
    const auto edges = make_edges(
      soup, emscripten::convertJSArrayToNumberVector<double>(request["constrainedEdges"]));
    auto seeds = emscripten::convertJSArrayToNumberVector<std::int32_t>(request["seeds"]);
    seeds.resize(soup.polygons.size(), -1);
    return std::make_shared<Segmenter>(
      Segmenter{{method, 0, soup,
                 RS::parameters::component_links(request["componentLinks"].as<bool>())
                   .constrained_edges(edges)
                   .face_seed_map(seeds)},
                soup.polygons.size()});
  });
}

/// `request`: that of a soup; `tolerance`. The faces are a text of JSON.
val part_faces(const val& request)
{
  return answer([&] {
    const auto found = segment_mesh::find_part_faces(
      soup_of(request), request["tolerance"].as<double>(), RS::parameters::default_values());
    json faces = json::array();
    const auto adder = [](json& object) {
      return [&object](const char* name, const auto& value) { object[name] = value; };
    };
    for (const auto& part_face : found.faces) {
      json& face = faces.emplace_back();
      segment_mesh::visit_attributes_of_surface(part_face.surface, adder(face["surface"]));
      segment_mesh::visit_attributes_of_face(part_face, adder(face));
      face["neighbors"] = json::array();
      for (const RS::Part_face_neighbor& n : part_face.neighbors)
        face["neighbors"].push_back(
          {{"face", n.face}, {"length", n.length}, {"is_smooth", n.is_smooth}});
    }
    val result = val::object();
    result.set("labels", typed_array("Int32Array", found.labels));
    result.set("faces", faces.dump());
    return result;
  });
}

} // namespace

EMSCRIPTEN_BINDINGS(engine)
{
  emscripten::class_<Segmenter>("Segmenter")
    .smart_ptr<std::shared_ptr<Segmenter>>("Segmenter")
    .function("segment", &Segmenter::segment);
  emscripten::function("prepare", &prepare);
  emscripten::function("findPartFaces", &part_faces);
}
