// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The library as WebAssembly: see index.mjs, which calls it, and build.sh.

#include "segmentation/Any_segmenter.h"
#include "soup/make_soup.h"

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace RS = CGAL::Region_segmentation;
using emscripten::val;

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
      return val::global("Uint32Array")
        .new_(val(emscripten::typed_memory_view(labels.size(), labels.data()))); // a copy
    });
  }
};

/// `request`: `points`, `corners` and `constrainedEdges` one after another; `sizes` of faces;
/// `seeds`, empty for none; `componentLinks`.
val prepare(const std::string& method, const val& request)
{
  return answer([&] {
    const auto numbers = [&](const char* name) {
      return emscripten::convertJSArrayToNumberVector<double>(request[name]);
    };
    const auto soup = segment_mesh::make_soup(numbers("points"), numbers("corners"),
                                              numbers("sizes"));
    const auto edges = make_edges(soup, numbers("constrainedEdges"));
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

} // namespace

EMSCRIPTEN_BINDINGS(engine)
{
  emscripten::class_<Segmenter>("Segmenter")
    .smart_ptr<std::shared_ptr<Segmenter>>("Segmenter")
    .function("segment", &Segmenter::segment);
  emscripten::function("prepare", &prepare);
}
