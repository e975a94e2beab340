// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/command_line.h"

#include "io/errors.h"

#include <CGAL/Region_segmentation/version.h>

#include <CLI/CLI.hpp>

#include <charconv>
#include <iostream>
#include <limits>
#include <map>
#include <system_error>

namespace segment_mesh {

namespace {

using CGAL::Region_segmentation::Feature_convexity;

constexpr const char* description =
  "Segments surface meshes into parts, and prints one line for each.\n"
  "Without an INPUT: a figure that the program builds, with its score against its true parts.";

constexpr const char* footer =
  "Examples:\n"
  "  segment_mesh\n"
  "  segment_mesh armadillo.off -k 9 -o armadillo.seg -o armadillo_parts.ply\n"
  "  segment_mesh *.off -k 7 -o 'parts/{stem}.obj' --quiet\n"
  "  segment_mesh gear.stl --method smooth-faces -o gear.json\n"
  "\nExit status: 0 done; 1 an input or an output failed; 2 wrong usage.";

const std::map<std::string, Method> methods = {{"learned", Method::LEARNED},
                                               {"visibility", Method::VISIBILITY},
                                               {"two-step", Method::TWO_STEP},
                                               {"smooth-faces", Method::SMOOTH_FACES}};

const std::map<std::string, Feature_convexity> features = {
  {"concave", Feature_convexity::CONCAVE},
  {"convex", Feature_convexity::CONVEX},
  {"all", Feature_convexity::ALL}};

const std::map<std::string, Mesh_type> mesh_types = {{"surface_mesh", Mesh_type::SURFACE_MESH},
                                                     {"polyhedron", Mesh_type::POLYHEDRON},
                                                     {"openmesh", Mesh_type::OPENMESH}};

const std::map<std::string, Mesh_format> formats = {
  {"off", Mesh_format::OFF}, {"obj", Mesh_format::OBJ}, {"ply", Mesh_format::PLY}, {"stl", Mesh_format::STL}};

/// More would be a slip of the hand.
constexpr std::size_t most_threads = 1024;

/// The options as CLI11 fills them.
struct Raw_options
{
  Options options;
  double maximum_angle = 0;
  std::string number_of_segments, number_of_threads = "0"; ///< CLI11 would cut off large numbers
  std::string method = "learned", features = "concave", mesh_type = "surface_mesh";
  std::string input_format;
  bool is_quiet = false;
};

template <typename Value>
CLI::IsMember one_of(const std::map<std::string, Value>& names)
{
  std::vector<std::string> list;
  for (const auto& entry : names)
    list.push_back(entry.first);
  return CLI::IsMember(list);
}

void add_run_options(CLI::App& app, Raw_options& raw)
{
  const auto add = [&app](const char* name, auto& value, const char* type, const char* text) {
    return app.add_option(name, value, text)->type_name(type);
  };
  add("-k,--segments", raw.number_of_segments, "N",
      "Number of segments; left out: chosen automatically, or the true one of the figure");
  add("--method", raw.method, "METHOD",
      "learned (from people; default), visibility (a hand-made cost), smooth-faces (of machine parts), or two-step "
      "(Yang et al. 2014; needs -k)")
    ->check(one_of(methods));
  add("--features", raw.features, "KIND",
      "Of two-step: edges that can be features: concave (default), convex, all")
    ->check(one_of(features));
  add("--max-angle", raw.maximum_angle, "DEG",
      "Of two-step: angle between the normals of two faces above which their edge is a feature; default 1.2372");
  add("--mesh", raw.mesh_type, "TYPE",
      "Mesh type to run on, with the same labels: surface_mesh (default), polyhedron, openmesh")
    ->check(one_of(mesh_types));
}

void add_file_options(CLI::App& app, Raw_options& raw)
{
  app.add_option("INPUT", raw.options.inputs,
                 ".off, .obj, .ply or .stl, also compressed as .gz; - is standard input; several are a batch")
    ->type_name("FILE");
  app.add_option("--input-format", raw.input_format,
                 "Of all inputs, whatever their endings: off, obj, ply, stl; needed for standard input")
    ->check(one_of(formats))
    ->type_name("FORMAT");
  app.add_option("-o,--output", raw.options.outputs)
    ->description("Repeatable; {stem} is the input's name. Written by its ending: .seg (a label a "
                  "line), .ply (colors, int segment), .off (colors), .obj (groups, feature lines), "
                  ".json (regions, sections, segments, settings, times), .png (a view)")
    ->allow_extra_args(false)
    ->type_name("FILE");
  app.add_option("--truth", raw.options.truths)
    ->description("Repeatable; {stem} as above. Print four measures of the distance to this "
                  "segmentation, and their means")
    ->allow_extra_args(false)
    ->type_name("FILE.seg");
}

void add_options(CLI::App& app, Raw_options& raw)
{
  add_file_options(app, raw);
  add_run_options(app, raw);
  app.add_option("--threads", raw.number_of_threads)
    ->description(
      "Most threads, and most meshes of a batch in memory at a time; default 0: one for each core. "
      "Unless it is alone, a mesh waits while it and those in work would take more than half of "
      "the memory "
      "there is, at 36 times the size of a .ply file and 16 times that of others")
    ->take_last()
    ->type_name("N");
  app.add_flag("--quiet", raw.is_quiet, "No progress and remarks on stderr");
  app.set_help_flag("--help", "Print this and exit");
  app.set_version_flag("--version", "segment_mesh " CGAL_REGION_SEGMENTATION_VERSION,
                       "Print the version and exit");
}

struct Range
{
  std::size_t least, greatest;
};

/// \throws Usage_error unless `word` is a whole number within the range
std::size_t whole_number(const std::string& option, const std::string& word, const Range& range)
{
  std::size_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || rest != end || value < range.least || value > range.greatest)
    throw Usage_error(option + " " + word + ": not a whole number from " +
                      std::to_string(range.least) + " to " + std::to_string(range.greatest));
  return value;
}

Options checked(const CLI::App& app, const Raw_options& raw)
{
  Options options = raw.options;
  if (app.count("--segments") > 0)
    options.settings.number_of_segments =
      whole_number("-k", raw.number_of_segments, {1, (std::numeric_limits<std::size_t>::max)()});
  options.number_of_threads = whole_number("--threads", raw.number_of_threads, {0, most_threads});
  if (app.count("--max-angle") > 0) {
    if (!(raw.maximum_angle >= 0 && raw.maximum_angle <= 180))
      throw Usage_error("--max-angle: an angle from 0 to 180 degrees");
    options.settings.maximum_angle = raw.maximum_angle;
  }
  if (!raw.input_format.empty())
    options.input_format = formats.at(raw.input_format);
  options.settings.method = methods.at(raw.method);
  for (const char* option : {"--features", "--max-angle"})
    if (options.settings.method != Method::TWO_STEP && app.count(option) > 0)
      throw Usage_error(std::string(option) + ": --method " + raw.method + " has no feature edges");
  options.settings.features = features.at(raw.features);
  options.settings.mesh_type = mesh_types.at(raw.mesh_type);
  if (!is_available(options.settings.mesh_type))
    throw Usage_error("--mesh " + raw.mesh_type + ": this program was built without it");
  options.verbosity = raw.is_quiet ? Verbosity::QUIET : Verbosity::NORMAL;
  return options;
}

} // namespace

std::optional<Options> parse_command_line(int argc, const char* const* argv)
{
  CLI::App app(description, "segment_mesh");
  app.footer(footer);
  Raw_options raw;
  add_options(app, raw);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Usage_error(error.what());
  }
  return checked(app, raw);
}

} // namespace segment_mesh
