// SPDX-License-Identifier: GPL-3.0-or-later

// The program in a web worker: reads a mesh from the bytes of a file, segments it, and writes it.
// Answers are objects for worker.js; one with `error` holds the reason for a user.

#include "page/page.h"
#include "read/errors.h"
#include "read/read_mesh.h"
#include "write/write_mesh.h"

#include <CGAL/Region_segmentation/Support/exceptions.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <iterator>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace segment_mesh {

/// Emscripten has no minizip.
Input_mesh read_3mf(const std::string& file, std::string_view)
{
  throw Input_error(file, "a .3mf is read by the program segment_mesh, not by this page");
}

namespace {

using emscripten::val;

/// What was opened last, and its last segmentation.
struct Opened_file
{
  std::string name;
  Input_mesh mesh;
  Segmentation_settings settings;
  Segmentation segmentation;
  std::optional<Segmentation_details> details;
};

std::unique_ptr<Opened_file> opened;

val to_bytes(const std::string& bytes)
{
  const emscripten::memory_view<unsigned char> here(
    bytes.size(), reinterpret_cast<const unsigned char*>(bytes.data()));
  return val::global("Uint8Array").new_(here); // a copy
}

std::vector<std::size_t> to_indices(const val& array)
{
  const auto numbers = emscripten::convertJSArrayToNumberVector<std::uint32_t>(array);
  return {numbers.begin(), numbers.end()};
}

/// `f()`, or the error that it throws.
template <typename F>
val answer(const F& f)
{
  val failure = val::object();
  try {
    return f();
  } catch (const std::bad_alloc&) {
    failure.set("error", one_line(opened->name + ": not enough memory in the browser"));
  } catch (const CGAL::Region_segmentation::Invalid_input& error) {
    failure.set("error", one_line(opened->name + ": " + error.what()));
  } catch (const std::exception& error) {
    failure.set("error", one_line(error.what()));
  }
  return failure;
}

val open_file(const std::string& name, const std::string& bytes)
{
  return answer([&] {
    opened = std::make_unique<Opened_file>();
    opened->name = name;
    if (bytes.empty())
      throw Input_error(name, "is empty");
    opened->mesh = parse_mesh(name, mesh_format(name), bytes);
    return val::object();
  });
}

/// `constraints`: the points of edges, two by two; `seeds`: faces and their seeds, two by two.
Marks marks_of(const val& request)
{
  Marks marks;
  const std::vector<std::size_t> ends = to_indices(request["constraints"]);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    marks.constrained_edges.push_back(
      {(std::min)(ends[i], ends[i + 1]), (std::max)(ends[i], ends[i + 1])});
  std::sort(marks.constrained_edges.begin(), marks.constrained_edges.end());
  const std::vector<std::size_t> seeds = to_indices(request["seeds"]);
  if (!seeds.empty())
    marks.seed_of_face.assign(opened->mesh.soup.polygons.size(), no_seed);
  for (std::size_t i = 0; i + 1 < seeds.size(); i += 2)
    marks.seed_of_face.at(seeds[i]) = seeds[i + 1];
  return marks;
}

/// `request`: see `marks_of()`; `method` by its name, and `number` of segments, 0 if the method is
/// to choose it. `report(stage, fraction)` hears of the progress.
val segment_opened(const val& request, const val& report)
{
  return answer([&] {
    Segmentation_settings settings;
    settings.method = Method(std::find(std::begin(method_names), std::end(method_names),
                                       request["method"].as<std::string>()) -
                             std::begin(method_names));
    if (const unsigned number = request["number"].as<unsigned>())
      settings.number_of_segments = number;
    Segmentation segmentation = run_segmentation(opened->mesh.soup, marks_of(request), settings,
                                                 [&](const char* stage, double fraction) {
                                                   report(std::string(stage), fraction);
                                                   return true;
                                                 });
    opened->settings = settings;
    opened->segmentation = std::move(segmentation);
    opened->details.emplace(opened->mesh.soup, opened->settings, opened->segmentation);
    const Page_data data = page_data(
      {opened->name, opened->mesh.soup, opened->segmentation, *opened->details});
    val result = val::object();
    result.set("content", text_of(data.content));
    result.set("arrays", to_bytes(data.arrays));
    return result;
  });
}

/// The shapes of the nodes of the merge tree that are given for the faces; of them `no_segment` is
/// none.
val describe_nodes(const val& node_of_face)
{
  return answer([&] {
    nlohmann::ordered_json shapes = nlohmann::ordered_json::array();
    for (const Segment_description& shape : opened->details->describe(to_indices(node_of_face)))
      shapes.push_back(shape_json(shape));
    val result = val::object();
    result.set("shapes", text_of(shapes));
    return result;
  });
}

/// The bytes of a file of the mesh, whose segments have these labels and the names that the page
/// shows.
val write_mesh(const std::string& ending, const val& labels, const val& names)
{
  return answer([&] {
    const std::vector<std::size_t> segment_of_face = to_indices(labels);
    const Mesh_properties& properties = opened->mesh.properties;
    const Labelled_mesh mesh = {opened->mesh.soup, segment_of_face,
                                emscripten::vecFromJSArray<std::string>(names), properties};
    std::ostringstream out;
    if (ending == ".obj")
      write_obj(out, mesh,
                has_obj_materials(properties) ? properties.library->files
                                              : std::vector<std::string>());
    else if (ending == ".off")
      write_off(out, mesh);
    else
      write_ply(out, mesh);
    val result = val::object();
    result.set("bytes", to_bytes(out.str()));
    return result;
  });
}

} // namespace

EMSCRIPTEN_BINDINGS(engine)
{
  emscripten::function("open", &open_file);
  emscripten::function("segment", &segment_opened);
  emscripten::function("describe", &describe_nodes);
  emscripten::function("write", &write_mesh);
}

} // namespace segment_mesh
